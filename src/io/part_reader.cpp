#include "io/part_reader.hpp"

#include <new>
#include <utility>

#include "io/part_formats.hpp"
#include "io/read_context.hpp"
#include "mesh/part_selection.hpp"
#include "mold/exact/united_bodies.hpp"

namespace moldlight {

Part read_part(const std::string& path, const ReadOptions& options, const Progress& progress) {
  const PartFormat* format = nullptr;
  FileContents contents(path, progress,
                        [&](const FileBeginning& file) { format = &detect_format(path, file); });
  const ReadContext context{path, contents, options, progress};
  const std::size_t size_mib = contents.bytes().size() >> 20;
  try {
    Part part = format->read(context);
    part.file = path;
    part.format = format->name;
    part.effort = options.effort;
    if (!options.unit.empty()) set_unit(part, options.unit);
    part = select_body(std::move(part), options.body);
    mend_part(part, options.repair, progress);
    if (part.mesh.facets.empty()) context.fail("", "has no facet with an area; the repair left nothing");
    return part;
  } catch (const std::bad_alloc&) {
    context.fail("", "there is not enough memory for this part (a file of {} MiB)", size_mib);
  }
}

}  // namespace moldlight
