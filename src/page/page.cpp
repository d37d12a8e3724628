#include "page/page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.hpp"
#include "io/digest.hpp"
#include "page/html.hpp"
#include "page/page_files.hpp"

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
  std::string text = "\n";
  for (const std::string_view name : frame.scripts) text += page_file(name);
  return text;
}

}  // namespace

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
