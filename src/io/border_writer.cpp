#include "io/border_writer.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_format.hpp"

namespace moldlight {

namespace {

void write_obj(const std::string& path, const SplitMesh& mesh) {
  AtomicFile file(path);
  file.write("# moldlight borders of mold-piece regions\n");
  std::vector<std::uint32_t> numbers(mesh.vertices.size(), 0);  // in the file, from 1
  std::uint32_t count = 0;
  std::pair<Region, Region> group{};
  for (const RegionBorder& border : region_borders(mesh)) {
    std::string points, line = "l";
    for (const VertexIndex vertex : border.vertices) {
      if (numbers[vertex] == 0) {
        numbers[vertex] = ++count;
        const glm::dvec3& point = mesh.vertices[vertex];
        fmt::format_to(std::back_inserter(points), "v {} {} {}\n", point.x, point.y, point.z);
      }
      fmt::format_to(std::back_inserter(line), " {}", numbers[vertex]);
    }
    file.write(points);
    if (const std::pair sides(border.left, border.right); sides != group) {
      group = sides;
      file.write(fmt::format("g {}-{}\n", region_name(border.left), region_name(border.right)));
    }
    file.write(line += '\n');
  }
  file.commit();
}

void write_csv(const std::string& path, const SplitMesh& mesh) {
  AtomicFile file(path);
  file.write("chain,closed,region_a,region_b,x,y,z\n");
  std::size_t chain = 0;
  for (const RegionBorder& border : region_borders(mesh)) {
    const std::string start = fmt::format("{},{},{},{}", chain++, border.closed() ? 1 : 0,
                                          region_name(border.left), region_name(border.right));
    for (const VertexIndex vertex : border.vertices) {
      const glm::dvec3& point = mesh.vertices[vertex];
      file.write(fmt::format("{},{},{},{}\n", start, point.x, point.y, point.z));
    }
  }
  file.commit();
}

}  // namespace

void check_border_extension(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == "obj" || extension == "csv") return;
  throw UsageError(path + ": borders are written as .obj or .csv; change the extension");
}

void write_borders(const std::string& path, const SplitMesh& mesh) {
  check_border_extension(path);
  (lower_extension(path) == "obj" ? write_obj : write_csv)(path, mesh);
}

}  // namespace moldlight
