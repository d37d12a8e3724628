#include "render/rehearsal.hpp"

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/draft.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

// Like most windows: code for sides that are powers of two is made apart.
constexpr glm::ivec2 k_size(60, 52);  // pixels
constexpr int k_map_resolution = 64;
constexpr double k_near_vertical_deg = 1.0;

TriangleMesh cube_mesh() {
  TriangleMesh mesh;
  for (unsigned k = 0; k < 8; ++k) mesh.vertices.emplace_back(k & 1U, (k >> 1U) & 1U, k >> 2U);
  mesh.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace

struct Rehearsal::Cube {
  TriangleMesh mesh = cube_mesh();
  FacetGeometry geometry = facet_geometry(mesh);
  Adjacency adjacency = build_adjacency(mesh);
  UnitFrame frame{.center = glm::dvec3(0.5), .diagonal = 2.0};
  ViewGeometry view = view_geometry(mesh, geometry, adjacency, frame);
  /// A cube has no concave ones; to the GL it makes no difference.
  std::vector<FacetEdge> edges = bent_edges(mesh, geometry, adjacency).convex;

  [[nodiscard]] std::vector<FacetClass> classes() const {
    std::vector<FacetClass> all;
    for (const glm::dvec3& normal : geometry.normals)
      all.push_back(facet_class(normal, glm::dvec3(0.0, 0.0, 1.0), k_near_vertical_deg));
    return all;
  }
  [[nodiscard]] SplitGeometry split() const {
    SplitGeometry whole{.vertices = view.vertices, .pieces = view.facets, .sources = {}};
    for (std::uint32_t facet = 0; facet < whole.pieces.size(); ++facet)
      whole.sources.push_back(facet | (facet % 4U) << k_source_bits_shift);
    return whole;
  }
};

const std::array<Rehearsal::Change, 22> Rehearsal::k_changes = {
    [](Rehearsal& of, const Cube& cube) {
      const std::vector<FacetClass> classes = cube.classes();
      of.maps_.draw({of.part_, map_frame(glm::dvec3(0.0, 0.0, 1.0)), classes},
                    {.resolution = k_map_resolution, .lateral = 1e-3});
    },
    [](Rehearsal& of, const Cube&) { of.look_.settings.ambient_occlusion = true; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.backdrop = Backdrop::gradient; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.arrows = true; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.feature_edges = true; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.cut = CutPlane{.extent = 1.0}; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.cut.reset(); },
    [](Rehearsal& of, const Cube& cube) { of.split_.emplace(of.gl_, cube.split(), cube.classes()); },
    [](Rehearsal& of, const Cube&) { of.look_.settings.samples = 2; },
    [](Rehearsal& of, const Cube&) { of.look_.marks.undercut_glow = 1.0; },
    [](Rehearsal& of, const Cube& cube) {
      of.view_.set_faces(std::vector<std::uint32_t>(cube.mesh.facets.size(), 0));
      of.look_.marks.chosen = 0;
    },
    [](Rehearsal& of, const Cube& cube) {
      const ViewBody body = view_body(cube.mesh, cube.frame, k_block_mark);
      of.view_.set_bodies({&body, 1});
      of.look_.body_motions = {&of.in_place_, 1};
    },
    [](Rehearsal& of, const Cube& cube) { of.view_.set_tube(cube.view.feature_edges, {}); },
    [](Rehearsal& of, const Cube& cube) {
      of.view_.set_marked_lines(MarkedLines::chosen, cube.view.feature_edges);
    },
    [](Rehearsal& of, const Cube& cube) {
      of.view_.set_veiled_surface(cube.view.vertices, cube.view.facets);
    },
    [](Rehearsal& of, const Cube&) { of.look_.settings.colour_mode = ColourMode::draft_angle; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.cut = CutPlane{.extent = 1.0}; },
    [](Rehearsal& of, const Cube& cube) {
      const ViewSolid solid = view_solid(cube.mesh, cube.frame, Steel::core);
      of.view_.set_steel({&solid, 1});
      of.look_.settings.steel = {.shown = true, .of = 1};
    },
    [](Rehearsal& of, const Cube&) { of.look_.settings.steel.clear = true; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.cut.reset(); },
    [](Rehearsal& of, const Cube&) { of.look_.settings.steel = {}; },
    [](Rehearsal& of, const Cube&) { of.look_.settings.open_mold = 0.5; },
};

Rehearsal::Rehearsal(const gl::Functions& gl) : Rehearsal(gl, Cube()) {}

Rehearsal::Rehearsal(const gl::Functions& gl, const Cube& cube)
    : gl_(gl),
      part_(gl,
            {.mesh = cube.mesh, .geometry = cube.geometry, .frame = cube.frame, .concave_edges = cube.edges}),
      view_(gl, cube.view),
      maps_(gl) {
  ViewSettings& settings = look_.settings;
  settings.samples = 1;
  settings.ambient_occlusion = settings.arrows = settings.feature_edges = false;
  settings.backdrop = Backdrop::none;
}

bool Rehearsal::draw_next(GLuint framebuffer) {
  if (next_ == k_changes.size()) return false;
  k_changes[next_++](*this, Cube());
  const ViewSubject subject{
      .part = part_, .maps = split_ ? nullptr : &maps_, .split = split_ ? &*split_ : nullptr};
  view_.draw_final({.framebuffer = framebuffer, .size = k_size}, subject, look_);
  return next_ < k_changes.size();
}

}  // namespace moldlight
