// What goes into a page, made harmless: text, data, pictures and addresses from wherever they come.
#pragma once

#include <string>
#include <string_view>

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

}  // namespace moldlight::page
