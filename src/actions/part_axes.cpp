#include "actions/part_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr double k_quarter = 0.5 * std::numbers::pi;
constexpr double k_upright_sine = 0.02;  // of a wall's lean at most
constexpr double k_same_turn = 3e-4;     // radians, between walls that face one way
constexpr double k_least_upright = 0.1;  // of all upright walls: fewer say nothing
constexpr std::size_t k_most_facings = 3;
constexpr double k_least_walls = 0.1;  // of the surface

/// Where walls face, by a quarter of a turn: a wall says as much of where it stands along.
struct Facing {
  double turn = 0.0;  // from the frame's x, [0, a quarter)
  double area = 0.0;
};

/// The file's axes that lie across `direction`, as far as they do.
std::pair<glm::dvec3, glm::dvec3> file_axes(const glm::dvec3& direction) {
  int nearest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < std::abs(direction[nearest]) - 1e-9) nearest = axis;
  }
  glm::dvec3 x(0.0);
  x[nearest] = 1.0;
  x = glm::normalize(x - glm::dot(x, direction) * direction);
  return {x, glm::cross(direction, x)};
}

/// The most area first; those that turn into each other at the end of the quarter are one.
std::vector<Facing> facings(const PartModel& model, const PartAxes& axes) {
  std::vector<Facing> walls;
  double total = 0.0;
  for (FacetIndex facet = 0; facet < model.geometry.normals.size(); ++facet) {
    const glm::dvec3& normal = model.geometry.normals[facet];
    const double area = model.geometry.areas[facet];
    if (area <= 0.0 || std::abs(glm::dot(normal, axes.z)) > k_upright_sine) continue;
    double turn = std::fmod(std::atan2(glm::dot(normal, axes.y), glm::dot(normal, axes.x)), k_quarter);
    if (turn < -0.5 * k_same_turn) turn += k_quarter;
    if (turn > k_quarter - 0.5 * k_same_turn) turn -= k_quarter;
    walls.push_back({turn, area});
    total += area;
  }
  std::ranges::sort(walls, {}, [](const Facing& wall) { return std::pair(wall.turn, wall.area); });
  std::vector<Facing> found;
  for (std::size_t k = 0; k < walls.size();) {
    const double first = walls[k].turn;
    Facing facing;
    double moment = 0.0;
    for (; k < walls.size() && walls[k].turn <= first + k_same_turn; ++k) {
      facing.area += walls[k].area;
      moment += walls[k].area * walls[k].turn;
    }
    facing.turn = moment / facing.area;
    // But for the rounding of its file a wall faces the file's axis.
    if (std::abs(facing.turn) < 0.5 * k_same_turn) facing.turn = 0.0;
    found.push_back(facing);
  }
  std::erase_if(found, [&](const Facing& facing) { return facing.area < k_least_upright * total; });
  std::ranges::stable_sort(found, std::greater(), &Facing::area);
  if (found.size() > k_most_facings) found.resize(k_most_facings);
  return found;
}

/// The third moments of the surface: which way it is longer than the other.
double lean_along(const PartModel& model, const PartAxes& axes, const glm::dvec3& along) {
  double sum = 0.0, total = 0.0;
  for (FacetIndex facet = 0; facet < model.geometry.areas.size(); ++facet) {
    for (int corner = 0; corner < 3; ++corner) {
      const double at =
          glm::dot(model.part.mesh.corner(facet, corner) - axes.centre, along) / model.frame.diagonal;
      sum += model.geometry.areas[facet] * at * at * at;
    }
    total += model.geometry.areas[facet];
  }
  return total > 0.0 ? sum / total : 0.0;
}

glm::dvec3 surface_centre(const PartModel& model) {
  glm::dvec3 sum(0.0);
  double total = 0.0;
  for (FacetIndex facet = 0; facet < model.geometry.areas.size(); ++facet) {
    for (int corner = 0; corner < 3; ++corner)
      sum += model.geometry.areas[facet] / 3.0 * (model.part.mesh.corner(facet, corner) - model.frame.center);
    total += model.geometry.areas[facet];
  }
  return total > 0.0 ? model.frame.center + sum / total : model.frame.center;
}

/// 0 and neighbours are one key, whatever the sign of rounding.
std::int64_t steps_of(double value, double step) { return std::llround(value / step); }

}  // namespace

PartAxes part_axes(const PartModel& model, const glm::dvec3& direction) {
  PartAxes axes;
  axes.centre = surface_centre(model);
  axes.z = direction;
  axes.step = 1e-4 * model.frame.diagonal;
  std::tie(axes.x, axes.y) = file_axes(direction);
  const std::vector<Facing> found = facings(model, axes);
  const std::array<glm::dvec3, 2> file = {axes.x, axes.y};
  const auto turned = [&](double turn) { return std::cos(turn) * file[0] + std::sin(turn) * file[1]; };
  const double turn = found.empty() ? 0.0 : found.front().turn;
  axes.by_walls = !found.empty() && found.front().area > k_least_walls * model.geometry.total_area;
  axes.x = turned(turn);
  axes.y = turned(turn + k_quarter);
  constexpr double k_alike = 1e-9;  // leans that rounding alone distinguishes
  std::array<double, 2> leans = {lean_along(model, axes, axes.x), lean_along(model, axes, axes.y)};
  if (std::abs(leans[1]) > std::abs(leans[0]) + k_alike) {
    std::swap(axes.x, axes.y);
    std::swap(leans[0], leans[1]);
  }
  if (leans[0] < -k_alike) axes.x = -axes.x;
  if (leans[1] < -k_alike) axes.y = -axes.y;
  for (std::size_t k = 0; k < std::max<std::size_t>(1, found.size()); ++k) {
    const double its = k == 0 ? turn : found[k].turn;
    for (const glm::dvec3& across : {turned(its), turned(its + k_quarter)}) {
      axes.across.push_back(across);
      axes.across.push_back(-across);
    }
  }
  std::ranges::stable_sort(axes.across.begin(), axes.across.begin() + 4, std::greater(),
                           [&](const glm::dvec3& across) { return direction_key(axes, across); });
  return axes;
}

PlaceKey place_key(const PartAxes& axes, const glm::dvec3& place) {
  const glm::dvec3 from = place - axes.centre;
  return {steps_of(glm::dot(from, axes.z), axes.step), steps_of(glm::dot(from, axes.x), axes.step),
          steps_of(glm::dot(from, axes.y), axes.step)};
}

PlaceKey direction_key(const PartAxes& axes, const glm::dvec3& direction) {
  constexpr double k_step = 1e-6;
  return {steps_of(glm::dot(direction, axes.z), k_step), steps_of(glm::dot(direction, axes.x), k_step),
          steps_of(glm::dot(direction, axes.y), k_step)};
}

}  // namespace moldlight
