#include "support/shared_parts.hpp"

#include <cstdlib>

namespace moldlight::test {

namespace fs = std::filesystem;

std::optional<fs::path> shared_folder() {
  const char* named = std::getenv("MOLDLIGHT_SHARED");
  const fs::path folder =
      named != nullptr ? fs::path(named) : fs::path(MOLDLIGHT_SOURCE_DIR) / ".." / "shared";
  if (!fs::is_directory(folder / "parts")) return std::nullopt;
  return fs::weakly_canonical(folder);
}

fs::path data_folder() { return fs::path(MOLDLIGHT_SOURCE_DIR) / "tests" / "data"; }

fs::path asset_folder() { return fs::path(MOLDLIGHT_SOURCE_DIR) / "assets"; }

}  // namespace moldlight::test
