#include "gui/store/state_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "io/atomic_file.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

std::optional<fs::path> state_folder() {
  // The specification has relative paths ignored.
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state) / "moldlight";
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / ".local/state/moldlight";
  return std::nullopt;
}

std::optional<std::string> read_text(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

void write_text(const fs::path& path, const std::string& text) {
  std::error_code ignored;  // write_file says what is wrong with the folder
  fs::create_directories(path.parent_path(), ignored);
  write_file(path.string(), text);
}

}  // namespace moldlight::gui
