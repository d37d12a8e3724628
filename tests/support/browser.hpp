// A real browser, Chromium without a window, that tests look at pages with; where it is not installed they
// skip.
#pragma once

#include <string>
#include <vector>

#include "io/png.hpp"

namespace moldlight::test {

[[nodiscard]] bool has_browser();

struct LoadedPage {
  std::string dom;                    // once its scripts have run
  std::vector<std::string> messages;  // of its console
  std::size_t requests = 0;           // over a network
};
/// Loads a page from a file, with `#fragment`. `flags` are the browser's.
[[nodiscard]] LoadedPage load_page(const std::string& file, const std::string& fragment,
                                   const std::vector<std::string>& flags = {});

/// What the page shows in a window of this size, px.
[[nodiscard]] Image picture_of_page(const std::string& file, int width, int height);

/// Prints the page to a PDF.
void print_page(const std::string& file, const std::string& pdf);

}  // namespace moldlight::test
