// The edges of a part, cut where borders end on them.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <BRepTools_ReShape.hxx>
#include <Geom_Curve.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_TShape.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include "step/face_mesh.hpp"

namespace moldlight::step {

class CutEdges {
 public:
  /// Places nearer than `tolerance`, in mm, are one.
  explicit CutEdges(double tolerance) : tolerance_(tolerance) {}

  void ask(const OnEdge& at) { asked_[at.edge.TShape().get()].push_back(at); }
  /// Once all have been asked for.
  void cut();

  /// Where a border that asked for this place ends: vertex and parameter.
  [[nodiscard]] std::pair<TopoDS_Vertex, double> stop(const OnEdge& at) const;
  /// Adds the edge, or the pieces of it.
  void append(const TopoDS_Edge& edge, TopTools_ListOfShape& list) const;
  void replace_in(BRepTools_ReShape& shapes) const;

 private:
  using TShape = const TopoDS_TShape*;
  struct Stop {
    double parameter = 0.0;
    TopoDS_Vertex vertex;
  };
  struct Cut {
    std::vector<Stop> stops;
    TopoDS_Edge edge;
    TopoDS_Wire pieces;  // null where it stays whole
  };
  /// Along a pole, where all is one point, as share of its `range`, in millionths.
  static double distance(const Handle(Geom_Curve) & curve, double a, double b, double range);

  double tolerance_;
  std::map<TShape, std::vector<OnEdge>> asked_;
  std::map<TShape, Cut> cuts_;
};

}  // namespace moldlight::step
