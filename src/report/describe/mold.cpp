// The report of a mold: its parting line and its halves.
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/still_picture.hpp"
#include "parting/mold_figures.hpp"
#include "parting/mold_picture.hpp"
#include "render/view_settings.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr glm::ivec2 k_mold_px(1280, 800);
constexpr std::size_t k_most_loops = 40, k_most_pictured_loops = 12;

Section sides_section(const ReportContext& context, const MoldReport& found) {
  const Assignment& assignment = found.assignment;
  const FigureStyle style(found.model);
  Section section{"Who forms what", {}};
  ShareBar bar;
  Table table{{{"formed by", true}, {style.heading("area", FigureKind::area)}, {"share"}}, {}};
  for (const MoldSide side : k_mold_sides) {
    const Mark mark = region_mark(region_of(side), context.palette);
    const std::string name(side_name(side));
    const double area = assignment.area(side);
    bar.shares.push_back({mark, share(area, assignment.total_area), name});
    table.rows.push_back({{{name},
                           number(style, FigureKind::area, "/assignment/" + name, area),
                           {share_text(area, assignment.total_area)}},
                          mark});
  }
  section.blocks = {std::move(bar), std::move(table),
                    grid_of(style, found_figures(assignment_figures(), assignment), "/assignment")};
  return section;
}

/// The part as its halves and side actions form it.
Classification formed_part(const Assignment& assignment) {
  Classification shown;
  shown.direction = assignment.direction;
  shown.total_area = assignment.total_area;
  auto split = std::make_shared<SplitMesh>(assignment.mesh);
  for (std::size_t k = 0; k < split->pieces.size(); ++k)
    split->pieces[k].region = region_of(assignment.sides[k]);
  shown.split = std::move(split);
  return shown;
}

Section line_section(const ReportContext& context, const MoldReport& found) {
  const PartingLine& line = found.line;
  const FigureStyle style(found.model);
  const Classification formed = formed_part(found.assignment);
  Illustrator pictures(context, formed);
  Section section{"Parting line", {}};
  section.add(parting_verdict(found.assignment, line, found.model));
  Table table{{{"#"}, {"loop", true}}, {}};
  std::vector<std::size_t> listed;
  add_columns(style, loop_figures(), table);
  std::size_t tiny = 0;
  for (std::size_t k = 0; k < line.loops.size(); ++k) {
    tiny += line.loops[k].tiny;
    if (line.loops[k].tiny || table.rows.size() == k_most_loops) continue;
    Row row{{{fmt::format("{}", k + 1)}, {std::string(loop_name(line.loops[k].kind))}}};
    add_cells(style, found_figures(loop_figures(), line.loops[k]), fmt::format("/loops/{}", k), row);
    if (listed.size() < k_most_pictured_loops) {
      row.picture = pictures.loop(line, k);
      row.picture_text = fmt::format("Loop {}", k + 1);
    }
    listed.push_back(k);
    table.rows.push_back(std::move(row));
  }
  if (line.loops.size() - tiny > k_most_loops) table.rest = fmt::format("… {} in all.", line.loops.size());
  table.tiny = tiny_text(tiny);
  if (context.drawn() && !listed.empty()) {
    Pictures overview;
    overview.pictures.push_back({pictures.line(line, loop_callouts(line, listed)),
                                 {},
                                 "The part with the loops of its parting line",
                                 "Numbers are those of the table."});
    section.add(std::move(overview));
  }
  if (!line.loops.empty()) section.add(std::move(table));
  return section;
}

/// Topology of the line and what rounding leaves: for who checks the rest.
Section details_section(const MoldReport& found) {
  Section section{"Details", {}};
  const EulerCheck& euler = found.line.euler;
  FigureGrid checks;
  checks.figures = {
      {"Euler characteristics",
       {euler.sums() ? "add up" : "do not add up"},
       {},
       with_minus(fmt::format(
           "core {} + cavity {} + actions {} = part {}{}", euler.core, euler.cavity, euler.action, euler.part,
           euler.touching == 0 ? "" : fmt::format(" + {} where lines touch", euler.touching)))},
      {"Loops of core and cavity",
       number(fmt::format("{}", euler.loops), "/euler/loops", static_cast<double>(euler.loops)),
       {},
       fmt::format("genus {} asks for {}{}", euler.genus, euler.expected_loops, difference_text(euler))}};
  if (found.halves.made()) {
    FigureGrid of_halves =
        grid_of(FigureStyle(found.model), found_figures(halves_figures(), found.halves), "", true);
    std::ranges::move(of_halves.figures, std::back_inserter(checks.figures));
  }
  section.add(std::move(checks));
  if (const std::string needles = needles_text(found.model, found.halves); !needles.empty())
    section.add(needles);
  return section;
}

Section halves_section(const MoldReport& found, bool drawn) {
  const MoldHalves& halves = found.halves;
  Section section{"Halves", {}};
  const auto notice = [&](const std::string& text) {
    if (!text.empty()) section.add(text, TextLook::notice);
  };
  if (!found.written.refusal.empty()) {
    notice(refusal_text(found.model, halves, found.written,
                        halves.refused_at ? loop_near(found.line, *halves.refused_at) : std::string()));
    return section;
  }
  if (found.pieces == nullptr) {
    const std::string unfilled = unfilled_text(found.model, found.settings, halves);
    notice(sentence_of(unfilled));
    if (!unfilled.empty() && found.plan == nullptr)
      notice("With --actions, slides and lifters form them, and the parting surface need not reach there.");
  }
  section.add(grid_of(FigureStyle(found.model), found_figures(halves_figures(), halves), ""));
  for (const std::string& remark : halves_remarks(found)) notice(remark);
  // What is sent names no folder.
  for (const WrittenBody& body : found.written.bodies)
    if (!body.file.empty())
      section.add(drawn ? std::filesystem::path(body.file).filename().string() : body.file, TextLook::quiet);
  return section;
}

/// Which side actions form what the halves leave; of a report that was asked for them.
Section insert_actions_section(const MoldReport& found) {
  Section section{"Side actions", {}};
  section.add(actions_table(found.model, *found.plan, {}));
  section.add(bodies_table(found.model, *found.plan, {}));
  return section;
}

/// Steel in the part's coordinates.
ViewSurface steel_surface(const MoldHalves& halves, const MoldBody& body, std::size_t group) {
  return {in_part(halves, body.mesh),
          std::vector<std::uint16_t>(body.mesh.facets.size(), static_cast<std::uint16_t>(group))};
}

void add_steel(const MoldHalves& halves, const glm::dvec3& direction, Palette palette, ModelView& view) {
  const auto add = [&](const MoldBody& body, std::string name, Steel steel, double way) {
    view.surfaces.push_back(steel_surface(halves, body, view.groups.size()));
    view.groups.push_back({.name = std::move(name),
                           .colour = steel_colour(steel, palette),
                           .shift = way * k_mold_travel * view.diagonal * direction});
  };
  add(halves.core, "Core half", Steel::core, 1.0);
  add(halves.cavity, "Cavity half", Steel::cavity, -1.0);
  for (std::size_t k = 0; k < halves.inserts.size(); ++k)
    add(halves.inserts[k], k == 0 ? "Inserts" : "", Steel::insert, 0.0);
}

ModelView mold_view(const ReportContext& context, const MoldReport& found) {
  const Assignment& assignment = found.assignment;
  const auto split = std::make_shared<const SplitMesh>(assignment.mesh);
  ModelView view = begin_view(
      context, assignment.direction,
      revealing_orientation(*context.model, {&split, 1}, assignment.direction) * glm::dvec3(0, 0, 1));
  view.opens = "Open the mold";
  view.opened = 1.0;
  for (const MoldSide side : k_mold_sides) {
    const bool any = assignment.area(side) > 0.0;
    view.groups.push_back({.name = any ? fmt::format("Part: {}", side_name(side)) : std::string(),
                           .aside = share_text(assignment.area(side), assignment.total_area),
                           .colour = region_colour(region_of(side), context.palette),
                           .hatched = side == MoldSide::action,
                           .stays_opaque = true});
  }
  ViewSurface part{piece_mesh(assignment.mesh), {}};
  for (const MoldSide side : assignment.sides)
    part.group_of_facet.push_back(static_cast<std::uint16_t>(side));
  view.surfaces.push_back(std::move(part));
  const auto line_group = static_cast<std::uint16_t>(view.groups.size());
  view.groups.push_back({.name = "Parting line", .colour = k_tube, .stays_opaque = true});
  for (const PartingLoop& loop : found.line.loops)
    if (loop.kind != LoopKind::action) view.lines.push_back({loop.points, true, line_group});
  if (found.halves.made()) add_steel(found.halves, assignment.direction, context.palette, view);
  return view;
}

}  // namespace

Report mold_report(const ReportContext& context, Study& study) {
  const MoldReport found = moldlight::mold_report(study, context.progress);
  Report report = begin_report(context, "Mold", found.assignment.direction);
  take_verdict(mold_verdict(study, context.progress), report);
  if (!found.written.refusal.empty()) report.tone = Tone::bad;
  if (context.drawn()) {
    auto& title = std::get<Facts>(report.title->blocks.front()).facts;
    if (found.settings.shrink_pct > 0.0)
      title.emplace_back("Shrinkage", figure(found.settings.shrink_pct) + " %");
    if (found.halves.made()) title.emplace_back("Mold block", block_text(found.model, found.halves));
    StillSettings still;
    still.size = k_mold_px;
    still.backdrop = Backdrop::none;
    still.look.palette = context.palette;
    const MoldScene scene{found.model, found.assignment, found.line, found.halves};
    report.still = {mold_picture(*context.gl, scene, still, context.progress),
                    {},
                    "The part with its parting line between the opened halves",
                    view_caption()};
    report.view = mold_view(context, found);
  }
  report.sections.push_back(sides_section(context, found));
  report.sections.push_back(line_section(context, found));
  report.sections.push_back(halves_section(found, context.drawn()));
  if (found.plan != nullptr && !found.plan->actions.empty())
    report.sections.push_back(insert_actions_section(found));
  report.sections.push_back(part_section(context, mold_warnings(study, context.progress)));
  report.sections.push_back(details_section(found));
  report.sections.push_back(repeat_section(context, mold_settings_json(found)));
  return report;
}

}  // namespace moldlight::report
