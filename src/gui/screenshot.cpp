#include "gui/screenshot.hpp"

#include "base/error.hpp"
#include "gui/script.hpp"
#include "gui/store/files.hpp"

namespace moldlight::gui {

void take_screenshot(const ScreenshotOptions& options) {
  const Script script = options.script ? parse_script(*options.script) : Script();
  OffscreenWindow window(options.window);
  if (options.notes) window.app().set_notes(*options.notes);
  if (!options.part.empty()) {
    window.app().open(options.part);
    window.wait_until_loaded();
    if (!window.state().model && !window.state().batch) {
      throw Error(window.state().toasts.empty() ? options.part + ": cannot be loaded"
                                                : window.state().toasts.back().text);
    }
    if (!options.compare.empty()) window.app().compare_with(options.compare);
    window.wait_until_measured();
    if (!options.compare.empty() && !window.state().revisions.on())
      throw Error(window.state().toasts.back().text);
    if (window.app().sweeping()) window.wait_until_swept();
  } else {
    window.wait_until_prepared();
  }
  if (options.script) {
    play_script(script, window);
    window.wait_until_measured();
    if (window.app().sweeping()) window.wait_until_swept();
  }
  window.settle();
  write_picture(options.output, window.size(), window.pixels());
}

}  // namespace moldlight::gui
