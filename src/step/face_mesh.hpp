// The facets that OpenCASCADE has cut a face into: where a point of one is among the parameters of the
// surface, and on which edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

namespace moldlight::step {

/// Of labels that are not those of the part.
inline constexpr const char* k_beside = "has borders beside its faces; use --mesh";
/// Of a border and an edge that it runs along, in tolerances.
inline constexpr double k_near_edge = 0.1;

/// A place on an edge of the part.
struct OnEdge {
  TopoDS_Edge edge;  // as its face has it
  double parameter = 0.0;
};

/// A point of a border.
struct Place {
  gp_Pnt2d uv;
  gp_Pnt point;
  std::optional<OnEdge> on_edge;
};

/// With the places of the corners of facets among the parameters and on the edges of the face.
class FaceMesh {
 public:
  /// `tolerance`, in mm, of a point and its facet. Throws std::runtime_error for a face that has none.
  FaceMesh(const TopoDS_Face& face, double tolerance);

  /// Of a point in facet `k`, from 0. Throws std::runtime_error where it is not there.
  [[nodiscard]] Place place(std::size_t k, const gp_Pnt& point) const;
  /// Whether both points are on one side of facet `k` that is on an edge of the face.
  [[nodiscard]] bool along_edge(std::size_t k, const gp_Pnt& from, const gp_Pnt& to) const;
  /// The greatest height of facet `k` over a side.
  [[nodiscard]] double greatest_height(std::size_t k) const;

 private:
  struct Side {
    TopoDS_Edge edge;
    double low = 0.0, high = 0.0;  // parameters at the nodes of lower and higher number
  };
  struct Weighed {
    std::array<int, 3> nodes;
    std::array<double, 3> weights, heights;  // of the facet over the side across from the node
  };

  [[nodiscard]] std::map<std::pair<int, int>, Side>::const_iterator side_at(const std::array<int, 3>& nodes,
                                                                            std::size_t across) const {
    return sides_.find(std::minmax(nodes[(across + 1) % 3], nodes[(across + 2) % 3]));
  }
  [[nodiscard]] gp_Pnt corner_of(int node) const {
    return mesh_->Node(node).Transformed(location_.Transformation());
  }
  [[nodiscard]] Weighed weighed(std::size_t k, const gp_Pnt& point) const;

  double tolerance_, near_;  // of a point and its facet; of a point and an edge
  TopLoc_Location location_;
  Handle(Poly_Triangulation) mesh_;
  std::map<int, OnEdge> nodes_;  // a pole is on its edge without length
  std::map<std::pair<int, int>, Side> sides_;
};

}  // namespace moldlight::step
