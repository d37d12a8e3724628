#include "io/mesh_writer.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/part_formats.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

/// The regions as groups: number k is k_regions[k].
class RegionGroups {
 public:
  explicit RegionGroups(const ColouredMesh& coloured)
      : coloured_(coloured), groups_(region_groups(coloured.palette)) {
    for (const Region region : coloured.regions) of_facet_.push_back(static_cast<std::uint32_t>(region));
  }
  [[nodiscard]] GroupedMesh mesh() const {
    return {.mesh = coloured_.mesh,
            .groups = groups_,
            .of_facet = of_facet_,
            .unit = coloured_.unit,
            .name = coloured_.name,
            .values = coloured_.values};
  }

 private:
  const ColouredMesh& coloured_;
  std::vector<MeshGroup> groups_;
  std::vector<std::uint32_t> of_facet_;
};

void write_ply(const std::string& path, const GroupedMesh& grouped) {
  const TriangleMesh& mesh = grouped.mesh;
  const bool few = grouped.groups.size() <= 256;
  AtomicFile file(path);
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment {}\n"
                  "comment {}: {}\n"
                  "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
                  "element face {}\nproperty list uchar uint vertex_indices\n"
                  "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty {} {}\n"
                  "end_header\n",
                  written_description(grouped), grouped.what, group_numbers(grouped), mesh.vertices.size(),
                  mesh.facets.size(), few ? "uchar" : "ushort", grouped.what));
  std::string row;
  for (const glm::dvec3& vertex : mesh.vertices) {
    row.clear();
    for (int axis = 0; axis < 3; ++axis) append_bytes(row, vertex[axis]);
    file.write(row);
  }
  for (std::size_t facet = 0; facet < mesh.facets.size(); ++facet) {
    const std::uint32_t group = grouped.of_facet[facet];
    const Colour colour = grouped.groups[group].colour;
    row.assign(1, '\3');
    append_bytes(row, mesh.facets[facet]);
    for (const std::uint8_t value : {colour.r, colour.g, colour.b}) append_bytes(row, value);
    if (few) {
      append_bytes(row, static_cast<std::uint8_t>(group));
    } else {
      append_bytes(row, static_cast<std::uint16_t>(group));
    }
    file.write(row);
  }
  file.commit();
}

std::string material_library(const GroupedMesh& grouped) {
  std::string text = fmt::format("# {}\n", written_description(grouped));
  for (const auto& [name, colour] : grouped.groups) {
    text += fmt::format("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\nillum 1\n", name, colour.r / 255.0,
                        colour.g / 255.0, colour.b / 255.0);
  }
  return text;
}

void write_obj(const std::string& path, const GroupedMesh& grouped) {
  const TriangleMesh& mesh = grouped.mesh;
  const std::string library_path = material_library_path(path);
  AtomicFile library(library_path);
  library.write(material_library(grouped));
  AtomicFile file(path);
  file.write(fmt::format("# {}\nmtllib {}\n", written_description(grouped),
                         fs::path(library_path).filename().string()));
  std::string row;
  for (const glm::dvec3& vertex : mesh.vertices) {
    row.clear();
    fmt::format_to(std::back_inserter(row), "v {} {} {}\n", vertex.x, vertex.y, vertex.z);
    file.write(row);
  }
  for (std::size_t facet = 0; facet < mesh.facets.size(); ++facet) {
    row.clear();
    const std::uint32_t group = grouped.of_facet[facet];
    if (facet == 0 || group != grouped.of_facet[facet - 1])
      fmt::format_to(std::back_inserter(row), "usemtl {}\n", grouped.groups[group].name);
    const auto& corners = mesh.facets[facet];
    fmt::format_to(std::back_inserter(row), "f {} {} {}\n", std::uint64_t{corners[0]} + 1,
                   std::uint64_t{corners[1]} + 1, std::uint64_t{corners[2]} + 1);
    file.write(row);
  }
  file.put_on_disk();
  library.commit();
  file.commit();
}

std::uint16_t stl_colour(Colour colour) {
  const auto five_bits = [](std::uint8_t value) { return static_cast<unsigned>((value * 31 + 127) / 255); };
  return static_cast<std::uint16_t>(0x8000u | five_bits(colour.r) << 10 | five_bits(colour.g) << 5 |
                                    five_bits(colour.b));
}

/// Binary STL of the facets that `takes` lets through by their groups.
template <typename Filter>
void write_stl_of(const std::string& path, const GroupedMesh& grouped, const Filter& takes) {
  write_stl_facets(path, written_description(grouped), grouped.mesh,
                   [&](FacetIndex facet) -> std::optional<std::uint16_t> {
                     const std::uint32_t group = grouped.of_facet[facet];
                     return takes(group) ? std::optional(stl_colour(grouped.groups[group].colour))
                                         : std::nullopt;
                   });
}

void write_whole_stl(const std::string& path, const GroupedMesh& grouped) {
  write_stl_of(path, grouped, [](std::uint32_t) { return true; });
}

void write_border_obj(const std::string& path, const SplitMesh& mesh) {
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

void write_border_csv(const std::string& path, const SplitMesh& mesh) {
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

/// `what`: "a mesh is", for the UsageError where the extension is none of theirs.
template <typename Content>
const WrittenFormat<Content>& format_of(const std::string& path,
                                        std::span<const WrittenFormat<Content>> formats,
                                        std::string_view what) {
  const std::string extension = lower_extension(path);
  std::string known;
  for (const auto& format : formats) {
    if (format.extension == extension) return format;
    known.append(known.empty() ? "." : &format == &formats.back() ? " or ." : ", .").append(format.extension);
  }
  throw UsageError(fmt::format("{}: {} written as {}; change the extension", path, what, known));
}

}  // namespace

std::vector<MeshGroup> region_groups(Palette palette) {
  std::vector<MeshGroup> groups;
  for (const Region region : k_regions)
    groups.push_back({std::string(region_name(region)), region_colour(region, palette)});
  return groups;
}

std::string written_description(const GroupedMesh& grouped) {
  return fmt::format("moldlight {}{}", grouped.title,
                     grouped.unit.empty() ? "" : ", unit " + clean_name(grouped.unit));
}

std::string group_numbers(const GroupedMesh& grouped) {
  std::string text;
  for (std::size_t k = 0; k < grouped.groups.size(); ++k)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", k, grouped.groups[k].name);
  return text;
}

std::string material_library_path(const std::string& path) {
  return lower_extension(path) == "obj" ? fs::path(path).replace_extension(".mtl").string() : std::string();
}

std::span<const WrittenFormat<GroupedMesh>> mesh_formats() {
  static constexpr WrittenFormat<GroupedMesh> k_formats[] = {{"ply", write_ply},
                                                             {"obj", write_obj},
                                                             {"stl", write_whole_stl},
                                                             {"glb", write_glb},
                                                             {"vtp", write_vtp}};
  return k_formats;
}

std::span<const WrittenFormat<SplitMesh>> border_formats() {
  static constexpr WrittenFormat<SplitMesh> k_formats[] = {{"obj", write_border_obj},
                                                           {"csv", write_border_csv}};
  return k_formats;
}

void write_grouped_mesh(const std::string& path, const GroupedMesh& grouped) {
  CHECK(grouped.of_facet.size() == grouped.mesh.facets.size() && grouped.groups.size() <= 65536);
  format_of(path, mesh_formats(), "a mesh is").write(path, grouped);
}

void write_coloured_mesh(const std::string& path, const ColouredMesh& coloured) {
  write_grouped_mesh(path, RegionGroups(coloured).mesh());
}

void write_stl_facets(const std::string& path, std::string header, const TriangleMesh& mesh,
                      const std::function<std::optional<std::uint16_t>(FacetIndex)>& attribute) {
  std::uint32_t count = 0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) count += attribute(facet) ? 1 : 0;
  AtomicFile file(path);
  header.resize(80, ' ');
  append_bytes(header, count);
  file.write(header);
  std::string row;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const std::optional<std::uint16_t> bits = attribute(facet);
    if (!bits) continue;
    row.assign(12, '\0');  // readers take the normal from the corners' order where it is zero
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3& point = mesh.corner(facet, corner);
      for (int axis = 0; axis < 3; ++axis) append_bytes(row, static_cast<float>(point[axis]));
    }
    append_bytes(row, *bits);
    file.write(row);
  }
  file.commit();
}

void write_stl(const std::string& path, const TriangleMesh& mesh, Colour colour) {
  const MeshGroup whole{"body", colour};
  const std::vector<std::uint32_t> of_facet(mesh.facets.size(), 0);
  write_whole_stl(path,
                  {.mesh = mesh, .groups = std::span(&whole, 1), .of_facet = of_facet, .title = "body"});
}

std::vector<std::string> write_region_stls(const std::string& folder, const std::string& stem,
                                           const ColouredMesh& coloured) {
  CHECK(coloured.regions.size() == coloured.mesh.facets.size());
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "", "cannot be made a folder: " + error.message());
  const RegionGroups groups(coloured);
  std::vector<std::string> paths;
  for (const Region region : k_regions) {
    const std::string path =
        (fs::path(folder) / fmt::format("{}_{}.stl", stem, region_name(region))).string();
    const auto count = std::count(coloured.regions.begin(), coloured.regions.end(), region);
    if (count == 0) {
      fs::remove(path, error);
      if (error) throw FileError(path, "", "is out of date and cannot be removed: " + error.message());
      continue;
    }
    write_stl_of(path, groups.mesh(),
                 [region](std::uint32_t group) { return group == static_cast<std::uint32_t>(region); });
    paths.push_back(path);
  }
  return paths;
}

void write_borders(const std::string& path, const SplitMesh& mesh) {
  format_of(path, border_formats(), "borders are").write(path, mesh);
}

}  // namespace moldlight
