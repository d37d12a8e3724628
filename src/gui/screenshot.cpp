#include "gui/screenshot.hpp"

#include "base/error.hpp"
#include "gui/picture_file.hpp"
#include "gui/script.hpp"

namespace moldlight::gui {

void take_screenshot(const ScreenshotOptions& options) {
  OffscreenWindow window(options.window);
  if (options.notes) window.app().set_notes(*options.notes);
  if (!options.part.empty()) {
    window.app().open(options.part);
    window.wait_until_loaded();
    if (!window.state().model) {
      throw Error(window.state().toasts.empty() ? options.part + ": cannot be loaded"
                                                : window.state().toasts.back().text);
    }
    window.wait_until_measured();
  } else {
    window.wait_until_prepared();
  }
  if (!options.script.empty()) {
    play_script(options.script, window);
    window.wait_until_measured();
  }
  window.settle();
  write_picture(options.output, window.size(), window.pixels());
}

}  // namespace moldlight::gui
