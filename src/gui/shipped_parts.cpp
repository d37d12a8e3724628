#include "gui/shipped_parts.hpp"

#include <algorithm>
#include <filesystem>

namespace moldlight::gui {

namespace fs = std::filesystem;

std::vector<std::string> shipped_parts() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<fs::path> folders = {program / "../share/moldlight/parts"};
  // A program that was built but not installed stands some folders below the source tree.
  for (fs::path folder = program; folder.has_relative_path(); folder = folder.parent_path()) {
    folders.push_back(folder / "assets/parts");
  }
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder, error)) continue;
    std::vector<std::string> parts;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".stl")
        parts.push_back(fs::weakly_canonical(entry.path(), error).string());
    }
    std::sort(parts.begin(), parts.end());
    if (!parts.empty()) return parts;
  }
  return {};
}

}  // namespace moldlight::gui
