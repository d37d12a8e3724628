#include "session/still_options.hpp"

#include <charconv>

#include <fmt/format.h>
#include <glm/vector_relational.hpp>

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
      {"regions", "--regions", "Regions by", "",
       "What the picture's regions are: exact, or as the shadow maps of these settings show them.",
       choice<&S::regions_by>({"exact", "maps"})},
      {"mark_difference", "--mark-difference", "Mark difference", "",
       "Hatch the surface on which the shadow maps and the exact regions differ.",
       SwitchKind<S>{&S::mark_difference}},
  };
  return k_options;
}

glm::ivec2 parse_picture_size(std::string_view text, std::string_view what, const glm::ivec2& least) {
  glm::ivec2 size(0);
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.x);
  const bool has_cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_cross ? std::from_chars(width.ptr + 1, end, size.y) : width;
  if (!has_cross || height.ec != std::errc() || height.ptr != end) {
    throw UsageError(fmt::format("{}: '{}' is not WIDTHxHEIGHT, such as 1280x720", what, text));
  }
  if (glm::any(glm::lessThan(size, least)) ||
      glm::any(glm::greaterThan(size, glm::ivec2(k_most_picture_px)))) {
    throw UsageError(fmt::format("{}: '{}' is out of range, {}x{} to {}x{} pixels", what, text, least.x,
                                 least.y, k_most_picture_px, k_most_picture_px));
  }
  return size;
}

}  // namespace moldlight
