#include "mold/exact_rays.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <new>

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moldlight {

namespace {

/// How far below its facet a surface point's ray starts: a few roundings of a coordinate of 0.5 in single
/// precision.
constexpr float k_start_below = 5e-7F;
constexpr std::size_t k_rays_at_once = 256;
/// Embree ends the program at coordinates that are not finite.
constexpr float k_far = 1e12F;

/// Drops hits of facets that face away from the ray's origin.
void keep_facing(const RTCFilterFunctionNArguments* arguments) {
  CHECK(arguments->N == 1);
  if (arguments->valid[0] == 0) return;
  const RTCRay* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
  const RTCHit* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
  const float facing = hit->Ng_x * ray->dir_x + hit->Ng_y * ray->dir_y + hit->Ng_z * ray->dir_z;
  if (facing >= 0.0F) arguments->valid[0] = 0;
}

/// One without a place or a way, as of surface whose extent is all rounding, begins off the part and leaves
/// it.
RTCRay make_ray(glm::vec3 origin, glm::vec3 direction) {
  if (!(glm::dot(origin, origin) < k_far && glm::dot(direction, direction) < k_far)) {
    origin = glm::vec3(2.0F);
    direction = glm::vec3(1.0F);
  }
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tnear = 0.0F;
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = ~0U;
  return ray;
}

/// What visit_near() goes on with.
struct NearVisit {
  const std::function<float(FacetIndex)>& visit;
};

/// True where the radius has changed.
bool visit_near_facet(RTCPointQueryFunctionArguments* arguments) {
  const auto* near = static_cast<const NearVisit*>(arguments->userPtr);
  const float radius = near->visit(arguments->primID);
  if (radius >= arguments->query->radius) return false;
  arguments->query->radius = radius;
  return true;
}

RTCIntersectContext make_context(bool facing_only) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (facing_only) context.filter = keep_facing;
  return context;
}

/// What an occlusion test keeps of the hit that ends it.
struct KeepingContext {
  RTCIntersectContext embree;  // first, as Embree hands back its address
  RTCHit hit;
  float distance;
};

void keep_facing_hit(const RTCFilterFunctionNArguments* arguments) {
  keep_facing(arguments);
  if (arguments->valid[0] == 0) return;
  auto* context = reinterpret_cast<KeepingContext*>(arguments->context);
  context->hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
  context->distance = reinterpret_cast<const RTCRay*>(arguments->ray)->tfar;
}

/// Builds the scene's tree. Embree keeps a group of tasks with the scene, which TBB notes as begun by the
/// work that goes on now, and looks for there whenever any work is cancelled: that must last as long.
void commit(RTCScene scene) {
  static auto* const k_lasting = new tbb::task_group_context(tbb::task_group_context::isolated);
  tbb::parallel_for(
      0, 1, [scene](int) { rtcCommitScene(scene); }, *k_lasting);
}

}  // namespace

struct ExactRays::Scene {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  // Embree's own copies.
  const glm::vec3* vertices = nullptr;
  const std::array<VertexIndex, 3>* facets = nullptr;

  ~Scene() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

ExactRays::ExactRays(const TriangleMesh& mesh, std::span<const glm::vec3> positions)
    : scene_(std::make_unique<Scene>()) {
  CHECK(positions.size() == mesh.vertices.size());
  scene_->device = rtcNewDevice(nullptr);
  if (scene_->device == nullptr) {
    if (rtcGetDeviceError(nullptr) == RTC_ERROR_UNSUPPORTED_CPU)
      throw Error("exact rays: Embree does not know this processor");
    throw std::bad_alloc();
  }
  scene_->scene = rtcNewScene(scene_->device);
  rtcSetSceneFlags(scene_->scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                                             RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  if (!mesh.facets.empty()) {
    RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(glm::vec3), positions.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.facets[0]), mesh.facets.size());
    if (vertices == nullptr || indices == nullptr) throw std::bad_alloc();
    std::memcpy(vertices, positions.data(), positions.size_bytes());
    std::memcpy(indices, mesh.facets.data(), mesh.facets.size() * sizeof(mesh.facets[0]));
    scene_->vertices = static_cast<const glm::vec3*>(vertices);
    scene_->facets = static_cast<const std::array<VertexIndex, 3>*>(indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  commit(scene_->scene);
  const RTCError error = rtcGetDeviceError(scene_->device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE)
    throw Error(fmt::format("exact rays: Embree fails with error {}", static_cast<int>(error)));
}

ExactRays::~ExactRays() = default;
ExactRays::ExactRays(ExactRays&&) noexcept = default;
ExactRays& ExactRays::operator=(ExactRays&&) noexcept = default;

bool ExactRays::surface_point_blocked(const glm::vec3& origin, const glm::vec3& normal,
                                      const glm::vec3& direction) const {
  RTCIntersectContext context = make_context(true);
  RTCRay ray = make_ray(origin - k_start_below * normal, direction);
  rtcOccluded1(scene_->scene, &context, &ray);
  return ray.tfar < 0.0F;
}

ExactRays::Blockage ExactRays::blockage(const glm::vec3& origin, const glm::vec3& direction,
                                        float reach) const {
  KeepingContext context{.embree = make_context(false), .hit = {}, .distance = 0.0F};
  context.embree.filter = keep_facing_hit;
  RTCRay ray = make_ray(origin, direction);
  rtcOccluded1(scene_->scene, &context.embree, &ray);
  if (!(ray.tfar < 0.0F)) return Blockage::none;
  // In the facet's plane they lie apart by more the flatter they meet it.
  const RTCHit& hit = context.hit;
  const glm::vec3 normal(hit.Ng_x, hit.Ng_y, hit.Ng_z);
  const float doubled_area = glm::length(normal), facing = -glm::dot(normal, direction);
  const auto& facet = scene_->facets[hit.primID];
  float longest = 0.0F;
  for (int k = 0; k < 3; ++k)
    longest =
        std::max(longest, glm::distance(scene_->vertices[facet[k]], scene_->vertices[facet[(k + 1) % 3]]));
  constexpr float k_sure = 4.0F, k_rounding = 1e-6F;
  const float apart = k_sure * reach + k_rounding;
  const float inside = std::min({hit.u, hit.v, 1.0F - hit.u - hit.v});
  const bool around = inside * facing > apart * longest && context.distance * facing > apart * doubled_area;
  return around ? Blockage::around : Blockage::ray;
}

void ExactRays::blocked(std::span<const glm::vec3> origins, const glm::vec3& direction,
                        std::span<std::uint8_t> answers) const {
  CHECK(answers.size() == origins.size());
  std::array<RTCRay, k_rays_at_once> rays;
  for (std::size_t done = 0; done < origins.size(); done += k_rays_at_once) {
    const std::size_t count = std::min(k_rays_at_once, origins.size() - done);
    for (std::size_t i = 0; i < count; ++i) rays[i] = make_ray(origins[done + i], direction);
    // Not as coherent rays, though they are: in facets as thin as those of CAD parts that takes twice the
    // time.
    RTCIntersectContext context = make_context(false);
    rtcOccluded1M(scene_->scene, &context, rays.data(), static_cast<unsigned>(count), sizeof(RTCRay));
    for (std::size_t i = 0; i < count; ++i) answers[done + i] = rays[i].tfar < 0.0F ? 1 : 0;
  }
}

std::optional<ExactRays::Hit> ExactRays::first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                                   bool facing_only) const {
  RTCIntersectContext context = make_context(facing_only);
  RTCRayHit rayhit{};
  rayhit.ray = make_ray(origin, direction);
  rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &context, &rayhit);
  if (rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{rayhit.hit.primID, rayhit.ray.tfar};
}

void ExactRays::visit_near(const glm::vec3& point, float radius,
                           const std::function<float(FacetIndex)>& visit) const {
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query{};
  query.x = point.x;
  query.y = point.y;
  query.z = point.z;
  query.radius = radius;
  NearVisit near{visit};
  rtcPointQuery(scene_->scene, &query, &context, visit_near_facet, &near);
}

glm::vec3 lateral_point(const glm::vec3& point, const glm::dvec3& normal, const AccessibilityQuery& query) {
  const glm::dvec3 level = normal - glm::dot(normal, query.direction) * query.direction;
  return glm::vec3(glm::dvec3(point) + query.lateral * glm::normalize(level));
}

}  // namespace moldlight
