#include "gui/store/files.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/own_files.hpp"
#include "io/atomic_file.hpp"
#include "io/png.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

/// Starts the desktop's own opener and does not wait for it; false where there is none.
bool open_on_desktop(const std::string& path) {
  std::string shell = "sh", flag = "-c", name = path;
  std::string script =
      "command -v xdg-open >/dev/null || exit 1; xdg-open \"$0\" >/dev/null 2>&1 </dev/null &";
  char* const arguments[] = {shell.data(), flag.data(), script.data(), name.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "sh", nullptr, nullptr, arguments, ::environ) != 0) return false;
  int status = 0;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::optional<fs::path> state_folder() {
  // The specification has relative paths ignored.
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state) / "moldlight";
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return fs::path(home) / ".local/state/moldlight";
  return std::nullopt;
}

std::string absolute_path(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return error ? path : absolute.lexically_normal().string();
}

std::optional<std::string> read_text(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

nlohmann::json parse_json(std::string_view text) {
  using Json = nlohmann::json;
  constexpr int k_deepest = 32;
  bool too_deep = false;
  Json json = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, Json&) {
        too_deep = too_deep || depth > k_deepest;
        return !too_deep;
      },
      false);
  return too_deep ? Json(Json::value_t::discarded) : json;
}

void write_text(const fs::path& path, const std::string& text) {
  std::error_code ignored;  // write_file says what is wrong with the folder
  fs::create_directories(path.parent_path(), ignored);
  write_file(path.string(), text);
}

std::vector<std::string> shipped_parts() {
  // Installed, or in the source tree, below which a program stands that was only built.
  constexpr const char* k_places[] = {"../share/moldlight/parts", "../assets/parts", "../../assets/parts",
                                      "../../../assets/parts"};
  const auto folder = own_file(k_places);
  if (!folder) return {};
  std::error_code error;
  std::vector<std::string> parts;
  for (const auto& entry : fs::directory_iterator(*folder, error))
    if (entry.path().extension() == ".stl") parts.push_back(entry.path().string());
  std::sort(parts.begin(), parts.end());
  return parts;
}

std::string open_documentation() {
  constexpr const char* k_places[] = {"../share/doc/moldlight/html/index.html"};
  const auto page = own_file(k_places);
  if (!page) return "The documentation is not installed; its sources are in docs/";
  const bool desktop = std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
  if (desktop && open_on_desktop(page->string())) return "The documentation opens in the browser";
  return fmt::format("The documentation is {}", page->string());
}

fs::path pictures_folder() {
  std::error_code ignored;
  const char* const named = std::getenv("XDG_PICTURES_DIR");
  if (named != nullptr && fs::is_directory(named, ignored)) return named;
  const char* const home = std::getenv("HOME");
  if (home == nullptr || !fs::is_directory(home, ignored)) return fs::current_path(ignored);
  const fs::path pictures = fs::path(home) / "Pictures";
  return fs::is_directory(pictures, ignored) ? pictures : fs::path(home);
}

std::string free_name(const fs::path& folder, const std::string& stem) {
  std::error_code ignored;
  for (int number = 1;; ++number) {
    const fs::path path = folder / fmt::format("{}-{:02}.png", stem, number);
    if (!fs::exists(path, ignored)) return path.string();
  }
}

void write_picture(const std::string& path, const glm::ivec2& size, std::vector<std::uint8_t> rgba) {
  for (std::size_t alpha = 3; alpha < rgba.size(); alpha += 4) rgba[alpha] = 255;
  write_png(path, {.width = size.x, .height = size.y, .rgba = std::move(rgba)});
}

}  // namespace moldlight::gui
