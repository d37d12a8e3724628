// Points of a body are moved as the mold moves it, and are in another solid where two rays say so; how deep
// is how far the solid's surface is from there. Where a body moves straight and nothing is in the way of a
// point, only the ends of its way are asked for.
#include "actions/body_figures.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/parallel_for.h>

#include "actions/action_body.hpp"
#include "mesh/nearest_in_triangle.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// In the part's unit and place, as all lengths here.
struct BodyPlayer::Solid {
  std::shared_ptr<const PartModel> model;
  std::vector<glm::dvec3> few, points;  // of its surface
  BodyHit hit = {};                     // of the part: by all, or by the few where these are too deep
  double in_part = 0.0;                 // how deep that is, beyond the tolerance
  /// Of others, by all, where they are taken off later or not: of the same ones in another plan it is known.
  std::map<std::pair<const Solid*, bool>, BodyHit> others = {};
};
namespace {

using Solid = BodyPlayer::Solid;

/// Of an action of a plan.
struct Placed {
  std::size_t action = 0;
  Solid* solid = nullptr;  // not null
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

  /// The deepest of some points of a body in the part.
  [[nodiscard]] BodyHit in_part(const Placed& body, std::span<const glm::dvec3> points) const {
    BodyHit hit;
    if (model_.health.closed && model_.health.volume > 0.0) play_against(body, points, nullptr, hit);
    return hit;
  }
  /// Those that are too deep in the part.
  [[nodiscard]] std::vector<glm::dvec3> all_in_part(const Placed& body,
                                                    std::span<const glm::dvec3> points) const {
    std::vector<glm::dvec3> deep;
    for (const glm::dvec3& point : points) {
      if (beyond(in_part(body, std::span(&point, 1)).depth) > 0.0) deep.push_back(point);
    }
    return deep;
  }
  /// Likewise in the part, of which it is known, and in others; none where that is within the tolerance.
  [[nodiscard]] std::optional<BodyHit> deepest(const Placed& body, std::span<const Placed> others) const {
    BodyHit hit = body.solid->hit;
    for (const Placed& other : others) {
      if (other.action == body.action) continue;
      const BodyHit& its = hit_in(body, other);
      if (its.depth <= hit.depth) continue;
      hit = its;
      hit.action = other.action;
    }
    return beyond(hit.depth) > 0.0 ? std::optional(hit) : std::nullopt;
  }
  /// How deep a body and others are in each other; by a few points, and where these are clear by all.
  [[nodiscard]] double depth_of_all(const Placed& body, std::span<const Placed> others) const {
    BodyHit hit;
    for (const Placed& other : others) {
      play_against(body, body.solid->few, &other, hit);
      play_against(other, other.solid->few, &body, hit);
    }
    for (const Placed& other : others) {
      if (beyond(hit.depth) > 0.0) break;
      hit.depth = std::max({hit.depth, hit_in(body, other).depth, hit_in(other, body).depth});
    }
    return beyond(hit.depth);
  }
  /// How many of a few points are too deep in the part or in others.
  [[nodiscard]] double share_of_few(const Placed& body, std::span<const Placed> others) const {
    const std::vector<glm::dvec3>& few = body.solid->few;
    const auto deep = std::ranges::count_if(few, [&](const glm::dvec3& point) {
      BodyHit hit = in_part(body, std::span(&point, 1));
      for (const Placed& other : others) {
        if (other.action != body.action) play_against(body, std::span(&point, 1), &other, hit);
      }
      return beyond(hit.depth) > 0.0;
    });
    return static_cast<double>(deep) / static_cast<double>(few.size());
  }
  /// Points of a body that are too deep in others, and of others that are too deep in it.
  [[nodiscard]] std::vector<glm::dvec3> shared_with(const Placed& body,
                                                    std::span<const Placed> others) const {
    std::vector<glm::dvec3> deep;
    const auto take = [&](const Placed& one, const Placed& other) {
      for (const glm::dvec3& point : one.solid->points) {
        BodyHit hit;
        play_against(one, std::span(&point, 1), &other, hit);
        if (beyond(hit.depth) > 0.0) deep.push_back(point);
      }
    };
    for (const Placed& other : others) {
      take(body, other);
      take(other, body);
    }
    return deep;
  }
  /// Deeper than slivers of a body's surface are.
  [[nodiscard]] bool is_deep(double depth) const { return depth > 5.0 * allowed_; }
  /// 0 within the tolerance.
  [[nodiscard]] double beyond(double depth) const { return depth > allowed_ ? depth : 0.0; }

 private:
  /// By all points of a body in another one; found once.
  [[nodiscard]] const BodyHit& hit_in(const Placed& body, const Placed& other) const {
    const auto [known, is_new] = body.solid->others.try_emplace({other.solid, other.action < body.action});
    if (is_new) play_against(body, body.solid->points, &other, known->second);
    return known->second;
  }

  /// Of a body in another one, or in the part where that is null.
  void play_against(const Placed& body, std::span<const glm::dvec3> points, const Placed* other,
                    BodyHit& hit) const {
    const PartModel& solid = other != nullptr ? *other->solid->model : model_;
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
    const bool goes_out = turn != k_last_turn && !together && !has_left;
    if (other != nullptr && straight) {
      const glm::dvec3 way = has_left   ? glm::dvec3(0.0)
                             : together ? action.travel * action.direction - its->travel * its->direction
                                        : action.travel * action.direction;
      Bounds path = body.solid->model->health.bounds;
      for (const glm::dvec3& corner : Bounds(path).corners()) {
        path.add(corner + way);
        if (goes_out) path.add(corner + way + 2.0 * model_.frame.diagonal * side);
      }
      const Bounds& box = solid.health.bounds;
      if (glm::any(glm::greaterThan(path.min, box.max)) || glm::any(glm::greaterThan(box.min, path.max)))
        return;
    }
    for (const glm::dvec3& point : points) {
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
      if (!goes_out) continue;
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

constexpr int k_most_trims = 4;
constexpr double k_slivers = 0.02;  // of a body's points

/// `mesh` is the body of an action.
Solid solid_of(TriangleMesh mesh, const Player& player, std::size_t action, const BodyPlay& play,
               const Progress& progress) {
  constexpr std::size_t k_coarser = 30;  // as long as its shape is looked for
  Part part;
  part.mesh = std::move(mesh);
  Solid solid{prepare_part(std::move(part), Progress(&progress)), {}, {}};
  solid.few = points_of(*solid.model, 1 + play.points / k_coarser);
  solid.points = points_of(*solid.model, play.points);
  solid.hit = player.in_part({action, &solid}, solid.few);
  if (player.beyond(solid.hit.depth) == 0.0) solid.hit = player.in_part({action, &solid}, solid.points);
  solid.in_part = player.beyond(solid.hit.depth);
  return solid;
}

/// Of what an action forms, and how it moves.
std::vector<double> key_of(const ActionPlan& plan, std::size_t number) {
  constexpr std::size_t k_motion = 7;
  const SideAction& action = plan.actions[number];
  std::vector<double> key = {static_cast<double>(action.kind),
                             action.core_side ? 1.0 : 0.0,
                             action.direction.x,
                             action.direction.y,
                             action.direction.z,
                             action.travel,
                             action.clear_to};
  for (std::size_t piece = 0; piece < plan.action_of_piece.size(); ++piece)
    if (plan.action_of_piece[piece] == static_cast<std::int32_t>(number))
      key.push_back(static_cast<double>(piece));
  if (key.size() == k_motion) key.push_back(static_cast<double>(number));
  for (const std::size_t patch : action.patches) {
    if (action_of(plan, patch) != &action) continue;
    key.push_back(-1.0);
    for (const FacetIndex facet : plan.patches[patch].formed) key.push_back(facet);
  }
  return key;
}

}  // namespace

struct BodyPlayer::Shapes {
  ActionBody shaper;
  std::deque<Solid> solids = {};  // each half as thick as the one before
  bool done = false;              // there is no thinner one

  /// What enters the part goes, as far as little of the surface comes to that.
  void trim(const Player& player, std::size_t action, const BodyPlay& play, const Progress& progress) {
    if (solids.empty() || solids.front().in_part == 0.0) return;
    constexpr double k_hopeless = 0.1;  // of its points
    const auto deep = [&](std::span<const glm::dvec3> points) {
      return player.all_in_part({action, &solids.front()}, points);
    };
    const std::vector<glm::dvec3>& few = solids.front().few;
    if (static_cast<double>(deep(few).size()) > k_hopeless * static_cast<double>(few.size())) return;
    for (int k = 0; k < k_most_trims && !solids.empty() && solids.front().in_part > 0.0; ++k) {
      if (!shaper.trim(deep(solids.front().points))) return;
      solids.clear();
      done = false;
      thinner(player, action, play, progress);
    }
  }

  /// The next one; null where there is none.
  Solid* thinner(const Player& player, std::size_t action, const BodyPlay& play, const Progress& progress) {
    constexpr std::size_t k_most = 5;
    if (done) return nullptr;
    auto mesh = shaper.shaped(std::exp2(-static_cast<double>(solids.size())));
    done = !mesh || solids.size() + 1 == k_most;
    if (!mesh) return nullptr;
    Solid solid = solid_of(std::move(*mesh), player, action, play, progress);
    if (!solids.empty() && solids.back().model->health.volume == solid.model->health.volume) {
      done = true;
      return nullptr;
    }
    return &solids.emplace_back(std::move(solid));
  }
};

BodyPlayer::BodyPlayer(const PartModel& model, const SplitMesh& split, const ExactQuery& query,
                       const Progress& progress, const BodyPlay& play)
    : model_(model), split_(split), query_(query), progress_(progress), play_(play) {}
BodyPlayer::~BodyPlayer() = default;

void BodyPlayer::measure(ActionPlan& plan) {
  progress_.report("shaping what moves", 0.95);
  const Player player(model_, query_, plan, play_.steps, progress_);
  std::vector<Shapes*> shapes;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    auto key = key_of(plan, k);
    auto known = known_.find(key);
    if (known == known_.end())
      known = known_.emplace(std::move(key), Shapes{{{model_, split_, query_, play_.stem}, plan, k}}).first;
    shapes.push_back(&known->second);
  }
  tbb::parallel_for(std::size_t{0}, shapes.size(), [&](std::size_t k) {
    std::deque<Solid>& solids = shapes[k]->solids;
    if (solids.empty()) {
      shapes[k]->thinner(player, k, play_, progress_);
      shapes[k]->trim(player, k, play_, progress_);
    }
    while ((solids.empty() || solids.back().in_part > 0.0) &&
           shapes[k]->thinner(player, k, play_, progress_) != nullptr) {
    }
  });
  std::vector<std::size_t> order(plan.actions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return sequence_of(plan.actions[k].kind); });
  std::vector<Placed> bodies;
  for (const std::size_t k : order) {
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    std::deque<Solid>& solids = shapes[k]->solids;
    for (std::size_t thin = 0; least > 0.0; ++thin) {
      if (thin == solids.size() && shapes[k]->thinner(player, k, play_, progress_) == nullptr) break;
      const double in_part = solids[thin].in_part;
      const double depth = in_part > 0.0 ? in_part : player.depth_of_all({k, &solids[thin]}, bodies);
      if (depth >= least) continue;
      least = depth;
      best = thin;
    }
    if (!best) continue;
    bodies.push_back({k, &solids[*best]});
    if (least == 0.0 || solids[*best].in_part > 0.0) continue;
    // What it has in common with them goes, as far as little of the surface comes to that.
    const std::span<const Placed> others(bodies.data(), bodies.size() - 1);
    ActionBody trimmed = shapes[k]->shaper;
    for (int tries = 0; tries < k_most_trims && least > 0.0; ++tries) {
      if (!trimmed.trim(player.shared_with(bodies.back(), others))) break;
      auto mesh = trimmed.shaped(std::exp2(-static_cast<double>(*best)));
      if (!mesh) break;
      apart_.push_back(std::make_unique<Solid>(solid_of(std::move(*mesh), player, k, play_, progress_)));
      const Placed apart{k, apart_.back().get()};
      const double depth = player.depth_of_all(apart, others);
      if (apart.solid->in_part > 0.0 || depth >= least) break;
      bodies.back() = apart;
      least = depth;
    }
  }
  std::vector<std::optional<BodyHit>> hits(bodies.size());
  grave_.assign(plan.actions.size(), 0);
  tbb::parallel_for(std::size_t{0}, bodies.size(), [&](std::size_t k) {
    hits[k] = player.deepest(bodies[k], bodies);
    if (hits[k] && (player.is_deep(hits[k]->depth) || player.share_of_few(bodies[k], bodies) > k_slivers))
      grave_[bodies[k].action] = 1;
  });
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::shared_ptr<const PartModel>& model = bodies[k].solid->model;
    SideAction& action = plan.actions[bodies[k].action];
    const glm::dvec3& way = action.kind == ActionKind::unscrew ? action.about->direction : action.direction;
    action.body = BodyFigures{.solid = {model, &model->part.mesh},
                              .volume = model->health.volume,
                              .least_section = least_section(model->part.mesh, way),
                              .hit = hits[k]};
  }
}

}  // namespace moldlight
