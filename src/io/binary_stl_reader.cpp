#include <array>
#include <bit>
#include <cstring>
#include <vector>

#include "io/file_contents.hpp"
#include "io/readers.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_header_bytes = 84;
constexpr std::size_t k_facet_bytes = 50;
constexpr std::size_t k_normal_bytes = 12;
constexpr std::size_t k_binary_facets_between_reports = 1 << 18;

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

std::uint32_t declared_facets(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

}  // namespace

bool binary_stl_size_fits(const FileBeginning& file) {
  if (file.bytes.size() < k_header_bytes) return false;
  return file.size == k_header_bytes + std::uint64_t{declared_facets(file.bytes)} * k_facet_bytes;
}

void refuse_binary_stl(const std::string& path, const FileBeginning& file) {
  if (file.size < k_header_bytes) {
    throw FileError(path, fmt::format("byte {}", file.size),
                    fmt::format("ends inside the {} bytes of the binary STL header; export the part again",
                                k_header_bytes));
  }
  const std::uint64_t declared = declared_facets(file.bytes);
  const std::uint64_t held = (file.size - k_header_bytes) / k_facet_bytes;
  const std::uint64_t rest = (file.size - k_header_bytes) % k_facet_bytes;
  if (rest == 0) {
    throw FileError(
        path, "byte 80",
        fmt::format("the header declares {} facets, but the file's size is that of {}; export the "
                    "part again",
                    declared, held));
  }
  if (declared > held) {
    throw FileError(
        path, fmt::format("facet {}", held),
        fmt::format("the file ends inside this facet, {} are declared; export the part again", declared));
  }
  throw FileError(path, fmt::format("byte {}", k_header_bytes + declared * k_facet_bytes),
                  fmt::format("{} bytes follow the {} facets that the header declares; export the part again",
                              file.size - k_header_bytes - declared * k_facet_bytes, declared));
}

Part read_binary_stl(const ReadContext& context) {
  const std::string_view bytes = context.bytes();
  if (const FileBeginning whole{bytes, bytes.size()}; !binary_stl_size_fits(whole))
    refuse_binary_stl(context.path, whole);
  const std::size_t count = declared_facets(bytes);
  if (count == 0) context.fail("byte 80", "holds no facets; export the part again");
  context.check_facet_count(count);
  check_memory(context.path, count * (3 * sizeof(glm::dvec3) + sizeof(std::array<VertexIndex, 3>)));

  std::vector<glm::dvec3> corners;
  corners.reserve(3 * count);
  for (std::size_t facet = 0; facet < count; ++facet) {
    if (facet % k_binary_facets_between_reports == 0) {
      context.progress.report("reading facets", static_cast<double>(facet) / static_cast<double>(count));
    }
    float xyz[9];
    std::memcpy(xyz, bytes.data() + k_header_bytes + facet * k_facet_bytes + k_normal_bytes, sizeof xyz);
    for (const float value : xyz) {
      if (!is_usable_coordinate(static_cast<double>(value))) {
        context.fail(fmt::format("facet {}", facet), "a coordinate is {}; export the part again", value);
      }
    }
    for (int corner = 0; corner < 3; ++corner) {
      corners.emplace_back(xyz[3 * corner], xyz[3 * corner + 1], xyz[3 * corner + 2]);
    }
  }
  context.contents.release();

  Part part;
  part.mesh = weld_corners(corners);
  part.bodies = {{"", 0, static_cast<FacetIndex>(count)}};
  return part;
}

}  // namespace moldlight
