#include "io/step_writer.hpp"

#include <algorithm>

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

std::vector<std::uint32_t> write_step_part(const std::string& path, const Part& part,
                                           const ReadOptions& options, const StepLabels& labels,
                                           const Progress& progress) {
  FileContents contents(part.file, progress);
  const ReadContext context{part.file, contents, options, progress, true};
  const std::uint64_t file_bytes = contents.bytes().size();
  const std::string bytes = labels.to_bytes();
  std::uint64_t points = 0;
  for (const StepLine& line : labels.lines) points += line.points.size();
  for (const StepSurface& surface : labels.surfaces) {
    for (const StepSurface::Face& face : surface.faces) {
      for (const auto& loop : face.loops) points += 2 * loop.size();
    }
  }
  const std::string result = run_step_program(
      context, {.format = part.format.c_str(),
                .file_bytes = file_bytes + bytes.size(),
                .from_memory = true,
                .labels = bytes,
                .most_bytes = k_base_bytes + k_bytes_a_byte * file_bytes +
                              k_bytes_a_border * labels.borders.size() + k_bytes_a_point * points});
  auto written = step_answer<StepWritten>(context, result);
  const auto is_split = [&](std::uint32_t face) {
    return std::ranges::binary_search(labels.split_faces, face);
  };
  if (!written.file.starts_with("ISO-10303-21;") || !std::ranges::all_of(written.failed_faces, is_split))
    context.fail("", "{}", k_step_breaks);
  write_file(path, written.file);
  return std::move(written.failed_faces);
}

}  // namespace moldlight
