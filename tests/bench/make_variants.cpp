// Many small parts, each another: bench_make_variants FOLDER COUNT. The shapes whose areas are known, turned,
// scaled and subdivided by random numbers that begin alike each time.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "io/mesh_writer.hpp"
#include "support/shapes.hpp"

int main(int argc, char** argv) {
  using namespace moldlight;
  if (argc != 3) {
    std::fputs("bench_make_variants FOLDER COUNT\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  std::filesystem::create_directories(folder);
  const std::vector<test::Shape> shapes = test::all_shapes({});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turn(-1.0, 1.0), scale(0.2, 5.0);
  constexpr const char* k_endings[] = {"stl", "obj", "ply"};
  for (int k = 0; k < count; ++k) {
    const test::Shape& shape = shapes[static_cast<std::size_t>(k) % shapes.size()];
    const glm::dquat rotation =
        glm::normalize(glm::dquat(turn(random), turn(random), turn(random), turn(random)));
    TriangleMesh mesh = test::turned(shape, rotation).mesh;
    const double factor = scale(random);
    for (auto& point : mesh.vertices) point *= factor;
    const std::string file = (folder / fmt::format("{:05}_{}.{}", k, shape.name, k_endings[k % 3])).string();
    write_coloured_mesh(file, {mesh, std::vector<Region>(mesh.facets.size(), Region::core)});
  }
  return 0;
}
