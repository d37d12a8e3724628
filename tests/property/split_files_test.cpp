// The files of a split part: together they are the part, and its borders lie on it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "classify/classify_report.hpp"
#include "support/classify_mesh.hpp"
#include "support/exact_model.hpp"
#include "support/manifest.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr double k_area = 1e-6;      // of the part's area: coordinates in single precision
constexpr double k_off_mesh = 1e-9;  // of the diagonal

using FloatPoint = std::array<float, 3>;

/// Facets over vertices of which no two have the same coordinates in single precision.
class WeldedFacets {
 public:
  void add(const TriangleMesh& mesh) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      std::array<std::size_t, 3> corners{};
      for (int k = 0; k < 3; ++k) {
        const glm::vec3 point(mesh.corner(facet, k));
        // 0.0F turns -0 into 0.
        corners[static_cast<std::size_t>(k)] =
            numbers_.try_emplace({point.x + 0.0F, point.y + 0.0F, point.z + 0.0F}, numbers_.size())
                .first->second;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = corners[k], to = corners[(k + 1) % 3];
        if (from != to) edges_[std::minmax(from, to)] += from < to ? 1 : -1;
      }
    }
  }
  /// Whether every edge is run through as often one way as the other.
  [[nodiscard]] bool closed() const {
    return std::all_of(edges_.begin(), edges_.end(), [](const auto& edge) { return edge.second == 0; });
  }

 private:
  std::map<FloatPoint, std::size_t> numbers_;
  std::map<std::pair<std::size_t, std::size_t>, int> edges_;
};

/// As the file has them: no welding, no turning of facets.
TriangleMesh stl_facets(const std::filesystem::path& path) {
  const std::string bytes = test::file_bytes(path);
  TriangleMesh mesh;
  for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
    glm::vec3 corners[3];
    std::memcpy(corners, bytes.data() + at + 12, sizeof corners);
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), std::begin(corners), std::end(corners));
    mesh.facets.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                            const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
  const double square = glm::dot(normal, normal);
  if (square > 0.0) {
    const double v = glm::dot(glm::cross(p - a, ac), normal) / square;
    const double w = glm::dot(glm::cross(ab, p - a), normal) / square;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return std::abs(glm::dot(p - a, normal)) / std::sqrt(square);
  }
  const auto to_edge = [&](const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = to - from;
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? glm::clamp(glm::dot(p - from, along) / length, 0.0, 1.0) : 0.0;
    return glm::distance(p, from + t * along);
  };
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

struct BorderPoint {
  glm::dvec3 at{0.0};
  std::string chain, closed, region_a, region_b;
};

std::vector<BorderPoint> read_borders(const std::string& path) {
  std::istringstream lines(test::file_bytes(path));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "chain,closed,region_a,region_b,x,y,z");
  std::vector<BorderPoint> points;
  while (std::getline(lines, line)) {
    std::istringstream row(line);
    BorderPoint point;
    for (std::string* text : {&point.chain, &point.closed, &point.region_a, &point.region_b})
      std::getline(row, *text, ',');
    char comma = 0;
    row >> point.at.x >> comma >> point.at.y >> comma >> point.at.z;
    EXPECT_FALSE(row.fail()) << line;
    points.push_back(point);
  }
  return points;
}

/// Facets whose boxes hold a point, by cells of a grid.
class FacetsNear {
 public:
  explicit FacetsNear(const TriangleMesh& mesh, double diagonal) : mesh_(mesh), cell_(diagonal / k_cells) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      glm::dvec3 min(mesh.corner(facet, 0)), max(min);
      for (int k = 1; k < 3; ++k) {
        min = glm::min(min, mesh.corner(facet, k));
        max = glm::max(max, mesh.corner(facet, k));
      }
      const auto low = cell_of(min - 1e-3 * cell_), high = cell_of(max + 1e-3 * cell_);
      for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int z = low[2]; z <= high[2]; ++z) cells_[{x, y, z}].push_back(facet);
    }
  }
  [[nodiscard]] double distance(const glm::dvec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    const auto found = cells_.find(cell_of(point));
    if (found == cells_.end()) return least;
    for (const FacetIndex facet : found->second) {
      least = std::min(least, distance_to_triangle(point, mesh_.corner(facet, 0), mesh_.corner(facet, 1),
                                                   mesh_.corner(facet, 2)));
    }
    return least;
  }

 private:
  static constexpr double k_cells = 48.0;  // along the diagonal
  [[nodiscard]] std::array<int, 3> cell_of(const glm::dvec3& point) const {
    const glm::dvec3 at = glm::floor(point / cell_);
    return {static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z)};
  }
  const TriangleMesh& mesh_;
  double cell_;
  std::map<std::array<int, 3>, std::vector<FacetIndex>> cells_;
};

Query along(const glm::dvec3& direction, double tolerance = 0.0) {
  Query query;
  query.direction = direction;
  query.method.tolerance = tolerance;
  return query;
}

struct Totals {
  std::size_t parts = 0, closed = 0, points = 0;
  double worst_area = 0.0, worst_point = 0.0;
  void print() const {
    std::printf("%zu parts, %zu closed; areas off by %.2g at most, %zu points of borders off by %.2g\n",
                parts, closed, worst_area, points, worst_point);
  }
};

void check_files(const PartModel& model, const Query& query, const std::string& name, Totals& totals) {
  const test::ScratchFolder folder;
  OutputPaths paths;
  paths.split_folder = folder.file("split");
  paths.borders = folder.file("borders.csv");
  write_outputs(paths, model, classify_exact(model, query, Progress{}, true));

  WeldedFacets whole, pieces;
  whole.add(model.part.mesh);
  double area = 0.0;
  for (const auto& entry : std::filesystem::directory_iterator(paths.split_folder)) {
    const TriangleMesh region = stl_facets(entry.path());
    pieces.add(region);
    area += facet_geometry(region).total_area;
  }
  const double off = std::abs(area / model.geometry.total_area - 1.0);
  EXPECT_LE(off, k_area) << name;
  EXPECT_EQ(pieces.closed(), whole.closed()) << name;
  EXPECT_TRUE(pieces.closed() || !model.health.closed) << name;

  const FacetsNear facets(model.part.mesh, model.frame.diagonal);
  for (const BorderPoint& point : read_borders(paths.borders)) {
    const double distance = facets.distance(point.at) / model.frame.diagonal;
    EXPECT_LE(distance, k_off_mesh) << name;
    EXPECT_NE(point.region_a, point.region_b) << name;
    totals.worst_point = std::max(totals.worst_point, distance);
    ++totals.points;
  }
  ++totals.parts;
  totals.closed += pieces.closed() ? 1 : 0;
  totals.worst_area = std::max(totals.worst_area, off);
}

TEST(SplitFiles, OfOurOwnShapesAreTheWhole) {
  Totals totals;
  for (const test::Shape& shape : test::all_shapes({})) {
    const auto model = test::model_of(shape.mesh);
    check_files(*model, along(shape.direction, shape.settings.lateral_tolerance), shape.name, totals);
    check_files(*model, along({0.36, 0.48, 0.8}), shape.name, totals);
  }
  totals.print();
  EXPECT_EQ(totals.closed, totals.parts);
}

TEST(SplitFiles, OfSharedPartsAreTheWhole) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no folder of real parts";
  Totals totals;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (row.file.starts_with("bad/")) continue;
    try {
      const auto model = load_part((*shared / "parts" / row.file).string(), ReadOptions{}, Progress{});
      const glm::dvec3 direction = test::five_directions()[totals.parts % 5];
      check_files(*model, along(direction), row.file, totals);
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("not supported"), std::string::npos) << error.what();
    }
  }
  totals.print();
  EXPECT_GE(totals.parts, 38U);
}

TEST(SplitFiles, BordersOfAPlateWithAHoleRunRoundItsEdges) {
  // Along the axis of the hole every wall is `both`: above and below of it a loop outside and one in the
  // hole.
  const test::Shape shape = test::plate_with_through_hole({});
  const auto model = test::model_of(shape.mesh);
  const test::ScratchFolder folder;
  OutputPaths paths;
  paths.borders = folder.file("borders.csv");
  write_outputs(paths, *model, classify_exact(*model, along(shape.direction, 0.02), Progress{}, true));
  std::map<std::string, std::vector<BorderPoint>> chains;
  for (const BorderPoint& point : read_borders(paths.borders)) chains[point.chain].push_back(point);
  ASSERT_EQ(chains.size(), 4U);
  std::multiset<std::pair<std::string, std::size_t>> found;
  for (const auto& [number, chain] : chains) {
    EXPECT_EQ(chain.front().closed, "1");
    EXPECT_EQ(chain.front().at, chain.back().at);
    EXPECT_EQ(chain.front().region_b, "both");
    for (const BorderPoint& point : chain) EXPECT_EQ(point.at.z, chain.front().at.z);
    EXPECT_EQ(chain.front().at.z == 0.0, chain.front().region_a == "cavity");
    found.emplace(chain.front().region_a, chain.size() - 1);
  }
  EXPECT_EQ(found, (std::multiset<std::pair<std::string, std::size_t>>{
                       {"core", 4}, {"core", 17}, {"cavity", 4}, {"cavity", 17}}));
}

}  // namespace
}  // namespace moldlight
