#include "mold/second_depth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr int k_subtexel_bits = 8, k_subtexel = 1 << k_subtexel_bits, k_half_texel = k_subtexel / 2;
/// Heights from -0.5 to 0.5 of the unit frame span the 24 bits of a depth but for a margin, so that rounding
/// cannot leave them.
constexpr float k_greatest_height = (1 << 24) - 1, k_height_margin = 64.0F,
                k_height_scale = k_greatest_height - 2.0F * k_height_margin;
constexpr int k_rows_a_task = 64;
constexpr std::size_t k_depth_grain = 4096;

/// A triangle's edge: which columns of a row lie inside of it.
struct Edge {
  double at_row_0,
      per_row;        // numerator of the last column inside (of the first, for a left edge), and a half
  double per_column;  // 1 / (256 dy)
  bool is_right, is_level;
};

/// Columns beyond every map are as good as any.
constexpr double k_most_columns = 65536.0;
int floor_of(double columns) {
  return static_cast<int>(std::clamp(columns, -k_most_columns, k_most_columns) + k_most_columns) -
         static_cast<int>(k_most_columns);
}

}  // namespace

void SecondDepthMaps::set_resolution(int resolution) {
  CHECK(resolution >= 16 && resolution <= 8192);
  resolution_ = resolution;
  const std::size_t texels = static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution);
  for (auto& map : maps_) map.resize(texels);
  for (auto& facets : facets_) facets.resize(texels);
}

SecondDepthMaps::Corner SecondDepthMaps::corner(const glm::dvec3& point, const MapFrame& frame) const {
  const auto place = [&](const glm::dvec3& axis) {
    return static_cast<std::int32_t>(
        std::floor((glm::dot(point, axis) + 0.5) * resolution_ * k_subtexel + 0.5));
  };
  const auto height =
      static_cast<float>((glm::dot(point, frame.z) + 0.5) * static_cast<double>(k_height_scale));
  return {place(frame.x), place(frame.y), std::clamp(height + k_height_margin, 0.0F, k_greatest_height)};
}

void SecondDepthMaps::draw(const SecondDepthPart& part, const MapFrame& frame,
                           std::span<const FacetClass> classes, double edge_thickness) {
  CHECK(classes.size() == part.mesh.facets.size());
  corners_.resize(part.positions.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, corners_.size(), k_depth_grain),
                    [&](const auto& range) {
                      for (std::size_t k = range.begin(); k < range.end(); ++k)
                        corners_[k] = corner(glm::dvec3(part.positions[k]), frame);
                    });
  rows_.resize(part.mesh.facets.size());
  tbb::parallel_for(tbb::blocked_range<FacetIndex>(0, static_cast<FacetIndex>(rows_.size()), k_depth_grain),
                    [&](const auto& range) {
                      for (FacetIndex facet = range.begin(); facet < range.end(); ++facet)
                        rows_[facet] = rows_of(triangle_of(part.mesh, facet));
                    });
  add_strips(part, frame, classes, 0.5 * edge_thickness / resolution_);
  const int tasks = (resolution_ + k_rows_a_task - 1) / k_rows_a_task;
  tbb::parallel_for(0, tasks, [&](int task) {
    const Rows rows{task * k_rows_a_task, std::min((task + 1) * k_rows_a_task, resolution_) - 1};
    const auto begin = static_cast<std::ptrdiff_t>(rows.first) * resolution_,
               end = static_cast<std::ptrdiff_t>(rows.last + 1) * resolution_;
    for (auto& map : maps_) std::fill(map.begin() + begin, map.begin() + end, std::uint64_t{0});
    for (FacetIndex facet = 0; facet < rows_.size(); ++facet) {
      if (rows_[facet].first <= rows.last && rows_[facet].last >= rows.first)
        fill(triangle_of(part.mesh, facet), facet, rows, nullptr);
    }
    for (const bool plus : {false, true}) {
      const Strips& strips = strips_[plus ? 1 : 0];
      for (std::size_t k = 0; k < strips.facets.size(); ++k)
        fill(strips.triangles[k], strips.facets[k], rows, &plus);
    }
    // The negative of an inverted number is the number + 1, and that of no facet is 0.
    for (std::size_t map = 0; map < 2; ++map) {
      std::transform(maps_[map].begin() + begin, maps_[map].begin() + end, facets_[map].begin() + begin,
                     [](std::uint64_t texel) { return 0U - static_cast<std::uint32_t>(texel); });
    }
  });
}

/// Rows whose texel centres lie between the lowest and the highest corner; none for the last before the
/// first.
SecondDepthMaps::Rows SecondDepthMaps::rows_of(const Triangle& triangle) {
  const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  return {(low + k_half_texel - 1) >> k_subtexel_bits, (high - k_half_texel) >> k_subtexel_bits};
}

/// Into the map of the light that the facet faces away from, or into the one that is named.
void SecondDepthMaps::fill(Triangle triangle, FacetIndex facet, const Rows& rows, const bool* only_plus) {
  const auto across = [](const Corner& a, const Corner& b) { return static_cast<std::int64_t>(b.x) - a.x; };
  const auto along = [](const Corner& a, const Corner& b) { return static_cast<std::int64_t>(b.y) - a.y; };
  std::int64_t area = across(triangle[0], triangle[1]) * along(triangle[0], triangle[2]) -
                      across(triangle[0], triangle[2]) * along(triangle[0], triangle[1]);
  if (area == 0) return;
  const bool faces_down = area < 0;
  if (faces_down) {
    std::swap(triangle[1], triangle[2]);
    area = -area;
  }
  const bool plus = only_plus != nullptr ? *only_plus : faces_down;
  const Rows own = rows_of(triangle);
  const int first_row = std::max(own.first, rows.first), last_row = std::min(own.last, rows.last);
  const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  const int first_column = std::max((left + k_half_texel - 1) >> k_subtexel_bits, 0);
  const int last_column = std::min((right - k_half_texel) >> k_subtexel_bits, resolution_ - 1);
  if (first_row > last_row || first_column > last_column) return;

  // Spans are exact: a column is inside an edge if it is not above a quotient of integers, whose numerator is
  // moved by a half; that is more than all roundings together.
  std::array<Edge, 3> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = triangle[k], &b = triangle[(k + 1) % 3];
    const std::int64_t dx = across(a, b), dy = along(a, b);
    const bool yields_ties = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t numerator =
        dx * (k_half_texel - a.y) - dy * (k_half_texel - a.x) - (yields_ties ? 1 : 0);
    const bool is_right = dy >= 0;
    edges[k] = {.at_row_0 = static_cast<double>(numerator) + 0.5,
                .per_row = static_cast<double>(dx) * k_subtexel,
                .per_column = dy == 0 ? 0.0 : 1.0 / (static_cast<double>(std::abs(dy)) * k_subtexel),
                .is_right = is_right,
                .is_level = dy == 0};
  }
  // Height at the centre of the texel 0, 0, and its steps.
  const double rise1 = static_cast<double>(triangle[1].height) - static_cast<double>(triangle[0].height);
  const double rise2 = static_cast<double>(triangle[2].height) - static_cast<double>(triangle[0].height);
  const double per_texel = k_subtexel / static_cast<double>(area);
  const double height_x = per_texel * (rise1 * static_cast<double>(along(triangle[0], triangle[2])) -
                                       rise2 * static_cast<double>(along(triangle[0], triangle[1])));
  const double height_y = per_texel * (rise2 * static_cast<double>(across(triangle[0], triangle[1])) -
                                       rise1 * static_cast<double>(across(triangle[0], triangle[2])));
  const double height_0 =
      static_cast<double>(triangle[0].height) +
      (height_x * (k_half_texel - triangle[0].x) + height_y * (k_half_texel - triangle[0].y)) / k_subtexel;
  const auto [lowest, highest] = std::minmax({triangle[0].height, triangle[1].height, triangle[2].height});
  const std::uint64_t number = ~facet;  // 32 bits

  for (int row = first_row; row <= last_row; ++row) {
    int first = first_column, last = last_column;
    for (const Edge& edge : edges) {
      const double numerator = edge.at_row_0 + edge.per_row * row;
      const int columns = floor_of(numerator * edge.per_column);
      if (edge.is_level) {
        if (numerator < 0.0) last = -1;
      } else if (edge.is_right) {
        last = std::min(last, columns);
      } else {
        first = std::max(first, -columns);
      }
    }
    const double at_row = height_0 + height_y * row;
    std::uint64_t* texels =
        maps_[plus ? 1 : 0].data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(resolution_);
    for (int column = first; column <= last; ++column) {
      const auto height = std::clamp(static_cast<float>(at_row + height_x * column), lowest, highest);
      const auto steps = static_cast<std::uint32_t>(plus ? height : k_greatest_height - height) + 1;
      const std::uint64_t texel = static_cast<std::uint64_t>(steps) << 32 | number;
      texels[column] = std::max(texels[column], texel);
    }
  }
}

void SecondDepthMaps::add_strips(const SecondDepthPart& part, const MapFrame& frame,
                                 std::span<const FacetClass> classes, double half_width) {
  for (Strips& strips : strips_) {
    strips.triangles.clear();
    strips.facets.clear();
  }
  if (half_width <= 0.0) return;
  const auto add = [&](const FacetEdge& edge, bool is_left, bool plus) {
    const glm::dvec3 start(part.positions[edge.a]), end(part.positions[edge.b]);
    const glm::dvec3 level = end - start - glm::dot(end - start, frame.z) * frame.z;
    const double length = glm::length(level);
    if (length < 1e-9) return;
    const FacetIndex facet = is_left ? edge.left : edge.right;
    const glm::dvec3& normal = part.normals[facet];
    // Seen along +d a facet of the +d map runs clockwise: its outer side is mirrored.
    const glm::dvec3 out = (is_left == plus ? -1.0 : 1.0) / length * glm::cross(level, frame.z);
    const double rise = -glm::dot(normal, out) / glm::dot(normal, frame.z);
    const glm::dvec3 across = half_width * (out + rise * frame.z);
    const std::array<Corner, 4> corners = {corner(start, frame), corner(end, frame),
                                           corner(start + across, frame), corner(end + across, frame)};
    Strips& strips = strips_[plus ? 1 : 0];
    strips.triangles.push_back({corners[0], corners[1], corners[2]});
    strips.triangles.push_back({corners[1], corners[2], corners[3]});
    strips.facets.insert(strips.facets.end(), 2, facet);
  };
  for (const FacetEdge& edge : part.concave_edges) {
    if (classes[edge.left] == classes[edge.right]) continue;
    for (const bool is_left : {true, false}) {
      const FacetClass own = classes[is_left ? edge.left : edge.right];
      if (own != FacetClass::near_vertical) add(edge, is_left, own == FacetClass::down);
    }
  }
}

std::vector<float> SecondDepthMaps::depths(bool plus) const {
  std::vector<float> depths;
  depths.reserve(maps_[0].size());
  for (const std::uint64_t texel : maps_[plus ? 1 : 0]) {
    const auto steps = static_cast<float>(texel >> 32) - 1.0F - k_height_margin;
    depths.push_back(texel == 0 ? 1.0F : 1.0F - steps / k_height_scale);
  }
  return depths;
}

}  // namespace moldlight
