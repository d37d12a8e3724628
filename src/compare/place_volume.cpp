#include "compare/place_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// Labels that are not apart by then share a cell.
constexpr int k_most_cuts = 128;
constexpr std::size_t k_most_cells = 2000;
/// More labels than this are halved without looking where they are apart.
constexpr std::size_t k_many_labels = 256;

using LabelBounds = std::map<std::uint32_t, Bounds>;

/// Six times the volume of the cone from `apex` over the polygon.
double cone(const ConvexPolygon& polygon, const glm::dvec3& apex) {
  double sum = 0.0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    sum += glm::dot(polygon[0] - apex, glm::cross(polygon[k - 1] - apex, polygon[k] - apex));
  return sum;
}

/// Facets of B with their sense, of A reversed, without those in both: they enclose what came less what went.
void add_facets(const TriangleMesh& a, const TriangleMesh& b, std::vector<CellBit>& bits) {
  using Point = std::array<double, 3>;
  std::map<std::array<Point, 3>, int> counts;
  for (const bool is_of_b : {false, true}) {
    const TriangleMesh& mesh = is_of_b ? b : a;
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      std::array<Point, 3> corners;
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3& at = mesh.corner(facet, k);
        corners[static_cast<std::size_t>(k)] = {at.x, at.y, at.z};
      }
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      counts[corners] += is_of_b ? 1 : -1;
    }
  }
  for (const auto& [corners, count] : counts) {
    ConvexPolygon polygon;
    for (const Point& at : corners) polygon.emplace_back(at[0], at[1], at[2]);
    if (count < 0) std::swap(polygon[1], polygon[2]);
    for (int k = 0; k < std::abs(count); ++k) bits.push_back({CellBit::Kind::facet, polygon});
  }
}

/// Across an axis: what is not above belongs to the lower side.
struct Cut {
  int axis = -1;
  double at = 0.0;
  bool clean = false;  // no label is on both sides
};

glm::dvec3 crossing(const glm::dvec3& a, const glm::dvec3& b, const Cut& cut) {
  const bool rises = a[cut.axis] < b[cut.axis];  // the same from both ends
  const glm::dvec3 &low = rises ? a : b, &high = rises ? b : a;
  glm::dvec3 at = glm::mix(low, high, (cut.at - low[cut.axis]) / (high[cut.axis] - low[cut.axis]));
  at[cut.axis] = cut.at;
  return at;
}

struct Cell {
  std::vector<CellBit> bits;
  std::uint32_t owner = 0;  // whose it is without a label
  bool whole = true;        // no label in it is elsewhere, too
  int cuts = 0;
};

/// What is closed is so on both sides again: triangles from one point of the plane to where facets were cut.
std::array<Cell, 2> cut_cell(Cell cell, const Cut& cut, std::uint32_t owner) {
  const Cell empty{{}, owner, cell.whole && cut.clean, cell.cuts + 1};
  std::array<Cell, 2> sides = {empty, empty};
  std::vector<std::array<glm::dvec3, 2>> rims;  // where facets come up, and go down again
  for (CellBit& bit : cell.bits) {
    const auto is_above = [&](const glm::dvec3& corner) { return corner[cut.axis] > cut.at; };
    const auto above = std::count_if(bit.polygon.begin(), bit.polygon.end(), is_above);
    if (above == 0 || static_cast<std::size_t>(above) == bit.polygon.size()) {
      sides[above == 0 ? 0 : 1].bits.push_back(std::move(bit));
      continue;
    }
    std::array<ConvexPolygon, 2> parts;
    std::array<glm::dvec3, 2> rim{};
    for (std::size_t k = 0; k < bit.polygon.size(); ++k) {
      const glm::dvec3 &a = bit.polygon[k], &b = bit.polygon[(k + 1) % bit.polygon.size()];
      parts[is_above(a) ? 1 : 0].push_back(a);
      if (is_above(a) == is_above(b)) continue;
      const glm::dvec3 at = crossing(a, b, cut);
      for (ConvexPolygon& part : parts) part.push_back(at);
      rim[is_above(a) ? 1 : 0] = at;
    }
    if (bit.kind != CellBit::Kind::changed) rims.push_back(rim);
    for (std::size_t k = 0; k < 2; ++k) sides[k].bits.push_back({bit.kind, parts[k], bit.label});
  }
  for (const auto& [up, down] : rims) {
    const glm::dvec3& foot = rims.front()[0];
    sides[0].bits.push_back({CellBit::Kind::cap, {foot, down, up}});
    sides[1].bits.push_back({CellBit::Kind::cap, {foot, up, down}});
  }
  return sides;
}

/// Beside the end of a label's box, where the fewest labels are on both sides; then where they halve best.
/// Half-way through all where no end parts them.
Cut best_cut(const LabelBounds& labels, double margin) {
  Bounds all;
  for (const auto& one : labels)
    for (const glm::dvec3& corner : {one.second.min, one.second.max}) all.add(corner);
  Cut best;
  const auto count = static_cast<std::ptrdiff_t>(labels.size());
  std::pair<std::ptrdiff_t, std::ptrdiff_t> least = {2 * count, 0};
  const auto look = [&](int axis, double end, bool upper) {
    std::ptrdiff_t low = 0, high = 0;
    double next = all.max[axis];
    for (const auto& one : labels) {
      const double from = one.second.min[axis], to = one.second.max[axis];
      if (upper ? from <= end : from < end) ++low;
      if (upper ? to > end : to >= end) ++high;
      if (from > end) next = std::min(next, from);
    }
    const bool clean = low + high == count;
    if (clean && !upper) return;  // found above the box below
    const double at = clean ? 0.5 * (end + next) : end + (upper ? 0.5 : -0.5) * margin;
    // Else one slice after the other would be cut off beside the same end.
    if (!clean && (at < all.min[axis] + margin || at > all.max[axis] - margin)) return;
    const std::pair cost = {low + high, std::abs(low - high)};
    if (low == 0 || high == 0 || cost >= least) return;
    least = cost;
    best = {axis, at, clean};
  };
  for (int axis = 0; axis < 3 && labels.size() <= k_many_labels; ++axis)
    for (const auto& one : labels) {
      look(axis, one.second.max[axis], true);
      look(axis, one.second.min[axis], false);
    }
  if (best.axis >= 0) return best;
  const glm::dvec3 extent = all.max - all.min;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  return {axis, all.center()[axis], false};
}

class Division {
 public:
  Division(const VolumeQuestion& question, const Progress& progress)
      : question_(question),
        progress_(progress),
        apexes_(question.labels),
        alone_(question.labels, 0.0),
        doubts_(alone_) {
    divided_.of_label.resize(question.labels);
    for (const auto& [label, box] : bounds_of(question.bits)) apexes_[label] = box.center();
  }

  void divide(Cell cell) {
    progress_.report("measuring what changed", 0.0);
    const LabelBounds labels = bounds_of(cell.bits);
    if (labels.empty() && cell.cuts == 0) return add_elsewhere(cell);
    if (labels.empty()) return static_cast<void>(add(cell, cell.owner));
    if (labels.size() == 1) return add_label(std::move(cell), labels.begin()->first, labels.begin()->second);
    Bounds widest;
    std::uint32_t owner = 0;
    for (const auto& [label, box] : labels) {
      if (box.diagonal() >= widest.diagonal()) owner = label;
      for (const glm::dvec3& corner : {box.min, box.max}) widest.add(corner);
    }
    if (cell.cuts < k_most_cuts && ++cells_ < k_most_cells && widest.diagonal() > question_.margin) {
      for (Cell& side : cut_cell(std::move(cell), best_cut(labels, question_.margin), owner))
        divide(std::move(side));
      return;
    }
    // The first has it all, and each may be off by it.
    const double here = std::abs(add(cell, labels.begin()->first));
    for (const auto& one : labels) divided_.of_label[one.first].error += here;
  }

  [[nodiscard]] DividedVolume result() {
    for (std::uint32_t label = 0; label < question_.labels; ++label) {
      MeasuredVolume& one = divided_.of_label[label];
      divided_.open.push_back(std::abs(one.volume - alone_[label]));
      one.error += divided_.open.back() + std::abs(doubts_[label]);
    }
    return std::move(divided_);
  }

 private:
  [[nodiscard]] static LabelBounds bounds_of(const std::vector<CellBit>& bits) {
    LabelBounds labels;
    for (const CellBit& bit : bits)
      if (bit.kind == CellBit::Kind::changed)
        for (const glm::dvec3& corner : bit.polygon) labels[bit.label].add(corner);
    return labels;
  }

  double add(const Cell& cell, std::uint32_t label) {
    double sum = 0.0;
    for (const CellBit& bit : cell.bits) {
      doubts_[label] += bit.doubt;
      if (bit.kind != CellBit::Kind::facet && bit.kind != CellBit::Kind::cap) continue;
      const double volume = cone(bit.polygon, apexes_[label]) / 6.0;
      sum += volume;
      // Between clean cuts nothing that comes or goes is cut.
      if (bit.kind == CellBit::Kind::facet || cell.whole) alone_[label] += volume;
    }
    divided_.of_label[label].volume += sum;
    return sum;
  }

  void add_elsewhere(const Cell& cell) {
    for (const CellBit& bit : cell.bits)
      if (bit.kind == CellBit::Kind::facet || bit.kind == CellBit::Kind::cap)
        divided_.elsewhere += cone(bit.polygon, cell.bits.front().polygon.front()) / 6.0;
  }

  /// Leaves out what is beside the label's box where that is asked for.
  void add_label(Cell cell, std::uint32_t label, const Bounds& box) {
    const double elsewhere = divided_.elsewhere;
    for (int axis = 0; question_.reach && cell.whole && axis < 3; ++axis) {
      for (const std::size_t upper : {0U, 1U}) {
        const double at = upper == 1 ? box.max[axis] + *question_.reach : box.min[axis] - *question_.reach;
        std::array<Cell, 2> sides = cut_cell(std::move(cell), {axis, at, true}, label);
        add_elsewhere(sides[upper]);
        cell = std::move(sides[1 - upper]);
      }
    }
    divided_.of_label[label].error += std::abs(divided_.elsewhere - elsewhere);
    add(cell, label);
  }

  const VolumeQuestion& question_;
  const Progress& progress_;
  std::vector<glm::dvec3> apexes_;  // of each label's cones
  std::vector<double> alone_, doubts_;
  DividedVolume divided_;
  std::size_t cells_ = 0;
};

}  // namespace

DividedVolume divided_volume(const TriangleMesh& a, const TriangleMesh& b, const VolumeQuestion& question,
                             const Progress& progress) {
  Division division(question, progress);
  Cell whole{question.bits};
  add_facets(a, b, whole.bits);
  division.divide(std::move(whole));
  return division.result();
}

}  // namespace moldlight
