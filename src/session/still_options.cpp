#include "session/still_options.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace moldlight {

std::span<const Option<StillSettings>> still_options() {
  using S = StillSettings;
  static const std::vector<Option<S>> k_options = {
      {"view", "--view", "View", "",
       "From where the picture shows the part; auto looks where undercuts show best, with the parting "
       "direction upward.",
       choice<&S::view>({"auto", "iso", "front", "back", "left", "right", "top", "bottom"})},
      {"theme", "--theme", "Theme", "", "Whether the picture's background is light or dark.",
       choice<&S::theme>({"dark", "light"})},
      {"palette", "--palette", "Palette", "",
       "The paper's colours, or a set that colour-blind eyes tell apart.",
       choice<&S::palette>({"paper", "safe"})},
  };
  return k_options;
}

glm::ivec2 parse_picture_size(std::string_view text, std::string_view what) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) {
    throw UsageError(
        fmt::format("{}: '{}' is no size; write width and height in pixels as 1600x1000", what, text));
  }
  const glm::ivec2 size(parse_integer(text.substr(0, cross), what),
                        parse_integer(text.substr(cross + 1), what));
  validate(StillSettings{.size = size});
  return size;
}

}  // namespace moldlight
