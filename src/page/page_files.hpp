// The styles and scripts of pages: the files of page/files, embedded at build time.
#pragma once

#include <span>
#include <string_view>

namespace moldlight::page {

struct PageFile {
  std::string_view name, text;
};

[[nodiscard]] std::span<const PageFile> page_files();
/// The text of the file of this name, which must be there.
[[nodiscard]] std::string_view page_file(std::string_view name);

}  // namespace moldlight::page
