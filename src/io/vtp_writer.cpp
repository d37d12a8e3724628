// VTK's XML PolyData (VTK File Formats, Kitware): one file, whose arrays follow the XML as they lie in
// memory.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "base/check.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight {

namespace {

struct VtpArray {
  std::string head;                             // its attributes but for where it is
  std::uint64_t bytes = 0;                      // that it has
  std::function<void(AtomicFile& file)> write;  // all of them
};

/// Of `count` values, value(k) each.
template <typename Value>
VtpArray vtp_array(std::string_view name, int components, std::uint64_t count, Value value) {
  using Number = decltype(value(std::uint64_t{}));
  constexpr std::string_view k_type = std::is_same_v<Number, double>         ? "Float64"
                                      : std::is_same_v<Number, std::int32_t> ? "Int32"
                                                                             : "Int64";
  static_assert(k_type != "Int64" || std::is_same_v<Number, std::int64_t>);
  return {.head = fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", k_type, name, components),
          .bytes = count * sizeof(Number),
          .write = [count, value](AtomicFile& file) {
            std::string row;
            for (std::uint64_t k = 0; k < count; ++k) {
              row.clear();
              append_bytes(row, value(k));
              file.write(row);
            }
          }};
}

VtpArray vtp_array(const FacetValues& values) {
  return std::visit(
      [&](const auto& list) {
        return vtp_array(values.name, 1, list.size(), [&list](std::uint64_t k) { return list[k]; });
      },
      values.values);
}

}  // namespace

void write_vtp(const std::string& path, const GroupedMesh& grouped) {
  const TriangleMesh& mesh = grouped.mesh;
  const std::uint64_t facets = mesh.facets.size();
  const std::vector<FacetValues> more = grouped.values ? grouped.values() : std::vector<FacetValues>();
  std::vector<VtpArray> arrays = {
      vtp_array("Points", 3, 3 * mesh.vertices.size(),
                [&](std::uint64_t k) { return mesh.vertices[k / 3][static_cast<int>(k % 3)]; }),
      vtp_array("connectivity", 1, 3 * facets,
                [&](std::uint64_t k) { return std::int64_t{mesh.facets[k / 3][k % 3]}; }),
      vtp_array("offsets", 1, facets, [](std::uint64_t k) { return static_cast<std::int64_t>(3 * k + 3); }),
      vtp_array(grouped.what, 1, facets,
                [&](std::uint64_t k) { return static_cast<std::int32_t>(grouped.of_facet[k]); })};
  for (const FacetValues& values : more) {
    arrays.push_back(vtp_array(values));
    CHECK(std::visit([](const auto& list) { return list.size(); }, values.values) == facets);
  }
  std::string comment =
      fmt::format("{}; {}: {}", written_description(grouped), grouped.what, group_numbers(grouped));
  for (std::size_t at = 0; (at = comment.find("--", at)) != std::string::npos;) comment.erase(at, 1);
  std::string head = fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- {} -->\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      comment, mesh.vertices.size(), facets);
  std::uint64_t offset = 0;
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    head += k == 0   ? "<Points>\n"
            : k == 1 ? "</Points>\n<Polys>\n"
            : k == 3 ? fmt::format("</Polys>\n<CellData Scalars=\"{}\">\n", grouped.what)
                     : "";
    fmt::format_to(std::back_inserter(head), "<DataArray {} format=\"appended\" offset=\"{}\"/>\n",
                   arrays[k].head, offset);
    offset += sizeof(std::uint64_t) + arrays[k].bytes;
  }
  AtomicFile file(path);
  file.write(head + "</CellData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
  for (const VtpArray& array : arrays) {
    std::string size;
    append_bytes(size, array.bytes);
    file.write(size);
    array.write(file);
  }
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

}  // namespace moldlight
