#include "pieces/divided_body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/slide_blank.hpp"
#include "pieces/plane_cut.hpp"

namespace moldlight {

namespace {

constexpr int k_most_cuts = 3;  // one after the other
constexpr std::size_t k_share_lines = 40, k_most_faces = 16;
constexpr double k_same_normal = 0.9998;  // cosine of a degree
constexpr double k_least_lean = 0.02;     // of a normal, seen along a way
constexpr double k_least_parted = 0.12;   // of a body, that a plane has to part off
constexpr double k_share_step = 0.01;     // what parts off less more is as good
/// Shares of what is held that may be in front of a plane, to be parted off later; it counts so much against.
/// The first is that of lines that meet an edge and miss what is there.
constexpr double k_held_in_front[] = {0.003, 0.1, 0.3};
constexpr double k_held_weight = 4.0;
constexpr double k_clear_of_way = 0.25;  // of the tolerance, between a plane and what is held
constexpr double k_nearer[] = {0.0, 0.03, 0.5, 1.0, 2.0, 4.0, 8.0};  // likewise, what is tried

/// Points of a body, on lines along a way: those that move out along it, and those that are held.
struct Movement {
  std::vector<glm::dvec3> free, held;
  double cell = 0.0;  // between lines, the wider
};

Movement movement(const DivisionTask& task, const TriangleMesh& body, const glm::dvec3& way) {
  const WayFrame frame = frame_along(way);
  const LineGrid grid = LineGrid::over(body, frame, k_share_lines);
  const auto own = depth_columns(body, frame, grid), part = depth_columns(task.part, frame, grid);
  Movement found;
  const glm::dvec2 size = (grid.high - grid.low) / static_cast<double>(k_share_lines);
  found.cell = std::max(size.x, size.y);
  for (std::size_t line = 0; line < grid.lines(); ++line) {
    const glm::dvec2 at = grid.at(line);
    for (const Stretch& stretch : own[line]) {
      const auto count = std::max(1.0, std::round((stretch.to - stretch.from) / found.cell));
      for (double k = 0.5; k < count; k += 1.0) {
        const double height = stretch.from + k / count * (stretch.to - stretch.from);
        double before = 0.0;
        for (const Stretch& other : part[line])
          before += std::max(0.0, other.to - std::max(other.from, height));
        (before > 0.5 * task.tolerance ? found.held : found.free)
            .push_back(at.x * frame.across + at.y * frame.up + height * frame.way);
      }
    }
  }
  return found;
}

/// The axes and the normals of its largest faces, each once.
std::vector<glm::dvec3> face_normals(const TriangleMesh& body) {
  struct Face {
    glm::dvec3 sum{0.0};
    double area = 0.0;
  };
  std::vector<Face> faces;
  for (FacetIndex facet = 0; facet < body.facets.size(); ++facet) {
    const glm::dvec3 normal = twice_area_vector(body, facet);
    const double area = glm::length(normal);
    if (area == 0.0) continue;
    const auto same = std::ranges::find_if(faces, [&](const Face& face) {
      return std::abs(glm::dot(face.sum, normal)) > k_same_normal * area * glm::length(face.sum);
    });
    Face& face = same == faces.end() ? faces.emplace_back() : *same;
    face.sum += glm::dot(face.sum, normal) < 0.0 ? -normal : normal;
    face.area += area;
    if (faces.size() > 40 * k_most_faces) break;  // round all over
  }
  std::ranges::stable_sort(faces, std::ranges::greater(), &Face::area);
  std::vector<glm::dvec3> normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t k = 0; k < std::min(faces.size(), k_most_faces); ++k)
    normals.push_back(glm::normalize(faces[k].sum));
  return normals;
}

class Divider {
 public:
  Divider(const DivisionTask& task, const Progress& progress) : task_(task), progress_(progress) {}

  void divide(TriangleMesh body, int cuts_left, std::vector<BodyShare>& shares) const {
    for (const PieceWay& one : task_.ways) {
      progress_.report("pulling the pieces", 0.5);
      if (way_out(body, task_.part, one.way).blocked > task_.tolerance) continue;
      shares.push_back({std::move(body), one.direction});
      return;
    }
    if (cuts_left > 0) {
      if (const auto cut = best_cut(body)) {
        for (const std::vector<TriangleMesh>* side : {&cut->inside, &cut->outside})
          for (const TriangleMesh& share : *side) divide(share, cuts_left - 1, shares);
        return;
      }
    }
    shares.push_back({std::move(body), std::nullopt});
  }

 private:
  struct Cut {
    double share = k_least_parted;  // of the body that it parts off
    HalfSpace half;
    glm::dvec3 way{0.0};
  };

  [[nodiscard]] std::optional<CutSolid> best_cut(const TriangleMesh& body) const {
    const std::vector<glm::dvec3> normals = face_normals(body);
    Cut best;
    for (const PieceWay& one : task_.ways) {
      const Movement moving = movement(task_, body, one.way);
      if (moving.free.empty() || moving.held.empty()) continue;
      for (const glm::dvec3& normal : normals) {
        progress_.report("pulling the pieces", 0.5);
        const glm::dvec3 along = normal - glm::dot(normal, one.way) * one.way;
        for (const glm::dvec3& either : {normal, along, -normal, -along}) {
          const double size = glm::length(either);
          if (size > k_least_lean && glm::dot(either, one.way) <= 1e-9 * size)
            look_across(moving, body, either / size, one.way, best);
        }
      }
    }
    if (best.share == k_least_parted) return std::nullopt;
    // Nearer to what moves out until that does, or no more of it; a corner may lie in the plane, too.
    std::optional<CutSolid> chosen;
    double least = INFINITY;
    for (const double nearer : k_nearer) {
      auto cut = cut_solid(body, {best.half.normal, best.half.offset - nearer * task_.tolerance});
      if (!cut || cut->inside.empty() || cut->outside.empty()) continue;
      double held = 0.0;
      for (const TriangleMesh& share : cut->inside) {
        const WayOut out = way_out(share, task_.part, best.way);
        if (out.blocked > task_.tolerance) held += out.share;
      }
      if (held > least - k_share_step && held > 0.0) continue;
      least = held;
      chosen = std::move(cut);
      if (held == 0.0) break;
    }
    return chosen;
  }

  /// Planes across this normal.
  void look_across(const Movement& moving, const TriangleMesh& body, const glm::dvec3& normal,
                   const glm::dvec3& way, Cut& best) const {
    std::vector<double> held;
    for (const glm::dvec3& point : moving.held) held.push_back(glm::dot(normal, point));
    const auto all = static_cast<double>(moving.free.size() + held.size());
    for (const double in_front : k_held_in_front) {
      const auto count = static_cast<std::size_t>(in_front * static_cast<double>(held.size()));
      std::ranges::nth_element(held, held.begin() + static_cast<std::ptrdiff_t>(count));
      const HalfSpace half{normal, offset_before(held[count], moving.cell, body, normal)};
      const auto parted = std::ranges::count_if(
          moving.free, [&](const glm::dvec3& point) { return beyond(point, half) < 0.0; });
      const double share = (static_cast<double>(parted) - k_held_weight * static_cast<double>(count)) / all;
      if (share > best.share + k_share_step) best = {share, half, way};
    }
  }

  /// As far along the normal as what is held: to the last corner of the body before it, if one is near.
  [[nodiscard]] double offset_before(double held, double cell, const TriangleMesh& body,
                                     const glm::dvec3& normal) const {
    double corner = held - cell;
    for (const glm::dvec3& vertex : body.vertices) {
      const double height = glm::dot(normal, vertex);
      if (height < held) corner = std::max(corner, height);
    }
    return corner - k_clear_of_way * task_.tolerance;
  }

  const DivisionTask& task_;
  const Progress& progress_;
};

}  // namespace

std::vector<BodyShare> divided_body(const DivisionTask& task, TriangleMesh body, const Progress& progress) {
  std::vector<BodyShare> shares;
  Divider(task, progress).divide(std::move(body), k_most_cuts, shares);
  return shares;
}

}  // namespace moldlight
