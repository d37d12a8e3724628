#include "parting/draft/draft_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/faces.hpp"
#include "mold/draft.hpp"

namespace moldlight {

namespace {

constexpr double k_bin_deg = 0.5, k_binned_deg = 10.0;  // bins are wide beyond that
/// Of a wall's area, by which it is not turned.
constexpr double k_sliver_share = 0.01;
/// A wall whose normals differ by more has no straight foot.
constexpr double k_straight_deg = 0.5;

std::vector<DraftBin> empty_bins() {
  std::vector<DraftBin> bins = {{-90.0, -k_binned_deg, {}}};
  const int count = static_cast<int>(2.0 * k_binned_deg / k_bin_deg);
  for (int k = 0; k < count; ++k)
    bins.push_back({-k_binned_deg + k * k_bin_deg, -k_binned_deg + (k + 1) * k_bin_deg, {}});
  bins.push_back({k_binned_deg, 90.0, {}});
  return bins;
}

DraftBin& bin_of(std::vector<DraftBin>& bins, double draft_deg) {
  const double from_first = (draft_deg + k_draft_rounding_deg + k_binned_deg) / k_bin_deg;
  const double last = static_cast<double>(bins.size() - 1);
  return bins[static_cast<std::size_t>(std::clamp(std::floor(from_first) + 1.0, 0.0, last))];
}

/// What one half forms of a face with too little draft, piece by piece.
struct Shallow {
  struct Piece {
    PieceIndex piece;
    double area, draft_deg;
  };
  std::vector<Piece> pieces;
  double area = 0.0;

  /// What all but slivers of it have: those that stitch a round wall to others lean by chance.
  [[nodiscard]] double draft_deg() const {
    std::vector<Piece> rising = pieces;
    std::ranges::sort(rising, {}, &Piece::draft_deg);
    double passed = 0.0;
    const auto first = std::ranges::find_if(
        rising, [&](const Piece& each) { return (passed += each.area) > k_sliver_share * area; });
    return first == rising.end() ? rising.back().draft_deg : first->draft_deg;
  }
};

WallDraft wall_of(const PartModel& model, const Assignment& assignment, const Shallow& shallow, MoldSide side,
                  double required_deg) {
  const glm::dvec3& d = assignment.direction;
  const double outward = side == MoldSide::core ? 1.0 : -1.0;  // along which the half leaves
  WallDraft wall;
  wall.side = side;
  wall.area = shallow.area;
  wall.least_deg = std::ranges::min(shallow.pieces, {}, &Shallow::Piece::draft_deg).draft_deg;
  double low = INFINITY, high = -INFINITY;
  glm::dvec3 sum(0.0);
  for (const Shallow::Piece& each : shallow.pieces) {
    sum += twice_piece_area(assignment.mesh, each.piece);
    for (const VertexIndex corner : assignment.mesh.pieces[each.piece].corners) {
      const double height = outward * glm::dot(assignment.mesh.vertices[corner], d);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  wall.height = high - low;
  wall.foot = outward * low;
  const double draft = shallow.draft_deg();
  wall.turn_deg = required_deg - draft;
  wall.thickness = wall.height * (std::tan(glm::radians(required_deg)) - std::tan(glm::radians(draft)));

  const double cosine = std::cos(glm::radians(k_straight_deg)), size = glm::length(sum);
  const glm::dvec3 normal = size > 0.0 ? sum / size : d, along = glm::cross(d, normal);
  const bool straight =
      glm::length(along) > 0.5 && std::ranges::all_of(shallow.pieces, [&](const Shallow::Piece& each) {
        return glm::dot(model.geometry.normals[assignment.mesh.pieces[each.piece].facet], normal) >= cosine;
      });
  if (!straight) return wall;
  // The line in which the wall's plane meets the level of the foot.
  const glm::dvec3 line = glm::normalize(along), up = outward * glm::cross(normal, line);
  const glm::dvec3& anchor =
      assignment.mesh.vertices[assignment.mesh.pieces[shallow.pieces.front().piece].corners[0]];
  const double climb = glm::dot(up, d) * outward;
  const glm::dvec3 on_foot =
      anchor + up * ((low - outward * glm::dot(anchor, d)) / (std::abs(climb) > 0.5 ? climb : 1.0));
  double first = INFINITY, last = -INFINITY;
  for (const Shallow::Piece& each : shallow.pieces) {
    for (const VertexIndex corner : assignment.mesh.pieces[each.piece].corners) {
      const double place = glm::dot(assignment.mesh.vertices[corner] - on_foot, line);
      first = std::min(first, place);
      last = std::max(last, place);
    }
  }
  wall.foot_line = {on_foot + first * line, on_foot + last * line};
  return wall;
}

}  // namespace

std::span<const Option<DraftSettings>> draft_options() {
  using S = DraftSettings;
  static const std::vector<Option<S>> k_options = {
      {"required_draft_deg", "--required-draft", "Required draft of each half", "deg",
       "Report the walls with less draft than this, the reverse draft, and the thickness that the missing "
       "draft costs.",
       PositiveKind<S>{[](S& s) -> double& { return s.required_deg; }, k_most_required_deg}},
  };
  return k_options;
}

DraftCheck check_draft(const PartModel& model, const Assignment& assignment, const ReverseDraft& reverse,
                       double required_deg) {
  DraftCheck check;
  check.required_deg = required_deg;
  check.reverse = reverse;
  check.histogram = empty_bins();
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  std::map<std::pair<std::uint32_t, MoldSide>, Shallow> shallow;
  for (PieceIndex k = 0; k < assignment.sides.size(); ++k) {
    const MoldSide side = assignment.sides[k];
    if (side == MoldSide::action) continue;
    const auto half = static_cast<std::size_t>(side);
    const FacetIndex facet = assignment.mesh.pieces[k].facet;
    const double upward = draft_angle_deg(model.geometry.normals[facet], assignment.direction);
    const double draft = side == MoldSide::core ? upward : -upward;
    const double area = 0.5 * glm::length(twice_piece_area(assignment.mesh, k));
    if (area <= 0.0) continue;
    bin_of(check.histogram, draft).area[half] += area;
    if (draft >= required_deg - k_draft_rounding_deg) continue;
    check.below[half] += area;
    Shallow& face = shallow[{faces.of_facet[facet], side}];
    face.pieces.push_back({k, area, draft});
    face.area += area;
  }
  for (const auto& [key, face] : shallow) {
    ++check.faces_below[static_cast<std::size_t>(key.second)];
    check.walls.push_back(wall_of(model, assignment, face, key.second, required_deg));
    check.walls.back().face = key.first;
  }
  std::ranges::stable_sort(check.walls, std::greater(), &WallDraft::thickness);
  return check;
}

}  // namespace moldlight
