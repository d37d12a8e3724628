#include "base/own_files.hpp"

#include <vector>

#include <dlfcn.h>

namespace moldlight {

namespace fs = std::filesystem;

std::optional<fs::path> own_file(std::span<const char* const> places) {
  static constexpr char k_in_this_library = 0;
  std::error_code ignored;
  std::vector<fs::path> folders;
  // A module first: beside the program that loads it another version may be installed. Of the program itself
  // the name may be relative, and says nothing.
  Dl_info own = {};
  if (::dladdr(&k_in_this_library, &own) != 0 && own.dli_fname != nullptr && own.dli_fname[0] == '/')
    folders.push_back(fs::path(own.dli_fname).parent_path());
  folders.push_back(fs::read_symlink("/proc/self/exe", ignored).parent_path());
  for (const fs::path& folder : folders)
    for (const char* place : places)
      if (fs::exists(folder / place, ignored)) return fs::weakly_canonical(folder / place, ignored);
  return std::nullopt;
}

}  // namespace moldlight
