#include "actions/action_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/health.hpp"
#include "mesh/open_surface.hpp"
#include "mesh/polygon_triangulation.hpp"

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

class BodyMaker {
 public:
  BodyMaker(const PartModel& model, const Classification& result, const ActionPlan& plan, std::size_t number)
      : model_(model),
        split_(*result.split),
        action_(plan.actions[number]),
        release_(model, exact_query(model, result.query())) {
    std::set<FacetIndex> formed;
    for (const std::size_t patch : action_.patches) {
      const UndercutReport& noted = plan.patches[patch];
      // What is formed with an undercut goes with the action that releases most of it.
      if (!action_.about && action_of(plan, patch) == &action_)
        formed.insert(noted.formed.begin(), noted.formed.end());
    }
    for (std::uint32_t piece = 0; piece < split_.pieces.size(); ++piece) {
      const bool own = plan.action_of_piece[piece] == static_cast<std::int32_t>(number);
      if (!own && !formed.contains(split_.pieces[piece].facet)) continue;
      triangles_.push_back(split_.pieces[piece].corners);
    }
  }

  std::optional<TriangleMesh> make() {
    if (triangles_.empty() || action_.kind == ActionKind::strip) return std::nullopt;
    OpenSurface surface = surface_of_triangles();
    if (action_.kind == ActionKind::unscrew) return solid_between(surface, toward_axis(surface));
    const bool leaves = is_slide(action_.kind);
    const double diagonal = model_.frame.diagonal;
    double length = k_thickness * diagonal;
    if (leaves) {
      length = (release_.reach(action_.direction) + k_beyond) * diagonal - least_reach(surface.mesh.vertices);
    } else if (std::isfinite(action_.clear_to)) {
      length = std::clamp(action_.clear_to - action_.travel, k_least_thickness * diagonal, length);
    }
    if (leaves && close_far_ends(surface)) surface = surface_of_triangles();
    const glm::dvec3 normal = mean_normal(surface.mesh);
    const glm::dvec3 way = length * (action_.direction + k_lean * normal);
    TriangleMesh solid = solid_between(surface, shifted(surface, way));
    const double area = total_area(surface.mesh);
    if (signed_volume(solid) > k_flat * std::pow(area, 1.5)) return solid;
    return solid_between(surface, thickened(surface, normal));
  }

 private:
  /// Where fans of triangles meet in a point they are drawn back from it, each into itself, so that the walls
  /// over them do not share an edge.
  [[nodiscard]] OpenSurface surface_of_triangles() const {
    constexpr double k_back = 1e-3;  // of the triangles' size
    OpenSurface surface = open_surface(split_.vertices, triangles_);
    std::map<VertexIndex, int> uses;
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

  /// Adds caps where the surface, seen against the pull, has a hole that leads on through the part, and the
  /// cap can be pulled out, too. The corners of a cap are those of the border.
  bool close_far_ends(const OpenSurface& surface) {
    PolygonTriangulator triangulator(k_cap_work);
    const std::size_t before = triangles_.size();
    for (const std::vector<VertexIndex>& border : surface.borders) {
      const double seen = glm::dot(enclosed_area(surface, border), action_.direction);
      if (border.size() < 3 || seen > -1e-9 * model_.frame.diagonal * model_.frame.diagonal) continue;
      std::vector<glm::dvec3> outline;
      for (auto at = border.rbegin(); at != border.rend(); ++at)
        outline.push_back(surface.mesh.vertices[*at]);
      std::vector<std::array<std::uint32_t, 3>> cap;
      if (triangulator.triangulate(outline, cap) == PolygonCut::fan_of_odd) continue;
      const bool free = std::ranges::all_of(cap, [&](const auto& corners) {
        const glm::dvec3 middle = (outline[corners[0]] + outline[corners[1]] + outline[corners[2]]) / 3.0;
        const UndercutSample sample{model_.frame.to_unit(middle), action_.direction, 0.0};
        return release_.free_length(sample, action_.direction) == k_never;
      });
      if (!free) continue;
      for (const auto& corners : cap) {
        std::array<VertexIndex, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k)
          triangle[k] = surface.sources[border[border.size() - 1 - corners[k]]];
        triangles_.push_back(triangle);
      }
    }
    return triangles_.size() > before;
  }

  /// The image of a body that gets its thickness off the surface: as much as there is room for, along the
  /// mean normal, or where that leaves none, along the normals of the vertices.
  [[nodiscard]] std::vector<glm::dvec3> thickened(const OpenSurface& surface,
                                                  const glm::dvec3& normal) const {
    constexpr double k_thinner = 0.6;
    const std::vector<glm::dvec3> curved = vertex_normals(surface.mesh);
    std::vector<std::vector<glm::dvec3>> ways;
    if (normal != glm::dvec3(0.0)) ways.emplace_back(surface.mesh.vertices.size(), normal);
    ways.push_back(curved);
    std::vector<glm::dvec3> image = surface.mesh.vertices;
    const auto move = [&](const std::vector<glm::dvec3>& outward, double thickness) {
      for (std::size_t k = 0; k < image.size(); ++k)
        image[k] += thickness * model_.frame.diagonal * outward[k];
    };
    for (const std::vector<glm::dvec3>& outward : ways) {
      for (double thickness = k_thickness; thickness > k_least_thickness; thickness *= k_thinner) {
        if (!has_room(surface.mesh, outward, thickness)) continue;
        move(outward, thickness);
        return image;
      }
    }
    move(curved, k_least_thickness);
    return image;
  }

  /// Whether the body has so much thickness (share of the diagonal) outside the part, and stays so as it
  /// moves: at the middles of facets and near their corners.
  [[nodiscard]] bool has_room(const TriangleMesh& mesh, const std::vector<glm::dvec3>& outward,
                              double thickness) const {
    constexpr double k_inward = 0.05;
    const double travel = action_.travel / model_.frame.diagonal;
    double all = 0.0, blocked = 0.0;
    for (const auto& facet : mesh.facets) {
      const auto& [a, b, c] = facet;
      const glm::dvec3 middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
      const glm::dvec3 across =
          glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
      const double area = glm::length(across);
      all += area;
      if (area <= 0.0) continue;
      const auto fits = [&](const glm::dvec3& at, const glm::dvec3& outward_there) {
        const double length = glm::length(outward_there);
        if (length <= 0.0) return true;  // where facets without area meet
        const glm::dvec3 way = outward_there / length;
        const UndercutSample base{model_.frame.to_unit(at), across / area, 0.0};
        const UndercutSample top{model_.frame.to_unit(at + thickness * model_.frame.diagonal * way), way,
                                 0.0};
        return release_.free_length(base, way) > thickness &&
               release_.free_length(top, action_.direction) >= travel;
      };
      bool free = fits(middle, outward[a] + outward[b] + outward[c]);
      for (const VertexIndex vertex : facet)
        free = free && fits(glm::mix(mesh.vertices[vertex], middle, k_inward), outward[vertex]);
      blocked += free ? 0.0 : area;
    }
    return blocked <= k_blocked_share * all;
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
  const SplitMesh& split_;
  const SideAction& action_;
  Release release_;
  std::vector<std::array<VertexIndex, 3>> triangles_;  // of the split mesh, with caps
};

}  // namespace

std::optional<TriangleMesh> action_body(const PartModel& model, const Classification& result,
                                        const ActionPlan& plan, std::size_t action) {
  return BodyMaker(model, result, plan, action).make();
}

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
