// Units of length: their names here, the words that files and users have for them, their size. What lengths
// make sense for a part.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"

namespace moldlight {

struct LengthUnit {
  std::string_view name;  // "mm", "in", …
  double mm = 1.0;
};

/// The unit that a word in lower case names, in British or American spelling, singular or plural; none for
/// others.
[[nodiscard]] constexpr std::optional<LengthUnit> find_length_unit(std::string_view word) {
  struct Word {
    std::string_view word;
    LengthUnit unit;
  };
  constexpr LengthUnit k_um{"um", 0.001}, k_mm{"mm", 1.0}, k_cm{"cm", 10.0}, k_dm{"dm", 100.0},
      k_m{"m", 1000.0}, k_in{"in", 25.4}, k_ft{"ft", 304.8};
  constexpr std::array<Word, 24> k_words = {
      {{"um", k_um},         {"micron", k_um},     {"microns", k_um},    {"micrometre", k_um},
       {"micrometer", k_um}, {"mm", k_mm},         {"millimetre", k_mm}, {"millimeter", k_mm},
       {"cm", k_cm},         {"centimetre", k_cm}, {"centimeter", k_cm}, {"dm", k_dm},
       {"decimetre", k_dm},  {"decimeter", k_dm},  {"m", k_m},           {"metre", k_m},
       {"meter", k_m},       {"in", k_in},         {"inch", k_in},       {"inches", k_in},
       {"ft", k_ft},         {"foot", k_ft},       {"feet", k_ft},       {"millimeters", k_mm}}};
  for (const Word& known : k_words) {
    if (known.word == word) return known.unit;
  }
  return std::nullopt;
}

/// How long the unit of this name is; 1 where it is none.
[[nodiscard]] constexpr double mm_per_unit(std::string_view unit) {
  const auto known = find_length_unit(unit);
  return known ? known->mm : 1.0;
}

/// The same of a user's word, whatever its case. Throws UsageError for others.
[[nodiscard]] inline LengthUnit parse_length_unit(std::string_view word) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto unit = find_length_unit(lower);
  if (!unit) throw UsageError(fmt::format("--unit: '{}' is unknown; use um, mm, cm, dm, m, in or ft", word));
  return *unit;
}

/// Throws UsageError that names the flag for a length of more than the part's diagonal, both in model units.
inline void require_within_part(std::string_view flag, double length, double diagonal) {
  if (length <= diagonal) return;
  throw UsageError(fmt::format("{}: {:g} is more than the whole part, {:g} from corner to corner", flag,
                               length, diagonal));
}

}  // namespace moldlight
