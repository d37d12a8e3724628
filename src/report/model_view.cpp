#include "report/model_view.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "base/check.hpp"
#include "classify/classify_report.hpp"
#include "page/page.hpp"

namespace moldlight::report {

namespace {

constexpr double k_steps = 65535.0;

/// Points in a box, 16 bits a coordinate, each as its difference from the one before.
class PointWriter {
 public:
  PointWriter(PackedBytes& bytes, const Bounds& box)
      : bytes_(&bytes), low_(box.min), size_(box.max - box.min) {}

  void add(const glm::dvec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
      const double share = size_[axis] > 0.0 ? (point[axis] - low_[axis]) / size_[axis] : 0.0;
      const auto step = static_cast<std::int32_t>(std::lround(std::clamp(share, 0.0, 1.0) * k_steps));
      bytes_->add_signed(step - last_[axis]);
      last_[axis] = step;
    }
  }

 private:
  PackedBytes* bytes_;
  glm::dvec3 low_, size_;
  glm::ivec3 last_{0};
};

Json pack_surface(const ViewSurface& surface, const glm::dvec3& centre, PackedBytes& bytes) {
  const TriangleMesh& mesh = surface.mesh;
  CHECK(surface.group_of_facet.size() == mesh.facets.size());
  PackedBytes corners;
  const std::vector<VertexIndex> order = pack_corners(mesh, corners);
  Bounds box;
  for (const VertexIndex vertex : order) box.add(mesh.vertices[vertex]);
  PointWriter points(bytes, box);
  for (const VertexIndex vertex : order) points.add(mesh.vertices[vertex]);
  bytes.append(corners);
  std::int32_t last = 0;
  for (const std::uint16_t group : surface.group_of_facet) {
    bytes.add_signed(group - last);
    last = group;
  }
  const bool any = !order.empty();
  return {{"corners", order.size()},
          {"facets", mesh.facets.size()},
          {"low", point_json(any ? box.min - centre : glm::dvec3(0.0))},
          {"high", point_json(any ? box.max - centre : glm::dvec3(0.0))}};
}

Json group_json(const ViewGroup& group, const glm::dvec3& centre) {
  Json json = {{"name", group.name},       {"colour", {group.colour.r, group.colour.g, group.colour.b}},
               {"hatched", group.hatched}, {"opaque", group.stays_opaque},
               {"hidden", group.hidden},   {"shift", point_json(group.shift)}};
  if (group.without_edges) json["plain"] = true;
  if (group.shown_with) json["with"] = *group.shown_with;
  if (group.turn_rad != 0.0) {
    json["turn"] = group.turn_rad;
    json["point"] = point_json(group.point - centre);
    json["axis"] = point_json(group.axis);
  }
  return json;
}

}  // namespace

std::string PackedBytes::deflated_base64() const {
  uLongf size = compressBound(static_cast<uLong>(bytes_.size()));
  std::string out(size, '\0');
  CHECK(compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes_.data()),
                  static_cast<uLong>(bytes_.size()), Z_BEST_COMPRESSION) == Z_OK);
  out.resize(size);
  return page::base64(out);
}

std::vector<VertexIndex> pack_corners(const TriangleMesh& mesh, PackedBytes& bytes) {
  constexpr std::uint32_t k_unused = ~0U;
  std::vector<std::uint32_t> number(mesh.vertices.size(), k_unused);
  std::vector<VertexIndex> order;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex corner : facet) {
      const auto next = static_cast<std::uint32_t>(order.size());
      if (number[corner] == k_unused) {
        number[corner] = next;
        order.push_back(corner);
      }
      bytes.add(next - number[corner]);
    }
  }
  return order;
}

Json packed(const ModelView& view) {
  Json json;
  json["groups"] = Json::array();
  for (const ViewGroup& group : view.groups) json["groups"].push_back(group_json(group, view.centre));
  json["diagonal"] = view.diagonal;
  json["direction"] = point_json(view.direction);
  json["to_viewer"] = point_json(view.to_viewer);
  json["opened"] = view.opened;
  json["callouts"] = Json::array();
  for (const ViewCallout& callout : view.callouts)
    json["callouts"].push_back({{"place", point_json((callout.place - view.centre) / view.diagonal)},
                                {"normal", point_json(callout.normal)}});
  PackedBytes bytes;
  json["surfaces"] = Json::array();
  for (const ViewSurface& surface : view.surfaces)
    json["surfaces"].push_back(pack_surface(surface, view.centre, bytes));
  Bounds box;
  for (const ViewLine& line : view.lines)
    for (const glm::dvec3& point : line.points) box.add(point);
  json["lines"] = Json::array();
  if (!view.lines.empty()) {
    json["lines_low"] = point_json(box.min - view.centre);
    json["lines_high"] = point_json(box.max - view.centre);
  }
  PointWriter points(bytes, box);
  for (const ViewLine& line : view.lines) {
    for (const glm::dvec3& point : line.points) points.add(point);
    json["lines"].push_back({{"points", line.points.size()}, {"closed", line.closed}, {"group", line.group}});
  }
  json["data"] = bytes.deflated_base64();
  return json;
}

}  // namespace moldlight::report
