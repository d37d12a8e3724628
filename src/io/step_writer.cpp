#include "io/step_writer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "io/atomic_file.hpp"
#include "io/file_contents.hpp"
#include "io/step_program.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

namespace {

// Of what comes back: an edge with its curves for each piece of a border.
constexpr std::uint64_t k_base_bytes = std::uint64_t{16} << 20, k_bytes_a_byte = 40, k_bytes_a_border = 8192,
                        k_bytes_a_point = 1024;

}  // namespace

StepPartWritten write_step_part(const std::string& path, const Part& part, const ReadOptions& options,
                                const StepLabels& labels, const Progress& progress) {
  CHECK(options.stays && options.stays->running());
  StepProgram& program = *options.stays;
  FileContents nothing{std::string_view()};
  const ReadContext context{part.file, nothing, options, progress};
  std::uint64_t points = 0;
  for (const StepLine& line : labels.lines) points += line.points.size();
  for (const StepSurface& surface : labels.surfaces) {
    for (const StepSurface::Face& face : surface.faces) {
      for (const auto& loop : face.loops) points += 2 * loop.size();
    }
  }
  program.ask(context, labels.to_bytes());
  auto written = step_answer<StepWritten>(
      context,
      program.answer(context, k_base_bytes + k_bytes_a_byte * program.file_bytes() +
                                  k_bytes_a_border * labels.borders.size() + k_bytes_a_point * points));
  const auto is_split = [&](std::uint32_t face) {
    return std::ranges::binary_search(labels.split_faces, face);
  };
  const auto is_area = [](double area) { return std::isfinite(area) && area >= 0.0; };
  if (!written.file.starts_with("ISO-10303-21;") || !std::ranges::all_of(written.failed_faces, is_split) ||
      written.areas.size() != labels.names.size() || !std::ranges::all_of(written.areas, is_area))
    context.fail("", "{}", k_step_breaks);
  write_file(path, written.file);
  return {std::move(written.failed_faces), std::move(written.areas)};
}

}  // namespace moldlight
