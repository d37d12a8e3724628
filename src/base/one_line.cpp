#include "base/one_line.hpp"

#include <algorithm>

#include "base/shown_text.hpp"

namespace moldlight {

std::string one_line(std::string_view text) {
  std::string line(text);
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return shown_text(line);
}

}  // namespace moldlight
