// Collects the vertices and polygons of an indexed file and makes the part of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "io/readers.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// A body of this name begins with polygon `first_polygon`.
struct BodyStart {
  std::string name;
  std::size_t first_polygon = 0;
};

/// Polygons are cut into triangles once all vertices are there, so they may come before their vertices.
/// Facets are numbered polygon by polygon; polygon k of n corners gives n - 2 facets, fan order where a fan
/// covers it.
class PolygonPartBuilder {
 public:
  explicit PolygonPartBuilder(const ReadContext& context) : context_(context) {}

  /// The point's coordinates are usable. Throws FileError for a vertex too many.
  void add_vertex(const glm::dvec3& point);
  /// At least three vertex numbers from 0, each below the final vertex count.
  void add_polygon(std::span<const std::uint32_t> corners);
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  [[nodiscard]] std::size_t vertex_count() const { return vertices_.size(); }
  [[nodiscard]] std::size_t polygon_count() const { return polygon_ends_.size(); }

  /// Gives the file's memory back, cuts, welds. `bodies` in order of polygons; those without polygons are
  /// left out. Throws FileError where there is no polygon.
  [[nodiscard]] Part finish(const std::vector<BodyStart>& bodies = {});

 private:
  void cut_polygons(Part& part, const std::vector<BodyStart>& bodies);

  const ReadContext& context_;
  std::vector<glm::dvec3> vertices_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint64_t> polygon_ends_;  // of each polygon, in corners_
  std::vector<std::string> warnings_;
  std::uint64_t facets_ = 0;
};

}  // namespace moldlight
