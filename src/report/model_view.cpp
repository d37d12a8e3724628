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

/// Numbers of seven bits a byte, the lowest first.
class Bytes {
 public:
  void add(std::uint32_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(0x80 | (value & 0x7F));
    bytes_ += static_cast<char>(value);
  }
  void add_signed(std::int32_t value) {
    add(value < 0 ? ~(static_cast<std::uint32_t>(value) << 1) : static_cast<std::uint32_t>(value) << 1);
  }
  void append(const Bytes& others) { bytes_ += others.bytes_; }
  [[nodiscard]] std::string deflated() const {
    uLongf size = compressBound(static_cast<uLong>(bytes_.size()));
    std::string out(size, '\0');
    CHECK(compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                    reinterpret_cast<const Bytef*>(bytes_.data()), static_cast<uLong>(bytes_.size()),
                    Z_BEST_COMPRESSION) == Z_OK);
    out.resize(size);
    return out;
  }

 private:
  std::string bytes_;
};

/// Points in a box, 16 bits a coordinate, each as its difference from the one before.
class PointWriter {
 public:
  PointWriter(Bytes& bytes, const Bounds& box) : bytes_(&bytes), low_(box.min), size_(box.max - box.min) {}

  void add(const glm::dvec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
      const double share = size_[axis] > 0.0 ? (point[axis] - low_[axis]) / size_[axis] : 0.0;
      const auto step = static_cast<std::int32_t>(std::lround(std::clamp(share, 0.0, 1.0) * k_steps));
      bytes_->add_signed(step - last_[axis]);
      last_[axis] = step;
    }
  }

 private:
  Bytes* bytes_;
  glm::dvec3 low_, size_;
  glm::ivec3 last_{0};
};

Json pack_surface(const ViewSurface& surface, const glm::dvec3& centre, Bytes& bytes) {
  const TriangleMesh& mesh = surface.mesh;
  CHECK(surface.group_of_facet.size() == mesh.facets.size());
  constexpr std::uint32_t k_unused = ~0U;
  std::vector<std::uint32_t> number(mesh.vertices.size(), k_unused);
  std::vector<VertexIndex> order;
  Bounds box;
  Bytes corners;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex corner : facet) {
      const auto next = static_cast<std::uint32_t>(order.size());
      if (number[corner] == k_unused) {
        number[corner] = next;
        order.push_back(corner);
        box.add(mesh.vertices[corner]);
      }
      corners.add(next - number[corner]);
    }
  }
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

Json packed(const ModelView& view) {
  Json json;
  json["groups"] = Json::array();
  for (const ViewGroup& group : view.groups) json["groups"].push_back(group_json(group, view.centre));
  json["diagonal"] = view.diagonal;
  json["direction"] = point_json(view.direction);
  json["to_viewer"] = point_json(view.to_viewer);
  json["opened"] = view.opened;
  Bytes bytes;
  json["surfaces"] = Json::array();
  for (const ViewSurface& surface : view.surfaces)
    json["surfaces"].push_back(pack_surface(surface, view.centre, bytes));
  Bounds box;
  for (const ViewLine& line : view.lines) {
    for (const glm::dvec3& point : line.points) box.add(point);
  }
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
  json["data"] = page::base64(bytes.deflated());
  return json;
}

}  // namespace moldlight::report
