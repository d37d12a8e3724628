#include "mesh/coarsened.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "mesh/weld.hpp"

namespace moldlight {

namespace {

/// Facets of a vertex beyond which it stays: what a collapse there costs grows with their square.
constexpr unsigned k_most_around = 32;
constexpr std::size_t k_a_report = 4096;  // facets, or collapses that are weighed
constexpr std::string_view k_stage = "coarsening";

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using CollapsibleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// Forbids nothing, but hears that the work is cancelled, and tells how much of it is done.
template <typename Mesh_>
class Watch final : public OpenMesh::Decimater::ModBaseT<Mesh_> {
 public:
  DECIMATING_MODULE(Watch, Mesh_, Watch)
  explicit Watch(Mesh& mesh) : Base(mesh, true) {}
  void tell(const Progress& progress, std::size_t facets_to_go) {
    progress_ = &progress;
    collapses_to_go_ = 0.5 * static_cast<double>(facets_to_go);
  }
  float collapse_priority(const CollapseInfo&) override {
    if (++asked_ % k_a_report == 0)
      progress_->report(k_stage, std::min(1.0, static_cast<double>(collapses_) / collapses_to_go_));
    return Base::LEGAL_COLLAPSE;
  }
  void postprocess_collapse(const CollapseInfo&) override { ++collapses_; }

 private:
  const Progress* progress_ = nullptr;
  double collapses_to_go_ = 1.0;
  std::size_t asked_ = 0, collapses_ = 0;
};

/// Facets that OpenMesh refuses, as their edges are not those of a manifold, stand alone on vertices of their
/// own.
CollapsibleMesh collapsible(const TriangleMesh& mesh, const Progress& progress) {
  CollapsibleMesh open;
  open.request_vertex_status();
  open.request_edge_status();
  open.request_halfedge_status();
  open.request_face_status();
  open.request_face_normals();
  omerr().disable();  // likewise where half-edges are built (mesh/adjacency.cpp)
  for (const glm::dvec3& vertex : mesh.vertices) open.add_vertex({vertex.x, vertex.y, vertex.z});
  std::size_t taken = 0;
  for (const auto& facet : mesh.facets) {
    if (++taken % k_a_report == 0) progress.report(k_stage, 0.0);
    std::array<OpenMesh::VertexHandle, 3> corners;
    for (const std::size_t corner : {0, 1, 2})
      corners[corner] = OpenMesh::VertexHandle(static_cast<int>(facet[corner]));
    if (open.add_face(corners[0], corners[1], corners[2]).is_valid()) continue;
    for (OpenMesh::VertexHandle& corner : corners) {
      open.status(corner).set_locked(true);
      corner = open.add_vertex(open.point(corner));
    }
    open.add_face(corners[0], corners[1], corners[2]);
  }
  for (const auto vertex : open.vertices())
    if (open.is_boundary(vertex) || open.valence(vertex) > k_most_around)
      open.status(vertex).set_locked(true);
  open.update_face_normals();
  return open;
}

}  // namespace

TriangleMesh coarsened(const TriangleMesh& mesh, std::size_t facets, const Progress& progress) {
  if (mesh.facets.size() <= facets) return mesh;
  progress.report(k_stage, 0.0);
  CollapsibleMesh open = collapsible(mesh, progress);
  OpenMesh::Decimater::DecimaterT<CollapsibleMesh> decimater(open);
  OpenMesh::Decimater::ModQuadricT<CollapsibleMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<CollapsibleMesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  Watch<CollapsibleMesh>::Handle watch;
  decimater.add(watch);
  decimater.module(watch).tell(progress, mesh.facets.size() - facets);
  decimater.initialize();
  decimater.decimate_to_faces(0, facets);
  std::vector<glm::dvec3> corners;
  for (const auto face : open.faces()) {
    for (const auto vertex : face.vertices()) {
      const OpenMesh::Vec3d& point = open.point(vertex);
      corners.emplace_back(point[0], point[1], point[2]);
    }
  }
  return weld_corners(corners);
}

}  // namespace moldlight
