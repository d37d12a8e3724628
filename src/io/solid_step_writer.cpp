// Solids for CAD: bodies with plane faces in one product.
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "io/atomic_file.hpp"
#include "io/mesh_writer.hpp"
#include "io/step_text.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/flat_faces.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight {

namespace {

using EntityNumber = StepText::Number;

/// Edges shorter than so many times what a face is bent would be points to readers.
constexpr double k_short_edge = 8.0;
/// Fewer enclose nothing: a sliver that short edges have left.
constexpr std::size_t k_least_faces = 4;

class BodyText {
 public:
  BodyText(StepText& text, TriangleMesh mesh, double mm) : text_(text), mesh_(std::move(mesh)), mm_(mm) {
    const double bend = rounding_step(mesh_);  // by which a flat face is bent that was written so
    collapse_short_edges(mesh_, k_short_edge * bend);
    flat_ = flat_faces(mesh_, bend);
  }

  /// The numbers of its solids; of its surfaces where it is no closed one.
  std::vector<EntityNumber> add(const std::string& name, bool closed) {
    add_edges();
    std::vector<std::string> faces(flat_.shells.size());
    std::vector<std::size_t> counts(flat_.shells.size(), 0);
    for (const FlatFaces::Face& face : flat_.faces) ++counts[face.shell];
    for (const FlatFaces::Face& face : flat_.faces) {
      if (closed && counts[face.shell] < k_least_faces) continue;
      std::string& list = faces[face.shell];
      list += fmt::format("{}#{}", list.empty() ? "" : ",", add_face(face));
    }
    std::vector<EntityNumber> shells;
    for (const std::string& list : faces)
      shells.push_back(
          list.empty() ? 0 : text_.add(fmt::format("{}_SHELL('',({}))", closed ? "CLOSED" : "OPEN", list)));
    std::vector<EntityNumber> bodies;
    for (std::size_t k = 0; k < shells.size(); ++k) {
      if (shells[k] == 0) continue;
      if (!closed) {
        bodies.push_back(text_.add(
            fmt::format("SHELL_BASED_SURFACE_MODEL('{}',(#{}))", StepText::plain(name), shells[k])));
      } else if (flat_.shells[k].volume >= 0.0) {
        bodies.push_back(add_solid(name, k, shells));
      }
    }
    return bodies;
  }

 private:
  void add_edges() {
    std::vector<EntityNumber> vertices(mesh_.vertices.size(), 0);
    const auto vertex = [&](VertexIndex v) {
      if (vertices[v] == 0) {
        const EntityNumber at = text_.point(mm_ * mesh_.vertices[v]);
        vertices[v] = text_.add(fmt::format("VERTEX_POINT('',#{})", at));
      }
      return vertices[v];
    };
    for (const FlatFaces::Edge& edge : flat_.edges) {
      const EntityNumber from = vertex(edge.from), to = vertex(edge.to);
      const glm::dvec3 way = mm_ * (mesh_.vertices[edge.to] - mesh_.vertices[edge.from]);
      const double length = glm::length(way);
      const EntityNumber along = text_.direction(length > 0.0 ? way / length : glm::dvec3(1, 0, 0));
      const EntityNumber vector = text_.add(fmt::format("VECTOR('',#{},1.)", along));
      const EntityNumber line = text_.add(fmt::format("LINE('',#{},#{})", from - 1, vector));
      edges_.push_back(text_.add(fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", from, to, line)));
    }
  }

  EntityNumber add_face(const FlatFaces::Face& face) {
    std::string bounds;
    for (const FlatFaces::Loop& loop : face.loops) {
      EntityNumber first = 0;
      for (const FlatFaces::Use& use : loop) {
        const EntityNumber added = text_.add(
            fmt::format("ORIENTED_EDGE('',*,*,#{},{})", edges_[use.edge], use.backwards ? ".F." : ".T."));
        if (first == 0) first = added;
      }
      const EntityNumber around =
          text_.add(fmt::format("EDGE_LOOP('',({}))", StepText::list(first, loop.size())));
      const EntityNumber bound = text_.add(
          fmt::format("FACE_{}BOUND('',#{},.T.)", &loop == face.loops.data() ? "OUTER_" : "", around));
      bounds += fmt::format("{}#{}", bounds.empty() ? "" : ",", bound);
    }
    const EntityNumber plane =
        text_.add(fmt::format("PLANE('',#{})", text_.placement(mm_ * face.point, face.normal)));
    return text_.add(fmt::format("ADVANCED_FACE('',({}),#{},.T.)", bounds, plane));
  }

  /// The smallest one around a void has it.
  std::optional<std::size_t> around(std::size_t hollow) const {
    std::optional<std::size_t> best;
    const Bounds& inner = flat_.shells[hollow].bounds;
    for (std::size_t k = 0; k < flat_.shells.size(); ++k) {
      const FlatFaces::Shell& shell = flat_.shells[k];
      if (shell.volume < 0.0 || glm::any(glm::lessThan(inner.min, shell.bounds.min)) ||
          glm::any(glm::lessThan(shell.bounds.max, inner.max)))
        continue;
      if (!best || shell.volume < flat_.shells[*best].volume) best = k;
    }
    return best;
  }

  EntityNumber add_solid(const std::string& name, std::size_t outer,
                         const std::vector<EntityNumber>& shells) {
    std::string voids;
    for (std::size_t k = 0; k < shells.size(); ++k) {
      if (shells[k] == 0 || flat_.shells[k].volume >= 0.0 || around(k) != outer) continue;
      const EntityNumber turned = text_.add(fmt::format("ORIENTED_CLOSED_SHELL('',*,#{},.T.)", shells[k]));
      voids += fmt::format("{}#{}", voids.empty() ? "" : ",", turned);
    }
    const std::string known = StepText::plain(name);
    if (voids.empty()) return text_.add(fmt::format("MANIFOLD_SOLID_BREP('{}',#{})", known, shells[outer]));
    return text_.add(fmt::format("BREP_WITH_VOIDS('{}',#{},({}))", known, shells[outer], voids));
  }

  StepText& text_;
  TriangleMesh mesh_;
  double mm_;
  FlatFaces flat_;
  std::vector<EntityNumber> edges_;
};

/// Puts the colour of an item into `styled`.
void add_colour(StepText& text, EntityNumber item, Colour colour, std::string& styled) {
  const auto channel = [](std::uint8_t value) { return StepText::real(value / 255.0); };
  EntityNumber last = text.add(
      fmt::format("COLOUR_RGB('',{},{},{})", channel(colour.r), channel(colour.g), channel(colour.b)));
  for (const char* entity : {"FILL_AREA_STYLE_COLOUR('',#{})", "FILL_AREA_STYLE('',(#{}))",
                             "SURFACE_STYLE_FILL_AREA(#{})", "SURFACE_SIDE_STYLE('',(#{}))",
                             "SURFACE_STYLE_USAGE(.BOTH.,#{})", "PRESENTATION_STYLE_ASSIGNMENT((#{}))"})
    last = text.add(fmt::format(fmt::runtime(entity), last));
  const EntityNumber style = text.add(fmt::format("STYLED_ITEM('',(#{}),#{})", last, item));
  styled += fmt::format("{}#{}", styled.empty() ? "" : ",", style);
}

}  // namespace

void write_solids_step(const std::string& path, const std::string& title, std::span<const NamedSolid> solids,
                       const std::string& unit) {
  const double mm = mm_per_unit(unit);
  StepText text("moldlight " + title, title);
  std::string styled, items(StepText::origin());
  for (const NamedSolid& solid : solids) {
    for (const EntityNumber body : BodyText(text, *solid.mesh, mm).add(solid.name, solid.closed)) {
      add_colour(text, body, solid.colour, styled);
      items += fmt::format(",#{}", body);
    }
  }
  // One product: some programs take an assembly's parts for parts of several files.
  const EntityNumber shape =
      text.add(fmt::format("SHAPE_REPRESENTATION('{}',({}),{})", title, items, StepText::context()));
  text.represent(text.product(title), shape);
  if (!styled.empty())
    text.add(fmt::format("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({}),{})", styled,
                         StepText::context()));
  write_file(path, std::move(text).finished());
}

}  // namespace moldlight
