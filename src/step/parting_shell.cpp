#include "step/parting_shell.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>
#include <gp_Cone.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>

namespace moldlight::step {

namespace {

/// A loop of fewer sides is no circle.
constexpr std::size_t k_least_sides = 24;

using Point = StepSurface::Point;
using Loop = std::vector<Point>;
using Ends = std::pair<Point, Point>;

gp_Pnt point_of(const Point& at) { return {at[0], at[1], at[2]}; }
gp_Dir normal_of(const StepSurface::Face& face) { return {face.normal[0], face.normal[1], face.normal[2]}; }
Ends ends_of(const Loop& loop, std::size_t k) {
  const auto [low, high] = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
  return {low, high};
}

/// A loop all of whose corners are on a circle, evenly.
struct RoundLoop {
  gp_Pnt centre;
  gp_Dir normal;  // of the plane face that it bounds
  double radius = 0.0;
  std::size_t sides = 0;
};

std::optional<RoundLoop> circle_of(const StepSurface::Face& face, const Loop& loop, double tolerance) {
  if (loop.size() < k_least_sides) return std::nullopt;
  gp_XYZ sum(0, 0, 0);
  for (const Point& at : loop) sum += point_of(at).XYZ();
  const gp_Pnt centre(sum / static_cast<double>(loop.size()));
  const RoundLoop circle{centre, normal_of(face), centre.Distance(point_of(loop.front())), loop.size()};
  const double side = 2.0 * circle.radius * std::sin(std::numbers::pi / static_cast<double>(loop.size()));
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const gp_Pnt at = point_of(loop[k]), next = point_of(loop[(k + 1) % loop.size()]);
    if (std::abs(centre.Distance(at) - circle.radius) > tolerance ||
        std::abs(at.Distance(next) - side) > 2.0 * tolerance)
      return std::nullopt;
  }
  return circle;
}

/// Cones as rings of four-sided faces between two circles.
class Cones {
 public:
  Cones(const StepSurface& surface, double tolerance) : tolerance_(tolerance) {
    for (const StepSurface::Face& face : surface.faces) {
      for (const Loop& loop : face.loops) {
        const auto circle = circle_of(face, loop, tolerance);
        if (!circle) continue;
        for (std::size_t k = 0; k < loop.size(); ++k) circle_at_.emplace(ends_of(loop, k), circles_.size());
        circles_.push_back(*circle);
      }
    }
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> rings;
    for (std::size_t k = 0; k < surface.faces.size() && !circles_.empty(); ++k) {
      const auto& loops = surface.faces[k].loops;
      if (loops.size() != 1 || loops[0].size() != 4) continue;
      std::set<std::size_t> beside;
      for (std::size_t side = 0; side < 4; ++side)
        if (const auto found = circle_at_.find(ends_of(loops[0], side)); found != circle_at_.end())
          beside.insert(found->second);
      if (beside.size() == 2) rings[{*beside.begin(), *beside.rbegin()}].push_back(k);
    }
    for (const auto& [ends, faces] : rings)
      if (add(circles_[ends.first], circles_[ends.second], faces.size(), ends))
        left_out_.insert(faces.begin(), faces.end());
  }

  [[nodiscard]] const std::vector<TopoDS_Face>& faces() const { return faces_; }
  [[nodiscard]] bool replaces(std::size_t face) const { return left_out_.contains(face); }
  /// The edge that a loop around a cone is, as the loop walks it.
  [[nodiscard]] std::optional<TopoDS_Edge> edge_of(const Loop& loop) const {
    const auto found = circle_at_.find(ends_of(loop, 0));
    if (found == circle_at_.end() || !edges_.contains(found->second)) return std::nullopt;
    const auto& [edge, axis] = edges_.at(found->second);
    const gp_Pnt& centre = circles_[found->second].centre;
    const gp_Vec turn = gp_Vec(centre, point_of(loop[0])).Crossed(gp_Vec(centre, point_of(loop[1])));
    return TopoDS::Edge(edge.Oriented(turn.Dot(axis) > 0.0 ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

 private:
  bool add(const RoundLoop& a, const RoundLoop& b, std::size_t faces,
           std::pair<std::size_t, std::size_t> numbers) {
    const bool turned = b.radius < a.radius;
    const RoundLoop &small = turned ? b : a, &large = turned ? a : b;
    const gp_Vec way(small.centre, large.centre);
    const double height = way.Magnitude(), wider = large.radius - small.radius;
    if (faces != a.sides || faces != b.sides || height <= tolerance_ || wider <= tolerance_) return false;
    const gp_Dir axis(way);
    if (small.radius * gp_Vec(axis).CrossMagnitude(gp_Vec(small.normal)) > tolerance_) return false;
    const gp_Cone cone(gp_Ax3(small.centre, axis), std::atan(wider / height), small.radius);
    const TopoDS_Face made =
        BRepBuilderAPI_MakeFace(cone, 0.0, 2.0 * std::numbers::pi, 0.0, std::hypot(wider, height));
    for (TopExp_Explorer walk(made, TopAbs_EDGE); walk.More(); walk.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(walk.Current());
      if (BRep_Tool::IsClosed(edge, made)) continue;  // the seam
      const bool is_small = std::abs(BRepAdaptor_Curve(edge).Circle().Radius() - small.radius) < 0.5 * wider;
      edges_.insert_or_assign(is_small == turned ? numbers.second : numbers.first, std::pair(edge, axis));
    }
    // Its own normal leads away from the axis, towards the small end.
    faces_.push_back(axis.Dot(small.normal) < 0.0 ? made : TopoDS::Face(made.Reversed()));
    return true;
  }

  double tolerance_;
  std::vector<RoundLoop> circles_;
  std::map<Ends, std::size_t> circle_at_;
  std::map<std::size_t, std::pair<TopoDS_Edge, gp_Dir>> edges_;  // of circles, with the axis they turn about
  std::vector<TopoDS_Face> faces_;
  std::set<std::size_t> left_out_;
};

class ShellMaker {
 public:
  explicit ShellMaker(const StepSurface& surface)
      : tolerance_(std::max(surface.tolerance, Precision::Confusion())), cones_(surface, tolerance_) {
    builder_.MakeShell(shell_);
    for (std::size_t k = 0; k < surface.faces.size(); ++k)
      if (!cones_.replaces(k)) add(surface.faces[k]);
    for (const TopoDS_Face& face : cones_.faces()) builder_.Add(shell_, face);
  }
  [[nodiscard]] const TopoDS_Shell& shell() const { return shell_; }

 private:
  void add(const StepSurface::Face& face) {
    TopoDS_Face made;
    builder_.MakeFace(made, new Geom_Plane(gp_Pln(point_of(face.point), normal_of(face))), tolerance_);
    for (const Loop& loop : face.loops) {
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      if (const auto circle = cones_.edge_of(loop)) {
        builder_.Add(wire, *circle);
      } else {
        for (std::size_t k = 0; k < loop.size(); ++k)
          builder_.Add(wire, edge(loop[k], loop[(k + 1) % loop.size()]));
      }
      wire.Closed(Standard_True);
      builder_.Add(made, wire);
    }
    builder_.Add(shell_, made);
  }

  TopoDS_Vertex vertex(const Point& at) {
    const auto [entry, fresh] = vertices_.try_emplace(at);
    if (fresh) builder_.MakeVertex(entry->second, point_of(at), tolerance_);
    return entry->second;
  }

  TopoDS_Shape edge(const Point& from, const Point& to) {
    const bool turned = to < from;
    const auto [entry, fresh] = edges_.try_emplace(turned ? std::pair(to, from) : std::pair(from, to));
    if (fresh) {
      BRepBuilderAPI_MakeEdge made(vertex(entry->first.first), vertex(entry->first.second));
      if (!made.IsDone())
        throw std::runtime_error("has a parting surface with edges too short for OpenCASCADE");
      entry->second = made.Edge();
      builder_.UpdateEdge(entry->second, tolerance_);
    }
    return turned ? entry->second.Reversed() : TopoDS_Shape(entry->second);
  }

  double tolerance_;
  Cones cones_;
  BRep_Builder builder_;
  TopoDS_Shell shell_;
  std::map<Point, TopoDS_Vertex> vertices_;
  std::map<Ends, TopoDS_Edge> edges_;
};

}  // namespace

TopoDS_Shell shell_of(const StepSurface& surface) { return ShellMaker(surface).shell(); }

}  // namespace moldlight::step
