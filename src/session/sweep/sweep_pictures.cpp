#include "session/sweep/sweep_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/png.hpp"
#include "picture/contact_sheet.hpp"
#include "picture/direction_sphere.hpp"
#include "session/figures.hpp"
#include "session/sweep/sweep_texts.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_most_tiles = 12;
/// More labels would hide the map.
constexpr std::size_t k_most_labels = 30;
constexpr glm::dvec2 k_full_scale_px(1600.0, 1000.0);

// The map's field: as fine as a picture shows it, but the work of it is bounded.
constexpr double k_most_field_work = 3e8;  // cells times directions
constexpr double k_least_cells = 96.0, k_most_cells = 320.0;

UndercutField undercut_field(const SweepResult& result) {
  const double directions = std::max<double>(1.0, static_cast<double>(result.evaluated.size()));
  const int cells =
      static_cast<int>(std::clamp(std::sqrt(k_most_field_work / directions), k_least_cells, k_most_cells));
  UndercutField field{.areas = DirectionField(even_set_reach_deg(result.settings.directions), cells)};
  for (const EvaluatedDirection& evaluated : result.evaluated) {
    field.areas.add(evaluated.direction, evaluated.undercut);
    field.worst = std::max(field.worst, evaluated.undercut);
  }
  return field;
}

double share_pct(const PartModel& model, double area) {
  return model.geometry.total_area > 0.0 ? 100.0 * area / model.geometry.total_area : 0.0;
}

/// What speaks for a candidate, in ever fewer words.
std::vector<std::string> reasons(const Candidate& candidate) {
  return {reasons_text(candidate, 3), reasons_text(candidate, 2), reasons_text(candidate, 1)};
}

/// An area in a column of a picture, which has no room for six digits and an exponent.
std::string area_text(const FigureColumn& column, double area) {
  const std::string text = column.text(area);
  return text.find('e') == std::string::npos ? text : with_minus(fmt::format("{:.3g}", area));
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

SphereContent sphere_content(const PartModel& model, const SweepResult& result) {
  SphereContent content;
  content.title = part_name(model.part);
  content.lines = {
      fmt::format("Undercut by parting direction: {} scored{}", counted(result.evaluated.size(), "direction"),
                  result.complete ? "" : ", not complete"),
      fmt::format("{} facets, surface {} {}, draft tolerance {}°", model.health.facets,
                  figure(model.geometry.total_area), powered_unit(model.part, 2),
                  figure(result.settings.method.tau_deg))};
  content.unit = powered_unit(model.part, 2);
  content.total_area = model.geometry.total_area;
  content.note = "No direction was measured to the end.";
  const FigureColumn areas(model.geometry.total_area);
  const std::vector<std::string> ties = tie_marks(result.candidates);
  for (std::size_t k = 0; k < result.candidates.size(); ++k) {
    const SweepCandidate& candidate = result.candidates[k];
    SphereRow row;
    row.mark = {.direction = candidate.classification.direction,
                .label = k < k_most_labels ? fmt::format("{}{}", candidate.rank, ties[k]) : std::string(),
                .best = candidate.rank == 1,
                .tilt_deg = k == 0 && candidate.tilt ? candidate.tilt->deg : 0.0};
    row.number = fmt::format("{}", candidate.rank);
    row.tie = ties[k];
    row.undercut = undercut_area(candidate);
    for (int axis = 0; axis < 3; ++axis) {
      row.direction[static_cast<std::size_t>(axis)] =
          with_minus(component_text(candidate.classification.direction[axis], 3));
    }
    row.area = area_text(areas, row.undercut);
    row.error = area_text(areas, candidate.classification.uncertainty.total());
    row.share = fmt::format("{:.2f}", share_pct(model, row.undercut));
    row.tilt = with_minus(tilt_text(candidate));
    row.reasons = reasons(candidate.candidate);
    content.rows.push_back(std::move(row));
  }
  return content;
}

ContactTile contact_tile(const PartModel& model, const SweepCandidate& candidate, const std::string& tie) {
  const std::string length = length_unit(model.part), area = powered_unit(model.part, 2);
  const FigureColumn areas(model.geometry.total_area);
  const double undercut = undercut_area(candidate);
  ContactTile tile;
  tile.number = fmt::format("{}", candidate.rank);
  tile.heading = fmt::format("along {}", with_minus(direction_text(candidate.classification.direction)));
  if (!tie.empty()) tile.remark = fmt::format("tie {}", tie);
  tile.figures = {{"undercut " + area, fmt::format("{} ± {:.2g}", area_text(areas, undercut),
                                                   candidate.classification.uncertainty.total())},
                  {"share", fmt::format("{:.2f} %", share_pct(model, undercut))},
                  {"patches", fmt::format("{}", candidate.patches)},
                  {"depth " + length, fmt::format("{:.4g}", candidate.draw_depth)},
                  {"may lean", with_minus(tilt_text(candidate))}};
  tile.reasons = reasons(candidate.candidate);
  return tile;
}

double scale_of(const StillSettings& settings) {
  return std::min(settings.size.x / k_full_scale_px.x, settings.size.y / k_full_scale_px.y);
}

}  // namespace

Image sweep_sphere_picture(const PartModel& model, const SweepResult& result, const StillSettings& settings) {
  return direction_sphere_picture(settings.size, undercut_field(result), sphere_content(model, result),
                                  settings.theme == Theme::dark);
}

Image sweep_contact_sheet(const gl::Context& context, std::shared_ptr<const PartModel> model,
                          const SweepResult& result, const StillSettings& settings,
                          const Progress& progress) {
  const double scale = scale_of(settings);
  StillSettings still = settings;
  still.legend = false;
  still.size = glm::max(glm::ivec2(glm::round(scale * glm::dvec2(k_tile_width, k_tile_height))), 16);
  const std::size_t shown = std::min(result.candidates.size(), k_most_tiles);
  ContactSheet sheet{.title = part_name(model->part),
                     .dark = settings.theme == Theme::dark,
                     .palette = settings.look.palette};
  sheet.line = shown == 0
                   ? "No direction was measured to the end."
                   : fmt::format("The best {} of {} scored{}; every part stands with its direction upward",
                                 counted(shown, "parting direction"), result.evaluated.size(),
                                 result.complete ? "" : ", not complete");
  const std::vector<std::string> ties = tie_marks(result.candidates);
  StillPainter painter(context, model);
  for (std::size_t k = 0; k < shown; ++k) {
    const SweepCandidate& candidate = result.candidates[k];
    ContactTile tile = contact_tile(*model, candidate, ties[k]);
    tile.picture = painter.draw(candidate.classification, still, silent(progress));
    sheet.tiles.push_back(std::move(tile));
  }
  return contact_sheet_picture(sheet, scale);
}

bool write_sweep_pictures(const std::string& folder, const gl::Context& context,
                          std::shared_ptr<const PartModel> model, const SweepResult& result,
                          const StillSettings& settings, const Progress& progress) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder, "", "cannot be made a folder: " + error.message());
  const std::filesystem::path there(folder);
  write_png((there / k_sphere_picture).string(), sweep_sphere_picture(*model, result, settings));
  try {
    if (progress.cancelled()) return false;
    write_png((there / k_contact_sheet).string(),
              sweep_contact_sheet(context, std::move(model), result, settings, progress));
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

}  // namespace moldlight
