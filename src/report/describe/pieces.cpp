// The report of a mold of several pieces.
#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "mold/direction.hpp"
#include "pieces/pieces_report.hpp"
#include "render/view_settings.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr std::size_t k_most_left_rows = 10;
/// Of the surface: what is smaller nobody would see; it is what the tolerance leaves along edges.
constexpr double k_seen_share = 1e-4;

Section directions_section(const ReportContext& context, const PiecesResult& result) {
  const FigureStyle style(*context.model);
  Section section{"Directions, in the order of removal", {}};
  Table table{{{"piece"},
               {"direction", true},
               {style.heading("area", FigureKind::area)},
               {"share"},
               {"patches"},
               {"why", true}},
              {}};
  for (std::size_t k = 0; k < result.count(); ++k) {
    const PieceDirection& one = result.directions[k];
    const std::string key = fmt::format("/directions/{}/", k), words = pull_words(one.direction);
    Row row{{{fmt::format("{}", k + 1)},
             {with_minus(words)},
             number(style, FigureKind::area, key + "area", one.area),
             {share_text(one.area, context.model->geometry.total_area)},
             number(style, FigureKind::count, key + "components", static_cast<double>(one.components)),
             {one.name == words ? "" : one.name}}};
    row.mark = Mark{.colour = piece_colour(k, context.palette)};
    table.rows.push_back(std::move(row));
  }
  section.add(std::move(table));
  return section;
}

Section left_section(const ReportContext& context, const PiecesResult& result) {
  const FigureStyle style(*context.model);
  Section section{"Surface that no piece releases", {}};
  FigureGrid grid;
  grid.figures.push_back(
      {"Area", number(style, FigureKind::area, "/left/area", result.left_area), style.unit(FigureKind::area),
       share_text(result.left_area, context.model->geometry.total_area) + " of the surface"});
  section.add(std::move(grid));
  const double least = k_seen_share * context.model->geometry.total_area;
  Table table{{{"place"},
               {style.heading("area", FigureKind::area)},
               {style.heading("centre", FigureKind::length), true},
               {style.heading("across", FigureKind::length)}},
              {}};
  for (std::size_t k = 0; k < std::min(result.places.size(), k_most_left_rows); ++k) {
    const LeftPlace& place = result.places[k];
    if (place.area < least) break;
    table.rows.push_back(
        {{{fmt::format("{}", k + 1)},
          number(style, FigureKind::area, fmt::format("/left/places/{}/area", k), place.area),
          {with_minus(style.point(place.centre))},
          {style.text(FigureKind::length, place.bounds.diagonal())}}});
  }
  if (!table.rows.empty()) section.add(std::move(table));
  return section;
}

Section stretch_section(const ReportContext& context, const PiecesResult& result) {
  const FigureStyle style(*context.model);
  Section section{"Undercuts of the flexible pieces", {}};
  Table table{{{"undercut"},
               {"piece"},
               {style.heading("area", FigureKind::area)},
               {style.heading("centre", FigureKind::length), true},
               {style.heading("depth", FigureKind::length)},
               {style.heading("neck", FigureKind::length)},
               {style.heading("widest", FigureKind::length)},
               {"strain"},
               {"of the elongation"}},
              {}};
  for (std::size_t k = 0; k < std::min(result.stretches.size(), k_most_left_rows); ++k) {
    const auto& [place, direction, depth, neck] = result.stretches[k];
    const std::string key = fmt::format("/flexible/undercuts/{}/", k);
    const auto length = [&](const std::string& where, double value) {
      return number(style, FigureKind::length, key + where, value);
    };
    table.rows.push_back({{{fmt::format("{}", k + 1)},
                           {fmt::format("{}", direction + 1)},
                           number(style, FigureKind::area, key + "area", result.places[k].area),
                           {with_minus(style.point(result.places[k].centre))},
                           depth ? length("depth", *depth) : Value{},
                           neck ? length("neck/perimeter", neck->perimeter) : Value{},
                           neck ? length("neck/widest", neck->widest) : Value{},
                           {neck ? share_text(neck->strain(), 1.0) : ""},
                           {neck ? share_text(100.0 * neck->strain(), result.settings.elongation_pct) : ""}},
                          Mark{.colour = piece_colour(direction, context.palette)}});
  }
  if (!table.rows.empty()) section.add(std::move(table));
  for (std::size_t k = 0; result.cuts && k < result.cuts->size(); ++k)
    if ((*result.cuts)[k] > 0)
      section.add(fmt::format("Piece {} holds {} through a tunnel of the part, to be cut.", k + 1,
                              plural((*result.cuts)[k], "loop")),
                  TextLook::notice);
  if (!result.cuts)
    section.add("Loops through tunnels were not counted: the part is open or has too many.",
                TextLook::notice);
  return section;
}

Section seams_section(const ReportContext& context, const PiecesResult& result) {
  const FigureStyle style(*context.model);
  struct Sum {
    std::size_t count = 0;
    double length = 0.0, on_creases = 0.0;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Sum> sums;
  for (const PieceSeam& seam : result.formed.seams) {
    Sum& sum = sums[{seam.a, seam.b}];
    ++sum.count;
    sum.length += seam.length;
    sum.on_creases += seam.length * seam.crease_share;
  }
  Section section{"Seams between the pieces", {}};
  Table table{{{"pieces", true}, {"lines"}, {style.heading("length", FigureKind::length)}, {"on edges"}}, {}};
  for (const auto& [pieces, sum] : sums) {
    table.rows.push_back({{{fmt::format("{} and {}", pieces.first + 1, pieces.second + 1)},
                           {fmt::format("{}", sum.count)},
                           {style.text(FigureKind::length, sum.length)},
                           {share_text(sum.on_creases, sum.length)}}});
  }
  section.add(std::move(table));
  return section;
}

Section solids_section(const ReportContext& context, const PiecesResult& result, const PieceSolids& solids) {
  const PartModel& model = *context.model;
  const FigureStyle style(model);
  Section section{"Pieces as solids", {}};
  if (!solids.refusal.empty()) {
    section.add(sentence_of(solids_refusal(model, solids)), TextLook::notice);
    return section;
  }
  const MoldHalves& halves = solids.halves;
  Table table{{{"body", true},
               {"moves along", true},
               {style.heading("travel", FigureKind::length)},
               {style.heading("volume", FigureKind::volume)}},
              {}};
  std::vector<std::size_t> order;
  double left = 0.0;
  for (std::size_t k = 0; k < solids.solids.size(); ++k) {
    if (solids.solids[k].direction)
      order.push_back(k);
    else
      left += halves.written.bodies[k].volume;
  }
  const std::size_t number_left = solids.solids.size() - order.size();
  std::ranges::stable_sort(order, {}, [&](std::size_t k) {
    const std::string& name = halves.written.bodies[k].name;
    return std::tuple(solids.solids[k].sequence, *solids.solids[k].direction, name.size(), name);
  });
  for (const std::size_t k : order) {
    const auto& [direction, travel, sequence] = solids.solids[k];
    const std::string key = fmt::format("/solids/bodies/{}/", k);
    table.rows.push_back(
        {{{halves.written.bodies[k].name},
          {with_minus(pull_words(solids.directions[*direction]))},
          number(style, FigureKind::length, key + "travel", travel),
          number(style, FigureKind::volume, key + "volume", halves.written.bodies[k].volume)},
         Mark{.colour = piece_colour(*direction, context.palette)}});
  }
  section.add(std::move(table));
  if (solids.directions.size() > result.count())
    section.add(fmt::format("No two of the directions are opposite, so a piece more opens along {}.",
                            with_minus(pull_words(solids.directions.back()))),
                TextLook::notice);
  if (number_left > 0)
    section.add(fmt::format("No piece can form {} beside the part, {} in all ({}). Fill {} in the part.",
                            plural(number_left, "space"), style.with_unit(FigureKind::volume, left),
                            number_left == 1 ? "left_1" : fmt::format("left_1 to left_{}", number_left),
                            number_left == 1 ? "it" : "them"),
                TextLook::notice);
  section.add(
      "The bodies are removed from top to bottom. Each moves clear of the part and of what is still there.",
      TextLook::quiet);
  for (const WrittenBody& body : halves.written.bodies)
    if (!body.file.empty())
      section.add(context.drawn() ? std::filesystem::path(body.file).filename().string() : body.file,
                  TextLook::quiet);
  return section;
}

/// The part in the colours of its pieces, and these around it.
ModelView pieces_view(const ReportContext& context, const PiecesResult& result, const Classification& formed,
                      std::span<const StillBody> bodies) {
  ModelView view = begin_view(
      context, formed.direction,
      revealing_orientation(*context.model, {&formed.split, 1}, formed.direction) * glm::dvec3(0, 0, 1));
  view.opens = bodies.empty() ? "Pull the surface apart" : "Open the mold";
  view.opened = bodies.empty() ? 0.0 : 1.0;
  for (std::size_t k = 0; k < result.count(); ++k) {
    view.groups.push_back({.name = fmt::format("Part: piece {}", k + 1),
                           .aside = share_text(result.directions[k].area, context.model->geometry.total_area),
                           .colour = piece_colour(k, context.palette),
                           .stays_opaque = true});
    if (bodies.empty())
      view.groups.back().shift = k_mold_travel * view.diagonal * result.directions[k].direction;
  }
  view.groups.push_back({.name = result.left_area > 0.0 ? "Part: left over" : "",
                         .colour = region_colour(Region::undercut, context.palette),
                         .hatched = true,
                         .stays_opaque = true});
  ViewSurface part{piece_mesh(*formed.split), std::vector<std::uint16_t>(formed.split->pieces.size(), 0)};
  std::ranges::transform(result.formed.formed_by, part.group_of_facet.begin(),
                         [](std::uint32_t by) { return static_cast<std::uint16_t>(by); });
  view.surfaces.push_back(std::move(part));
  for (const StillBody& body : bodies) {
    view.surfaces.push_back(
        {body.mesh, std::vector<std::uint16_t>(body.mesh.facets.size(),
                                               static_cast<std::uint16_t>(view.groups.size()))});
    view.groups.push_back({.name = body.label, .colour = body.colour, .shift = glm::dvec3(body.motion[3])});
  }
  return view;
}

}  // namespace

Report pieces_report(const ReportContext& context, Study& study) {
  const PiecesResult& result = study.find<PiecesResult>(context.progress);
  const auto solids = study.known<PieceSolids>();
  const PartModel& model = *context.model;
  const FigureStyle style(model);
  Report report =
      begin_report(context, "Mold of several pieces",
                   result.directions.empty() ? glm::dvec3(0, 0, 1) : result.directions.front().direction);
  report.subject = "along " + plural(result.count(), "direction");
  report.sentence = with_minus(pieces_sentence(model, result));
  report.tone = pieces_state(result) == "stretched" ? Tone::attention
                : !result.releases_all              ? Tone::bad
                : result.count() == 2               ? Tone::good
                                                    : Tone::attention;
  const auto patches =
      static_cast<std::size_t>(std::ranges::count_if(result.formed.patches, [&](const FormedPatch& patch) {
        return patch.area > k_seen_share * model.geometry.total_area;
      }));
  const std::size_t specks = result.formed.patches.size() - patches;
  if (patches > result.count())
    report.lead.push_back(fmt::format(
        "The directions form {} patches of surface that do not touch{}, so more bodies may be needed.",
        patches, specks == 0 ? "" : fmt::format(", beside {}", plural(specks, "speck"))));
  if (result.enclosed_air && *result.enclosed_air > 2.0 * result.enclosed_error)
    report.lead.push_back(
        fmt::format("{} {} of space beside the part is hidden along all of them, so no piece can fill it.",
                    style.text(FigureKind::volume, *result.enclosed_air), style.unit(FigureKind::volume)));
  if (context.drawn()) {
    const Classification formed = formed_part(model, result);
    std::vector<StillBody> bodies;
    if (solids) bodies = pulled_pieces(model, *solids, context.palette);
    report.still = {Illustrator(context, formed).whole({}, bodies),
                    {},
                    "The part in the colours of its pieces",
                    view_caption()};
    report.view = pieces_view(context, result, formed, bodies);
  }
  if (result.count() > 0) report.sections.push_back(directions_section(context, result));
  if (solids) report.sections.push_back(solids_section(context, result, *solids));
  if (pieces_state(result) == "stretched")
    report.sections.push_back(stretch_section(context, result));
  else if (result.left_area > k_seen_share * model.geometry.total_area)
    report.sections.push_back(left_section(context, result));
  if (!result.formed.seams.empty()) report.sections.push_back(seams_section(context, result));
  report.sections.push_back(part_section(context, model.warnings));
  report.sections.push_back(repeat_section(context, pieces_json(study, context.progress)["settings"]));
  return report;
}

}  // namespace moldlight::report
