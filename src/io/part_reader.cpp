#include "io/part_reader.hpp"

#include <new>
#include <utility>

#include "io/file_format.hpp"
#include "io/read_context.hpp"
#include "io/readers.hpp"
#include "mesh/part_selection.hpp"
#include "mesh/repair.hpp"

namespace moldlight {

namespace {

Part read_as(FileFormat format, const ReadContext& context) {
  switch (format) {
    case FileFormat::stl_binary:
      return read_binary_stl(context);
    case FileFormat::stl_ascii:
      return read_ascii_stl(context);
    case FileFormat::obj:
      return read_obj(context);
    case FileFormat::ply:
      return read_ply(context);
    case FileFormat::off:
      return read_off(context);
    case FileFormat::threemf:
      return read_threemf(context);
    case FileFormat::step:
      break;
  }
  return read_step(context);
}

}  // namespace

Part read_part(const std::string& path, const ReadOptions& options, const Progress& progress) {
  FileContents contents(path, progress);
  const ReadContext context{path, contents, options, progress};
  const FileFormat format = detect_format(path, contents.bytes());
  const std::size_t size_mib = contents.bytes().size() >> 20;
  try {
    Part part = read_as(format, context);
    part.file = path;
    part.format = format_name(format);
    if (!options.unit.empty()) set_unit(part, options.unit);
    part = select_body(std::move(part), options.body);
    repair_part(part, options.repair);
    if (part.mesh.facets.empty())
      context.fail("", "has no facet with an area; nothing is left of it after the repair");
    return part;
  } catch (const std::bad_alloc&) {
    context.fail("", "there is not enough memory for this part (a file of {} MiB)", size_mib);
  }
}

}  // namespace moldlight
