// Whether the mold that exists survives a revision, in words.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "compare/comparison.hpp"

namespace moldlight {

namespace {

/// " ± 0.2" where it can be seen in the digits shown.
std::string seen_error(const MeasuredVolume& measured) {
  constexpr double k_seen_share = 5e-5;
  return measured.error > k_seen_share * measured.volume ? " ± " + error_text(measured.error) : std::string();
}

}  // namespace

std::string steel_owner_text(const Comparison& comparison, const SteelOwner& owner, bool is_cut) {
  if (owner.side != MoldSide::action) return std::string(side_name(owner.side));
  const std::optional<ActionPlan>& plan = (is_cut ? comparison.a : comparison.b).plan;
  if (!owner.action || !plan) return "side action";
  return fmt::format("{} {}", facts(plan->actions[*owner.action].kind).singular, *owner.action + 1);
}

std::string steel_of_text(const Comparison& comparison, const SteelChange& steel, bool is_cut) {
  constexpr double k_least_share = 0.05;
  double whole = 0.0;
  for (const OwnedArea& one : steel.of) whole += one.area;
  std::vector<std::string> names;
  for (const OwnedArea& one : steel.of)
    if (one.area >= k_least_share * whole) names.push_back(steel_owner_text(comparison, one.owner, is_cut));
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string mold_change_text(const Comparison& comparison, const MoldChange& mold) {
  constexpr std::size_t k_most_named = 3;
  const FigureStyle style(*comparison.a.model);
  const auto cuts = static_cast<std::size_t>(
      std::ranges::count_if(mold.places, [](const PlaceSteel& one) { return one.cut.has_value(); }));
  std::vector<std::string> added;
  for (const PlaceSteel& place : mold.places) {
    if (!place.add) continue;
    added.push_back(fmt::format(
        "{}{} {} at ({}) {}, {}", style.text(FigureKind::volume, place.add->volume.volume),
        seen_error(place.add->volume), style.unit(FigureKind::volume), style.point(place.add->centre),
        length_unit(comparison.a.model->part), steel_of_text(comparison, *place.add, false)));
  }
  std::string text = cuts == 0
                         ? std::string("No place cuts steel")
                         : fmt::format("{} {} steel", plural(cuts, "place"), cuts == 1 ? "cuts" : "cut");
  if (added.empty()) {
    text = cuts == 0 ? "No steel of the mold changes" : text + "; none needs steel";
  } else {
    const std::size_t named = std::min(added.size(), k_most_named), count = added.size();
    text += fmt::format("; {} {} steel: {}", count, count == 1 ? "needs" : "need",
                        fmt::join(added.begin(), added.begin() + static_cast<std::ptrdiff_t>(named), "; "));
    if (named < count) text += fmt::format("; {} more", count - named);
  }
  text += ".";
  if (!mold.line.fresh.empty()) {
    const auto& fresh = mold.line.fresh;
    const auto farthest = std::ranges::max_element(fresh, {}, &LineStretch::farthest);
    text +=
        fmt::format(" The parting line leaves the old one at {}, by {} at most, at ({}) {}.",
                    plural(fresh.size(), "place"), style.with_unit(FigureKind::length, farthest->farthest),
                    style.point(farthest->at), length_unit(comparison.a.model->part));
  } else if (!mold.line.gone.empty()) {
    text += fmt::format(" {} of the old parting line {}.", plural(mold.line.gone.size(), "stretch"),
                        mold.line.gone.size() == 1 ? "goes" : "go");
  }
  return text;
}

}  // namespace moldlight
