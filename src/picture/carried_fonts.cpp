#include "picture/carried_fonts.hpp"

#include <cstdlib>
#include <filesystem>
#include <mutex>

#include <fontconfig/fontconfig.h>

#include "base/own_files.hpp"

namespace moldlight {

namespace {

void add_carried_fonts() {
  constexpr const char* k_places[] = {"../lib/moldlight/fonts", "carried/fonts"};
  const auto folder = own_file(k_places);
  if (!folder) return;
  // Where there is no configuration at all, fontconfig complains on stderr unless it is given one.
  std::error_code ignored;
  if (std::getenv("FONTCONFIG_FILE") == nullptr && !std::filesystem::exists("/etc/fonts/fonts.conf", ignored))
    FcConfigSetCurrent(FcConfigCreate());
  // One by one: for a folder it would write a cache, or complain that it cannot.
  for (const auto& font : std::filesystem::directory_iterator(*folder, ignored))
    FcConfigAppFontAddFile(nullptr, reinterpret_cast<const FcChar8*>(font.path().c_str()));
}

}  // namespace

void find_carried_fonts() {
  static std::once_flag once;
  std::call_once(once, add_carried_fonts);
}

}  // namespace moldlight
