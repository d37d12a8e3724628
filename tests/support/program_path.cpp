#include "support/program_path.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace moldlight::test {

std::string program_path(std::initializer_list<const char*> names) {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(list, folder, ':');) {
    for (const char* name : names) {
      const std::filesystem::path path = std::filesystem::path(folder) / name;
      std::error_code error;
      if (std::filesystem::is_regular_file(path, error)) return path.string();
    }
  }
  return {};
}

}  // namespace moldlight::test
