// Solids for printing and machining: binary STL, and 3MF with several solids in one file.
#include <cstdint>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <zip.h>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight {

namespace {

std::string_view unit_word(const std::string& unit) {
  constexpr std::pair<std::string_view, std::string_view> k_words[] = {
      {"um", "micron"}, {"cm", "centimeter"}, {"m", "meter"}, {"in", "inch"}, {"ft", "foot"}};
  for (const auto& [name, word] : k_words) {
    if (name == unit) return word;
  }
  return "millimeter";
}

std::string model_xml(std::span<const NamedSolid> solids, const std::string& unit) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"{}\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n",
      unit_word(unit));
  const auto out = std::back_inserter(text);
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const TriangleMesh& mesh = *solids[k].mesh;
    fmt::format_to(out, "<object id=\"{}\" name=\"{}\" type=\"model\"><mesh><vertices>\n", k + 1,
                   solids[k].name);
    for (const glm::dvec3& v : mesh.vertices) {
      fmt::format_to(out, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", static_cast<float>(v.x),
                     static_cast<float>(v.y), static_cast<float>(v.z));
    }
    text += "</vertices><triangles>\n";
    for (const auto& facet : mesh.facets)
      fmt::format_to(out, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", facet[0], facet[1], facet[2]);
    text += "</triangles></mesh></object>\n";
  }
  text += "</resources>\n<build>\n";
  for (std::size_t k = 0; k < solids.size(); ++k) fmt::format_to(out, "<item objectid=\"{}\"/>\n", k + 1);
  return text += "</build>\n</model>\n";
}

/// A zip archive in memory.
std::string zipped(const std::string& path,
                   std::span<const std::pair<std::string_view, std::string_view>> entries) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  const auto fail = [&](const char* what) {
    throw FileError(path, "", std::string("cannot be packed: ") + what);
  };
  if (target == nullptr) fail(zip_error_strerror(&error));
  zip_source_keep(target);
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> kept(target, zip_source_free);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  if (archive == nullptr) {
    zip_source_free(target);
    fail(zip_error_strerror(&error));
  }
  for (const auto& [name, bytes] : entries) {
    zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    if (source == nullptr || zip_file_add(archive, std::string(name).c_str(), source, ZIP_FL_OVERWRITE) < 0) {
      zip_source_free(source);
      zip_discard(archive);
      fail("an entry cannot be added");
    }
  }
  if (zip_close(archive) < 0) {
    zip_discard(archive);
    fail("the archive cannot be finished");
  }
  std::string packed;
  if (zip_source_open(target) < 0) fail("the archive cannot be read");
  char chunk[1 << 16];
  for (zip_int64_t got = 0; (got = zip_source_read(target, chunk, sizeof chunk)) > 0;)
    packed.append(chunk, static_cast<std::size_t>(got));
  zip_source_close(target);
  return packed;
}

}  // namespace

void write_solid_stl(const std::string& path, const TriangleMesh& mesh, const std::string& unit) {
  write_stl_facets(path, "moldlight" + (unit.empty() ? "" : ", unit " + unit), mesh,
                   [](FacetIndex) { return std::uint16_t{0}; });
}

void write_solids_3mf(const std::string& path, std::span<const NamedSolid> solids, const std::string& unit) {
  constexpr std::string_view k_types =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types "
      "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
      "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
      "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
      "</Types>\n";
  constexpr std::string_view k_relations =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
      "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
      "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
  const std::string model = model_xml(solids, unit);
  const std::pair<std::string_view, std::string_view> entries[] = {
      {"[Content_Types].xml", k_types}, {"_rels/.rels", k_relations}, {"3D/3dmodel.model", model}};
  write_file(path, zipped(path, entries));
}

}  // namespace moldlight
