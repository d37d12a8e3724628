// Whether the mold of the former revision survives: steel by place, and the parting line.
#include <algorithm>

#include <fmt/format.h>

#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr std::size_t k_most_steel_rows = 40;

class MoldChangeDescriber {
 public:
  explicit MoldChangeDescriber(const Comparison& comparison)
      : comparison_(comparison), mold_(*comparison.mold), style_(*comparison.a.model) {}

  [[nodiscard]] FigureGrid sums() const {
    FigureGrid grid;
    for (const auto& [name, sum, key] :
         {std::tuple("Steel to cut", &mold_.to_cut, "cut"), std::tuple("Steel to add", &mold_.to_add, "add")})
      grid.figures.push_back(
          {name, volume(*sum, fmt::format("/mold/steel_to_{}/volume", key)), style_.unit(FigureKind::volume),
           std::string_view(key) == "cut" ? "the part grows there" : "the part shrinks there", error(*sum)});
    return grid;
  }

  [[nodiscard]] Table steel() const {
    Table table{{{"place"},
                 {"steel", true},
                 {"of", true},
                 {style_.heading("volume", FigureKind::volume)},
                 {"±"},
                 {style_.heading("area", FigureKind::area)},
                 {style_.heading("depth", FigureKind::length)},
                 {style_.heading("centre", FigureKind::length), true}},
                {}};
    std::size_t all = 0;
    for (std::size_t k = 0; k < mold_.places.size(); ++k)
      for (const bool is_cut : {true, false}) {
        const std::optional<SteelChange>& steel = is_cut ? mold_.places[k].cut : mold_.places[k].add;
        if (!steel || ++all > k_most_steel_rows) continue;
        const std::string key = fmt::format("/places/{}/steel_to_{}/", k, is_cut ? "cut" : "add");
        table.rows.push_back({{{fmt::format("{}", k + 1)},
                               {is_cut ? "cut" : "add"},
                               {steel_of_text(comparison_, *steel)},
                               volume(steel->volume, key + "volume"),
                               {error(steel->volume)},
                               number(style_, FigureKind::area, key + "area", steel->area),
                               number(style_, FigureKind::length, key + "depth", steel->depth),
                               {with_minus(style_.point(steel->centre))}}});
      }
    if (all > k_most_steel_rows) table.rest = fmt::format("… {} in all; --json lists them.", all);
    return table;
  }

  [[nodiscard]] Table line() const {
    Table table{{{"parting line", true},
                 {style_.heading("length", FigureKind::length)},
                 {style_.heading("farthest", FigureKind::length)},
                 {style_.heading("at", FigureKind::length), true}},
                {}};
    for (const bool is_new : {true, false}) {
      const std::vector<LineStretch>& stretches = is_new ? mold_.line.added : mold_.line.gone;
      for (std::size_t k = 0; k < std::min(stretches.size(), k_most_steel_rows); ++k) {
        const LineStretch& one = stretches[k];
        const std::string key = fmt::format("/mold/parting_line/{}/{}/", is_new ? "new" : "gone", k);
        table.rows.push_back({{{is_new ? "new, off the old one" : "old, no longer used"},
                               number(style_, FigureKind::length, key + "length", one.length),
                               number(style_, FigureKind::length, key + "farthest", one.farthest),
                               {with_minus(style_.point(one.at))}}});
      }
    }
    return table;
  }

 private:
  [[nodiscard]] Value volume(const MeasuredVolume& measured, std::string key) const {
    return number(style_, FigureKind::volume, std::move(key), measured.volume);
  }
  /// Where it can be seen in the digits shown.
  [[nodiscard]] static std::string error(const MeasuredVolume& measured) {
    constexpr double k_seen_share = 5e-5;
    return measured.error > k_seen_share * measured.volume && measured.volume > 0.0
               ? error_text(measured.error)
               : std::string();
  }

  const Comparison& comparison_;
  const MoldChange& mold_;
  FigureStyle style_;
};

}  // namespace

Section mold_change_section(const Comparison& comparison) {
  const MoldChangeDescriber describer(comparison);
  Section section{"Does the mold survive?", {}};
  section.add(describer.sums());
  for (Table table : {describer.steel(), describer.line()})
    if (!table.rows.empty()) section.add(std::move(table));
  return section;
}

}  // namespace moldlight::report
