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

WallCaps::WallCaps(const PartModel& model, const MoldLine& line, const SheetFrame& frame)
    : formers_(model.part.mesh.facets.size(), 0),
      direction_(line.assignment.direction),
      cut_height_(line.assignment.height),
      cut_tolerance_(k_same_height * frame.diagonal),
      cut_at_((line.assignment.height - glm::dot(frame.centre, direction_)) / frame.diagonal),
      reach_(k_reach * line.assignment.lateral / frame.diagonal),
      cell_(std::max(k_cell * reach_, k_least_cell)) {
  const Assignment& assignment = line.assignment;
  for (PieceIndex piece = 0; piece < assignment.mesh.pieces.size(); ++piece) {
    std::uint8_t& former = formers_[assignment.mesh.pieces[piece].facet];
    if (assignment.sides[piece] == MoldSide::core) former |= k_by_core;
    if (assignment.sides[piece] == MoldSide::cavity) former |= k_by_cavity;
  }
  const double middle = glm::dot(frame.centre, direction_);
  for (const PartingLoop& loop : line.line.loops) {
    if (loop.kind == LoopKind::action || loop.climb() > k_planar_share * frame.diagonal) continue;
    const auto in_sheets = [&](double height) { return (height - middle) / frame.diagonal; };
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      add({glm::dvec2(frame.in_mold(loop.points[k])),
           glm::dvec2(frame.in_mold(loop.points[(k + 1) % loop.points.size()])), in_sheets(loop.low),
           in_sheets(loop.high)});
  }
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
  cut_at_height(
      cut, former,
      {.direction = direction_, .height = cut_height_, .tolerance = cut_tolerance_, .least = k_by_both});
  return cut;
}

std::optional<double> WallCaps::height(FacetIndex facet, Sheet sheet,
                                       const std::array<glm::dvec3, 3>& corners) const {
  if (facet >= formers_.size() || (sheet != Sheet::upper && sheet != Sheet::lower)) return std::nullopt;
  const auto& [a, b, c] = corners;
  std::uint8_t former = formers_[facet];
  if (former == k_by_both) former = (a.z + b.z + c.z) / 3.0 > cut_at_ ? k_by_core : k_by_cavity;
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
