#include "pieces/pieces_settings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace moldlight {

std::span<const Option<PiecesSettings>> pieces_options() {
  using S = PiecesSettings;
  static const std::vector<Option<S>> k_options = {
      {"eps", "--eps", "Left over", "", "Share of the part's surface that no piece needs to release.",
       RealKind<S>{&S::eps, 0.0, 0.2, 0.001}},
      {"max", "--max", "Most directions", "", "Most directions that the mold may open along.",
       IntegerKind<S>{&S::most, 1, 12}},
      {"fixed", "--fixed", "Fixed directions", "",
       "A direction that the mold opens along in any case, X,Y,Z or an axis such as -y. May be given several "
       "times.",
       DirectionsKind<S>{&S::fixed}},
      {"elongation_pct", "--elongation", "Elongation", "%",
       "Elongation of a flexible mold's material. Undercuts that are left are then measured against it. 0 "
       "stands for a rigid mold.",
       RealKind<S>{&S::elongation_pct, 0.0, 2000.0, 50.0}},
      {"cosmetic", "--cosmetic", "Cosmetic faces", "",
       "Faces that no seam should cross, by the numbers that classify --faces writes. After the number of a "
       "piece and a colon, those that it must form. Separate groups by a slash: 3,17/2:4.",
       TextKind<S>{.name = "[PIECE:]FACES",
                   .get = [](const S& s) { return s.cosmetic; },
                   .set =
                       [](S& s, std::string_view text) {
                         static_cast<void>(cosmetic_groups(text));
                         s.cosmetic = text;
                       }}},
  };
  return k_options;
}

std::span<const Option<MethodSettings>> pieces_method_options() {
  static const std::vector<Option<MethodSettings>> k_options = {option_named(method_options(), "tau_deg"),
                                                                option_named(method_options(), "tolerance")};
  return k_options;
}

std::span<const Option<MoldSettings>> pieces_solid_options() {
  static const std::vector<Option<MoldSettings>> k_options = [] {
    std::vector<Option<MoldSettings>> options;
    for (const std::string_view key :
         {"margin", "shrink_pct", "ramp_deg", "land", "slope_deg", "registration"})
      options.push_back(option_named(mold_options(), key));
    return options;
  }();
  return k_options;
}

std::vector<CosmeticGroup> cosmetic_groups(std::string_view text) {
  std::vector<CosmeticGroup> groups;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('/'), text.size());
    const std::string_view group = text.substr(0, end);
    const std::size_t colon = group.find(':');
    groups.push_back({.piece = {}, .faces = parse_faces(group.substr(colon + 1))});  // npos + 1 is 0
    if (colon != std::string_view::npos) {
      const auto piece = number_from<std::uint32_t>(group.substr(0, colon));
      if (!piece || *piece == 0)
        throw UsageError(
            fmt::format("--cosmetic: '{}' is not the number of a piece", group.substr(0, colon)));
      groups.back().piece = *piece - 1;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return groups;
}

void validate(const PiecesSettings& settings) {
  if (settings.fixed.size() > static_cast<std::size_t>(settings.most))
    throw UsageError(fmt::format("--fixed: {} directions are more than the {} of --max",
                                 settings.fixed.size(), settings.most));
}

}  // namespace moldlight
