#include "page/page.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/check.hpp"
#include "base/shown_text.hpp"
#include "io/file_contents.hpp"
#include "io/png.hpp"

namespace moldlight::page {

namespace {

/// As a policy names what may run.
std::string hash_of(std::string_view text) {
  const Digest digest = digest_of(text);
  return "'sha256-" + base64({reinterpret_cast<const char*>(digest.data()), digest.size()}) + "'";
}

std::string style_of(const PageFrame& frame) {
  return fmt::format("\n{}{}", page_file("common.css"), page_file(frame.style));
}

std::string script_of(const PageFrame& frame) {
  std::string text = fmt::format("\n{}", page_file("common.js"));
  for (const std::string_view name : frame.scripts) text += page_file(name);
  return text;
}

}  // namespace

using Json = nlohmann::ordered_json;

std::string html_text(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (const char32_t letter : letters_of(text)) {
    switch (letter) {
      case U'&':
        html += "&amp;";
        break;
      case U'<':
        html += "&lt;";
        break;
      case U'>':
        html += "&gt;";
        break;
      case U'"':
        html += "&quot;";
        break;
      case U'\'':
        html += "&#39;";
        break;
      default: {
        const bool obeyed = is_command_letter(letter) && letter != U'\n' && letter != U'\t';
        html += obeyed ? letter_escape(letter) : utf8_of(std::u32string(1, letter));
      }
    }
  }
  return html;
}

std::string script_json(const Json& json) {
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t k = text.find('<'); k != std::string::npos; k = text.find('<', k))
    text.replace(k, 1, "\\u003c");
  return text;
}

std::string data_block(std::string_view id, const Json& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, script_json(json));
}

std::string url_of(std::string_view path) {
  std::string url;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8 | (i < count ? static_cast<unsigned char>(bytes[k + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= count ? k_digits[group >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

// Colours in steps of 4 look the same, and take three quarters of the bytes.
std::string picture_url(const Image& image) {
  Image coarse = image;
  for (std::size_t k = 0; k < coarse.rgba.size(); ++k)
    if (k % 4 != 3)
      coarse.rgba[k] = static_cast<std::uint8_t>(coarse.rgba[k] >= 254 ? 255 : (coarse.rgba[k] + 2) / 4 * 4);
  return "data:image/png;base64," + base64(png_bytes(coarse));
}

std::string_view page_file(std::string_view name) {
  const auto found = std::ranges::find(page_files(), name, &PageFile::name);
  CHECK(found != page_files().end());
  return found->text;
}

std::string page_begin(const PageFrame& frame) {
  const std::string style = style_of(frame);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:{}; "
      "style-src {}; script-src {}; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<meta name=\"referrer\" content=\"no-referrer\">\n"
      "<title>{}</title>\n<style>{}</style></head>\n<body>\n",
      frame.pictures_beside ? " 'self' file:" : "", hash_of(style), hash_of(script_of(frame)),
      html_text(frame.title), style);
}

std::string page_end(const PageFrame& frame) {
  return fmt::format("<script>{}</script>\n</body></html>\n", script_of(frame));
}

}  // namespace moldlight::page
