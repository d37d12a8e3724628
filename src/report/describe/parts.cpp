#include "report/describe/parts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/map_comparison.hpp"
#include "classify/option.hpp"
#include "mold/direction.hpp"
#include "parting/draft/draft_check.hpp"

namespace moldlight::report {

namespace {

constexpr double k_most_draft_deg = 10.0, k_least_draft_deg = -5.0;
constexpr std::size_t k_most_walls = 8;

std::string json_value_text(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_number_float()) return real_text(value.get<double>());
  if (value.is_string()) return value.get<std::string>().empty() ? "–" : value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const auto& item : value) text += (text.empty() ? "" : ", ") + json_value_text(item);
  return text.empty() ? "none" : text;
}

/// "tau_deg" → "tau deg".
std::string spoken(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

/// No sign where the two decimals are 0.
std::string angle_text(double degrees) { return with_minus(component_text(degrees, 2)) + "°"; }

Table walls_table(const ReportContext& context, const DraftCheck& check) {
  const PartModel& model = *context.model;
  const FigureStyle style(model);
  Table table{{{"wall", true}, {"area " + powered_unit(model.part, 2)}}, {}};
  const bool finished = !check.finishes.empty();
  if (finished) table.columns.insert(table.columns.end(), {{"face"}, {"finish", true}, {"required"}});
  table.columns.insert(table.columns.end(),
                       {{"least draft"}, {"height " + length_unit(model.part)}, {"what helps", true}});
  for (std::size_t k = 0; k < std::min(check.walls.size(), k_most_walls); ++k) {
    const WallDraft& wall = check.walls[k];
    const Region region = wall.side == MoldSide::core ? Region::core : Region::cavity;
    const auto value = [&](std::string text, std::string_view name, double found) {
      return number(std::move(text), fmt::format("/draft/faces/{}/{}", k, name), found);
    };
    Row row{{{std::string(side_name(wall.side))},
             value(style.text(FigureKind::area, wall.area), "area", wall.area)},
            region_mark(region, context.palette)};
    if (finished)
      row.cells.insert(row.cells.end(),
                       {{fmt::format("{}", wall.face)},
                        {wall.finish.empty() ? "–" : wall.finish},
                        value(angle_text(wall.required_deg), "required_deg", wall.required_deg)});
    row.cells.insert(row.cells.end(),
                     {value(angle_text(wall.least_deg), "least_deg", wall.least_deg),
                      value(style.text(FigureKind::length, wall.height), "height", wall.height),
                      {suggestion(model, wall)}});
    table.rows.push_back(std::move(row));
  }
  if (check.walls.size() > k_most_walls)
    table.rest = fmt::format("… {} walls in all; --draft FILE.csv lists them.", check.walls.size());
  return table;
}

Table finishes_table(const FigureStyle& style, const DraftCheck& check) {
  Table table{{{"finish", true},
               {"required"},
               {"faces"},
               {style.heading("area", FigureKind::area)},
               {"least draft"},
               {style.heading("too little", FigureKind::area)}},
              {}};
  for (std::size_t k = 0; k < check.finishes.size(); ++k) {
    const FinishDraft& one = check.finishes[k];
    const std::string key = fmt::format("/draft/finishes/{}/", k);
    table.rows.push_back(
        {{{one.finish.name},
          number(angle_text(one.finish.required_deg), key + "required_deg", one.finish.required_deg),
          number(fmt::format("{}", one.faces), key + "faces", static_cast<double>(one.faces)),
          number(style, FigureKind::area, key + "area", one.area),
          one.least_deg ? number(angle_text(*one.least_deg), key + "least_deg", *one.least_deg) : Value{"–"},
          number(style, FigureKind::area, key + "below/area", one.below)}});
  }
  return table;
}

TitleBlock title_block(const ReportContext& context) {
  const PartModel& model = *context.model;
  const TitleFacts& title = context.title;
  const FigureStyle style(model);
  Facts facts;
  const auto add = [&](std::string name, std::string value) {
    if (!value.empty()) facts.facts.emplace_back(std::move(name), std::move(value));
  };
  add("File", part_name(model.part));
  add("Revision", title.revision);
  add("Material", title.material);
  add("Size", fmt::format("{} {}", style.point(model.health.bounds.max - model.health.bounds.min),
                          length_unit(model.part)));
  add("Company", title.company);
  add("Author", title.author);
  add("Date", title.date);
  TitleBlock block{title.logo, {std::move(facts)}};
  if (!title.note.empty()) block.blocks.emplace_back(Text{title.note});
  return block;
}

/// Why the undercut is not known to rounding; empty where it is.
std::string uncertainty_reason(const FigureStyle& style, const UndercutUncertainty& uncertainty) {
  if (uncertainty.sampled_facets > 0)
    return fmt::format("{} facets were sampled, which leaves ± {}.", uncertainty.sampled_facets,
                       style.with_unit(FigureKind::error, uncertainty.readout));
  if (uncertainty.readout > 0.0)
    return fmt::format("The readout is off the exact regions by {}.",
                       style.with_unit(FigureKind::error, uncertainty.readout));
  return uncertainty.mesh > uncertainty.rounding ? "The ± comes from faults of the mesh." : "";
}

/// What shadow maps show where the exact regions are otherwise: a row for every pair that surface has.
void add_maps(const FigureStyle& style, const MapComparison& maps, Section& section) {
  const double total = maps.total();
  section.add(fmt::format("{}; measured by {} samples, ± {} % of the area.", comparison_text(maps),
                          maps.samples, error_text(100.0 * share(maps.error, total))));
  Table table{{{"exact", true}, {"by maps", true}, {style.heading("area", FigureKind::area)}, {"share"}}, {}};
  for (const Region exact : k_regions) {
    for (const Region shown : k_regions) {
      const double area = maps.areas[static_cast<std::size_t>(exact)][shown];
      if (area <= 0.0) continue;
      table.rows.push_back(
          {{{std::string(region_name(exact))},
            {std::string(region_name(shown))},
            number(style, FigureKind::area,
                   fmt::format("/compare_maps/areas/{}/{}", region_name(exact), region_name(shown)), area),
            {share_text(area, total)}}});
    }
  }
  section.add(std::move(table));
}

}  // namespace

Value number(std::string text, std::string key, double value) {
  return {std::move(text), std::move(key), value};
}

Value number(const FigureStyle& style, FigureKind kind, std::string key, double value) {
  return number(style.text(kind, value), std::move(key), value);
}

Place entry_of(const Place& list, std::size_t number) {
  return list ? Place(fmt::format("{}/{}", *list, number)) : std::nullopt;
}

Value cell(const FigureStyle& style, const FoundFigure& figure, const Place& place) {
  const std::string text = with_minus(style.text(figure));
  if (!figure.value || figure.key.empty() || !place) return {text};
  return number(text, fmt::format("{}/{}", *place, figure.key), *figure.value);
}

FigureGrid grid_of(const FigureStyle& style, const std::vector<FoundFigure>& figures, const Place& place,
                   bool details) {
  FigureGrid grid;
  for (const FoundFigure& figure : figures) {
    if (!style.is_shown(figure, details)) continue;
    grid.figures.push_back({std::string(figure.title), cell(style, figure, place), style.unit(figure.kind),
                            std::string(figure.help)});
  }
  return grid;
}

void add_cells(const FigureStyle& style, const std::vector<FoundFigure>& figures, const Place& place,
               Row& row) {
  for (const FoundFigure& figure : figures)
    if (!figure.title.empty()) row.cells.push_back(cell(style, figure, place));
}

Mark region_mark(Region region, Palette palette) {
  return {region_colour(region, palette), region == Region::undercut, facts(region).terminal_colour};
}

void take_verdict(const Verdict& verdict, Report& report) {
  report.sentence = with_minus(verdict.sentence);
  report.tone = verdict.good() || verdict.state == VerdictState::side_actions ? Tone::good
                : verdict.state == VerdictState::not_releasable               ? Tone::bad
                                                                              : Tone::attention;
  for (const std::string& reason : verdict.reasons) report.lead.push_back(with_minus(reason));
}

Report begin_report(const ReportContext& context, std::string kind, const glm::dvec3& direction) {
  Report report;
  report.kind = std::move(kind);
  report.part = part_name(context.model->part);
  report.subject = "along " + with_minus(direction_words(direction));
  if (context.drawn()) report.title = title_block(context);
  return report;
}

Section regions_section(const ReportContext& context, const Classification& result, const Place& keys) {
  const FigureStyle style(*context.model);
  const std::string area_unit = style.unit(FigureKind::area);
  const auto area_text = [&](double area) { return style.text(FigureKind::area, area); };
  const auto value = [&](std::string text, const std::string& key, double found) {
    return number(std::move(text), keys ? *keys + key : "", found);
  };
  Section section{"Who forms what", {}};
  ShareBar bar;
  Table table{
      {{"region", true}, {"area " + area_unit}, {"±"}, {"share"}, {"meaning", true, TableColumnRoom::pages}},
      {}};
  for (const Region region : k_regions) {
    const std::string name(region_name(region)), title(facts(region).title);
    const Mark mark = region_mark(region, context.palette);
    const double part_of = share(result.areas[region], result.total_area), error = result.uncertainty.total();
    bar.shares.push_back({mark, part_of, title});
    table.rows.push_back(
        {{{title},
          value(area_text(result.areas[region]), "/areas/" + name, result.areas[region]),
          region == Region::undercut
              ? value(style.text(FigureKind::error, error), "/undercut_uncertainty", error)
              : Value{},
          value(share_text(result.areas[region], result.total_area), "/fractions/" + name, part_of),
          {std::string(facts(region).meaning)}},
         mark});
  }
  section.blocks = {std::move(bar), std::move(table)};
  const ShadowIdentity& identity = result.identity;
  const auto area = [&](std::string name, double found, const std::string& key, std::string note) {
    return Figure{std::move(name), value(area_text(found), key, found), area_unit, std::move(note)};
  };
  FigureGrid grid;
  grid.figures = {
      area("Surface", result.total_area, "/areas/total", "of the part"),
      area("Projected area", result.shadow_area, keys ? "/projected_area" : "",
           "which the clamp force acts on"),
      area("Projected undercut", result.projected_undercut, "/projected_undercut", "hidden from both sides"),
      area("Near-vertical", result.near_vertical_area, "/areas/near_vertical",
           fmt::format("draft below {}°", figure(result.settings.tau_deg))),
      {"Lateral tolerance",
       number(style, FigureKind::length, keys && keys->empty() ? "/lateral_tolerance" : "",
              result.lateral_tolerance),
       style.unit(FigureKind::length), "nothing narrower counts"},
      {"Cross-check",
       {identity.agrees() ? "passed" : "failed"},
       {},
       "the shadow from both sides differs by " +
           (identity.agrees() ? style.with_unit(FigureKind::error, identity.gap)
                              : fmt::format("{} {}, limit {}", error_text(std::abs(identity.gap)), area_unit,
                                            error_text(identity.gap_limit)))}};
  section.add(std::move(grid));
  if (const std::string why = uncertainty_reason(style, result.uncertainty); !why.empty())
    section.add(why, TextLook::quiet);
  if (result.maps) add_maps(style, *result.maps, section);
  return section;
}

Section part_section(const ReportContext& context, const std::vector<std::string>& warnings) {
  const PartModel& model = *context.model;
  const HealthReport& health = model.health;
  const FigureStyle style(model);
  const auto count = [](std::size_t many) { return static_cast<double>(many); };
  Section section{"The part", {}};
  FigureGrid grid;
  grid.figures = {
      {"Box", {style.point(health.bounds.max - health.bounds.min)}, length_unit(model.part)},
      {"Volume", number(style, FigureKind::volume, "/part/volume", health.volume),
       powered_unit(model.part, 3)},
      {"Facets",
       number(fmt::format("{}", health.facets), "/part/facets", count(health.facets)),
       {},
       health.closed ? "closed surface" : "the surface is not closed"},
      {"Bodies", number(fmt::format("{}", health.components), "/part/components", count(health.components))},
      {"Read as",
       {model.part.format},
       {},
       model.part.unit.empty() ? "the file names no unit; --unit sets it" : ""}};
  section.add(std::move(grid));
  if (!context.drawn()) return section;  // a terminal has seen them
  for (const std::string& warning : warnings) section.add(warning, TextLook::notice);
  return section;
}

Section draft_section(const ReportContext& context, const DraftShown& draft) {
  const PartModel& model = *context.model;
  const DraftCheck& check = draft.check;
  const std::string area_unit = powered_unit(model.part, 2);
  const FigureStyle style(model);
  DraftBars bars;
  bars.core = region_mark(Region::core, context.palette);
  bars.cavity = region_mark(Region::cavity, context.palette);
  bars.unit = area_unit;
  if (draft.asked && check.required_deg > 0.0) bars.required_deg = check.required_deg;
  double beyond = 0.0;
  for (const DraftBin& bin : check.histogram) {
    const bool shown = bin.from_deg >= k_least_draft_deg && bin.to_deg <= k_most_draft_deg;
    if (shown) bars.bars.push_back({bin.from_deg, bin.to_deg, bin.area[0], bin.area[1]});
    if (!shown && bin.from_deg > 0.0) beyond += bin.area[0] + bin.area[1];
  }
  Section section{"Draft", {}};
  if (context.drawn())
    section.add(
        fmt::format("Area by draft angle, seen from the half that forms it. {} {} more have over {}°.",
                    style.text(FigureKind::area, beyond), area_unit, figure(k_most_draft_deg)),
        TextLook::quiet);
  section.add(std::move(bars));
  if (!draft.asked) return section;
  FigureGrid grid;
  for (const std::size_t half : {0U, 1U}) {
    grid.figures.push_back(
        {fmt::format("{} {}", half == 0 ? "Core" : "Cavity",
                     check.finishes.empty() ? fmt::format("below {}°", figure(check.required_deg))
                                            : std::string("with too little draft")),
         number(style, FigureKind::area, fmt::format("/draft/below/{}/area", half == 0 ? "core" : "cavity"),
                check.below[half]),
         area_unit, plural(check.faces_below[half], "face")});
  }
  if (check.reverse.facet)
    grid.figures.push_back({"Reverse draft",
                            number(style, FigureKind::area, "/draft/reverse/area", check.reverse.area),
                            area_unit, fmt::format("at worst {:.3g}°", check.reverse.worst_deg)});
  if (check.reverse.facet && check.reverse_undercut > 0.0)
    grid.figures.push_back(
        {"Undercut of these walls",
         number(style, FigureKind::area, "/draft/reverse/undercut_area", check.reverse_undercut), area_unit,
         "leans back, and neither half reaches it"});
  section.add(std::move(grid));
  if (!check.finishes.empty()) section.add(finishes_table(style, check));
  Table walls = walls_table(context, check);
  if (!walls.rows.empty()) section.add(std::move(walls));
  return section;
}

Section repeat_section(const ReportContext& context, const Json& settings) {
  Section section{"To repeat it", {}, true};
  section.add(context.command, TextLook::command);
  Facts facts;
  facts.facts.emplace_back("moldlight", context.version);
  for (const auto& [key, value] : settings.items())
    facts.facts.emplace_back(spoken(key), json_value_text(value));
  section.add(std::move(facts));
  return section;
}

std::string view_caption() {
  return "Drag to turn, click and use the wheel to zoom, shift and drag to move; arrow keys, + and − do it, "
         "too.";
}

ModelView begin_view(const ReportContext& context, const glm::dvec3& direction, const glm::dvec3& to_viewer) {
  ModelView view;
  view.centre = context.model->frame.center;
  view.diagonal = context.model->frame.diagonal;
  view.direction = direction;
  view.to_viewer = to_viewer;
  return view;
}

ModelView region_view(const ReportContext& context, const Classification& result, const glm::dvec3& to_viewer,
                      std::span<const StillCallout> callouts) {
  const PartModel& model = *context.model;
  const FigureStyle style(model);
  ModelView view = begin_view(context, result.direction, to_viewer);
  view.opens = "Take core and cavity surface apart";
  for (const Region region : k_regions) {
    ViewGroup group;
    group.name = facts(region).title;
    group.aside = fmt::format("{}  ·  {}", share_text(result.areas[region], result.total_area),
                              style.with_unit(FigureKind::area, result.areas[region]));
    group.colour = region_colour(region, context.palette);
    group.hatched = group.stays_opaque = region == Region::undercut;
    const double way = region == Region::core ? 1.0 : region == Region::cavity ? -1.0 : 0.0;
    group.shift = way * k_mold_travel * view.diagonal * result.direction;
    view.groups.push_back(std::move(group));
  }
  for (const StillCallout& callout : callouts)
    view.callouts.push_back({callout.text, callout.places.front(), callout.normal});
  ViewSurface surface{piece_mesh(*result.split), {}};
  for (const SplitPiece& piece : result.split->pieces)
    surface.group_of_facet.push_back(static_cast<std::uint16_t>(piece.region));
  view.surfaces.push_back(std::move(surface));
  return view;
}

}  // namespace moldlight::report
