// Where walls lean back from the half that forms them, or stand out above an opening, by a hair: what would
// be a fin of the other half is left to the part, so that the halves meet where the line runs.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "classify/part_model.hpp"
#include "parting/halves/sheets.hpp"
#include "parting/loops.hpp"
#include "parting/sheet_frame.hpp"

namespace moldlight {

/// CAD programs make facets of round walls that lean a little to either side, where a hole runs into them or
/// their ends are divided otherwise. Seen along the direction such walls are no wider than twice the lateral
/// tolerance. Beside a loop of the parting line that lies in one plane they are formed by the half that the
/// line gives them to: from the other side the part ends at the loop's height.
class WallCaps {
 public:
  /// The sides that the line divides.
  WallCaps(const Assignment& sides, const PartingLine& line, const SheetFrame& frame);

  /// The split mesh with facets that both halves form cut at the line's height.
  [[nodiscard]] SplitMesh cut(const SplitMesh& split) const;
  /// The height in the sheets' frame at which the part ends in place of a piece that one half sees: of this
  /// facet, with these corners; none where it is the half's own.
  [[nodiscard]] std::optional<double> height(FacetIndex facet, Sheet sheet,
                                             const std::array<glm::dvec3, 3>& corners) const;

 private:
  struct Piece {
    glm::dvec2 from{0.0}, to{0.0};
    double low = 0.0, high = 0.0;  // of its loop
  };
  using Cell = std::pair<std::int64_t, std::int64_t>;
  [[nodiscard]] double in_sheets(double height) const;
  [[nodiscard]] Cell cell_of(const glm::dvec2& at) const;
  void add(const Piece& piece);
  [[nodiscard]] std::optional<double> height_at(const glm::dvec2& at, Sheet sheet) const;

  std::vector<std::uint8_t> formers_;  // of each facet: bits of the halves
  SheetFrame frame_;
  double cut_height_ = 0.0;          // along the direction, in the part's coordinates
  double reach_ = 0.0, cell_ = 0.0;  // twice the lateral tolerance, in diagonals; a cell's side
  std::vector<Piece> pieces_;
  std::map<Cell, std::vector<std::uint32_t>> near_;
};

}  // namespace moldlight
