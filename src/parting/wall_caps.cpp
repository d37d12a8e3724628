#include "parting/wall_caps.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr double k_reach = 2.0;         // lateral tolerances
constexpr double k_same_height = 1e-6;  // of the diagonal
constexpr double k_cell = 4.0;          // reaches, and at least this share of the diagonal:
constexpr double k_least_cell = 1e-3;
constexpr std::uint8_t k_by_core = 1, k_by_cavity = 2, k_by_both = 3;

}  // namespace

WallCaps::WallCaps(const Assignment& sides, const PartingLine& line, const SheetFrame& frame)
    : frame_(frame),
      cut_height_(sides.height),
      reach_(k_reach * sides.lateral / frame.diagonal),
      cell_(std::max(k_cell * reach_, k_least_cell)) {
  for (PieceIndex piece = 0; piece < sides.mesh.pieces.size(); ++piece) {
    const FacetIndex facet = sides.mesh.pieces[piece].facet;
    if (facet >= formers_.size()) formers_.resize(facet + 1, 0);
    if (sides.sides[piece] == MoldSide::core) formers_[facet] |= k_by_core;
    if (sides.sides[piece] == MoldSide::cavity) formers_[facet] |= k_by_cavity;
  }
  for (const PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action || loop.climb() > k_planar_share * frame.diagonal) continue;
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      add({glm::dvec2(frame.in_mold(loop.points[k])),
           glm::dvec2(frame.in_mold(loop.points[(k + 1) % loop.points.size()])), in_sheets(loop.low),
           in_sheets(loop.high)});
  }
}

double WallCaps::in_sheets(double height) const {
  return (height - glm::dot(frame_.centre, frame_.frame.z)) / frame_.diagonal;
}

WallCaps::Cell WallCaps::cell_of(const glm::dvec2& at) const {
  const glm::dvec2 cell = glm::floor(at / cell_);
  return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y)};
}

void WallCaps::add(const Piece& piece) {
  const auto number = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back(piece);
  // Points so close that a cell about each of them has all that is within reach in one of its corners' cells.
  const double apart = 0.25 * cell_, around = reach_ + 0.5 * apart;
  const auto steps = static_cast<int>(std::ceil(glm::distance(piece.from, piece.to) / apart));
  for (int step = 0; step <= steps; ++step) {
    const glm::dvec2 at = glm::mix(piece.from, piece.to, steps > 0 ? static_cast<double>(step) / steps : 0.0);
    for (const glm::dvec2& off :
         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)}) {
      std::vector<std::uint32_t>& here = near_[cell_of(at + around * off)];
      if (here.empty() || here.back() != number) here.push_back(number);
    }
  }
}

std::optional<double> WallCaps::height_at(const glm::dvec2& at, Sheet sheet) const {
  const auto found = near_.find(cell_of(at));
  if (found == near_.end()) return std::nullopt;
  std::optional<double> height;
  double nearest = reach_;
  for (const std::uint32_t k : found->second) {
    const auto& [from, to, low, high] = pieces_[k];
    const glm::dvec2 way = to - from;
    const double squared = glm::dot(way, way);
    const double share = squared > 0.0 ? glm::clamp(glm::dot(at - from, way) / squared, 0.0, 1.0) : 0.0;
    const double distance = glm::distance(at, from + share * way);
    if (distance >= nearest) continue;
    nearest = distance;
    height = sheet == Sheet::lower ? low : high;
  }
  return height;
}

SplitMesh WallCaps::cut(const SplitMesh& split) const {
  SplitMesh cut = split;
  std::vector<std::uint8_t> former;
  for (const SplitPiece& piece : cut.pieces)
    former.push_back(piece.facet < formers_.size() ? formers_[piece.facet] : std::uint8_t{0});
  cut_at_height(cut, former,
                {.direction = frame_.frame.z,
                 .height = cut_height_,
                 .tolerance = k_same_height * frame_.diagonal,
                 .least = k_by_both});
  return cut;
}

std::optional<double> WallCaps::height(FacetIndex facet, Sheet sheet,
                                       const std::array<glm::dvec3, 3>& corners) const {
  if (facet >= formers_.size() || (sheet != Sheet::upper && sheet != Sheet::lower)) return std::nullopt;
  const auto& [a, b, c] = corners;
  std::uint8_t former = formers_[facet];
  if (former == k_by_both)
    former = (a.z + b.z + c.z) / 3.0 > in_sheets(cut_height_) ? k_by_core : k_by_cavity;
  if ((former & (sheet == Sheet::upper ? k_by_core : k_by_cavity)) != 0) return std::nullopt;
  const double sense = sheet == Sheet::lower ? 1.0 : -1.0;
  std::optional<double> height;
  for (const glm::dvec3& corner : corners) {
    const std::optional<double> here = height_at(glm::dvec2(corner), sheet);
    if (!here || (height && std::abs(*here - *height) > k_same_height) ||
        sense * (corner.z - *here) < -k_same_height)
      return std::nullopt;
    if (!height) height = here;
  }
  return height;
}

}  // namespace moldlight
