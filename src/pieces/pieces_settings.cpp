#include "pieces/pieces_settings.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

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

void validate(const PiecesSettings& settings) {
  if (settings.fixed.size() > static_cast<std::size_t>(settings.most))
    throw UsageError(fmt::format("--fixed: {} directions are more than the {} of --max",
                                 settings.fixed.size(), settings.most));
}

}  // namespace moldlight
