// Text of several lines as one.
#pragma once

#include <string>
#include <string_view>

namespace moldlight {

/// As shown_text() has it, with blanks for line ends and tabs.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace moldlight
