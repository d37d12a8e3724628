#include "pieces/piece_solids.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "classify/number_format.hpp"
#include "mesh/facet_geometry.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_report.hpp"
#include "parting/slide_blank.hpp"
#include "pieces/divided_body.hpp"
#include "pieces/piece_words.hpp"

namespace moldlight {

namespace {

/// Shares of a body make up all of it but for so much of the block.
constexpr double k_most_gap = 1e-9;
/// Of a body of which less is held, that share is named.
constexpr double k_near_miss = 0.01;

/// A body between the halves, in the mold's frame, in diagonals of the part.
struct Between {
  TriangleMesh mesh;
  std::size_t number = 0;  // of the halves' inserts
  std::optional<std::size_t> direction;
  double reach = 0.0;  // of its far end along its way
};

bool is_same(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, b) > 1.0 - 1e-12; }

class SolidMaker {
 public:
  SolidMaker(const PartModel& model, const PiecesResult& result, std::size_t along, MoldHalves halves,
             const Progress& progress)
      : model_(model), result_(result), progress_(progress), along_(along) {
    made_.halves = std::move(halves);
    for (const PieceDirection& one : result.directions) made_.directions.push_back(one.direction);
    const glm::dvec3 opposite = glm::dvec3(0.0) - made_.directions[along];
    while (against_ < made_.directions.size() && !is_same(made_.directions[against_], opposite)) ++against_;
    if (against_ == made_.directions.size()) made_.directions.push_back(opposite);
  }

  PieceSolids run() {
    if (halves_are_good()) {
      find_ways();
      order_removal();
      if (little_is_left()) name_all();
    }
    if (!made_.refusal.empty()) made_.solids.clear();
    return std::move(made_);
  }

 private:
  bool refuse(std::string why, std::optional<glm::dvec3> at = std::nullopt) {
    made_.refusal = std::move(why);
    made_.refused_at = at;
    return false;
  }
  [[nodiscard]] glm::dvec3 way_of(std::size_t direction) const {
    return glm::normalize(made_.halves.frame.to_mold(made_.directions[direction]));
  }

  bool halves_are_good() {
    const MoldHalves& halves = made_.halves;
    if (!halves.written.refusal.empty()) return refuse(halves.written.refusal, halves.refused_at);
    const std::vector<std::string> faults = half_faults(model_, halves);
    if (!faults.empty()) return refuse(faults.front());
    for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
      if (halves.inserts[k].crossed_facets > 0)
        return refuse("facets of a body between the halves cross each other by rounding",
                      insert_place(halves, k));
    }
    return true;
  }

  /// For each body between the halves, or share of it, the first direction along which the part does not
  /// stand in its way.
  void find_ways() {
    part_ = in_mold(made_.halves, model_.part.mesh, model_.frame.diagonal);
    DivisionTask task{.part = part_, .ways = {}, .tolerance = result_.query.lateral};
    for (std::size_t d = 0; d < made_.directions.size(); ++d)
      if (d != along_ && d != against_) task.ways.push_back({d, way_of(d)});
    const std::size_t count = made_.halves.inserts.size();
    for (std::size_t k = 0; k < count; ++k) {
      progress_.report("pulling the pieces", static_cast<double>(k) / static_cast<double>(count));
      TriangleMesh whole = unscaled(made_.halves, made_.halves.inserts[k].mesh, model_.frame.diagonal);
      std::vector<BodyShare> shares = divided_body(task, whole, progress_);
      if (shares.size() > 1 && !put_shares(k, shares)) shares = {{std::move(whole), std::nullopt}};
      for (std::size_t share = 0; share < shares.size(); ++share) {
        auto& [mesh, direction] = shares[share];
        const double far = direction ? reach(mesh, way_of(*direction)) : 0.0;
        const std::size_t number = share == 0 ? k : made_.halves.inserts.size() - shares.size() + share;
        between_.push_back({std::move(mesh), number, direction, far});
      }
    }
    // Of one direction that which is nearer to the way out is removed first.
    std::ranges::stable_sort(between_, {}, [](const Between& body) {
      return std::tuple(!body.direction.has_value(), body.direction.value_or(0), -body.reach);
    });
  }

  /// Makes the shares of a body bodies between the halves; false, and nothing changed, where one of them
  /// could not be written.
  bool put_shares(std::size_t insert, std::span<const BodyShare> shares) {
    MoldHalves put = made_.halves;
    const double scale = model_.frame.diagonal * put.scale;
    double more = -put.inserts[insert].volume;
    for (const BodyShare& share : shares) {
      MoldBody body = mold_body(share.mesh, scale);
      more += body.volume;
      const std::size_t number = &share == shares.data() ? insert : put.inserts.size();
      if (!put_body(put, number + 2, std::move(body), k_needle * scale, progress_)) return false;
    }
    put.insert_volume += more;
    put.volume_gap -= more / put.block_volume;
    if (std::abs(more) > k_most_gap * put.block_volume) return false;
    made_.halves = std::move(put);
    return true;
  }

  /// Puts the bodies in an order in which each moves past those that are still there: as they are, but for
  /// those that others have to make way for. Where none of them can, the smallest stays.
  void order_removal() {
    for (auto first = between_.begin(); first != between_.end() && first->direction;) {
      const auto end = std::find_if(first, between_.end(), [](const Between& b) { return !b.direction; });
      auto next = std::find_if(first, end, [&](const Between& body) {
        return std::all_of(first, between_.end(),
                           [&](const Between& other) { return &other == &body || !hits(body, other); });
      });
      if (next != end) {
        std::rotate(first, next, next + 1);
        ++first;
        continue;
      }
      next = std::min_element(first, end, [](const Between& a, const Between& b) {
        return surface_area(a.mesh) < surface_area(b.mesh);
      });
      if (!stuck_) stuck_ = next->direction;
      next->direction.reset();
      std::rotate(next, next + 1, between_.end());
    }
  }
  /// Whether a body that moves out meets another that is still there.
  [[nodiscard]] bool hits(const Between& body, const Between& other) const {
    progress_.report("pulling the pieces", 1.0);
    const Bounds swept = swept_box(body), still = bounds(other.mesh);
    if (glm::any(glm::greaterThan(still.min, swept.max)) || glm::any(glm::lessThan(still.max, swept.min)))
      return false;
    return way_out(body.mesh, other.mesh, way_of(*body.direction)).blocked > result_.query.lateral;
  }

  /// What holds a body all along its way.
  [[nodiscard]] Bounds swept_box(const Between& body) const {
    Bounds box = bounds(body.mesh);
    const glm::dvec3 way = way_of(*body.direction), shift = travel_of(body) * way;
    box.add(box.min + shift);
    box.add(box.max + shift);
    return box;
  }
  /// Until it is clear of the part, in diagonals.
  [[nodiscard]] double travel_of(const Between& body) const {
    const glm::dvec3 way = way_of(*body.direction);
    return std::max(0.0, reach(part_, way) + reach(body.mesh, -way));
  }

  bool little_is_left() {
    double area = 0.0, largest = 0.0;
    std::size_t number = 0;
    const Between* most = nullptr;
    for (const Between& body : between_) {
      if (body.direction) continue;
      ++number;
      const double own = surface_area(body.mesh) * model_.frame.diagonal * model_.frame.diagonal;
      area += own;
      if (own <= largest) continue;
      largest = own;
      most = &body;
    }
    // Half of such a body's surface, at least, lies on the other bodies.
    if (area <= 2.0 * result_.settings.eps * model_.geometry.total_area) return true;
    if (stuck_)
      return refuse(fmt::format("the body that moves along {} would hit one that is removed later",
                                pull_words(made_.directions[*stuck_])),
                    insert_place(made_.halves, most->number));
    return refuse(fmt::format("no single direction releases {} between the halves{}",
                              number == 1 ? "a body" : fmt::format("{} bodies", number), near_miss(*most)),
                  insert_place(made_.halves, most->number));
  }
  /// Walls that coarse facets make lean both ways hold a body on few lines.
  [[nodiscard]] std::string near_miss(const Between& body) const {
    double least = k_near_miss;
    std::size_t direction = made_.directions.size();
    for (std::size_t d = 0; d < made_.directions.size(); ++d) {
      if (d == along_ || d == against_) continue;
      const double share = way_out(body.mesh, part_, way_of(d)).share;
      if (share >= least) continue;
      least = share;
      direction = d;
    }
    if (direction == made_.directions.size()) return {};
    return fmt::format("; along {} only {} of it is held, so a finer mesh may help",
                       pull_words(made_.directions[direction]), share_text(least, 1.0));
  }

  void name_all() {
    MoldHalves& halves = made_.halves;
    made_.solids.resize(halves.written.bodies.size());
    const auto name = [&](std::size_t body, const std::string& text) {
      halves.written.bodies[body].name = text;
    };
    for (const std::size_t k : {0, 1}) {
      const std::size_t direction = k == 0 ? along_ : against_;
      made_.solids[k] = {direction, halves.part_height, 1};
      name(k, piece_name(direction));
    }
    std::map<std::optional<std::size_t>, std::size_t> all, named;
    for (const Between& body : between_) ++all[body.direction];
    std::size_t sequence = 1;
    for (std::size_t k = 0; k < between_.size(); ++k) {
      const Between& body = between_[k];
      const std::size_t written = body.number + 2, number = ++named[body.direction];
      if (!body.direction) {
        name(written, fmt::format("left_{}", number));
        continue;
      }
      if (k == 0 || between_[k - 1].direction != body.direction) ++sequence;
      name(written, all[body.direction] == 1 ? piece_name(*body.direction)
                                             : fmt::format("{}_{}", piece_name(*body.direction), number));
      made_.solids[written] = {body.direction, model_.frame.diagonal * travel_of(body), sequence};
    }
  }

  [[nodiscard]] static double reach(const TriangleMesh& mesh, const glm::dvec3& way) {
    double most = -INFINITY;
    for (const glm::dvec3& vertex : mesh.vertices) most = std::max(most, glm::dot(vertex, way));
    return most;
  }
  [[nodiscard]] static double surface_area(const TriangleMesh& mesh) {
    double area = 0.0;
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet)
      area += 0.5 * glm::length(twice_area_vector(mesh, facet));
    return area;
  }

  const PartModel& model_;
  const PiecesResult& result_;
  const Progress& progress_;
  std::size_t along_, against_ = 0;  // of the halves
  PieceSolids made_;
  TriangleMesh part_;
  std::vector<Between> between_;
  std::optional<std::size_t> stuck_;  // direction of a body that others do not let out
};

}  // namespace

std::vector<std::size_t> halves_directions(const PiecesResult& result) {
  std::vector<glm::dvec3> directions;
  for (const PieceDirection& one : result.directions) directions.push_back(one.direction);
  if (const auto pair = opposite_pair(directions)) return {pair->first};
  std::vector<std::size_t> all(directions.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

PieceSolids piece_solids(const PartModel& model, const PiecesResult& result, std::size_t along,
                         MoldHalves halves, const Progress& progress) {
  return SolidMaker(model, result, along, std::move(halves), progress).run();
}

}  // namespace moldlight
