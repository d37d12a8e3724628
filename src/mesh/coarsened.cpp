#include "mesh/coarsened.hpp"

#include <array>
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

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using CollapsibleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

class Watch final : public OpenMesh::Decimater::Observer {
 public:
  explicit Watch(const Progress& progress) : OpenMesh::Decimater::Observer(1024), progress_(progress) {}
  void notify(std::size_t) override {}
  [[nodiscard]] bool abort() const override { return progress_.cancelled(); }

 private:
  const Progress& progress_;
};

/// Facets that OpenMesh refuses, as their edges are not those of a manifold, stand alone on vertices of their
/// own.
CollapsibleMesh collapsible(const TriangleMesh& mesh) {
  CollapsibleMesh open;
  open.request_vertex_status();
  open.request_edge_status();
  open.request_halfedge_status();
  open.request_face_status();
  open.request_face_normals();
  omerr().disable();
  for (const glm::dvec3& vertex : mesh.vertices) open.add_vertex({vertex.x, vertex.y, vertex.z});
  for (const auto& facet : mesh.facets) {
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
  omerr().enable();
  for (const auto vertex : open.vertices())
    if (open.is_boundary(vertex) || open.valence(vertex) > k_most_around)
      open.status(vertex).set_locked(true);
  open.update_face_normals();
  return open;
}

}  // namespace

TriangleMesh coarsened(const TriangleMesh& mesh, std::size_t facets, const Progress& progress) {
  if (mesh.facets.size() <= facets) return mesh;
  progress.report("coarsening", 0.0);
  CollapsibleMesh open = collapsible(mesh);
  OpenMesh::Decimater::DecimaterT<CollapsibleMesh> decimater(open);
  OpenMesh::Decimater::ModQuadricT<CollapsibleMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<CollapsibleMesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  Watch watch(progress);
  decimater.set_observer(&watch);
  decimater.initialize();
  decimater.decimate_to_faces(0, facets);
  if (progress.cancelled()) throw Cancelled();
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
