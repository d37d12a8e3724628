#include "mold/scan/scan_maps.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

scan::Projection projection_of(const MapFrame& frame, int resolution) {
  const double scale[3] = {static_cast<double>(resolution) * scan::k_subtexel,
                           static_cast<double>(resolution) * scan::k_subtexel, scan::k_height_scale};
  const glm::dvec3 axes[3] = {frame.x, frame.y, frame.z};
  scan::Projection projection;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) projection.column[i][k] = static_cast<float>(axes[k][i] * scale[k]);
    projection.offset[k] = static_cast<float>(0.5 * scale[k]);
  }
  projection.offset[2] += scan::k_height_margin;
  return projection;
}

}  // namespace

ScanMaps::ScanMaps(int resolution, const scan::Kernel& kernel) : resolution_(resolution), kernel_(&kernel) {
  CHECK(resolution >= 16 && resolution <= 8192);
  const int pitch = scan::map_pitch(resolution);
  const std::size_t entries =
      static_cast<std::size_t>(resolution) * static_cast<std::size_t>(pitch) + scan::k_entry_padding;
  for (int layer = 0; layer < 2; ++layer) {
    back_[layer].resize(entries);
    target_.back[layer] = back_[layer].data();
  }
  target_.size = resolution;
  target_.pitch = pitch;
  target_.generation = 0;
}

void ScanMaps::draw(const ScanPart& part, const MapFrame& frame, const ScanSettings& settings) {
  for (int layer = 0; layer < 2; ++layer) {
    front_[layer].resize(back_[layer].size());
    target_.front[layer] = front_[layer].data();
  }
  begin(part, frame, settings.tau_deg);
  const ScanPart::Clusters& clusters = part.clusters();
  cluster_sums_.assign(2 * clusters.all.size(), {});
  sums_ = {.clusters = cluster_sums_.data()};
  const double total_area = class_area_[0] + class_area_[1] + class_area_[2];
  has_second_depth_ = class_area(FacetClass::near_vertical) >= settings.second_depth_from * total_area;
  kernel_->rasterize({.vertices = vertices_.data(),
                      .facets = part.facets().data(),
                      .facet_count = part.facets().size(),
                      .weights = weights_.data(),
                      .clusters = clusters.of_facet.data(),
                      .entries = has_second_depth_ ? scan::Entries::both : scan::Entries::front},
                     target_, sums_);
  if (has_second_depth_) draw_concave_edges(part, 0.5 * settings.edge_thickness / resolution_);
}

void ScanMaps::draw_second_depth(const ScanPart& part, const MapFrame& frame, const ScanSettings& settings) {
  begin(part, frame, settings.tau_deg);
  sums_ = {};
  has_second_depth_ = true;
  kernel_->rasterize({.vertices = vertices_.data(),
                      .facets = part.facets().data(),
                      .facet_count = part.facets().size(),
                      .entries = scan::Entries::back},
                     target_, sums_);
  draw_concave_edges(part, 0.5 * settings.edge_thickness / resolution_);
}

void ScanMaps::begin(const ScanPart& part, const MapFrame& frame, double tau_deg) {
  if (target_.generation == scan::k_last_generation) {
    for (auto* maps : {front_, back_}) {
      for (int layer = 0; layer < 2; ++layer) std::fill(maps[layer].begin(), maps[layer].end(), 0);
    }
    target_.generation = 0;
  }
  ++target_.generation;
  frame_ = frame;
  projection_ = projection_of(frame, resolution_);
  vertices_.resize(part.positions().size());
  kernel_->transform(&part.positions().data()->x, part.positions().size(), projection_, vertices_.data());
  classify(part, tau_deg);
}

void ScanMaps::classify(const ScanPart& part, double tau_deg) {
  const std::size_t padded = part.areas().size();
  classes_.resize(padded);
  weights_.resize(padded);
  steep_.resize(padded);
  const double threshold = std::sin(glm::radians(tau_deg));
  const scan::ClassifyInput input{
      .normal_x = part.normals().x.data(),
      .normal_y = part.normals().y.data(),
      .normal_z = part.normals().z.data(),
      .areas = part.areas().data(),
      .padded_count = padded,
      .direction = {static_cast<float>(frame_.z.x), static_cast<float>(frame_.z.y),
                    static_cast<float>(frame_.z.z)},
      .threshold = static_cast<float>(threshold)};
  scan::ClassifyOutput output{.classes = classes_.data(), .weights = weights_.data(), .steep = steep_.data()};
  kernel_->classify(input, output);
  std::copy(std::begin(output.class_area), std::end(output.class_area), std::begin(class_area_));
  projected_area_ = output.projected_area;

  // Slopes at the threshold are decided in double, as everywhere else.
  near_vertical_count_ = 0;
  projected_near_vertical_area_ = 0.0;
  for (std::size_t i = 0; i < output.steep_count; ++i) {
    const FacetIndex facet = steep_[i];
    if (facet >= part.facets().size()) break;
    const double sine = glm::dot(part.geometry().normals[facet], frame_.z);
    const FacetClass now = sine >= threshold    ? FacetClass::up
                           : sine <= -threshold ? FacetClass::down
                                                : FacetClass::near_vertical;
    if (now == FacetClass::near_vertical) {
      steep_[near_vertical_count_++] = facet;
      projected_near_vertical_area_ += std::abs(sine) * static_cast<double>(part.areas()[facet]);
    }
    if (now == facet_class(facet)) continue;
    class_area_[classes_[facet]] -= static_cast<double>(part.areas()[facet]);
    class_area_[static_cast<std::size_t>(now)] += static_cast<double>(part.areas()[facet]);
    classes_[facet] = static_cast<std::int32_t>(now);
    weights_[facet] = now == FacetClass::near_vertical ? 0.0F : static_cast<float>(1.0 / std::abs(sine));
  }
}

void ScanMaps::draw_concave_edges(const ScanPart& part, double half_width) {
  if (half_width <= 0.0) return;
  constexpr auto k_up = static_cast<std::int32_t>(FacetClass::up),
                 k_down = static_cast<std::int32_t>(FacetClass::down);
  const glm::vec3 direction(frame_.z);
  const auto half = static_cast<float>(half_width);
  const auto draw = [&](const FacetEdge& edge, bool left_holds, bool plus) {
    const glm::vec3 start = part.position(edge.a), end = part.position(edge.b);
    const glm::vec3 along = end - start;
    const glm::vec3 level = along - glm::dot(along, direction) * direction;
    const float length = glm::length(level);
    if (length < 1e-9F) return;
    const FacetIndex facet = left_holds ? edge.left : edge.right;
    const glm::vec3 normal = part.normal(facet);
    // Seen along +d a facet of the +d map runs clockwise: its outer side is mirrored.
    const float sense = left_holds == plus ? -1.0F : 1.0F;
    const glm::vec3 out = sense * glm::cross(level, direction) / length;
    const float rise = -glm::dot(normal, out) / glm::dot(normal, direction);
    const glm::vec3 across = half * (out + rise * direction);
    const glm::vec3 points[4] = {start, end, start + across, end + across};
    scan::MapVertex corners[4];
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) {
        const float value = projection_.column[0][k] * points[i].x + projection_.column[1][k] * points[i].y +
                            projection_.column[2][k] * points[i].z + projection_.offset[k];
        if (k == 0) corners[i].x = static_cast<std::int32_t>(std::floor(value + 0.5F));
        if (k == 1) corners[i].y = static_cast<std::int32_t>(std::floor(value + 0.5F));
        if (k == 2) corners[i].height = std::clamp(value, 0.0F, static_cast<float>(scan::k_height_limit));
      }
    }
    Strips& strips = strips_[plus ? scan::k_down_layer : scan::k_up_layer];
    strips.corners.insert(strips.corners.end(), corners, corners + 3);
    strips.corners.insert(strips.corners.end(), corners + 1, corners + 4);
    strips.facets.insert(strips.facets.end(), 2, facet);
  };
  for (Strips& strips : strips_) {
    strips.corners.clear();
    strips.facets.clear();
  }
  for (const FacetEdge& edge : part.concave_edges()) {
    const std::int32_t left = classes_[edge.left], right = classes_[edge.right];
    if (left == right) continue;
    if (left == k_down) draw(edge, true, true);
    if (right == k_down) draw(edge, false, true);
    if (left == k_up) draw(edge, true, false);
    if (right == k_up) draw(edge, false, false);
  }
  for (const scan::Layer layer : {scan::k_up_layer, scan::k_down_layer}) {
    const Strips& strips = strips_[layer];
    kernel_->rasterize_back(strips.corners.data(), strips.facets.data(), strips.facets.size(), layer,
                            target_);
  }
}

void ScanMaps::copy_entries(bool plus, std::vector<std::uint32_t>& entries) const {
  const auto size = static_cast<std::size_t>(resolution_);
  const std::vector<std::int64_t>& map = back_[plus ? scan::k_down_layer : scan::k_up_layer];
  entries.resize(size * size);
  for (std::size_t y = 0; y < size; ++y) {
    const std::int64_t* from = map.data() + y * static_cast<std::size_t>(target_.pitch);
    std::uint32_t* to = entries.data() + y * size;
    for (std::size_t x = 0; x < size; ++x) to[x] = is_present(from[x]) ? scan::facet_of(from[x]) + 1 : 0;
  }
}

void ScanMaps::copy_depths(bool plus, std::vector<float>& depths) const {
  const auto size = static_cast<std::size_t>(resolution_);
  const std::vector<std::int64_t>& map = back_[plus ? scan::k_down_layer : scan::k_up_layer];
  depths.resize(size * size);
  for (std::size_t y = 0; y < size; ++y) {
    const std::int64_t* from = map.data() + y * static_cast<std::size_t>(target_.pitch);
    for (std::size_t x = 0; x < size; ++x) {
      const auto height = static_cast<float>(scan::height_of(from[x], !plus));
      const float risen = (height - scan::k_height_margin) / scan::k_height_scale;
      depths[y * size + x] = !is_present(from[x]) ? 1.0F : plus ? 1.0F - risen : risen;
    }
  }
}

double ScanMaps::shadow_area() const {
  const std::uint64_t texels =
      std::max(sums_.fragments[0] - sums_.hidden[0], sums_.fragments[1] - sums_.hidden[1]);
  const double texel = 1.0 / resolution_;
  return static_cast<double>(texels) * texel * texel;
}

}  // namespace moldlight
