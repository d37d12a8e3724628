// A sheet of pictures of one part, each with its figures below it.
#pragma once

#include <string>
#include <vector>

#include "base/image.hpp"
#include "mold/region.hpp"

namespace moldlight {

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
