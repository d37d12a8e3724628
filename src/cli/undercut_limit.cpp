#include "cli/undercut_limit.hpp"

#include "base/error.hpp"
#include "session/option.hpp"

namespace moldlight::cli {

UndercutLimit parse_undercut_limit(std::string_view text) {
  constexpr std::string_view k_flag = "--fail-if-undercut";
  UndercutLimit limit;
  limit.per_cent = text.ends_with('%');
  if (limit.per_cent) text.remove_suffix(1);
  limit.value = parse_real(text, k_flag);
  if (limit.value < 0.0) throw UsageError("--fail-if-undercut: the limit is less than 0");
  return limit;
}

}  // namespace moldlight::cli
