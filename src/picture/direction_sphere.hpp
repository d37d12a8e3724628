// The picture of a sweep: the map of the parting directions beside its colour bar and the best directions.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "mold/region.hpp"
#include "picture/sphere_map.hpp"

namespace moldlight {

/// Figures that a row has room for; the last may be a long one.
inline constexpr std::size_t k_sphere_columns = 4;

/// A listed direction; texts are ready to be shown.
struct SphereRow {
  SphereMark mark;
  double undercut = 0.0;  // for its colour
  std::string number = {}, tie = {};
  std::array<std::string, 3> direction = {};
  std::array<std::string, k_sphere_columns> figures = {};
  std::vector<std::string> reasons = {};  // the same in ever fewer words; the first that fits is shown
};

struct SphereContent {
  std::string title = {};
  std::vector<std::string> lines = {};  // below the title
  std::string unit = {};                // of areas
  double total_area = 0.0;              // of the part, for the per cents on the colour bar
  std::array<std::string, k_sphere_columns> headings = {};
  std::vector<SphereRow> rows = {};  // best first
  std::vector<SphereCap> open = {};  // what a proof left open
  std::string note = {};             // where there are no rows
};

/// Opaque, of `size` pixels; drawn for 1600 by 1000 and scaled to others. `palette` of the style is not used:
/// the colours of undercut areas are for every eye.
[[nodiscard]] Image direction_sphere_picture(const glm::ivec2& size, const UndercutField& field,
                                             const SphereContent& content, bool dark);

/// Round values from 0 to `worst` for the colour bar, far enough from each other on its scale.
[[nodiscard]] std::vector<double> scale_ticks(double worst);

/// Pixels of a tile's picture at scale 1.
inline constexpr int k_tile_width = 448, k_tile_height = 336;

/// A figure and its name, shown below one another.
struct NamedFigure {
  std::string name, value;
};

struct ContactTile {
  Image picture = {};                                  // k_tile_width by k_tile_height times the scale
  std::string number = {}, heading = {}, remark = {};  // in one line; the remark at its end
  std::vector<NamedFigure> figures = {};               // a row of columns
  std::vector<std::string> reasons = {};  // a last line, in ever fewer words; the first that fits is shown
};

struct ContactSheet {
  std::string title = {}, line = {};
  std::vector<ContactTile> tiles = {};
  bool dark = false;
  Palette palette = Palette::paper;
};

/// Opaque; as large as its tiles need.
[[nodiscard]] Image contact_sheet_picture(const ContactSheet& sheet, double scale);

/// Columns for so many tiles: as few empty places as there can be on a sheet that is wider than high.
[[nodiscard]] std::size_t sheet_columns(std::size_t tiles);

}  // namespace moldlight
