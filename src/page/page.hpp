// A page in one file, for a browser without a network: its head with style and policy, and its end with the
// script. The policy (a Content-Security-Policy in the page itself) lets the page's own style and script run,
// by their SHA-256, and nothing else; nothing is loaded from anywhere. Text, data, pictures and addresses
// that go into it are made harmless.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/image.hpp"

namespace moldlight::page {

/// Text as the content of an element or as an attribute's value in double quotes. Bytes that are no UTF-8,
/// and control characters but for line ends and tabs, become U+FFFD.
[[nodiscard]] std::string html_text(std::string_view text);

/// JSON, in ASCII, that may stand in a script element: nothing in it ends one or begins a comment.
[[nodiscard]] std::string script_json(const nlohmann::ordered_json& json);

/// A script element that a browser does not run but keeps as data.
[[nodiscard]] std::string data_block(std::string_view id, const nlohmann::ordered_json& json);

/// A path as part of an address.
[[nodiscard]] std::string url_of(std::string_view path);

[[nodiscard]] std::string base64(std::string_view bytes);

/// The address of a picture that is in the page itself, a PNG.
[[nodiscard]] std::string picture_url(const Image& image);

struct PageFrame {
  std::string title;
  // Names of embedded files: the style comes after common.css, the scripts after common.js, as one.
  std::string_view style;
  std::vector<std::string_view> scripts;
  bool pictures_beside = false;  // whether pictures that lie beside the page may be shown
};

/// Up to where the body's content begins.
[[nodiscard]] std::string page_begin(const PageFrame& frame);
/// From where it ends.
[[nodiscard]] std::string page_end(const PageFrame& frame);

/// Styles and scripts: the files of page/files, embedded at build time.
struct PageFile {
  std::string_view name, text;
};

[[nodiscard]] std::span<const PageFile> page_files();
/// The text of the file of this name, which must be there.
[[nodiscard]] std::string_view page_file(std::string_view name);

}  // namespace moldlight::page
