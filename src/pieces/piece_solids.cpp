#include "pieces/piece_solids.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/facet_geometry.hpp"
#include "parting/mold_report.hpp"
#include "parting/slide_blank.hpp"
#include "pieces/piece_words.hpp"

namespace moldlight {

namespace {

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
    if (halves_are_good() && find_ways() && ways_are_clear() && little_is_left()) name_all();
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

  /// For each body between the halves the first direction along which the part does not stand in its way.
  bool find_ways() {
    part_ = in_mold(made_.halves, model_.part.mesh, model_.frame.diagonal);
    const std::size_t count = made_.halves.inserts.size();
    for (std::size_t k = 0; k < count; ++k) {
      progress_.report("pulling the pieces", static_cast<double>(k) / static_cast<double>(count));
      Between body{.mesh = unscaled(made_.halves, made_.halves.inserts[k].mesh, model_.frame.diagonal),
                   .number = k,
                   .direction = std::nullopt};
      for (std::size_t d = 0; d < made_.directions.size() && !body.direction; ++d) {
        if (d == along_ || d == against_) continue;
        if (way_out(body.mesh, part_, way_of(d)).blocked <= result_.query.lateral) body.direction = d;
      }
      if (body.direction) body.reach = reach(body.mesh, way_of(*body.direction));
      between_.push_back(std::move(body));
    }
    // In the order of removal: of one direction that which is nearer to the way out.
    std::ranges::stable_sort(between_, {}, [](const Between& body) {
      return std::tuple(!body.direction.has_value(), body.direction.value_or(0), -body.reach);
    });
    return true;
  }

  bool ways_are_clear() {
    for (std::size_t k = 0; k < between_.size(); ++k) {
      if (!between_[k].direction) break;
      const Bounds swept = swept_box(between_[k]);
      for (std::size_t later = k + 1; later < between_.size(); ++later) {
        progress_.report("pulling the pieces", 1.0);
        const Bounds other = bounds(between_[later].mesh);
        if (glm::any(glm::greaterThan(other.min, swept.max)) || glm::any(glm::lessThan(other.max, swept.min)))
          continue;
        if (way_out(between_[k].mesh, between_[later].mesh, way_of(*between_[k].direction)).blocked >
            result_.query.lateral)
          return refuse(fmt::format("the body that moves along {} would hit one that is removed later",
                                    pull_words(made_.directions[*between_[k].direction])),
                        insert_place(made_.halves, between_[k].number));
      }
    }
    return true;
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
    std::size_t number = 0, at = 0;
    for (const Between& body : between_) {
      if (body.direction) continue;
      ++number;
      const double own = surface_area(body.mesh) * model_.frame.diagonal * model_.frame.diagonal;
      area += own;
      if (own <= largest) continue;
      largest = own;
      at = body.number;
    }
    // Half of such a body's surface, at least, lies on the other bodies.
    if (area <= 2.0 * result_.settings.eps * model_.geometry.total_area) return true;
    return refuse(fmt::format("no single direction releases {} between the halves",
                              number == 1 ? "a body" : fmt::format("{} bodies", number)),
                  insert_place(made_.halves, at));
  }

  void name_all() {
    MoldHalves& halves = made_.halves;
    made_.solids.resize(halves.written.bodies.size());
    const auto name = [&](std::size_t body, const std::string& text) {
      halves.written.bodies[body].name = text;
    };
    for (const std::size_t k : {0, 1}) {
      const std::size_t direction = k == 0 ? along_ : against_;
      made_.solids[k] = {direction, halves.part_height};
      name(k, piece_name(direction));
    }
    std::size_t left = 0;
    for (std::size_t k = 0, in_direction = 0; k < between_.size(); ++k) {
      const Between& body = between_[k];
      const std::size_t written = body.number + 2;
      if (!body.direction) {
        name(written, fmt::format("left_{}", ++left));
        continue;
      }
      const bool first = k == 0 || between_[k - 1].direction != body.direction;
      const bool last = k + 1 == between_.size() || between_[k + 1].direction != body.direction;
      in_direction = first ? 1 : in_direction + 1;
      name(written, first && last ? piece_name(*body.direction)
                                  : fmt::format("{}_{}", piece_name(*body.direction), in_direction));
      made_.solids[written] = {body.direction, model_.frame.diagonal * travel_of(body)};
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
