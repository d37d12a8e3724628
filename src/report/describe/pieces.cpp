// The report of a mold of several pieces.
#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "mold/direction.hpp"
#include "pieces/pieces_report.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr std::size_t k_most_left_rows = 10;

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
  // Places that nobody would see are what the tolerance leaves along edges.
  const double least = 1e-4 * context.model->geometry.total_area;
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

}  // namespace

Report pieces_report(const ReportContext& context, const PiecesResult& result) {
  const PartModel& model = *context.model;
  const FigureStyle style(model);
  Report report =
      begin_report(context, "Mold of several pieces",
                   result.directions.empty() ? glm::dvec3(0, 0, 1) : result.directions.front().direction);
  report.subject = "along " + plural(result.count(), "direction");
  report.sentence = with_minus(pieces_sentence(model, result));
  report.tone = !result.releases_all ? Tone::bad : result.count() == 2 ? Tone::good : Tone::attention;
  std::size_t patches = 0;
  for (const PieceDirection& one : result.directions) patches += one.components;
  if (patches > result.count())
    report.lead.push_back(fmt::format(
        "The directions form {} patches of surface that do not touch, so more bodies may be needed.",
        patches));
  if (result.enclosed_air && *result.enclosed_air > 2.0 * result.enclosed_error)
    report.lead.push_back(
        fmt::format("{} {} of space beside the part is hidden along all of them, so no piece can fill it.",
                    style.text(FigureKind::volume, *result.enclosed_air), style.unit(FigureKind::volume)));
  if (result.count() > 0) report.sections.push_back(directions_section(context, result));
  if (result.left_area > 1e-4 * model.geometry.total_area)
    report.sections.push_back(left_section(context, result));
  if (!result.formed.seams.empty()) report.sections.push_back(seams_section(context, result));
  report.sections.push_back(part_section(context, model.warnings));
  report.sections.push_back(repeat_section(context, pieces_json(model, result)["settings"]));
  return report;
}

}  // namespace moldlight::report
