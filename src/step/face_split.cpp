#include "step/face_split.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include <BOPAlgo_BuilderFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>

#include "step/border_chains.hpp"
#include "step/border_curves.hpp"
#include "step/cut_edges.hpp"
#include "step/face_area.hpp"

namespace moldlight::step {

namespace {

constexpr double k_area_share = 1e-5;  // that the pieces of a face may differ from it
constexpr double k_least_share = 0.2;  // of a face, of the label that has most of it on the facets
constexpr std::uint32_t k_none = StepLabels::k_none;

using TShape = const TopoDS_TShape*;

/// The pieces of a face, which is looked at forward; empty where they are not sound.
std::vector<LabelledFace> pieces_of(const TopoDS_Face& face, const std::vector<Chain>& chains,
                                    const CutEdges& cuts, double tolerance) {
  std::map<TShape, std::pair<std::uint32_t, std::uint32_t>> sides;
  std::map<std::uint32_t, TopoDS_Vertex> inner;
  TopTools_ListOfShape edges;
  for (TopExp_Explorer walk(face, TopAbs_EDGE); walk.More(); walk.Next())
    cuts.append(TopoDS::Edge(walk.Current()), edges);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  for (const Chain& chain : chains) {
    std::vector<gp_Pnt2d> points;
    for (const Place& place : chain.places) points.push_back(place.uv);
    const auto end = [&](const Place& place, std::uint32_t number, gp_Pnt2d& uv) {
      if (!place.on_edge) {
        TopoDS_Vertex& vertex = inner[number];
        if (vertex.IsNull())
          BRep_Builder().MakeVertex(vertex, surface->Value(uv.X(), uv.Y()), Precision::Confusion());
        return vertex;
      }
      const auto [vertex, parameter] = cuts.stop(*place.on_edge);
      // Of both curves of a seam the near one.
      const TopoDS_Edge& edge = place.on_edge->edge;
      std::optional<gp_Pnt2d> nearest;
      for (const TopAbs_Orientation side : {TopAbs_FORWARD, TopAbs_REVERSED}) {
        double first = 0.0, last = 0.0;
        const auto curve = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Oriented(side)), face, first, last);
        if (curve.IsNull()) continue;
        const gp_Pnt2d at = curve->Value(parameter);
        if (!nearest || at.Distance(uv) < nearest->Distance(uv)) nearest = at;
      }
      if (nearest) uv = *nearest;
      return vertex;
    };
    const TopoDS_Vertex first = end(chain.places.front(), chain.first, points.front());
    const TopoDS_Vertex last = end(chain.places.back(), chain.last, points.back());
    for (const TopoDS_Edge& edge : border_edges(face, first, last, points, tolerance)) {
      sides[edge.TShape().get()] = {chain.left, chain.right};
      edges.Append(edge.Oriented(TopAbs_FORWARD));
      edges.Append(edge.Oriented(TopAbs_REVERSED));
    }
  }
  BOPAlgo_BuilderFace builder;
  builder.SetFace(face);
  builder.SetShapes(edges);
  builder.Perform();
  if (builder.HasErrors()) return {};
  std::vector<LabelledFace> pieces;
  double area = 0.0;
  for (const TopoDS_Shape& shape : builder.Areas()) {
    LabelledFace piece{.face = TopoDS::Face(shape), .label = k_none};
    for (TopExp_Explorer walk(shape, TopAbs_EDGE); walk.More(); walk.Next()) {
      const auto found = sides.find(walk.Current().TShape().get());
      if (found == sides.end()) continue;
      const auto [left, right] = found->second;
      const std::uint32_t label = walk.Current().Orientation() == TopAbs_FORWARD ? left : right;
      if (piece.label != k_none && piece.label != label) return {};
      piece.label = label;
    }
    if (piece.label == k_none || !BRepCheck_Analyzer(shape).IsValid()) return {};
    piece.area = area_of(piece.face);
    area += piece.area;
    pieces.push_back(piece);
  }
  const double whole = area_of(face);
  if (std::abs(area - whole) > k_area_share * whole) return {};
  return pieces;
}

/// Whether the label that most facets have has some of the face. A border along the outline may be on the
/// other side of it, as facets leave a bent outline.
bool has_label(const std::vector<LabelledFace>& pieces, std::uint32_t label) {
  double there = 0.0, all = 0.0;
  for (const LabelledFace& piece : pieces) {
    all += piece.area;
    if (piece.label == label) there += piece.area;
  }
  return there >= k_least_share * all;
}

}  // namespace

LabelledPart split_faces(const std::vector<PlacedBody>& bodies, const StepLabels& labels) {
  std::vector<TopoDS_Face> faces;
  std::vector<std::uint32_t> first_facets;
  std::vector<gp_Trsf> to_body;
  std::vector<std::size_t> first_faces;  // of bodies
  std::uint32_t facets = 0;
  for (const PlacedBody& body : bodies) {
    first_faces.push_back(faces.size());
    for (TopExp_Explorer walk(body.shape, TopAbs_FACE); walk.More(); walk.Next()) {
      to_body.push_back(body.place.Inverted());
      faces.push_back(TopoDS::Face(walk.Current()));
      first_facets.push_back(facets);
      TopLoc_Location location;
      const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(faces.back(), location);
      if (!mesh.IsNull()) facets += static_cast<std::uint32_t>(mesh->NbTriangles());
    }
  }
  if (faces.size() < labels.of_face.size()) throw std::runtime_error(k_beside);

  std::map<std::uint32_t, FaceBorders> borders;
  std::map<std::uint32_t, std::vector<Chain>> chains;
  for (std::size_t begin = 0, next = 0; begin < labels.borders.size(); begin = next) {
    const auto above = std::ranges::upper_bound(first_facets, labels.borders[begin].facet);
    const auto number = static_cast<std::uint32_t>(above - first_facets.begin()) - 1;
    const std::uint32_t end = above == first_facets.end() ? facets : *above;
    while (next < labels.borders.size() && labels.borders[next].facet < end) ++next;
    if (next == begin) throw std::runtime_error(k_beside);
    FaceBorders& of_face = borders[number];
    of_face = {first_facets[number], std::span(labels.borders).subspan(begin, next - begin), to_body[number],
               labels.tolerance, std::nullopt};
    const auto& [x, y, z] = labels.direction;
    if (std::ranges::any_of(of_face.borders, &StepBorder::on_contour))
      of_face.direction = gp_Dir(x, y, z).Transformed(to_body[number]);
    chains[number] = chains_of(faces[number], of_face);
  }

  LabelledPart part;
  std::map<std::uint32_t, std::vector<LabelledFace>> pieces;
  std::set<std::uint32_t> failed;
  // Anew where a face fails, so that no neighbour keeps a vertex for it.
  for (bool again = true; again;) {
    again = false;
    pieces.clear();
    CutEdges cuts(labels.tolerance);
    for (const auto& [number, of_face] : chains) {
      for (const Chain& chain : of_face) {
        for (const Place* place : {&chain.places.front(), &chain.places.back()})
          if (place->on_edge) cuts.ask(*place->on_edge);
      }
    }
    cuts.cut();
    for (const auto& [number, of_face] : chains) {
      const TopoDS_Face forward = TopoDS::Face(faces[number].Oriented(TopAbs_FORWARD));
      for (const double tolerance : {labels.tolerance, 1e-3 * labels.tolerance}) {
        try {
          pieces[number] = pieces_of(forward, of_face, cuts, tolerance);
          // A border that divides nothing is beyond the outline, which facets cut short.
          if (pieces[number].size() == 1) pieces[number].front().label = labels.of_face[number];
          if (!has_label(pieces[number], labels.of_face[number])) pieces[number].clear();
        } catch (const Standard_Failure&) {
          pieces[number].clear();
        }
        if (!pieces[number].empty()) break;
      }
      if (pieces[number].empty()) failed.insert(number);
    }
    for (auto at = failed.begin(); at != failed.end();) {
      FaceBorders& of_face = borders[*at];
      if (of_face.direction) {
        of_face.direction.reset();  // with borders on the facets, as they were found
        chains[*at] = chains_of(faces[*at], of_face);
        at = failed.erase(at);
        again = true;
      } else {
        again = chains.erase(*at) > 0 || again;
        ++at;
      }
    }
    if (again) continue;
    const Handle(BRepTools_ReShape) shapes = new BRepTools_ReShape;
    cuts.replace_in(*shapes);
    for (const auto& [number, of_face] : pieces) {
      TopoDS_Shell shell;
      BRep_Builder().MakeShell(shell);
      for (const LabelledFace& piece : of_face) BRep_Builder().Add(shell, piece.face);
      shapes->Replace(faces[number].Oriented(TopAbs_FORWARD), shell);
    }
    for (std::uint32_t number = 0, body = 0; body < bodies.size(); ++body) {
      const TopoDS_Shape whole = shapes->Apply(bodies[body].shape);
      const std::size_t end = body + 1 < bodies.size() ? first_faces[body + 1] : faces.size();
      const std::size_t begin = part.faces.size();
      for (; number < end; ++number) {
        if (const auto found = pieces.find(number); found != pieces.end()) {
          for (const LabelledFace& piece : found->second) part.faces.push_back(piece);
        } else {
          const TopoDS_Face face = TopoDS::Face(shapes->Apply(faces[number]));
          const std::uint32_t label = number < labels.of_face.size() ? labels.of_face[number] : k_none;
          part.faces.push_back({face, label, label == k_none ? 0.0 : area_of(face)});
        }
      }
      BRepTools::Clean(whole);
      if (bodies[body].place.Form() == gp_Identity) {
        part.bodies.push_back(whole);
        continue;
      }
      BRepBuilderAPI_Transform placed(whole, bodies[body].place, Standard_True);
      part.bodies.push_back(placed.Shape());
      for (LabelledFace& face : std::span(part.faces).subspan(begin))
        face.face = TopoDS::Face(placed.ModifiedShape(face.face));
    }
  }
  part.failed_faces.assign(failed.begin(), failed.end());
  return part;
}

}  // namespace moldlight::step
