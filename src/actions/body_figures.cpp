// Points of a body are moved as the mold moves it, and are in another solid where two rays say so; how deep
// is how far the solid's surface is from there. Where a body moves straight, a ray says where on its way that
// is to be asked.
#include "actions/body_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <tbb/parallel_for.h>

#include "actions/action_body.hpp"
#include "actions/body_section.hpp"
#include "actions/lattice_points.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/orient.hpp"

namespace moldlight {

/// In the part's unit and place, as all lengths here.
struct PlayedBody {
  /// What was found of its first points.
  struct SoFar {
    BodyHit hit = {};
    std::size_t tested = 0;
    std::vector<glm::dvec3> points = {};  // that hit
  };
  std::shared_ptr<const PartModel> model;
  std::vector<glm::dvec3> points = {};               // of its surface
  std::size_t few = 0;                               // that are spread evenly, at the beginning
  mutable std::optional<double> least_section = {};  // once it was asked for
  mutable SoFar in_part = {};
  /// By whether the other moves first.
  mutable std::map<std::pair<const PlayedBody*, bool>, SoFar> in_others = {};
};

namespace {

/// As the body of an action.
struct Placed {
  std::size_t action = 0;
  const PlayedBody* solid = nullptr;
};

/// As facet_geometry() has it, which keeps those of all.
glm::dvec3 normal_of(const TriangleMesh& mesh, FacetIndex facet) {
  const glm::dvec3 vector = twice_area_vector(mesh, facet);
  const double twice_area = glm::length(vector);
  return twice_area > 0.0 ? vector / twice_area : glm::dvec3(0.0);
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
    depth += glm::dot(normal_of(solid.part.mesh, hit->facet), along) > 0.0 ? 1 : -1;
  }
  return depth > 0;
}

bool is_in(const Bounds& box, const glm::dvec3& point) {
  return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::lessThanEqual(point, box.max));
}

/// From a point to what of a solid's surface was found so near (unit frame); infinite where nothing was.
double distance_within(const PartModel& solid, const glm::dvec3& point, float reach) {
  double nearest = std::numeric_limits<double>::infinity();
  solid.rays().visit_near(solid.frame.to_unit(point), reach, [&](FacetIndex facet) {
    const TriangleMesh& mesh = solid.part.mesh;
    const glm::dvec3 its =
        nearest_in_triangle(point, {mesh.corner(facet, 0), mesh.corner(facet, 1), mesh.corner(facet, 2)});
    nearest = std::min(nearest, glm::distance(its, point));
    return std::min(reach, static_cast<float>(nearest / solid.frame.diagonal) + 1e-6F);
  });
  return nearest;
}

/// From a point inside a solid to its surface; 0 outside, and where that is no more than allowed.
double depth_in(const PartModel& solid, const glm::dvec3& point, double allowed) {
  constexpr float k_first_reach = 0.001F, k_last_reach = 2.0F;
  if (!is_in(solid.health.bounds, point)) return 0.0;
  // Most points of a body touch the part that it forms: that is found sooner than what is inside.
  double nearest = distance_within(solid, point, k_first_reach);
  if (nearest <= allowed) return 0.0;
  const glm::vec3 at = solid.frame.to_unit(point);
  for (const glm::dvec3& along : {glm::dvec3(0.3612, 0.6173, 0.6990), glm::dvec3(-0.5127, 0.4391, -0.7377)})
    if (!seems_inside(solid, at, glm::normalize(along))) return 0.0;
  for (float reach = 4.0F * k_first_reach; reach < k_last_reach && !std::isfinite(nearest); reach *= 4.0F)
    nearest = distance_within(solid, point, reach);
  return std::isfinite(nearest) ? nearest : 0.0;
}

/// Where a point that moves straight is within a solid, shares of its way; but for so much of it at the
/// beginning, where it may touch what it leaves.
std::vector<std::pair<double, double>> within(const PartModel& solid, const glm::dvec3& from,
                                              const glm::dvec3& to, double beginning) {
  constexpr double k_past = 1e-6;  // of the diagonal
  constexpr int k_most = 100;
  const double length = glm::distance(from, to);
  std::vector<std::pair<double, double>> found;
  double entered = 0.0, gone = beginning;
  bool inside = false;
  for (int passes = 0; passes < k_most && gone < length; ++passes) {
    const glm::dvec3 way = (to - from) / length;
    const auto hit = solid.rays().first_hit(solid.frame.to_unit(from + gone * way), glm::vec3(way), false);
    if (!hit) break;
    gone += static_cast<double>(hit->distance) * solid.frame.diagonal;
    if (gone > length) break;
    inside = glm::dot(normal_of(solid.part.mesh, hit->facet), way) < 0.0;
    if (inside) entered = gone / length;
    if (!inside) found.emplace_back(entered, gone / length);
    gone += k_past * solid.frame.diagonal;
  }
  if (inside) found.emplace_back(entered, 1.0);
  return found;
}

class Player {
 public:
  Player(const PartModel& model, const ExactQuery& query, const ActionPlan& plan, int steps, bool fine,
         const Progress& progress)
      : model_(model),
        direction_(query.direction),
        plan_(plan),
        steps_(steps),
        fine_(fine),
        progress_(progress),
        allowed_(2.0 * query.lateral * model.frame.diagonal) {}

  /// Of a body in the part and in others; none where that is within the tolerance.
  [[nodiscard]] std::optional<BodyHit> deepest(const Placed& body, std::span<const Placed> others) const {
    BodyHit hit = in_part(body);
    for (const Placed& other : others) {
      if (other.action == body.action || in_other(body, other).depth <= hit.depth) continue;
      hit = in_other(body, other);
      hit.action = other.action;
    }
    return hit.depth > allowed_ ? std::optional(hit) : std::nullopt;
  }

  /// Whether a body and others are in each other, or it in the part: found sooner than how deep.
  [[nodiscard]] bool hits(const Placed& body, std::span<const Placed> others) const {
    return in_part(body, true).depth > allowed_ || std::ranges::any_of(others, [&](const Placed& other) {
             return in_other(body, other, true).depth > allowed_ ||
                    in_other(other, body, true).depth > allowed_;
           });
  }

  /// How deep a body and others are in each other, and it in the part; 0 within the tolerance.
  [[nodiscard]] double depth_of_all(const Placed& body, std::span<const Placed> others) const {
    double depth = in_part(body).depth;
    for (const Placed& other : others) {
      if (depth <= allowed_)
        depth = std::max({depth, in_other(body, other).depth, in_other(other, body).depth});
    }
    return depth > allowed_ ? depth : 0.0;
  }

  /// With `any`, the first hit will do, here and below.
  [[nodiscard]] const BodyHit& in_part(const Placed& body, bool any = false) const {
    const bool solid = model_.health.closed && model_.health.volume > 0.0;
    return solid ? deepest_of(body, nullptr, any, body.solid->in_part) : body.solid->in_part.hit;
  }

  /// Those of its points that hit the part.
  [[nodiscard]] std::span<const glm::dvec3> points_in_part(const Placed& body) const {
    static_cast<void>(in_part(body));
    return body.solid->in_part.points;
  }

 private:
  [[nodiscard]] const BodyHit& in_other(const Placed& body, const Placed& other, bool any = false) const {
    return deepest_of(body, &other, any, body.solid->in_others[{other.solid, other.action < body.action}]);
  }

  /// By the first few points, and if it is to be fine and these are clear by all of them.
  [[nodiscard]] const BodyHit& deepest_of(const Placed& body, const Placed* other, bool any,
                                          PlayedBody::SoFar& found) const {
    const std::span<const glm::dvec3> points = body.solid->points;
    std::size_t begin = 0;
    for (const std::size_t wanted : {body.solid->few, fine_ ? points.size() : body.solid->few}) {
      // Where the first hit was enough, the others of its points may be asked for now.
      if (found.hit.depth > allowed_ && (any || found.tested == begin)) break;
      if (found.tested < wanted)
        found.tested +=
            play_against(body, points.subspan(found.tested, wanted - found.tested), other, any, found);
      begin = wanted;
    }
    return found.hit;
  }

  /// Of a body in another one, or in the part where that is null. How many points it came past.
  std::size_t play_against(const Placed& body, std::span<const glm::dvec3> points, const Placed* other,
                           bool any, PlayedBody::SoFar& found) const {
    const PartModel& solid = other != nullptr ? *other->solid->model : model_;
    const SideAction& action = plan_.actions[body.action];
    const SideAction* its = other != nullptr ? &plan_.actions[other->action] : nullptr;
    const int turn = sequence_of(action.kind);
    const int its_turn = its != nullptr ? sequence_of(its->kind) : k_last_turn;
    const bool together = its != nullptr && its_turn == turn && turn < k_last_turn;
    // Slides that go the same way are one steel where they overlap.
    constexpr double k_same_way = 0.9998;
    if (together && is_slide(action.kind) && glm::dot(action.direction, its->direction) > k_same_way)
      return points.size();
    // Inserts are taken off one after the other.
    const bool has_left =
        its_turn < turn || (turn == k_last_turn && other != nullptr && other->action < body.action);
    const bool straight = action.kind != ActionKind::unscrew && !(together && its->about);
    const glm::dvec3 way_out =
        turn == k_last_turn || together || has_left
            ? glm::dvec3(0.0)
            : 2.0 * model_.frame.diagonal * (action.core_side ? direction_ : -direction_);
    const glm::dvec3 way = has_left ? glm::dvec3(0.0)
                                    : action.travel * action.direction -
                                          (together ? its->travel * its->direction : glm::dvec3(0.0));
    const Bounds &box = solid.health.bounds, &own = body.solid->model->health.bounds;
    const auto may_meet = [&](const glm::dvec3& low, const glm::dvec3& high) {
      const glm::dvec3 out = way + way_out;
      return !straight || (glm::all(glm::lessThanEqual(low + glm::min(glm::min(way, out), 0.0), box.max)) &&
                           glm::all(glm::lessThanEqual(box.min, high + glm::max(glm::max(way, out), 0.0))));
    };
    if (!may_meet(own.min, own.max)) return points.size();
    for (const glm::dvec3& point : points) {
      if (any && found.hit.depth > allowed_) return static_cast<std::size_t>(&point - points.data());
      if (!may_meet(point, point)) continue;
      if (progress_.cancelled()) throw Cancelled();
      const auto take = [&](HitStage stage, double depth) {
        if (depth > allowed_ && (found.points.empty() || found.points.back() != point))
          found.points.push_back(point);
        if (depth > found.hit.depth)
          found.hit = {other != nullptr ? std::optional(other->action) : std::nullopt, depth, point, stage};
      };
      take(HitStage::rest, depth_in(solid, point, allowed_));
      // Out of the part a slide is as narrow as another one beside it needs.
      const bool shank = together && is_slide(action.kind) && !is_in(model_.health.bounds, point);
      if (has_left || shank) continue;
      const auto on_its_way = [&](double share) {
        const glm::dvec4 at = action_motion(action, share) * glm::dvec4(point, 1.0);
        return glm::dvec3(together ? glm::inverse(action_motion(*its, share)) * at : at);
      };
      move(solid, straight, on_its_way, [&](double depth) { take(HitStage::way, depth); });
      if (way_out == glm::dvec3(0.0)) continue;
      const glm::dvec3 from = on_its_way(1.0);
      const auto on_its_way_out = [&](double share) { return from + share * way_out; };
      move(solid, true, on_its_way_out, [&](double depth) { take(HitStage::way_out, depth); });
    }
    return points.size();
  }

  template <typename Place, typename Take>
  void move(const PartModel& solid, bool straight, const Place& place, const Take& take) const {
    take(depth_in(solid, place(1.0), allowed_));
    if (straight) {
      for (const auto& [from, to] : within(solid, place(0.0), place(1.0), allowed_))
        for (const double share : {0.25, 0.5, 0.75})
          take(depth_in(solid, place(glm::mix(from, to, share)), allowed_));
      return;
    }
    for (int step = 1; step < steps_; ++step)
      take(depth_in(solid, place(static_cast<double>(step) / steps_), allowed_));
  }

  static constexpr int k_last_turn = 4;
  const PartModel& model_;
  glm::dvec3 direction_;
  const ActionPlan& plan_;
  int steps_;
  bool fine_;
  const Progress& progress_;
  double allowed_;
};

/// What rays, box and volume of a body take, and no more of what is known of parts: there may be thousands.
std::shared_ptr<const PartModel> solid_model(TriangleMesh mesh) {
  auto model = std::make_shared<PartModel>();
  turn_if_inside_out(mesh);
  model->part.mesh = std::move(mesh);
  model->part.mesh.vertices.shrink_to_fit();
  model->part.mesh.facets.shrink_to_fit();
  model->health.volume = signed_volume(model->part.mesh);
  model->health.bounds = bounds(model->part.mesh);
  model->frame = unit_frame(model->health.bounds);
  return model;
}

/// The same without its search tree, which takes more than the solid and is made again where it is asked for.
void forget_rays(PlayedBody& body) {
  auto model = std::make_shared<PartModel>();
  model->part.mesh = body.model->part.mesh;
  model->health = body.model->health;
  model->frame = body.model->frame;
  body.model = std::move(model);
}

/// Of what an action forms, and how it moves.
std::vector<double> key_of(const ActionPlan& plan, std::size_t number,
                           std::span<const std::uint32_t> pieces) {
  const SideAction& action = plan.actions[number];
  std::vector<double> key = {static_cast<double>(action.kind),
                             action.core_side ? 1.0 : 0.0,
                             action.direction.x,
                             action.direction.y,
                             action.direction.z,
                             action.travel,
                             action.clear_to};
  const std::size_t motion = key.size();
  for (const std::uint32_t piece : pieces) key.push_back(piece);
  if (key.size() == motion) key.push_back(-1.0 - static_cast<double>(number));
  for (const std::size_t undercut : action.undercuts) {
    if (action_of(plan, undercut) != &action) continue;
    key.push_back(-1.0);
    for (const FacetIndex facet : plan.undercuts[undercut].formed) key.push_back(facet);
  }
  return key;
}

}  // namespace

struct BodyPlayer::Shape {
  std::optional<BodyShaper> shaper = {};
  std::deque<PlayedBody> solids = {};  // each half as thick as the one before
  std::deque<std::deque<PlayedBody>> former =
      {};              // before some of their surface was left out; known to others
  bool done = false;   // there is no thinner one
  bool rests = false;  // it is none of the plan's
  std::vector<std::pair<TriangleMesh, SurfacePoints>> stems = {};  // however thin it is

  /// The body of an action, so thin; null where there is none.
  const PlayedBody* thinned(std::size_t times, const SideAction& action, const glm::dvec3& direction,
                            std::size_t points) {
    constexpr std::size_t k_most = 7, k_of_stem = 4;  // of a stem one in so many of the points
    if (times < solids.size()) return &solids[times];
    if (done) return nullptr;
    const glm::dvec3& way = action.kind == ActionKind::unscrew ? action.about->direction : action.direction;
    if (stems.empty()) {
      for (TriangleMesh& stem : shaper->stems()) {
        SurfacePoints its = lattice_points(stem, way, direction, points / k_of_stem);
        stems.emplace_back(std::move(stem), std::move(its));
      }
    }
    auto mesh = shaper->shape(std::exp2(-static_cast<double>(solids.size())));
    done = !mesh || !shaper->thins() || solids.size() + 1 == k_most;
    if (!mesh) return nullptr;
    SurfacePoints all = lattice_points(*mesh, way, direction, points);
    for (const auto& [stem, its] : stems) {
      append(stem, *mesh);
      all.few.insert(all.few.end(), its.few.begin(), its.few.end());
      all.others.insert(all.others.end(), its.others.begin(), its.others.end());
    }
    done = done || (!solids.empty() && signed_volume(*mesh) == signed_volume(solids.back().model->part.mesh));
    if (done && shaper->thins() && solids.size() + 1 < k_most) return nullptr;
    PlayedBody& solid = solids.emplace_back(PlayedBody{solid_model(std::move(*mesh))});
    solid.few = all.few.size();
    solid.points = std::move(all.few);
    solid.points.insert(solid.points.end(), all.others.begin(), all.others.end());
    return &solid;
  }

  /// Of all bodies but one.
  void forget_rays_but(const PlayedBody* kept) {
    for (PlayedBody& solid : solids)
      if (&solid != kept) forget_rays(solid);
  }

  /// Leaves the surface out at which a body hits the part; false where that is too much.
  bool leave_out(std::span<const glm::dvec3> points) {
    if (!shaper->leave_out(points)) return false;
    // Their places are known to others, what they are is not needed any more.
    for (PlayedBody& solid : solids) solid = {};
    former.push_back(std::exchange(solids, {}));
    done = false;
    return true;
  }
};

BodyPlayer::BodyPlayer(const PartModel& model, const Classification& result, const Progress& progress,
                       const BodyPlay& play)
    : model_(model),
      split_(*result.split),
      query_(exact_query(model, result.query())),
      progress_(progress),
      play_(play) {}
BodyPlayer::~BodyPlayer() = default;

void BodyPlayer::measure(ActionPlan& plan, bool fine) {
  progress_.report("making the bodies of the actions", 0.95);
  const Player player(model_, query_, plan, play_.steps, fine, progress_);
  std::vector<Shape*> shapes;
  std::vector<std::vector<std::uint32_t>> pieces(plan.actions.size());
  for (std::uint32_t piece = 0; piece < plan.action_of_piece.size(); ++piece)
    if (const std::int32_t its = plan.action_of_piece[piece]; its >= 0)
      pieces[static_cast<std::size_t>(its)].push_back(piece);
  for (std::size_t k = 0; k < plan.actions.size(); ++k) shapes.push_back(&known_[key_of(plan, k, pieces[k])]);
  for (auto& [key, shape] : known_) {
    const bool rests = std::ranges::find(shapes, &shape) == shapes.end();
    if (rests && !shape.rests) shape.forget_rays_but(nullptr);
    shape.rests = rests;
  }
  const auto thinned = [&](std::size_t k, std::size_t times) {
    if (progress_.cancelled()) throw Cancelled();
    return shapes[k]->thinned(times, plan.actions[k], query_.direction, play_.points);
  };
  tbb::parallel_for(std::size_t{0}, shapes.size(), [&](std::size_t k) {
    if (!shapes[k]->shaper) shapes[k]->shaper.emplace(model_, split_, query_, plan, k);
    constexpr int k_most_rounds = 8;
    for (int round = 0; round < k_most_rounds; ++round) {
      const PlayedBody* solid = nullptr;
      for (std::size_t times = 0; (solid = thinned(k, times)) != nullptr; ++times)
        if (!player.hits({k, solid}, {})) break;
      // No thickness will do: some of its surface does not leave.
      if (solid != nullptr || (solid = thinned(k, 0)) == nullptr ||
          !shapes[k]->leave_out(player.points_in_part({k, solid})))
        break;
    }
  });
  std::vector<std::size_t> order(plan.actions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return sequence_of(plan.actions[k].kind); });
  std::vector<Placed> bodies;
  for (const std::size_t k : order) {
    const PlayedBody* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t times = 0; best == nullptr; ++times) {
      const PlayedBody* solid = thinned(k, times);
      if (solid == nullptr) break;
      if (!player.hits({k, solid}, bodies)) best = solid;
    }
    const bool clear = best != nullptr;
    for (std::size_t times = 0; !clear; ++times) {
      const PlayedBody* solid = thinned(k, times);
      if (solid == nullptr) break;
      const double depth = player.depth_of_all({k, solid}, bodies);
      if (depth < least) best = solid;
      least = std::min(least, depth);
    }
    if (best != nullptr) bodies.push_back({k, best});
    shapes[k]->forget_rays_but(best);
  }
  std::vector<std::optional<BodyHit>> hits(bodies.size());
  tbb::parallel_for(std::size_t{0}, bodies.size(),
                    [&](std::size_t k) { hits[k] = player.deepest(bodies[k], bodies); });
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::shared_ptr<const PartModel>& model = bodies[k].solid->model;
    SideAction& action = plan.actions[bodies[k].action];
    const glm::dvec3& way = action.kind == ActionKind::unscrew ? action.about->direction : action.direction;
    std::optional<double>& section = bodies[k].solid->least_section;
    if (!section) section = least_section(model->part.mesh, way);
    action.body = BodyFigures{.solid = {model, &model->part.mesh},
                              .volume = model->health.volume,
                              .least_section = *section,
                              .hit = hits[k]};
  }
}

}  // namespace moldlight
