// Writing a mesh with its facets in groups, such as regions, each in a colour of its own, and the lines
// between regions; and solids for printing and machining. Facet k of the file is facet k of the mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "mold/exact/split_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// A value of each facet. The name is letters and underscores.
struct FacetValues {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>> values;
};
/// Found only where a format has room for them; none where it is empty.
using FindFacetValues = std::function<std::vector<FacetValues>()>;

/// What is written; mesh and regions outlive it.
struct ColouredMesh {
  const TriangleMesh& mesh;
  std::span<const Region> regions;  // one a facet
  Palette palette = Palette::paper;
  std::string unit = {};  // named in a comment where the format has comments; may be empty
  std::string name = {};  // of the part, for formats that name what they hold
  FindFacetValues values = {};
};

/// Facets that are of one kind. Names are letters, digits and underscores.
struct MeshGroup {
  std::string name;
  Colour colour;
};

/// The regions, in their order.
[[nodiscard]] std::vector<MeshGroup> region_groups(Palette palette);

/// A solid beside the mesh, in its unit and place, that goes its way as the mold opens. It may turn about an
/// axis meanwhile, steadily. The mesh outlives it.
struct MovingSolid {
  std::string name;  // as of groups
  const TriangleMesh& mesh;
  Colour colour;
  glm::dvec3 way{0.0};
  glm::dvec3 point{0.0}, axis{0, 0, 1};  // of the axis; unit
  double turn_rad = 0.0;
};

/// The same of any groups; what is pointed at outlives it.
struct GroupedMesh {
  const TriangleMesh& mesh;
  std::span<const MeshGroup> groups;         // 65,536 at most
  std::span<const std::uint32_t> of_facet;   // number of its group
  std::string what = "region";               // that a group is
  std::string title = "mold-piece regions";  // of the file
  std::string unit = {};                     // as above
  std::string name = {};                     // as above
  FindFacetValues values = {};
  std::span<const MovingSolid> solids = {};
};

/// A format that something is written in.
template <typename Content>
struct WrittenFormat {
  std::string_view extension;
  void (*write)(const std::string& path, const Content& content);
};
[[nodiscard]] std::span<const WrittenFormat<GroupedMesh>> mesh_formats();
[[nodiscard]] std::span<const WrittenFormat<SplitMesh>> border_formats();
/// "ply|obj|stl|glb|vtp", for help.
template <typename Content>
[[nodiscard]] std::string extensions_text(std::span<const WrittenFormat<Content>> formats) {
  std::string text;
  for (const auto& format : formats) text.append(text.empty() ? "" : "|").append(format.extension);
  return text;
}

/// Writes by the extension of `path`, files replaced whole or not at all:
/// .ply  binary little endian, coordinates in double; per face red, green, blue and the number of its group
///       under the name of what a group is (`region`: 0 core, 1 cavity, 2 both, 3 undercut);
/// .obj  one material a group, in a .mtl file beside it;
/// .stl  binary, coordinates in float; the colour of each facet is in its attribute: bit 15 set, 5 bits each
/// of red
///       (10-14), green (5-9) and blue (0-4), as VisCAM and most viewers read it;
/// .glb  binary glTF 2.0, coordinates in float, relative to a node's place where the part is far away; one
///       primitive and material a group; y up and in metres by the root node, whose scale is 1 without a
///       unit; solids as nodes of an animation "opening";
/// .vtp  VTK PolyData, coordinates in double; a number of its group and the further values a facet.
/// Throws UsageError for another extension, FileError where it cannot be written.
void write_grouped_mesh(const std::string& path, const GroupedMesh& grouped);
void write_coloured_mesh(const std::string& path, const ColouredMesh& coloured);
void write_glb(const std::string& path, const GroupedMesh& grouped);
void write_vtp(const std::string& path, const GroupedMesh& grouped);

/// "moldlight mold-piece regions, unit mm", and "0 core, 1 cavity, …": what files say of themselves.
[[nodiscard]] std::string written_description(const GroupedMesh& grouped);
[[nodiscard]] std::string group_numbers(const GroupedMesh& grouped);

/// Binary STL, coordinates in float: the facets that have an attribute, each with it; the header is cut or
/// filled to 80 bytes. The file is replaced whole or not at all.
void write_stl_facets(const std::string& path, std::string header, const TriangleMesh& mesh,
                      const std::function<std::optional<std::uint16_t>(FacetIndex)>& attribute);
/// The same of one colour, coordinates in float; the file is replaced whole or not at all.
void write_stl(const std::string& path, const TriangleMesh& mesh, Colour colour);

/// The file beside an .obj that write_coloured_mesh writes, too; empty for others.
[[nodiscard]] std::string material_library_path(const std::string& path);

/// Writes the facets of each region to <folder>/<stem>_core.stl, …_cavity.stl, …_both.stl, …_undercut.stl
/// (coloured binary STL), making the folder. A region without facets gets no file, and a former file of its
/// name goes. Returns the paths.
std::vector<std::string> write_region_stls(const std::string& folder, const std::string& stem,
                                           const ColouredMesh& coloured);

/// Writes the chains of region_borders() by the extension of `path`, coordinates in the part's unit and in
/// the shortest form that reads back the same; the file is replaced whole or not at all: .obj  a polyline
/// (`l`) a chain, in a group a pair of regions (`g core-undercut`); chains share vertices; .csv
/// `chain,closed,region_a,region_b,x,y,z`, a line a point: chains from 0, closed 1 or 0, region_a left of
///       the walk as seen from outside; the first point of a closed chain comes again as its last.
/// Throws UsageError for another extension, FileError where it cannot be written.
void write_borders(const std::string& path, const SplitMesh& mesh);

/// Binary STL, coordinates in single precision, normals left to readers; the file is replaced whole or not at
/// all. Throws FileError.
void write_solid_stl(const std::string& path, const TriangleMesh& mesh, const std::string& unit);

struct NamedSolid {
  std::string name;
  const TriangleMesh* mesh = nullptr;
  Colour colour = {160, 160, 160};
  bool closed = true;  // else a surface, which STEP alone has
};
/// 3MF: an object a solid, each once; in millimetres where `unit` ("mm", "in", …) is none that 3MF knows.
/// Throws FileError.
void write_solids_3mf(const std::string& path, std::span<const NamedSolid> solids, const std::string& unit);
/// STEP: one product called `title`, in it a named and coloured body a solid, facets of one plane joined into
/// a face. In millimetres; lengths without a unit are taken for such. Throws FileError.
void write_solids_step(const std::string& path, const std::string& title, std::span<const NamedSolid> solids,
                       const std::string& unit);

}  // namespace moldlight
