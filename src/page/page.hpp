// A page in one file, for a browser without a network: its head with style and policy, and its end with the
// script. The policy (a Content-Security-Policy in the page itself) lets the page's own style and script run,
// by their SHA-256, and nothing else; nothing is loaded from anywhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moldlight::page {

struct PageFrame {
  std::string title;
  // Names of embedded files: the style comes after common.css, the scripts after each other, as one.
  std::string_view style;
  std::vector<std::string_view> scripts;
  bool pictures_beside = false;  // whether pictures that lie beside the page may be shown
};

/// Up to where the body's content begins.
[[nodiscard]] std::string page_begin(const PageFrame& frame);
/// From where it ends.
[[nodiscard]] std::string page_end(const PageFrame& frame);

}  // namespace moldlight::page
