#include "actions/action_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/open_surface.hpp"
#include "mesh/polygon_lift.hpp"
#include "mesh/polygon_triangulation.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

constexpr double k_beyond = 0.08;           // beyond the part, share of the diagonal
constexpr double k_thickness = 0.06;        // at most of a body that does not leave sideways, likewise
constexpr double k_sleeve = 0.25;           // of a radius: thickness of what is unscrewed
constexpr double k_least_thickness = 2e-4;  // share of the diagonal
/// A body whose volume is less, as a share of area to the power of 3/2, has no thickness along its pull.
constexpr double k_flat = 0.02;
/// Walls that stand along the pull lean outward by this, radians, so that they do not fold into lines; far
/// within any draft that is asked for.
constexpr double k_lean = 5e-4;
constexpr std::uint64_t k_cap_work = 2'000'000;
constexpr std::size_t k_most_triangles = 8'000;  // into which a surface is divided

}  // namespace

class BodyShaper::Maker {
 public:
  Maker(const PartModel& model, const SplitMesh& split, const ExactQuery& query, const ActionPlan& plan,
        std::size_t number)
      : model_(model), action_(plan.actions[number]), release_(model, query) {
    constexpr VertexIndex k_not_yet = std::numeric_limits<VertexIndex>::max();
    std::vector<VertexIndex> own(split.vertices.size(), k_not_yet);
    std::vector<char> formed(model.part.mesh.facets.size(), 0);
    for (const std::size_t undercut : action_.undercuts) {
      const UndercutReport& noted = plan.undercuts[undercut];
      // What is formed with an undercut goes with the action that releases most of it.
      if (!action_.about && action_of(plan, undercut) == &plan.actions[number])
        for (const FacetIndex facet : noted.formed) formed[facet] = 1;
    }
    for (std::uint32_t piece = 0; piece < split.pieces.size(); ++piece) {
      const std::int32_t its = plan.action_of_piece[piece];
      if (its != k_no_action_of_piece ? its != static_cast<std::int32_t>(number)
                                      : formed[split.pieces[piece].facet] == 0)
        continue;
      Corners& corners = triangles_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex vertex = split.pieces[piece].corners[k];
        if (own[vertex] == k_not_yet) {
          own[vertex] = static_cast<VertexIndex>(vertices_.size());
          vertices_.push_back(split.vertices[vertex]);
        }
        corners[k] = own[vertex];
      }
    }
    if (!action_.about) leave_out_blocked();
    whole_ = total_area();
  }

  bool leave_out(std::span<const glm::dvec3> points) {
    if (action_.about) return false;
    const auto is_hit = [&](const Corners& corners) {
      return are_before({vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]}, points);
    };
    // What is left out is no more than it must be.
    constexpr double k_small = 5e-4;  // of the surface
    const auto is_coarse = [&](const Corners& corners) {
      return glm::length(area_of(corners)) > k_small * whole_ && is_hit(corners);
    };
    while (std::ranges::any_of(triangles_, is_coarse) && divide(k_most_triangles)) {
    }
    std::vector<Corners> left;
    double lost = 0.0;
    for (const Corners& corners : triangles_) {
      if (!is_hit(corners))
        left.push_back(corners);
      else
        lost += glm::length(area_of(corners));
    }
    if (left.empty() || left.size() == triangles_.size() || lost_ + lost > k_blocked_share * whole_)
      return false;
    lost_ += lost;
    triangles_ = std::move(left);
    surface_.reset();
    hits_.insert(hits_.end(), points.begin(), points.end());
    return true;
  }

  [[nodiscard]] std::vector<TriangleMesh> stems() const {
    const glm::dvec3 down = action_.core_side ? release_.direction() : -release_.direction();
    std::vector<TriangleMesh> solids;
    for (const Stem& stem : action_.stems) {
      const double height = (release_.reach(down) + k_beyond) * model_.frame.diagonal -
                            glm::dot(stem.top - model_.frame.center, down);
      solids.push_back(stem_solid(stem, height / glm::dot(stem.way, down)));
    }
    return solids;
  }

  [[nodiscard]] bool thins() const { return thins_; }

  std::optional<TriangleMesh> make(double thickness) {
    if (triangles_.empty() || action_.kind == ActionKind::strip) return std::nullopt;
    if (!surface_) find_surface();
    const OpenSurface& surface = *surface_;
    thins_ = false;
    if (action_.kind == ActionKind::unscrew) return solid_between(surface, toward_axis(surface));
    const bool leaves = is_slide(action_.kind);
    const double diagonal = model_.frame.diagonal;
    const double thin = thickness;
    thickness *= k_thickness * diagonal;
    double length = thickness;
    if (leaves) {
      length = way_out_;
    } else if (std::isfinite(action_.clear_to)) {
      // A lifter's head is above its stem.
      for (const Stem& stem : action_.stems) length = std::max(length, thin * stem.behind);
      length = std::clamp(action_.clear_to - action_.travel, k_least_thickness * diagonal, length);
    }
    const glm::dvec3 normal = mean_normal(surface.mesh);
    const glm::dvec3 way = length * (action_.direction + k_lean * normal);
    TriangleMesh solid = solid_between(surface, shifted(surface, way));
    const double area = total_area(surface.mesh);
    thins_ = !leaves;
    if (signed_volume(solid) > k_flat * std::pow(area, 1.5)) return solid;
    thins_ = true;
    // It gets its thickness off the surface.
    std::vector<glm::dvec3> image = surface.mesh.vertices;
    const std::vector<glm::dvec3> curved = vertex_normals(surface.mesh);
    for (std::size_t k = 0; k < image.size(); ++k)
      image[k] += thickness * (normal != glm::dvec3(0.0) ? normal : curved[k]);
    return solid_between(surface, image);
  }

 private:
  using Corners = std::array<VertexIndex, 3>;

  /// Whether one of the points lies where a triangle passes on its way out.
  [[nodiscard]] bool are_before(const std::array<glm::dvec3, 3>& corners,
                                std::span<const glm::dvec3> points) const {
    const double near = release_.lateral() * model_.frame.diagonal;
    const glm::dvec3& way = action_.direction;
    const auto along = [&](const glm::dvec3& at) { return glm::dot(at, way); };
    const auto across = [&](const glm::dvec3& at) { return at - along(at) * way; };
    const auto& [a, b, c] = corners;
    const double least = std::min({along(a), along(b), along(c)}) - near;
    const std::array seen = {across(a), across(b), across(c)};
    return std::ranges::any_of(points, [&](const glm::dvec3& point) {
      const glm::dvec3 at = across(point);
      return along(point) >= least && glm::distance(nearest_in_triangle(at, seen), at) <= near;
    });
  }

  [[nodiscard]] double total_area() const {
    double area = 0.0;
    for (const Corners& corners : triangles_) area += glm::length(area_of(corners));
    return area;
  }

  /// Triangles are divided until each leaves whole, or has little of the surface; then those that do not go.
  void leave_out_blocked() {
    constexpr double k_little = 0.01;
    std::vector<Corners> free;
    for (bool divided = true; divided;) {
      divided = false;
      free.clear();
      const double all = total_area();
      for (const Corners& corners : triangles_) {
        const double share = all > 0.0 ? glm::length(area_of(corners)) / all : 0.0;
        const Leaves leaves = how_it_leaves(corners, share);
        if (leaves == Leaves::whole) free.push_back(corners);
        // Once one is to be divided, all are.
        divided = leaves == Leaves::in_part && share > k_little && divide(k_most_triangles);
        if (divided) break;
      }
    }
    if (!free.empty()) triangles_ = std::move(free);
  }

  /// Each into four; not where that would be more than `most`.
  bool divide(std::size_t most) {
    if (4 * triangles_.size() > most) return false;
    std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middles;
    const auto middle = [&](VertexIndex a, VertexIndex b) {
      const auto [at, added] = middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)),
                                                   static_cast<VertexIndex>(vertices_.size()));
      if (added) vertices_.push_back(0.5 * (vertices_[a] + vertices_[b]));
      return at->second;
    };
    std::vector<std::array<VertexIndex, 3>> finer;
    for (const auto& [a, b, c] : triangles_) {
      const VertexIndex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles_ = std::move(finer);
    return true;
  }

  /// Of a triangle, along its normal.
  [[nodiscard]] glm::dvec3 area_of(const std::array<VertexIndex, 3>& corners) const {
    const glm::dvec3& a = vertices_[corners[0]];
    return 0.5 * glm::cross(vertices_[corners[1]] - a, vertices_[corners[2]] - a);
  }

  enum class Leaves { whole, in_part, not_at_all };

  /// By places near its corners and on it, the more the larger its share of the surface is.
  [[nodiscard]] Leaves how_it_leaves(const Corners& corners, double share) const {
    constexpr double k_inward = 0.02, k_places = 300.0;  // for the whole surface
    const glm::dvec3 area = area_of(corners);
    if (area == glm::dvec3(0.0)) return Leaves::whole;  // it goes with its neighbours
    const glm::dvec3 &a = vertices_[corners[0]], &b = vertices_[corners[1]], &c = vertices_[corners[2]];
    const glm::dvec3 middle = (a + b + c) / 3.0, normal = glm::normalize(area);
    const LifterWay way{action_.direction, action_.core_side ? release_.direction() : -release_.direction(),
                        action_.travel / model_.frame.diagonal};
    const auto leaves = [&](const glm::dvec3& at) {
      const UndercutSample sample{model_.frame.to_unit(at), normal, 0.0};
      if (action_.kind == ActionKind::lifter) return release_.clears(sample, way);
      if (release_.free_length(sample, way.pull) != k_never) return false;
      if (action_.kind == ActionKind::insert) return !release_.covered(sample, way.pull);
      return release_.clear(sample, way.pull, way.length, way.side);
    };
    const bool first = leaves(middle);
    for (const glm::dvec3& corner : {a, b, c}) {
      if (leaves(glm::mix(corner, middle, k_inward)) != first) return Leaves::in_part;
    }
    for (std::uint64_t k = 0; static_cast<double>(k) < share * k_places; ++k) {
      if (leaves(triangle_place(k).in(a, b, c)) != first) return Leaves::in_part;
    }
    return first ? Leaves::whole : Leaves::not_at_all;
  }

  /// Of the triangles, a slide's with caps.
  void find_surface() {
    surface_ = surface_of_triangles();
    if (!is_slide(action_.kind)) return;
    if (!reach_) reach_ = release_.reach(action_.direction);
    way_out_ = (*reach_ + k_beyond) * model_.frame.diagonal - least_reach(surface_->mesh.vertices);
    const std::size_t own = triangles_.size();
    if (close_far_ends(*surface_)) surface_ = surface_of_triangles();
    triangles_.resize(own);
  }

  /// Where fans of triangles meet in a point they are drawn back from it, each into itself, so that the walls
  /// over them do not share an edge.
  [[nodiscard]] OpenSurface surface_of_triangles() const {
    constexpr double k_back = 1e-3;  // of the triangles' size
    OpenSurface surface = open_surface(vertices_, triangles_);
    std::vector<int> uses(vertices_.size(), 0);
    for (const VertexIndex source : surface.sources) ++uses[source];
    const std::vector<glm::dvec3> corners = surface.mesh.vertices;
    for (const auto& facet : surface.mesh.facets) {
      const glm::dvec3 middle = (corners[facet[0]] + corners[facet[1]] + corners[facet[2]]) / 3.0;
      for (const VertexIndex vertex : facet) {
        if (uses[surface.sources[vertex]] > 1)
          surface.mesh.vertices[vertex] = glm::mix(corners[vertex], middle, k_back);
      }
    }
    return surface;
  }

  [[nodiscard]] double least_reach(std::span<const glm::dvec3> points) const {
    double least = k_never;
    for (const glm::dvec3& point : points)
      least = std::min(least, glm::dot(point - model_.frame.center, action_.direction));
    return least;
  }

  [[nodiscard]] static double total_area(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.facets)
      sum += 0.5 * glm::length(
                       glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
    return sum;
  }
  /// Unit, or 0 for a surface that goes all the way round.
  [[nodiscard]] static glm::dvec3 mean_normal(const TriangleMesh& mesh) {
    glm::dvec3 sum(0.0);
    for (const auto& [a, b, c] : mesh.facets)
      sum += 0.5 * glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    const double length = glm::length(sum);
    return length > 0.05 * total_area(mesh) ? sum / length : glm::dvec3(0.0);
  }

  [[nodiscard]] static std::vector<glm::dvec3> shifted(const OpenSurface& surface, const glm::dvec3& way) {
    std::vector<glm::dvec3> image = surface.mesh.vertices;
    for (glm::dvec3& point : image) point += way;
    return image;
  }

  /// Adds caps where the surface, seen against the pull, has a hole that leads on through the part, or where
  /// it goes part of the way round such a hole, and the cap can be pulled out, too. The corners of a cap are
  /// those of the border.
  bool close_far_ends(const OpenSurface& surface) {
    constexpr double k_end = 1e-3;  // of the diagonal, along the pull
    const std::size_t before = triangles_.size();
    const double square = model_.frame.diagonal * model_.frame.diagonal;
    for (const std::vector<VertexIndex>& border : surface.borders) {
      if (glm::dot(enclosed_area(surface, border), action_.direction) < -1e-9 * square) {
        add_cap(surface, border);
        continue;
      }
      const auto reach = [&](VertexIndex vertex) {
        return glm::dot(surface.mesh.vertices[vertex], action_.direction);
      };
      double least = k_never;
      for (const VertexIndex vertex : border) least = std::min(least, reach(vertex));
      const auto is_far = [&](VertexIndex vertex) {
        return reach(vertex) <= least + k_end * model_.frame.diagonal;
      };
      // From where the border comes to its far end.
      std::vector<VertexIndex> end = border;
      const auto elsewhere = std::find_if_not(end.begin(), end.end(), is_far);
      std::rotate(end.begin(), std::find_if(elsewhere, end.end(), is_far), end.end());
      end.erase(std::find_if_not(end.begin(), end.end(), is_far), end.end());
      // Lips may curl past the mouth.
      const std::size_t least_size = end.size() / 2;
      while (end.size() < border.size() && end.size() > std::max<std::size_t>(4, least_size) &&
             glm::dot(enclosed_area(surface, end), action_.direction) < -k_end * k_end * square &&
             !add_cap(surface, end)) {
        end.pop_back();
        end.erase(end.begin());
      }
    }
    return triangles_.size() > before;
  }

  /// Not where the border crosses itself, or something is in the way.
  bool add_cap(const OpenSurface& surface, const std::vector<VertexIndex>& border) {
    if (border.size() < 3) return false;
    std::vector<glm::dvec3> outline;
    for (auto at = border.rbegin(); at != border.rend(); ++at) outline.push_back(surface.mesh.vertices[*at]);
    std::vector<std::array<std::uint32_t, 3>> cap;
    if (PolygonTriangulator(k_cap_work).triangulate(outline, cap) == PolygonCut::fan_of_odd) return false;
    // The steel of another action may fill what lies before it, as where bores cross.
    lift_triangles(outline, action_.direction, cap);
    constexpr std::uint64_t k_places = 24;  // of a triangle
    const bool free = std::ranges::all_of(cap, [&](const auto& corners) {
      const glm::dvec3 &a = outline[corners[0]], &b = outline[corners[1]], &c = outline[corners[2]];
      if (are_before({a, b, c}, hits_)) return false;
      for (std::uint64_t k = 0; k <= k_places; ++k) {
        const glm::dvec3 at = k == 0 ? (a + b + c) / 3.0 : triangle_place(k).in(a, b, c);
        const UndercutSample sample{model_.frame.to_unit(at), action_.direction, 0.0};
        if (release_.free_length(sample, action_.direction) != k_never ||
            release_.covered(sample, action_.direction))
          return false;
      }
      return true;
    });
    if (!free) return false;
    for (const auto& corners : cap) {
      std::array<VertexIndex, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = surface.sources[border[border.size() - 1 - corners[k]]];
      triangles_.push_back(triangle);
    }
    return true;
  }

  [[nodiscard]] static std::vector<glm::dvec3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<glm::dvec3> normals(mesh.vertices.size(), glm::dvec3(0.0));
    for (const auto& facet : mesh.facets) {
      const auto& [a, b, c] = facet;
      const glm::dvec3 across =
          glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
      for (const VertexIndex vertex : facet) normals[vertex] += across;
    }
    for (glm::dvec3& normal : normals) {
      const double length = glm::length(normal);
      if (length > 0.0) normal /= length;
    }
    return normals;
  }

  /// A thread's body is a sleeve: within the thread if its surface faces the axis, round it if it does not.
  [[nodiscard]] std::vector<glm::dvec3> toward_axis(const OpenSurface& surface) const {
    const glm::dvec3 axis = action_.about->direction, through = action_.about->point;
    const auto from_axis = [&](const glm::dvec3& point) {
      const glm::dvec3 away = point - through;
      return away - glm::dot(away, axis) * axis;
    };
    double facing = 0.0, least = k_never, greatest = 0.0;
    for (const auto& [a, b, c] : surface.mesh.facets)
      facing += glm::dot(glm::cross(surface.mesh.vertices[b] - surface.mesh.vertices[a],
                                    surface.mesh.vertices[c] - surface.mesh.vertices[a]),
                         from_axis(surface.mesh.vertices[a]));
    for (const glm::dvec3& point : surface.mesh.vertices) {
      const double radius = glm::length(from_axis(point));
      least = std::min(least, radius);
      greatest = std::max(greatest, radius);
    }
    const double radius = facing < 0.0 ? (1.0 - k_sleeve) * least : (1.0 + k_sleeve) * greatest;
    std::vector<glm::dvec3> image = surface.mesh.vertices;
    for (glm::dvec3& point : image) {
      const glm::dvec3 away = from_axis(point);
      const double its = glm::length(away);
      if (its > 0.0) point += (radius / its - 1.0) * away;
    }
    return image;
  }

  const PartModel& model_;
  std::vector<glm::dvec3> vertices_;  // of its pieces of the split mesh, and such as divide them
  SideAction action_;
  Release release_;
  std::vector<std::array<VertexIndex, 3>> triangles_;  // with caps while these are found
  std::optional<OpenSurface> surface_;                 // of the triangles, once it was asked for
  double whole_ = 0.0, lost_ = 0.0;                    // area at first, and what of it was left out since
  bool thins_ = false;                                 // what was made last
  std::vector<glm::dvec3> hits_;                       // for which it was
  std::optional<double> reach_;                        // of the part along its way, once that was asked for
  double way_out_ = 0.0;                               // of a slide's surface
};

BodyShaper::BodyShaper(const PartModel& model, const SplitMesh& split, const ExactQuery& query,
                       const ActionPlan& plan, std::size_t action)
    : maker_(std::make_unique<Maker>(model, split, query, plan, action)) {}
BodyShaper::~BodyShaper() = default;

std::optional<TriangleMesh> BodyShaper::shape(double thickness) { return maker_->make(thickness); }
bool BodyShaper::thins() const { return maker_->thins(); }
std::vector<TriangleMesh> BodyShaper::stems() const { return maker_->stems(); }
bool BodyShaper::leave_out(std::span<const glm::dvec3> points) { return maker_->leave_out(points); }

double turn_of(const SideAction& action, double share) {
  if (action.kind != ActionKind::unscrew || !action.about) return 0.0;
  const Revolution& about = *action.about;
  // A right-handed body that turns counter-clockwise about the axis goes along it.
  const double sense = glm::dot(action.direction, about.direction) >= 0.0 ? 1.0 : -1.0;
  return share * sense * glm::radians(360.0) * about.turns * (about.pitch < 0.0 ? -1.0 : 1.0);
}

glm::dmat4 action_motion(const SideAction& action, double share) {
  glm::dmat4 motion = glm::translate(glm::dmat4(1.0), share * action.travel * action.direction);
  if (action.kind != ActionKind::unscrew || !action.about) return motion;
  const Revolution& about = *action.about;
  motion = glm::translate(motion, about.point);
  motion = glm::rotate(motion, turn_of(action, share), about.direction);
  return glm::translate(motion, -about.point);
}

}  // namespace moldlight
