#include "step/face_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace moldlight::step {

namespace {

constexpr double k_same_place = 1e-6;  // mm, of a point and a facet's side or corner

}  // namespace

FaceMesh::FaceMesh(const TopoDS_Face& face, double tolerance)
    : tolerance_(tolerance), near_(std::max(k_same_place, k_near_edge * tolerance)) {
  mesh_ = BRep_Tool::Triangulation(face, location_);
  if (mesh_.IsNull() || !mesh_->HasUVNodes()) throw std::runtime_error("has a face without parameters");
  for (TopExp_Explorer walk(face, TopAbs_EDGE); walk.More(); walk.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(walk.Current());
    const auto polygon = BRep_Tool::PolygonOnTriangulation(edge, mesh_, location_);
    if (polygon.IsNull() || !polygon->HasParameters()) continue;
    const bool pole = BRep_Tool::Degenerated(edge);
    for (int k = 1; k <= polygon->NbNodes(); ++k) {
      const OnEdge at{edge, polygon->Parameter(k)};
      if (pole)
        nodes_.insert_or_assign(polygon->Node(k), at);
      else
        nodes_.insert({polygon->Node(k), at});
      if (k == 1 || pole) continue;
      const int a = polygon->Node(k - 1), b = polygon->Node(k);
      sides_[std::minmax(a, b)] = {edge, polygon->Parameter(a < b ? k - 1 : k),
                                   polygon->Parameter(a < b ? k : k - 1)};
    }
  }
}

Place FaceMesh::place(std::size_t k, const gp_Pnt& point) const {
  const auto [nodes, weights, heights] = weighed(k, point);
  Place place{.uv = {0, 0}, .point = point, .on_edge = std::nullopt};
  for (std::size_t i = 0; i < 3; ++i) place.uv.ChangeCoord() += weights[i] * mesh_->UVNode(nodes[i]).XY();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = nodes_.find(nodes[i]);
    const double corner = corner_of(nodes[i]).Distance(point);
    if (corner > (found == nodes_.end() ? k_same_place : near_)) continue;
    place.uv = mesh_->UVNode(nodes[i]);
    if (found != nodes_.end()) place.on_edge = found->second;
    return place;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto side = side_at(nodes, i);
    if (weights[i] * heights[i] > near_ || side == sides_.end()) continue;
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
    const double high = nodes[a] < nodes[b] ? weights[b] : weights[a];
    const Side& on = side->second;
    place.on_edge = OnEdge{on.edge, on.low + high * (on.high - on.low)};
  }
  return place;
}

bool FaceMesh::along_edge(std::size_t k, const gp_Pnt& from, const gp_Pnt& to) const {
  const auto a = weighed(k, from), b = weighed(k, to);
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.weights[i] * a.heights[i] <= near_ && b.weights[i] * b.heights[i] <= near_ &&
        side_at(a.nodes, i) != sides_.end())
      return true;
  }
  return false;
}

double FaceMesh::greatest_height(std::size_t k) const {
  std::array<int, 3> nodes{};
  mesh_->Triangle(static_cast<int>(k) + 1).Get(nodes[0], nodes[1], nodes[2]);
  return std::ranges::max(weighed(k, corner_of(nodes[0])).heights);
}

FaceMesh::Weighed FaceMesh::weighed(std::size_t k, const gp_Pnt& point) const {
  Weighed found{};
  mesh_->Triangle(static_cast<int>(k) + 1).Get(found.nodes[0], found.nodes[1], found.nodes[2]);
  std::array<gp_XYZ, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = corner_of(found.nodes[i]).XYZ();
  const gp_XYZ normal = (at[1] - at[0]).Crossed(at[2] - at[0]);
  const double square = normal.SquareModulus();
  if (square <= 0.0) throw std::runtime_error("has a border on a facet without area");
  gp_XYZ there(0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const gp_XYZ &a = at[(i + 1) % 3], &b = at[(i + 2) % 3];
    found.weights[i] = (b - a).Crossed(point.XYZ() - a).Dot(normal) / square;
    found.heights[i] = std::sqrt(square) / (b - a).Modulus();
    there += found.weights[i] * at[i];
  }
  if ((there - point.XYZ()).Modulus() > tolerance_) throw std::runtime_error(k_beside);
  return found;
}

}  // namespace moldlight::step
