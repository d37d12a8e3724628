// The report of a mold: its parting line and its halves.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "classify/view_choice.hpp"
#include "parting/mold_picture.hpp"
#include "render/view_colours.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr glm::ivec2 k_mold_px(1280, 800);
constexpr std::size_t k_most_loops = 40;

Region region_of(MoldSide side) {
  return side == MoldSide::core ? Region::core : side == MoldSide::cavity ? Region::cavity : Region::undercut;
}

Section sides_section(const ReportContext& context, const MoldReport& found) {
  const Assignment& assignment = found.assignment;
  const std::string area_unit = powered_unit(found.model.part, 2);
  const FigureColumn areas(assignment.total_area);
  Section section{"Who forms what", {}};
  ShareBar bar;
  Table table{{{"formed by", true}, {"area " + area_unit}, {"share"}}, {}};
  for (const MoldSide side : k_mold_sides) {
    const Mark mark = region_mark(region_of(side), context.palette);
    const std::string name(side_name(side));
    const double area = assignment.area(side);
    bar.shares.push_back({mark, share(area, assignment.total_area), name});
    table.rows.push_back({{{name},
                           number(areas.text(area), "/assignment/" + name, area),
                           {share_text(area, assignment.total_area)}},
                          mark});
  }
  section.blocks = {std::move(bar), std::move(table)};
  FigureGrid grid;
  grid.figures = {
      {"Either could form",
       number(areas.text(assignment.free_area), "/assignment/free", assignment.free_area), area_unit},
      {"Leans against its half",
       number(areas.text(assignment.reverse_draft_area), "/assignment/reverse_draft",
              assignment.reverse_draft_area),
       area_unit,
       {},
       "by less than the soft draft"}};
  section.blocks.emplace_back(std::move(grid));
  return section;
}

Section line_section(const MoldReport& found) {
  const PartingLine& line = found.line;
  const std::string unit = length_unit(found.model.part);
  const FigureColumn lengths(10.0 * found.model.frame.diagonal);
  Section section{"Parting line", {}};
  std::string sentence = parting_verdict(found.assignment, line, found.model.frame.diagonal);
  sentence.front() = static_cast<char>(sentence.front() == 'p' ? 'P' : sentence.front());
  section.blocks.emplace_back(Text{sentence + ".", TextLook::normal});
  Table table{{{"#"},
               {"loop", true},
               {"length " + unit},
               {"climb " + unit},
               {"flat to " + unit},
               {"steep " + unit},
               {"sharpest"},
               {"on crease"},
               {"breaks"}},
              {}};
  for (std::size_t k = 0; k < std::min(line.loops.size(), k_most_loops); ++k) {
    const PartingLoop& loop = line.loops[k];
    const std::string key = fmt::format("/loops/{}/", k);
    table.rows.push_back(
        {{{fmt::format("{}", k + 1)},
          {std::string(loop_name(loop.kind))},
          number(lengths.text(loop.length), key + "length", loop.length),
          number(lengths.text(loop.climb()), key + "climb", loop.climb()),
          number(lengths.text(loop.flatness), key + "flatness", loop.flatness),
          number(lengths.text(loop.steep_length), key + "steep_length", loop.steep_length),
          number(fmt::format("{:.1f}°", loop.sharpest_deg), key + "sharpest_deg", loop.sharpest_deg),
          number(fmt::format("{:.1f} %", 100.0 * loop.on_crease), key + "on_crease", loop.on_crease),
          {fmt::format("{}", loop.breaks)}}});
  }
  if (line.loops.size() > k_most_loops) table.rest = fmt::format("… {} in all.", line.loops.size());
  if (!table.rows.empty()) section.blocks.emplace_back(std::move(table));
  const EulerCheck& euler = line.euler;
  FigureGrid checks;
  checks.figures = {{"Euler characteristics",
                     {euler.sums() ? "add up" : "do not add up"},
                     {},
                     {},
                     with_minus(fmt::format("core {} + cavity {} + actions {} = part {}", euler.core,
                                            euler.cavity, euler.action, euler.part))},
                    {"Loops",
                     number(fmt::format("{}", euler.loops), "/euler/loops", static_cast<double>(euler.loops)),
                     {},
                     {},
                     fmt::format("genus {} asks for {}; the difference is {}accounted for", euler.genus,
                                 euler.expected_loops, euler.accounted() ? "" : "not ")}};
  section.blocks.emplace_back(std::move(checks));
  return section;
}

Section halves_section(const MoldReport& found) {
  const MoldHalves& halves = found.halves;
  const Part& part = found.model.part;
  Section section{"Halves", {}};
  if (!found.written.refusal.empty()) {
    section.blocks.emplace_back(
        Text{refusal_text(found.model, halves, found.written,
                          halves.refused_at ? loop_near(found.line, *halves.refused_at) : std::string()),
             TextLook::notice});
    return section;
  }
  if (const std::string unfilled = unfilled_text(found.model, found.settings, halves); !unfilled.empty())
    section.blocks.emplace_back(Text{unfilled, TextLook::notice});
  const std::string area_unit = powered_unit(part, 2), volume_unit = powered_unit(part, 3);
  FigureGrid grid;
  grid.figures = {
      {"Core half", {figure(halves.core.volume)}, volume_unit, {}, "closed"},
      {"Cavity half", {figure(halves.cavity.volume)}, volume_unit, {}, "closed"},
      {"Part", number(figure(halves.part_volume), "/halves/part_volume", halves.part_volume), volume_unit},
      {"Volumes differ",
       number(error_text(std::abs(halves.volume_gap)), "/volume_gap", halves.volume_gap),
       {},
       {},
       "of the block, less halves, part and inserts"},
      {"Parting surface",
       number(figure(halves.surface.parting_area), "/surfaces/parting", halves.surface.parting_area),
       area_unit},
      {"Shut-offs",
       number(figure(halves.surface.shut_off_area), "/surfaces/shut_offs", halves.surface.shut_off_area),
       area_unit},
      {"Steepest",
       number(fmt::format("{:.1f}", halves.surface.steepest_deg), "/surfaces/steepest_deg",
              halves.surface.steepest_deg),
       "°"},
      {"Steel on steel without draft",
       number(figure(halves.contact_area), "/surfaces/contact", halves.contact_area),
       area_unit,
       {},
       counted(halves.contacts.size(), "place")}};
  if (!halves.inserts.empty())
    grid.figures.push_back(
        {"Left to inserts",
         number(figure(halves.insert_volume), "/halves/insert_volume", halves.insert_volume),
         volume_unit,
         {},
         counted(halves.inserts.size(), "insert")});
  section.blocks.emplace_back(std::move(grid));
  return section;
}

/// Steel in the part's coordinates.
ViewSurface steel_surface(const MoldHalves& halves, const MoldBody& body, std::size_t group) {
  ViewSurface surface{body.mesh,
                      std::vector<std::uint16_t>(body.mesh.facets.size(), static_cast<std::uint16_t>(group))};
  for (glm::dvec3& vertex : surface.mesh.vertices)
    vertex = halves.centre + halves.frame.to_part(vertex / halves.scale);
  return surface;
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
  const UnitFrame& frame = context.model->frame;
  const auto split = std::make_shared<const SplitMesh>(assignment.mesh);
  ModelView view;
  view.centre = frame.center;
  view.diagonal = frame.diagonal;
  view.direction = assignment.direction;
  view.to_viewer =
      revealing_orientation(*context.model, {&split, 1}, assignment.direction) * glm::dvec3(0, 0, 1);
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
  for (const PartingLoop& loop : found.line.loops) {
    if (loop.kind != LoopKind::action) view.lines.push_back({loop.points, true, line_group});
  }
  if (found.halves.made()) add_steel(found.halves, assignment.direction, context.palette, view);
  return view;
}

}  // namespace

Report mold_report(const ReportContext& context, Study& study) {
  const MoldReport found = moldlight::mold_report(study, context.progress);
  Report report = begin_report(context, "Mold", found.assignment.direction);
  take_verdict(mold_verdict(study, context.progress), report);
  if (!found.written.refusal.empty()) report.tone = Tone::bad;
  StillSettings still;
  still.size = k_mold_px;
  still.backdrop = Backdrop::none;
  still.look.palette = context.palette;
  const MoldScene scene{found.model, found.assignment, found.line, found.halves};
  report.still = {mold_picture(context.gl, scene, still, context.progress),
                  {},
                  "The part with its parting line between the opened halves",
                  view_caption()};
  report.view = mold_view(context, found);
  report.sections.push_back(sides_section(context, found));
  report.sections.push_back(line_section(found));
  report.sections.push_back(halves_section(found));
  report.sections.push_back(part_section(context, mold_warnings(study, context.progress)));
  report.sections.push_back(repeat_section(context, mold_json(found)["settings"]));
  return report;
}

}  // namespace moldlight::report
