// A window for tests that look at no final picture.
#pragma once

#include "replay/offscreen.hpp"

namespace moldlight::gui::test {

/// Its pictures are refined as all are, but soon final: most of a test's time goes into them on the software
/// GL.
inline OffscreenOptions quick_options() {
  OffscreenOptions options;
  options.picture_samples = 2;
  return options;
}

}  // namespace moldlight::gui::test
