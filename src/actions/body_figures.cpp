// Points of a body are moved as the mold moves it, and are in another solid where two rays say so; how deep
// is how far the solid's surface is from there. Where a body moves straight and nothing is in the way of a
// point, only the ends of its way are asked for.
#include "actions/body_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include "actions/action_body.hpp"
#include "mesh/facet_geometry.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

/// In the part's unit and place, as all lengths here.
struct Solid {
  std::size_t action = 0;
  std::shared_ptr<const PartModel> model;
  std::vector<glm::dvec3> points;  // of its surface
};

/// Of a closed solid's section across a direction (unit) by the plane at a height along it.
double section_area(const TriangleMesh& mesh, std::span<const FacetIndex> facets, const glm::dvec3& normal,
                    double height) {
  double twice = 0.0;
  for (const FacetIndex facet : facets) {
    glm::dvec3 rising(0.0), falling(0.0);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 &a = mesh.corner(facet, k), &b = mesh.corner(facet, (k + 1) % 3);
      const double from = glm::dot(a, normal) - height, to = glm::dot(b, normal) - height;
      if ((from < 0.0) != (to < 0.0))
        (from < 0.0 ? rising : falling) = a + from / (from - to) * (b - a) - mesh.vertices.front();
    }
    twice += glm::dot(normal, glm::cross(rising, falling));
  }
  return 0.5 * std::abs(twice);
}

/// Across the way, where it is greatest, of the thinnest of a body's pieces; splinters aside.
double least_section(const TriangleMesh& body, const glm::dvec3& way) {
  constexpr double k_splinter = 0.01;  // of the greatest of the pieces
  constexpr int k_places = 9;
  const Components components = connected_components(body);
  std::vector<std::vector<FacetIndex>> pieces(components.count);
  for (FacetIndex facet = 0; facet < body.facets.size(); ++facet) {
    if (components.of_facet[facet] != k_no_facet) pieces[components.of_facet[facet]].push_back(facet);
  }
  std::vector<double> sections;
  for (const std::vector<FacetIndex>& piece : pieces) {
    double low = std::numeric_limits<double>::infinity(), high = -low, section = 0.0;
    for (const FacetIndex facet : piece) {
      low = std::min(low, glm::dot(body.corner(facet, 0), way));
      high = std::max(high, glm::dot(body.corner(facet, 0), way));
    }
    for (int k = 0; k < k_places; ++k)
      section = std::max(section, section_area(body, piece, way, low + (k + 0.5) / k_places * (high - low)));
    sections.push_back(section);
  }
  std::ranges::sort(sections);
  const auto found =
      std::ranges::find_if(sections, [&](double section) { return section > k_splinter * sections.back(); });
  return found != sections.end() ? *found : 0.0;
}

bool seems_inside(const PartModel& solid, const glm::vec3& point, const glm::dvec3& along) {
  constexpr float k_past = 1e-6F;
  constexpr int k_most = 1000;
  const glm::vec3 way(along);
  int depth = 0;
  float gone = 0.0F;
  for (int crossings = 0; crossings < k_most; ++crossings) {
    const auto hit = solid.rays().first_hit(point + gone * way, way, false);
    if (!hit) break;
    gone += hit->distance + k_past;
    depth += glm::dot(solid.geometry.normals[hit->facet], along) > 0.0 ? 1 : -1;
  }
  return depth > 0;
}

/// From a point inside a solid to its surface; 0 outside.
double depth_in(const PartModel& solid, const glm::dvec3& point) {
  constexpr float k_first_reach = 0.02F, k_last_reach = 2.0F;
  const Bounds& box = solid.health.bounds;
  for (int k = 0; k < 3; ++k)
    if (point[k] < box.min[k] || point[k] > box.max[k]) return 0.0;
  const glm::vec3 at = solid.frame.to_unit(point);
  for (const glm::dvec3& along : {glm::dvec3(0.3612, 0.6173, 0.6990), glm::dvec3(-0.5127, 0.4391, -0.7377)})
    if (!seems_inside(solid, at, glm::normalize(along))) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (float reach = k_first_reach; reach < k_last_reach && !std::isfinite(nearest); reach *= 4.0F) {
    solid.rays().visit_near(at, reach, [&](FacetIndex facet) {
      const TriangleMesh& mesh = solid.part.mesh;
      const glm::dvec3 its =
          nearest_in_triangle(point, {mesh.corner(facet, 0), mesh.corner(facet, 1), mesh.corner(facet, 2)});
      nearest = std::min(nearest, glm::distance(its, point));
      return std::min(reach, static_cast<float>(nearest / solid.frame.diagonal) + 1e-6F);
    });
  }
  return std::isfinite(nearest) ? nearest : 0.0;
}

bool meets_between(const PartModel& solid, const glm::dvec3& from, const glm::dvec3& to) {
  const double length = glm::distance(from, to);
  if (length <= 0.0) return false;
  const auto hit = solid.rays().first_hit(solid.frame.to_unit(from), glm::vec3((to - from) / length), false);
  return hit && static_cast<double>(hit->distance) * solid.frame.diagonal <= length;
}

class Player {
 public:
  Player(const PartModel& model, const ExactQuery& query, const ActionPlan& plan, int steps,
         const Progress& progress)
      : model_(model),
        direction_(query.direction),
        plan_(plan),
        steps_(steps),
        progress_(progress),
        allowed_(2.0 * query.lateral * model.frame.diagonal) {}

  /// Of a body in the part and in others; none where that is within the tolerance.
  [[nodiscard]] std::optional<BodyHit> deepest(const Solid& body, std::span<const Solid> others) const {
    BodyHit hit;
    if (model_.health.closed && model_.health.volume > 0.0) play_against(body, nullptr, hit);
    for (const Solid& other : others) {
      if (other.action != body.action) play_against(body, &other, hit);
    }
    return hit.depth > allowed_ ? std::optional(hit) : std::nullopt;
  }

  /// How deep a body and others are in each other, and it in the part; 0 within the tolerance.
  [[nodiscard]] double depth_of_all(const Solid& body, std::span<const Solid> others) const {
    BodyHit hit = deepest(body, others).value_or(BodyHit());
    for (const Solid& other : others) play_against(other, &body, hit);
    return hit.depth > allowed_ ? hit.depth : 0.0;
  }

 private:
  /// Of a body in another one, or in the part where that is null.
  void play_against(const Solid& body, const Solid* other, BodyHit& hit) const {
    const PartModel& solid = other != nullptr ? *other->model : model_;
    const SideAction& action = plan_.actions[body.action];
    const SideAction* its = other != nullptr ? &plan_.actions[other->action] : nullptr;
    const int turn = sequence_of(action.kind);
    const int its_turn = its != nullptr ? sequence_of(its->kind) : k_last_turn;
    const bool together = its != nullptr && its_turn == turn && turn < k_last_turn;
    // Inserts are taken off one after the other.
    const bool has_left =
        its_turn < turn || (turn == k_last_turn && other != nullptr && other->action < body.action);
    const bool straight = action.kind != ActionKind::unscrew && !(together && its->about);
    const glm::dvec3 side = action.core_side ? direction_ : -direction_;
    for (const glm::dvec3& point : body.points) {
      if (progress_.cancelled()) throw Cancelled();
      const auto take = [&](HitStage stage, double depth) {
        if (depth > hit.depth)
          hit = {other != nullptr ? std::optional(other->action) : std::nullopt, depth, point, stage};
      };
      take(HitStage::rest, depth_in(solid, point));
      if (has_left) continue;
      const auto on_its_way = [&](double share) {
        const glm::dvec4 at = action_motion(action, share) * glm::dvec4(point, 1.0);
        return glm::dvec3(together ? glm::inverse(action_motion(*its, share)) * at : at);
      };
      move(solid, straight, on_its_way, [&](double depth) { take(HitStage::way, depth); });
      if (turn == k_last_turn || together) continue;
      const glm::dvec3 from = on_its_way(1.0);
      const auto on_its_way_out = [&](double share) {
        return from + 2.0 * share * model_.frame.diagonal * side;
      };
      move(solid, true, on_its_way_out, [&](double depth) { take(HitStage::way_out, depth); });
    }
  }

  template <typename Place, typename Take>
  void move(const PartModel& solid, bool straight, const Place& place, const Take& take) const {
    take(depth_in(solid, place(1.0)));
    if (straight && !meets_between(solid, place(0.0), place(1.0))) return;
    for (int step = 1; step < steps_; ++step)
      take(depth_in(solid, place(static_cast<double>(step) / steps_)));
  }

  static constexpr int k_last_turn = 4;
  const PartModel& model_;
  glm::dvec3 direction_;
  const ActionPlan& plan_;
  int steps_;
  const Progress& progress_;
  double allowed_;
};

std::vector<glm::dvec3> points_of(const PartModel& body, std::size_t count) {
  std::vector<glm::dvec3> points;
  for (const SurfaceSample& sample :
       sample_surface_evenly(body.part.mesh, body.geometry, body.frame, count).samples)
    points.push_back(body.frame.center + body.frame.diagonal * glm::dvec3(sample.position));
  return points;
}

}  // namespace

void measure_bodies(const PartModel& model, const Classification& result, const Progress& progress,
                    ActionPlan& plan, const BodyPlay& play) {
  constexpr double k_thinnest = 0.01;   // of what a body usually is
  constexpr std::size_t k_coarser = 3;  // as long as its shape is looked for
  const Player player(model, exact_query(model, result.query()), plan, play.steps, progress);
  std::vector<std::size_t> order(plan.actions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return sequence_of(plan.actions[k].kind); });
  std::vector<Solid> bodies;
  for (const std::size_t k : order) {
    progress.report("shaping what moves", 0.95);
    std::optional<Solid> best;
    double least = std::numeric_limits<double>::infinity(), volume = 0.0;
    for (double thickness = 1.0; least > 0.0 && thickness > k_thinnest; thickness *= 0.5) {
      auto mesh = shaped_body(model, result, plan, k, thickness);
      if (!mesh) break;
      Part part;
      part.mesh = std::move(*mesh);
      Solid tried{k, prepare_part(std::move(part), Progress(&progress)), {}};
      // What reaches out of the mold is as long as it must be.
      if (std::exchange(volume, tried.model->health.volume) == tried.model->health.volume) break;
      tried.points = points_of(*tried.model, 1 + play.points / k_coarser);
      const double depth = player.depth_of_all(tried, bodies);
      if (depth >= least) continue;
      least = depth;
      best = std::move(tried);
    }
    if (best) bodies.push_back(std::move(*best));
  }
  for (Solid& body : bodies) body.points = points_of(*body.model, play.points);
  std::vector<std::optional<BodyHit>> hits(bodies.size());
  tbb::parallel_for(std::size_t{0}, bodies.size(),
                    [&](std::size_t k) { hits[k] = player.deepest(bodies[k], bodies); });
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const TriangleMesh& mesh = bodies[k].model->part.mesh;
    SideAction& action = plan.actions[bodies[k].action];
    const glm::dvec3& way = action.kind == ActionKind::unscrew ? action.about->direction : action.direction;
    action.body = BodyFigures{.solid = {bodies[k].model, &mesh},
                              .volume = bodies[k].model->health.volume,
                              .least_section = least_section(mesh, way),
                              .hit = hits[k]};
  }
}

}  // namespace moldlight
