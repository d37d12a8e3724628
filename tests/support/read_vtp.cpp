#include "support/read_vtp.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace moldlight::test {

namespace {

void need(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("vtp: " + what);
}

/// Of the first element of this text that has it.
std::string attribute(std::string_view text, const std::string& name) {
  const std::size_t at = text.find(" " + name + "=\"");
  need(at != std::string_view::npos, "no " + name);
  const std::size_t start = at + name.size() + 3;
  return std::string(text.substr(start, text.find('"', start) - start));
}

template <typename Number>
std::vector<double> converted(std::string_view bytes) {
  need(bytes.size() % sizeof(Number) == 0, "size of an array");
  std::vector<double> values;
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number)) {
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof(Number));
    values.push_back(static_cast<double>(number));
  }
  return values;
}

VtpArrayRead read_array(std::string_view element, std::string_view data) {
  need(attribute(element, "format") == "appended", "format of an array");
  const std::size_t at = std::stoull(attribute(element, "offset"));
  need(at + 8 <= data.size(), "offset of an array");
  std::uint64_t size = 0;
  std::memcpy(&size, data.data() + at, 8);
  need(size <= data.size() - at - 8, "an array leaves the file");
  const std::string_view bytes = data.substr(at + 8, size);
  const std::string type = attribute(element, "type");
  need(type == "Float64" || type == "Int32" || type == "Int64", "type " + type);
  return {type, type == "Float64" ? converted<double>(bytes)
                : type == "Int32" ? converted<std::int32_t>(bytes)
                                  : converted<std::int64_t>(bytes)};
}

}  // namespace

Vtp read_vtp(std::string_view bytes) {
  constexpr std::string_view k_data = "<AppendedData encoding=\"raw\">\n_",
                             k_end = "\n</AppendedData>\n</VTKFile>\n";
  const std::size_t start = bytes.find(k_data);
  need(bytes.starts_with("<?xml") && start != std::string_view::npos && bytes.ends_with(k_end), "frame");
  const std::string_view head = bytes.substr(0, start);
  std::string_view data = bytes.substr(start + k_data.size());
  data.remove_suffix(k_end.size());
  need(attribute(head, "byte_order") == "LittleEndian" && attribute(head, "header_type") == "UInt64",
       "header");
  Vtp found;
  std::map<std::string, VtpArrayRead> arrays;
  std::size_t used = 0;
  for (std::size_t at = head.find("<DataArray"); at != std::string_view::npos;
       at = head.find("<DataArray", at + 1)) {
    const std::string_view element = head.substr(at, head.find('>', at) - at);
    const std::string name = attribute(element, "Name");
    need(std::stoull(attribute(element, "offset")) == used, "arrays do not follow each other");
    VtpArrayRead array = read_array(element, data);
    used += 8 + array.values.size() * (array.type == "Int32" ? 4 : 8);
    (at > head.find("<CellData") ? found.of_facets : arrays)[name] = std::move(array);
  }
  need(used == data.size(), "bytes are left over");
  const auto &points = arrays["Points"].values, &corners = arrays["connectivity"].values,
             &ends = arrays["offsets"].values;
  need(points.size() == 3 * std::stoull(attribute(head, "NumberOfPoints")), "points");
  need(ends.size() == std::stoull(attribute(head, "NumberOfPolys")) && corners.size() == 3 * ends.size(),
       "polygons");
  for (std::size_t k = 0; k < points.size(); k += 3)
    found.mesh.vertices.emplace_back(points[k], points[k + 1], points[k + 2]);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    need(ends[k] == 3.0 * static_cast<double>(k + 1), "ends of polygons");
    std::array<VertexIndex, 3> facet{};
    for (std::size_t corner = 0; corner < 3; ++corner)
      facet[corner] = static_cast<VertexIndex>(corners[3 * k + corner]);
    for (const VertexIndex vertex : facet) need(vertex < found.mesh.vertices.size(), "corner of a polygon");
    found.mesh.facets.push_back(facet);
  }
  for (const auto& [name, array] : found.of_facets) need(array.values.size() == ends.size(), name);
  return found;
}

}  // namespace moldlight::test
