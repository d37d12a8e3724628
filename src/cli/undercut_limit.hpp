// The criterion of --fail-if-undercut.
#pragma once

#include <string_view>

namespace moldlight::cli {

/// An undercut area that may just be.
struct UndercutLimit {
  double value = 0.0;  // at least 0; per cent of the part's area or model units squared
  bool per_cent = false;

  [[nodiscard]] double area(double total_area) const { return per_cent ? 0.01 * value * total_area : value; }
};

/// Parses "12.5" or "2.5%"; throws UsageError.
[[nodiscard]] UndercutLimit parse_undercut_limit(std::string_view text);

}  // namespace moldlight::cli
