// The readers of part files, a function a format. Strict: what the format does not allow is a FileError that
// names the place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "io/file_contents.hpp"
#include "io/read_options.hpp"
#include "mesh/part.hpp"

namespace moldlight {

struct ReadContext {
  const std::string& path;
  FileContents& contents;
  const ReadOptions& options;
  const Progress& progress;
  bool in_memory = false;  // there is no file: `path` only names the bytes

  [[nodiscard]] std::string_view bytes() const { return contents.bytes(); }

  /// Throws FileError for a place such as "line 12"; the text is formatted as by fmt::format.
  template <typename... Args>
  [[noreturn]] void fail(const std::string& place, fmt::format_string<Args...> what, Args&&... args) const {
    throw FileError(path, place, fmt::format(what, std::forward<Args>(args)...));
  }

  /// Throws where `facets` exceeds the limit of the options.
  void check_facet_count(std::uint64_t facets) const {
    if (facets <= static_cast<std::uint64_t>(options.max_facets)) return;
    fail("", "holds more facets than the limit of {}; raise the limit (--max-facets) if they are meant",
         options.max_facets);
  }
};

/// Most vertices that a mesh can number.
inline constexpr std::uint32_t k_max_vertices = 0xffff'fffe;

/// Largest coordinate magnitude that is read; the sixth power of it, as volumes of volumes need it, is still
/// finite.
inline constexpr double k_max_coordinate = 1e30;

/// False for NaN, infinity and what is beyond k_max_coordinate.
[[nodiscard]] inline bool is_usable_coordinate(double value) {
  return value <= k_max_coordinate && value >= -k_max_coordinate;
}
[[nodiscard]] inline bool is_usable_point(const glm::dvec3& point) {
  return is_usable_coordinate(point.x) && is_usable_coordinate(point.y) && is_usable_coordinate(point.z);
}

/// True where the size is that of a binary STL with the facet count in its header.
[[nodiscard]] bool binary_stl_size_fits(const FileBeginning& file);
/// Says what is likely where the size and the count disagree: throws FileError.
[[noreturn]] void refuse_binary_stl(const std::string& path, const FileBeginning& file);
/// Binary STL: one body, named by nothing. Coordinates are the file's floats, exactly.
[[nodiscard]] Part read_binary_stl(const ReadContext& context);
/// ASCII STL: one body a solid that has facets. Normals are not looked at: the corners' order gives the
/// outer side.
[[nodiscard]] Part read_ascii_stl(const ReadContext& context);

/// Wavefront OBJ: facets are numbered in the order of the file's polygons ('f' lines). Objects are the
/// bodies, or groups where there are no objects. Materials, textures, normals, points, lines and
/// free-form surfaces are left out; no other file is opened. facet_source holds polygon numbers from 0.
[[nodiscard]] Part read_obj(const ReadContext& context);

/// PLY, ASCII and both binary orders: one body. Further elements and properties are passed over.
/// facet_source holds face numbers from 0 where some face is no triangle.
[[nodiscard]] Part read_ply(const ReadContext& context);

/// OFF and its kin with colours and normals (COFF, NOFF, …), in text: one body. A vertex or a face a
/// line; what follows the coordinates or the corners on it is passed over. facet_source as for PLY.
[[nodiscard]] Part read_off(const ReadContext& context);

/// 3MF, production extension included: one body for every use of a mesh, in the order of the build items.
/// The unit is the root model's. No file beside the archive is opened, and references that nest or
/// multiply without end are stopped.
[[nodiscard]] Part read_threemf(const ReadContext& context);

/// STEP, through the program moldlight-step, which lies beside moldlight and is built with OpenCASCADE.
/// Solids are the bodies; facet_source holds CAD face numbers from 0; lengths are in the file's unit. Throws
/// FileError also where this build has no STEP support, and where the file breaks the reading program.
[[nodiscard]] Part read_step(const ReadContext& context);
/// IGES in text, likewise; faces that no solid has are sewn to bodies.
[[nodiscard]] Part read_iges(const ReadContext& context);
/// Whether a line of an IGES file is a record of this section, by its 73rd letter and the number behind it.
[[nodiscard]] bool is_iges_record(std::string_view line, char section);
/// Path of moldlight-step: beside this program, or where an installation keeps helpers, of the program or of
/// the Python module; none where it is nowhere of these.
[[nodiscard]] std::optional<std::string> step_reading_program();
/// The part in a StepResult as bytes, which are not trusted. Throws FileError.
[[nodiscard]] Part part_of_step_result(const ReadContext& context, std::string_view bytes);

}  // namespace moldlight
