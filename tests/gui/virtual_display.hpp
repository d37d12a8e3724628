// An X display of its own (Xvfb) for a test, with a window manager (openbox) where one is installed, and the
// tools that act on it as a user would (xdotool, import).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "support/process.hpp"

namespace moldlight::gui::test {

/// Every wait ends after a minute or two with an exception.
class VirtualDisplay {
 public:
  /// What of Xvfb, xdotool, xrdb, import is not installed; empty if all is there.
  [[nodiscard]] static std::string missing();

  explicit VirtualDisplay(const glm::ivec2& screen);
  /// The window manager that runs there; empty where none is installed.
  [[nodiscard]] std::string manager() const { return manager_ ? "openbox" : ""; }
  /// Environment of programs that are to show their windows there, drawn in software.
  [[nodiscard]] const std::vector<std::string>& environment() const { return environment_; }
  /// The resource by which desktops show the content scale; for programs started afterwards.
  void set_dots_per_inch(int dpi, const std::string& scratch_file) const;

  /// Waits for a visible window with this in its title; gives its number.
  [[nodiscard]] std::string find_window(const std::string& title) const;
  /// Runs xdotool; gives its output.
  [[nodiscard]] std::string act(const std::vector<std::string>& arguments) const;
  [[nodiscard]] glm::ivec2 size_of(const std::string& window) const;
  [[nodiscard]] Image picture_of(const std::string& window) const;
  /// The picture once it has been the same for a while.
  [[nodiscard]] Image settled_picture_of(const std::string& window) const;

 private:
  [[nodiscard]] std::string run(const std::vector<std::string>& arguments) const;

  std::unique_ptr<moldlight::test::Process> server_, manager_;
  std::vector<std::string> environment_;
};

/// Number of different colours.
[[nodiscard]] std::size_t colours_of(const Image& image);

}  // namespace moldlight::gui::test
