#include "parting/mold_halves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "actions/part_axes.hpp"
#include "mesh/facet_geometry.hpp"

namespace moldlight {

int axis_of(const glm::dvec3& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) == 1.0) return axis;
  }
  return -1;
}

MoldFrame mold_frame(const glm::dvec3& direction) {
  MoldFrame frame;
  frame.z = direction;
  const int axis = axis_of(direction);
  if (axis >= 0) {
    frame.x = frame.y = glm::dvec3(0.0);
    frame.x[(axis + 1) % 3] = 1.0;
    frame.y[(axis + 2) % 3] = direction[axis];
    return frame;
  }
  const glm::dvec3 size = glm::abs(direction);
  glm::dvec3 least(0.0);
  least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
  frame.x = glm::normalize(glm::cross(least, direction));
  frame.y = glm::cross(direction, frame.x);
  return frame;
}

MoldFrame mold_frame(const PartModel& model, const glm::dvec3& direction) {
  MoldFrame frame = mold_frame(direction);
  if (axis_of(direction) >= 0) return frame;
  const PartAxes axes = part_axes(model, direction);
  if (!axes.by_walls) return frame;
  const std::array<glm::dvec3, 4> along = {axes.x, -axes.x, axes.y, -axes.y};
  const auto off = [&](const glm::dvec3& way) { return -glm::dot(way, frame.x); };
  frame.x = glm::normalize(*std::ranges::min_element(along, {}, off));
  frame.y = glm::cross(direction, frame.x);
  return frame;
}

std::string_view piece_name(PieceKind kind) {
  constexpr std::array<std::string_view, 3> k_names = {"slide", "lifter", "insert"};
  return k_names[static_cast<std::size_t>(kind)];
}

std::size_t MoldHalves::count(PieceKind kind) const {
  return static_cast<std::size_t>(std::ranges::count(inserts, kind, &MoldBody::kind));
}

double MoldHalves::volume(PieceKind kind) const {
  double sum = 0.0;
  for (const MoldBody& body : inserts) sum += body.kind == kind ? body.volume : 0.0;
  return sum;
}

MoldBody mold_body(TriangleMesh mesh, double scale) {
  for (glm::dvec3& vertex : mesh.vertices) vertex *= scale;
  MoldBody body{.mesh = std::move(mesh), .name = "insert"};
  body.volume = signed_volume(body.mesh);
  return body;
}

bool is_speck(const MoldBody& body, double unit) {
  constexpr double k_thickness = 0.5 / 2048.0;  // of the diagonal
  return 2.0 * std::abs(body.volume) <= k_thickness * unit * facet_geometry(body.mesh).total_area;
}

glm::dmat4 to_part_of(const MoldHalves& halves) {
  if (halves.written.part_frame) return glm::dmat4(1.0);
  const MoldFrame& frame = halves.frame;
  return {{frame.x, 0.0}, {frame.y, 0.0}, {frame.z, 0.0}, {halves.scale * halves.centre, 1.0}};
}

TriangleMesh in_mold(const MoldHalves& halves, TriangleMesh part, double diagonal) {
  for (glm::dvec3& vertex : part.vertices) vertex = halves.frame.to_mold(vertex - halves.centre) / diagonal;
  return part;
}

TriangleMesh unscaled(const MoldHalves& halves, TriangleMesh body, double diagonal) {
  for (glm::dvec3& vertex : body.vertices) vertex /= halves.scale * diagonal;
  return body;
}

TriangleMesh in_part(const MoldHalves& halves, TriangleMesh body) {
  for (glm::dvec3& vertex : body.vertices)
    vertex = halves.centre + halves.frame.to_part(vertex / halves.scale);
  return body;
}

glm::dvec3 insert_place(const MoldHalves& halves, std::size_t insert) {
  return halves.centre + halves.frame.to_part(bounds(halves.inserts[insert].mesh).center() / halves.scale);
}

}  // namespace moldlight
