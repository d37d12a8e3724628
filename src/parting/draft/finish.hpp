// Finishes of faces and the draft that each asks for, by rules of thumb that are named.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "classify/option.hpp"
#include "classify/part_model.hpp"

namespace moldlight {

inline constexpr double k_most_required_deg = 45.0;

/// By which the depth of a texture asks for draft: 1 degree a 0.025 mm, or 1.5 degrees a 0.001 inch.
enum class TextureRule : std::uint8_t { metric, inch };

struct FinishSettings {
  TextureRule texture_rule = TextureRule::metric;

  bool operator==(const FinishSettings&) const = default;
};
[[nodiscard]] std::span<const Option<FinishSettings>> finish_options();

/// A finish whose draft no depth or angle decides.
struct NamedFinish {
  std::string_view name;
  double required_deg;
};
/// Shop practice: a polished wall leaves its steel with half a degree; steel that shuts off on steel wears
/// below three.
inline constexpr std::array<NamedFinish, 3> k_named_finishes = {
    {{"polished", 0.5}, {"shut-off", 3.0}, {"none", 0.0}}};

struct Finish {
  std::string name;           // as given
  double required_deg = 0.0;  // [0, 45]; 0: draft is not looked at

  bool operator==(const Finish&) const = default;
};
/// Of "polished", "shut-off", "texture 0.03 mm" (of this depth), "draft 2" (degrees) or "none"; nothing for
/// what is none of these.
[[nodiscard]] std::optional<Finish> parse_finish(std::string_view text, TextureRule rule);

struct FaceFinish {
  std::uint32_t face = 0;  // of part_faces()
  Finish finish;

  bool operator==(const FaceFinish&) const = default;
};
/// Of a text with a line a face, "FACE,FINISH": FACE is a number, a colour of a STEP file as #RRGGBB for all
/// faces that have it, or * for all that no other line names. A first line of column names, empty lines and
/// lines that begin with "# " are left aside. Rising; the last line of a face holds. Throws FileError, which
/// names the line, for anything else.
[[nodiscard]] std::vector<FaceFinish> finishes_in(std::string_view text, const std::string& path,
                                                  const PartModel& model, TextureRule rule);
/// Of a file. Throws FileError.
[[nodiscard]] std::vector<FaceFinish> read_finishes(const std::string& path, const PartModel& model,
                                                    TextureRule rule, const Progress& progress);

/// What read_finishes reads. Throws FileError.
void write_finishes(const std::string& path, std::span<const FaceFinish> finishes);

/// The finish of a face among others, which rise; none takes it away.
void set_finish(std::vector<FaceFinish>& finishes, std::uint32_t face, std::optional<Finish> finish);
[[nodiscard]] const Finish* finish_of(std::span<const FaceFinish> finishes, std::uint32_t face);

}  // namespace moldlight
