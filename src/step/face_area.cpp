#include "step/face_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>

namespace moldlight::step {

namespace {

constexpr double k_area_error = 1e-9;  // of the whole, that halving a piece may change
constexpr int k_most_halvings = 12, k_most_parts = 5;

/// Gauss and Legendre's rule with eight points.
double integral(double from, double to, const auto& value) {
  constexpr std::array<std::pair<double, double>, 4> k_rule = {{{0.1834346424956498, 0.3626837833783620},
                                                                {0.5255324099163290, 0.3137066458778873},
                                                                {0.7966664774136267, 0.2223810344533745},
                                                                {0.9602898564975363, 0.1012285362903763}}};
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0.0;
  for (const auto& [place, weight] : k_rule)
    sum += weight * (value(middle - half * place) + value(middle + half * place));
  return half * sum;
}

double halved(double from, double to, double whole, double error, int left, const auto& value) {
  const double middle = 0.5 * (from + to);
  const double first = integral(from, middle, value), second = integral(middle, to, value);
  if (left == 0 || std::abs(first + second - whole) <= error) return first + second;
  return halved(from, middle, first, error, left - 1, value) +
         halved(middle, to, second, error, left - 1, value);
}

/// The inner integral, times the step of the other parameter.
class Strips {
 public:
  explicit Strips(const TopoDS_Face& face) : surface_(face, Standard_False) {
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    begin_ = {u0, v0};
    const GeomAbs_SurfaceType kind = surface_.GetType();
    even_in_v_ = kind == GeomAbs_SurfaceOfExtrusion;
    if (even_in_v_ || kind <= GeomAbs_Torus || kind == GeomAbs_SurfaceOfRevolution) return;
    TColStd_Array1OfReal smooth(1, surface_.NbUIntervals(GeomAbs_C3) + 1);
    surface_.UIntervals(smooth, GeomAbs_C3);
    spans_.push_back(smooth.First());
    for (int k = smooth.Lower(); k < smooth.Upper(); ++k)
      add_span(smooth(k), smooth(k + 1), {v0, v1}, k_most_parts);
  }

  [[nodiscard]] double at(const gp_Pnt2d& uv, const gp_Vec2d& step) const {
    if (even_in_v_) return -(uv.Y() - begin_.Y()) * density(uv.X(), begin_.Y()) * step.X();
    if (spans_.empty()) return (uv.X() - begin_.X()) * density(begin_.X(), uv.Y()) * step.Y();
    const double high = std::max(uv.X(), begin_.X());
    double sum = 0.0, from = std::min(uv.X(), begin_.X());
    const auto across = [&](double u) { return density(u, uv.Y()); };
    for (auto next = std::upper_bound(spans_.begin(), spans_.end(), from);
         next != spans_.end() && *next < high; ++next) {
      sum += integral(from, *next, across);
      from = *next;
    }
    sum += integral(from, high, across);
    return std::copysign(sum, uv.X() - begin_.X()) * step.Y();
  }

 private:
  /// In parts that are each one step of the rule.
  void add_span(double from, double to, const std::array<double, 2>& v, int left) {
    const double middle = 0.5 * (from + to);
    bool exact = true;
    for (const double at : {v[0], 0.5 * (v[0] + v[1]), v[1]}) {
      const auto across = [&](double u) { return density(u, at); };
      const double whole = integral(from, to, across);
      exact = exact && std::abs(integral(from, middle, across) + integral(middle, to, across) - whole) <=
                           k_area_error * whole;
    }
    if (exact || left == 0) return spans_.push_back(to);
    add_span(from, middle, v, left - 1);
    add_span(middle, to, v, left - 1);
  }

  [[nodiscard]] double density(double u, double v) const {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface_.D1(u, v, point, along_u, along_v);
    return along_u.CrossMagnitude(along_v);
  }

  BRepAdaptor_Surface surface_;
  gp_Pnt2d begin_;             // where the inner integral begins
  bool even_in_v_ = false;     // the density does not depend on v; nor on u where there are no spans
  std::vector<double> spans_;  // of u
};

}  // namespace

double area_of(const TopoDS_Face& face) {
  const Strips strips(face);
  struct Piece {
    Geom2dAdaptor_Curve curve;
    double from = 0.0, to = 0.0, sign = 1.0, whole = 0.0;
  };
  std::vector<Piece> pieces;
  double scale = 0.0;
  const auto value = [&](const Piece& piece) {
    return [&](double t) {
      gp_Pnt2d uv;
      gp_Vec2d step;
      piece.curve.D1(t, uv, step);
      return strips.at(uv, step);
    };
  };
  for (TopExp_Explorer walk(face, TopAbs_EDGE); walk.More(); walk.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(walk.Current());
    if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
    double first = 0.0, last = 0.0;
    const Handle(Geom2d_Curve) in_face = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (in_face.IsNull()) continue;
    const Geom2dAdaptor_Curve curve(in_face, first, last);
    TColStd_Array1OfReal smooth(1, curve.NbIntervals(GeomAbs_C3) + 1);
    curve.Intervals(smooth, GeomAbs_C3);
    for (int k = smooth.Lower(); k < smooth.Upper(); ++k) {
      Piece piece{curve, smooth(k), smooth(k + 1), edge.Orientation() == TopAbs_FORWARD ? 1.0 : -1.0};
      piece.whole = integral(piece.from, piece.to, value(piece));
      scale += std::abs(piece.whole);
      pieces.push_back(std::move(piece));
    }
  }
  double area = 0.0;
  for (const Piece& piece : pieces)
    area += piece.sign *
            halved(piece.from, piece.to, piece.whole, k_area_error * scale, k_most_halvings, value(piece));
  return std::abs(area);
}

}  // namespace moldlight::step
