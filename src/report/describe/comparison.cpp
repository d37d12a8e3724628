// The report of a comparison: what a revision changes.
#include "compare/comparison.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "compare/compare_figures.hpp"
#include "compare/compare_picture.hpp"
#include "mold/direction.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr glm::ivec2 k_both_px(1600, 800);
constexpr std::size_t k_most_rows = 40, k_most_pictures = 8;

std::string rest_text(std::size_t count) {
  return count > k_most_rows ? fmt::format("… {} in all; --json lists them.", count) : std::string();
}

class Describer {
 public:
  explicit Describer(const ReportContext& context, const Comparison& comparison)
      : context_(context),
        comparison_(comparison),
        length_unit_(length_unit(comparison.a.model->part)),
        area_unit_(powered_unit(comparison.a.model->part, 2)),
        volume_unit_(powered_unit(comparison.a.model->part, 3)),
        style_(*comparison.a.model) {}

  [[nodiscard]] Section criteria(const CriteriaShown& asked) const {
    Section section{"Criteria", {}};
    Table table{{{"fails if", true}, {"A"}, {"B"}, {"change"}, {"", true}}, {}};
    for (const Criterion& criterion : asked.criteria) {
      const auto found =
          std::ranges::find(asked.figures, std::string_view(criterion.name), &ComparedFigure::name);
      if (found == asked.figures.end()) continue;
      table.rows.push_back({{{criterion.text},
                             {value_text(*found, found->before)},
                             {value_text(*found, found->after)},
                             {with_minus(change_text(*found))},
                             {criterion.is_met_by(*found) ? "fails" : "holds"}}});
    }
    section.add(std::move(table));
    return section;
  }

  [[nodiscard]] Section places() const {
    const SurfaceChange& surface = comparison_.surface;
    Section section{"Surface that is new or gone", {}};
    FigureGrid grid;
    grid.figures = {{"Gone", area(surface.gone.area, "/surface/gone/area"), area_unit_, "of A alone",
                     style_.text(FigureKind::error, surface.gone.error)},
                    {"New", area(surface.added.area, "/surface/new/area"), area_unit_, "of B alone",
                     style_.text(FigureKind::error, surface.added.error)},
                    {"The same within", length(surface.tolerance.apart, "/same_within"), length_unit_}};
    if (surface.chords > 0.0)
      grid.figures.push_back({"Tessellation", length(surface.chords, "/tessellation"), length_unit_,
                              "largest error assumed for the facets of both"});
    if (const auto& alignment = comparison_.alignment)
      grid.figures.push_back(
          {"B was laid on A", number(style_, FigureKind::length, "/alignment/residual/rms", alignment->rms),
           length_unit_,
           fmt::format("off, rms; {} at most", style_.with_unit(FigureKind::length, alignment->largest))});
    section.add(std::move(grid));
    Table table{
        {{"place"}, {"gone " + area_unit_}, {"new " + area_unit_}}, {}, rest_text(surface.places.size())};
    if (closed()) table.columns.push_back({"volume " + volume_unit_});
    table.columns.insert(table.columns.end(), {{"centre " + length_unit_, true}, {"across " + length_unit_}});
    for (std::size_t k = 0; k < std::min(surface.places.size(), k_most_rows); ++k) {
      const ChangedPlace& place = surface.places[k];
      const std::string key = fmt::format("/places/{}/", k);
      Row row{{{fmt::format("{}", k + 1)},
               area(place.gone.area, key + "gone/area"),
               area(place.added.area, key + "new/area")}};
      if (closed()) row.cells.push_back(volume(place.volume, key + "volume"));
      row.cells.insert(row.cells.end(),
                       {point(place.centre), {style_.text(FigureKind::length, place.bounds.diagonal())}});
      table.rows.push_back(std::move(row));
    }
    const bool any = !table.rows.empty();
    if (any) section.add(std::move(table));
    if (any && closed() && style_.change(FigureKind::volume, surface.volume_elsewhere) != "0")
      section.add(
          fmt::format("{} {} changed outside of these places, within tolerance and tessellation.",
                      with_minus(style_.change(FigureKind::volume, surface.volume_elsewhere)), volume_unit_),
          TextLook::quiet);
    for (std::size_t k = 0; k < surface.places.size(); ++k)
      if (surface.places[k].joined)
        section.add(fmt::format("Place {} is several places joined, since none is closed by itself.", k + 1));
    return section;
  }

  [[nodiscard]] Section regions() const {
    Section section{"Who forms what", {}};
    section.add(region_table());
    if (!comparison_.surface.regions.empty()) section.add(changed_regions());
    return section;
  }

  [[nodiscard]] Section undercuts() const {
    Section section{"Undercuts", {}};
    Table table{{{"", true},
                 {"A " + area_unit_},
                 {"B " + area_unit_},
                 {"A deep " + length_unit_},
                 {"B deep " + length_unit_},
                 {"centre " + length_unit_, true}},
                {}};
    ReportContext of_a = context_;
    of_a.model = comparison_.a.model;
    Illustrator a(of_a, comparison_.a.result), b(context_, comparison_.b.result);
    std::size_t same = 0;
    for (std::size_t k = 0; k < comparison_.undercuts.size(); ++k) {
      const MatchedChange& one = comparison_.undercuts[k];
      if (one.kind == ChangeKind::same) ++same;
      if (one.kind == ChangeKind::same || table.rows.size() == k_most_rows) continue;
      const UndercutReport* was = one.a ? &comparison_.a.plan->undercuts[*one.a] : nullptr;
      const UndercutReport* now = one.b ? &comparison_.b.plan->undercuts[*one.b] : nullptr;
      const auto size = [&](const UndercutReport* side, const char* name) {
        return side != nullptr ? area(side->undercut.area, fmt::format("/undercuts/{}/{}/area", k, name))
                               : Value{"–"};
      };
      const auto depth = [&](const UndercutReport* side, const char* name) {
        if (side == nullptr || !side->depth) return Value{"–"};
        return number(style_, FigureKind::length, fmt::format("/undercuts/{}/{}/depth", k, name),
                      *side->depth);
      };
      Row row{{{std::string(change_name(one.kind))},
               size(was, "a"),
               size(now, "b"),
               depth(was, "a"),
               depth(now, "b"),
               point((now != nullptr ? now : was)->undercut.centre)}};
      if (table.rows.size() < k_most_pictures) {
        row.picture = now != nullptr ? b.undercut(now->undercut) : a.undercut(was->undercut);
        row.picture_text =
            fmt::format("Undercut of {}, {}", now != nullptr ? "B" : "A", change_name(one.kind));
      }
      table.rows.push_back(std::move(row));
    }
    section.add(fmt::format("{} of A, {} of B, {} of them the same.",
                            plural(comparison_.a.plan->undercuts.size(), "undercut"),
                            comparison_.b.plan->undercuts.size(), same));
    table.rest = rest_text(comparison_.undercuts.size() - same);
    if (!table.rows.empty()) section.add(std::move(table));
    return section;
  }

  [[nodiscard]] Section actions() const {
    Section section{"Side actions", {}};
    Table table{
        {{"", true}, {"of A", true}, {"travel " + length_unit_}, {"of B", true}, {"travel " + length_unit_}},
        {},
        rest_text(comparison_.actions.size())};
    for (std::size_t k = 0; k < std::min(comparison_.actions.size(), k_most_rows); ++k) {
      const MatchedChange& one = comparison_.actions[k];
      Row row{{{std::string(change_name(one.kind))}}};
      const auto add = [&](const ActionPlan& plan, const std::optional<std::size_t>& place,
                           const char* name) {
        if (!place) {
          row.cells.insert(row.cells.end(), {{"–"}, {}});
          return;
        }
        const SideAction& action = plan.actions[*place];
        row.cells.push_back({fmt::format("{} {}, {}", facts(action.kind).singular, *place + 1,
                                         with_minus(direction_words(action.direction)))});
        row.cells.push_back(
            number(style_, FigureKind::length, fmt::format("/actions/{}/{}/travel", k, name), action.travel));
      };
      add(*comparison_.a.plan, one.a, "a");
      add(*comparison_.b.plan, one.b, "b");
      table.rows.push_back(std::move(row));
    }
    if (table.rows.empty()) {
      section.add("Neither part needs one.");
    } else {
      section.add(std::move(table));
    }
    return section;
  }

  [[nodiscard]] Section parts() const {
    Section section{"The parts", {}};
    Table table{{{"", true}, {"A"}, {"B"}}, {}};
    const PartModel &a = *comparison_.a.model, &b = *comparison_.b.model;
    table.rows.push_back({{{"File"}, {part_name(a.part)}, {part_name(b.part)}}});
    table.rows.push_back({{{"Parting direction"},
                           {with_minus(direction_words(comparison_.a.result.direction))},
                           {with_minus(direction_words(comparison_.b.result.direction))}}});
    const auto box = [this](const PartModel& model) {
      return Value{style_.point(model.health.bounds.max - model.health.bounds.min)};
    };
    table.rows.push_back({{{"Box " + length_unit_}, box(a), box(b)}});
    const auto row = [&](std::string name, FigureKind kind, const std::string& key, double of_a,
                         double of_b) {
      table.rows.push_back({{{std::move(name)},
                             number(style_, kind, "/a/" + key, of_a),
                             number(style_, kind, "/b/" + key, of_b)}});
    };
    if (closed())
      row("Volume " + volume_unit_, FigureKind::volume, "volume", a.health.volume, b.health.volume);
    row("Facets", FigureKind::count, "facets", static_cast<double>(a.health.facets),
        static_cast<double>(b.health.facets));
    row("Bodies", FigureKind::count, "components", static_cast<double>(a.health.components),
        static_cast<double>(b.health.components));
    section.add(std::move(table));
    for (const std::string& remark : comparison_.remarks) section.add(remark + ".", TextLook::notice);
    for (const auto& [name, part] : {std::pair("A", &comparison_.a), std::pair("B", &comparison_.b)})
      for (const std::string& warning : part->result.warnings)
        section.add(fmt::format("{}: {}", name, warning), TextLook::notice);
    return section;
  }

 private:
  [[nodiscard]] bool closed() const { return comparison_.surface.closed; }
  [[nodiscard]] Value area(double value, std::string key) const {
    return number(style_, FigureKind::area, std::move(key), value);
  }
  [[nodiscard]] Value length(double value, std::string key) const {
    return number(style_, FigureKind::length, std::move(key), value);
  }
  [[nodiscard]] Value change(double value, std::string key) const {
    return number(with_minus(style_.change(FigureKind::area, value)), std::move(key), value);
  }
  /// "+12.3 ± 0.2"; the error where it can be seen in the digits shown.
  [[nodiscard]] Value volume(const MeasuredVolume& measured, std::string key) const {
    Value shown = number(with_minus(style_.change(FigureKind::volume, measured.volume)), std::move(key),
                         measured.volume);
    constexpr double k_seen_share = 5e-5;
    if (measured.error > k_seen_share * std::abs(measured.volume) &&
        style_.change(FigureKind::volume, measured.error) != "0")
      shown.text += " ± " + error_text(measured.error);
    return shown;
  }
  [[nodiscard]] Value point(const glm::dvec3& at) const { return {with_minus(style_.point(at))}; }
  [[nodiscard]] Table region_table() const {
    Table table{{{"", true}, {"A " + area_unit_}, {"B " + area_unit_}, {"change " + area_unit_}, {"of A"}},
                {}};
    for (const FigureRow<ComparedPart>& one : region_figures()) {
      if (one.title.empty()) continue;
      const std::string key(one.key);
      const double before = *one.find(comparison_.a), after = *one.find(comparison_.b);
      table.rows.push_back({{{std::string(one.title)},
                             area(before, "/regions/a/" + key),
                             area(after, "/regions/b/" + key),
                             change(after - before, "/regions/difference/" + key),
                             {with_minus(change_percent(before, after))}}});
      for (const Region region : k_regions)
        if (region_name(region) == one.key) table.rows.back().mark = region_mark(region, context_.palette);
    }
    return table;
  }

  [[nodiscard]] Table changed_regions() const {
    const auto& regions = comparison_.surface.regions;
    Table table{{{"surface of both parts", true},
                 {"area " + area_unit_},
                 {"centre " + length_unit_, true},
                 {"across " + length_unit_}},
                {},
                rest_text(regions.size())};
    for (std::size_t k = 0; k < std::min(regions.size(), k_most_rows); ++k) {
      const ChangedRegion& region = regions[k];
      if (style_.text(FigureKind::area, region.area).front() == '<') {  // and so are all that follow
        table.rest = fmt::format("… {} more, each {} {}.", regions.size() - k,
                                 style_.text(FigureKind::area, region.area), area_unit_);
        break;
      }
      table.rows.push_back({{{fmt::format("{}, now {}", region_name(region.from), region_name(region.to))},
                             area(region.area, fmt::format("/regions/changed/{}/area", k)),
                             point(region.centre),
                             {style_.text(FigureKind::length, region.bounds.diagonal())}},
                            region_mark(region.to, context_.palette)});
    }
    return table;
  }

  const ReportContext& context_;
  const Comparison& comparison_;
  std::string length_unit_, area_unit_, volume_unit_;
  FigureStyle style_;
};

void add_pictures(const ReportContext& context, const Comparison& comparison, Report& report) {
  StillSettings still = still_settings(context, k_both_px);
  still.seen_from = lit_seen_from(comparison);
  report.still = {comparison_picture(*context.gl, comparison, still, context.progress),
                  {},
                  "A on the left with the surface that is gone, B on the right with the new surface",
                  "A is on the left, B on the right. " + view_caption()};
  report.view = comparison_view(context, comparison, *still.seen_from * glm::dvec3(0, 0, 1));
}

}  // namespace

Report compare_report(const ReportContext& context, const Comparison& comparison,
                      const CriteriaShown& asked) {
  const Describer describer(context, comparison);
  Report report = begin_report(context, "Comparison", comparison.a.result.direction);
  report.part =
      fmt::format("{} → {}", part_name(comparison.a.model->part), part_name(comparison.b.model->part));
  report.sentence = with_minus(comparison_verdict(comparison));
  const std::vector<std::string> failed = met_criteria(asked.criteria, asked.figures);
  report.tone = !failed.empty() ? Tone::bad : comparison.surface.any() ? Tone::attention : Tone::good;
  for (const std::string& sentence : failed) report.lead.push_back("Fails: " + with_minus(sentence) + ".");
  if (failed.empty() && !asked.criteria.empty()) report.lead.emplace_back("No criterion fails.");
  if (context.drawn()) add_pictures(context, comparison, report);
  if (!asked.criteria.empty()) report.sections.push_back(describer.criteria(asked));
  if (comparison.mold) report.sections.push_back(mold_change_section(comparison));
  report.sections.push_back(describer.places());
  report.sections.push_back(describer.regions());
  if (comparison.a.plan && comparison.b.plan) {
    report.sections.push_back(describer.undercuts());
    report.sections.push_back(describer.actions());
  }
  report.sections.push_back(describer.parts());
  report.sections.push_back(repeat_section(context, compare_json(comparison)["settings"]));
  return report;
}

}  // namespace moldlight::report
