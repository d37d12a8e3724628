#include <algorithm>
#include <utility>

#include "io/file_contents.hpp"
#include "io/readers.hpp"
#include "io/step_program.hpp"
#include "io/step_result.hpp"
#include "io/text_scanner.hpp"
#include "mesh/repair.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

constexpr std::string_view k_end_mark = "END-ISO-10303-21";
// Of what is handed back: a facet with three corners of its own and a name of its own; names and sentences.
constexpr std::uint64_t k_result_bytes_a_facet = 128, k_result_bytes_a_byte = 16,
                        k_base_result_bytes = std::uint64_t{1} << 20;

/// Facets of faces that were sewn meet but for their last digits, in diagonals of the part.
constexpr double k_sewn_digits = 1e-7;

/// The reading program may have been broken by its file in ways that leave it running.
void check_result(const ReadContext& context, const StepResult& result) {
  context.check_facet_count(result.facets.size());
  std::uint64_t covered = 0;
  for (const StepBody& body : result.bodies) {
    if (body.facets == 0 || body.facets > result.facets.size() - covered)
      context.fail("", "{}", k_step_breaks);
    covered += body.facets;
  }
  if (covered == 0 || covered != result.facets.size() || result.faces.size() != covered)
    context.fail("", "{}", k_step_breaks);
  const auto faces = static_cast<std::uint32_t>(result.face_colours.size());
  if (faces > 0 && std::ranges::any_of(result.faces, [faces](std::uint32_t face) { return face >= faces; }))
    context.fail("", "{}", k_step_breaks);
  for (std::size_t i = 0; i < result.vertices.size(); ++i) {
    const auto& [x, y, z] = result.vertices[i];
    if (is_usable_point({x, y, z})) continue;
    context.fail(fmt::format("vertex {}", i), "is ({}, {}, {}); export the part as STL", x, y, z);
  }
  for (const auto& facet : result.facets) {
    for (const std::uint32_t corner : facet)
      if (corner >= result.vertices.size()) context.fail("", "{}", k_step_breaks);
  }
}

Part read_by_opencascade(const ReadContext& context, const char* format) {
  const std::uint64_t file_bytes = context.bytes().size();
  if (!context.in_memory) context.contents.release();
  StepProgram ends;
  StepProgram& program = context.options.stays ? *context.options.stays : ends;
  program.start(context, {.format = format,
                          .file_bytes = file_bytes,
                          .from_memory = context.in_memory,
                          .stays = context.options.stays != nullptr});
  return part_of_step_result(
      context,
      program.answer(context, k_base_result_bytes + k_result_bytes_a_facet * context.options.max_facets +
                                  k_result_bytes_a_byte * file_bytes));
}

}  // namespace

Part read_step(const ReadContext& context) {
  const std::string_view bytes = context.bytes();
  const std::string_view tail = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 4096));
  if (tail.find(k_end_mark) == std::string_view::npos) {
    context.fail(fmt::format("byte {}", bytes.size()),
                 "the STEP file ends without '{}'; export the part again", k_end_mark);
  }
  return read_by_opencascade(context, "STEP");
}

bool is_iges_record(std::string_view line, char section) {
  constexpr std::size_t k_mark = 72, k_length = 80;
  return line.size() >= k_length && line[k_mark] == section &&
         line.substr(k_mark + 1, k_length - k_mark - 1).find_first_not_of(" 0123456789") ==
             std::string_view::npos &&
         line.substr(0, k_length).find('\n') == std::string_view::npos;
}

Part read_iges(const ReadContext& context) {
  std::string_view bytes = context.bytes();
  bytes = bytes.substr(0, bytes.find_last_not_of(" \r\n\t\0\x1a") + 1);
  bytes = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 80));
  if (!is_iges_record(bytes, 'T')) {
    context.fail(fmt::format("byte {}", context.bytes().size()),
                 "the IGES file ends without its last record, 'T'; export the part again as IGES text");
  }
  Part part = read_by_opencascade(context, "IGES");
  weld_near_vertices(part.mesh, k_sewn_digits * bounds(part.mesh).diagonal(), context.progress);
  return part;
}

Part part_of_step_result(const ReadContext& context, std::string_view bytes) {
  auto result = step_answer<StepResult>(context, bytes);
  check_result(context, result);

  Part part;
  part.unit = clean_name(result.unit);
  for (const std::string& warning : result.warnings) part.warnings.push_back(clean_name(warning));
  FacetIndex first = 0;
  for (const StepBody& body : result.bodies) {
    part.bodies.push_back({clean_name(body.name), first, static_cast<FacetIndex>(body.facets)});
    first += part.bodies.back().facet_count;
  }
  for (const auto& [x, y, z] : result.vertices) part.mesh.vertices.emplace_back(x, y, z);
  part.mesh.facets = std::move(result.facets);
  part.facet_source = std::move(result.faces);
  part.has_cad_faces = true;
  part.face_colours = std::move(result.face_colours);
  part.mesh = weld_vertices(part.mesh);
  return part;
}

}  // namespace moldlight
