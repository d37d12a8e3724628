// What to do where no window can be opened.
#pragma once

namespace moldlight::gui {

inline constexpr const char* k_headless_advice =
    "without a display use moldlight classify or moldlight view PART --screenshot OUT.png";

}  // namespace moldlight::gui
