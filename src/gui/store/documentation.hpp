// The installed pages of the documentation, opened in the user's browser.
#pragma once

#include <string>

namespace moldlight::gui {

/// What was done, as a sentence: the pages open on the desktop, or where they are, or that there are none.
[[nodiscard]] std::string open_documentation();

}  // namespace moldlight::gui
