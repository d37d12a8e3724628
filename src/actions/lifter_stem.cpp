#include "actions/lifter_stem.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

struct Span {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  void take(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

class StemFinder {
 public:
  explicit StemFinder(const StemQuestion& question)
      : question_(question), level_(glm::normalize(glm::cross(question.side, question.action.direction))) {
    for (const glm::dvec3& point : question.surface) {
      along_.take(glm::dot(point, question.action.direction));
      wide_.take(glm::dot(point, level_));
      high_.take(glm::dot(point, question.side));
    }
    const double diagonal = question.model.frame.diagonal;
    for (const glm::dvec3& vertex : question.model.part.mesh.vertices)
      out_ = std::max(out_, glm::dot(vertex, question.side) + k_beyond * diagonal);
  }

  [[nodiscard]] TriangleMesh stem() const {
    constexpr int k_places = 4;  // on the head's thickness, and to both sides
    const double section = question_.section, first = along_.greatest + question_.lateral;
    const double last = std::max(first, along_.greatest + question_.head - section / k_places);
    const double middle = 0.5 * (wide_.least + wide_.greatest);
    const double aside = 0.5 * std::abs(wide_.greatest - wide_.least - section);
    for (int behind = 0; behind <= k_places; ++behind) {
      const double at = first + (last - first) * behind / k_places;
      for (int beside = 0; beside <= 2 * k_places; ++beside) {
        const double sense = beside % 2 == 0 ? 1.0 : -1.0;
        const double across = middle + sense * aside * ((beside + 1) / 2) / k_places - 0.5 * section;
        if (is_clear(at, across)) return box(at, across);
      }
    }
    return box(first, middle - 0.5 * section);
  }

 private:
  [[nodiscard]] glm::dvec3 point(double along, double across, double high) const {
    return along * question_.action.direction + across * level_ + high * question_.side;
  }

  /// Above a grid of places, where the mold is closed and on the lifter's way.
  [[nodiscard]] bool is_clear(double along, double across) const {
    constexpr int k_grid = 5, k_steps = 8;
    const double inner = question_.section - 2.0 * question_.lateral;
    for (int step = 0; step <= k_steps; ++step) {
      for (int cell = 0; cell < k_grid * k_grid; ++cell) {
        const double u = along + question_.lateral + inner * (cell % k_grid) / (k_grid - 1),
                     v = across + question_.lateral +
                         inner * static_cast<double>(cell / k_grid) / (k_grid - 1);
        const glm::dvec3 at =
            point(u + question_.action.travel * step / k_steps, v, high_.greatest + question_.lateral);
        if (question_.model.rays().surface_point_blocked(question_.model.frame.to_unit(at), glm::vec3(0.0F),
                                                         glm::vec3(question_.side)))
          return false;
      }
    }
    return true;
  }

  [[nodiscard]] TriangleMesh box(double along, double across) const {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
      mesh.vertices.push_back(point(along + ((corner & 1) != 0 ? question_.section : 0.0),
                                    across + ((corner & 2) != 0 ? question_.section : 0.0),
                                    (corner & 4) != 0 ? out_ : high_.greatest));
    // Direction, level and side are right-handed or not.
    const bool right = glm::dot(glm::cross(question_.action.direction, level_), question_.side) > 0.0;
    constexpr std::array<std::array<VertexIndex, 4>, 6> k_faces = {
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : k_faces) {
      mesh.facets.push_back(right ? std::array{a, b, c} : std::array{a, c, b});
      mesh.facets.push_back(right ? std::array{a, c, d} : std::array{a, d, c});
    }
    return mesh;
  }

  static constexpr double k_beyond = 0.08;  // the part, share of the diagonal

  const StemQuestion& question_;
  glm::dvec3 level_;
  Span along_, wide_, high_;
  double out_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

TriangleMesh lifter_stem(const StemQuestion& question) { return StemFinder(question).stem(); }

}  // namespace moldlight
