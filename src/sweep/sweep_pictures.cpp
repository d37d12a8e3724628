#include "sweep/sweep_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "classify/number_format.hpp"
#include "io/png.hpp"
#include "mold/direction.hpp"
#include "picture/direction_sphere.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_most_tiles = 12;
/// More labels would hide the map.
constexpr std::size_t k_most_labels = 30;
/// What the pictures have room for.
constexpr std::array<std::string_view, k_sphere_columns> k_sphere_figures = {
    "undercut", "undercut_uncertainty", "undercut_share", "tilt_margin_deg"};
constexpr std::array<std::string_view, 5> k_tile_figures = {"undercut", "undercut_share", "undercuts",
                                                            "draw_depth", "tilt_margin_deg"};
constexpr glm::dvec2 k_full_scale_px(1600.0, 1000.0);

// The map's field: as fine as a picture shows it, but the work of it is bounded.
constexpr double k_most_field_work = 3e8;  // cells times directions
constexpr double k_least_cells = 96.0, k_most_cells = 320.0;

/// A figure on a picture, which has no room for six digits and an exponent.
std::string picture_text(std::string_view key, const PartModel& model, const SweepCandidate& candidate) {
  const DirectionFigure& row = direction_figure(key);
  const std::string text = figure_text(row, model, candidate) + figure_aside(row, candidate);
  if (row.kind != FigureKind::area || text.find('e') == std::string::npos) return with_minus(text);
  return with_minus(fmt::format("{:.3g}", *figure_value(row, candidate)));
}

SphereContent sphere_content(const PartModel& model, const SweepResult& result) {
  SphereContent content;
  content.title = part_name(model.part);
  content.lines = {
      fmt::format("Undercut by parting direction: {} scored{}", plural(result.evaluated.size(), "direction"),
                  result.complete ? "" : ", not complete"),
      fmt::format("{} facets, surface {} {}, near-vertical below {}°", model.health.facets,
                  rounded(model.geometry.total_area), powered_unit(model.part, 2),
                  figure(result.settings.method.tau_deg))};
  const auto& proof = result.proof && result.proof->bound > 0.0 ? result.proof : result.all_free;
  if (proof) {
    content.lines.push_back(fmt::format(
        "{} have at least {} {} ({}), {}",
        proof->open.empty() ? "All directions" : "All but the circled directions", rounded(proof->bound),
        powered_unit(model.part, 2), share_text(proof->bound, model.geometry.total_area),
        proof->grade == ProofGrade::area ? "by area" : "for the scoring samples"));
    for (const OpenCap& open : proof->open) content.open.push_back({open.cap.direction, open.cap.radius_deg});
  }
  content.unit = powered_unit(model.part, 2);
  content.total_area = model.geometry.total_area;
  content.note = "No direction was measured to the end.";
  for (std::size_t k = 0; k < k_sphere_figures.size(); ++k)
    content.headings[k] = direction_figure(k_sphere_figures[k]).label;
  for (const SweepCandidate& candidate : result.candidates) {
    const glm::dvec3& direction = candidate.classification.direction;
    const bool best = candidate.rank == 1, labelled = candidate.rank <= k_most_labels;
    SphereRow row;
    row.mark = {.direction = direction,
                .label = labelled ? fmt::format("{}{}", candidate.rank, candidate.tie) : std::string(),
                .best = best,
                .tilt_deg = best && candidate.tilt ? candidate.tilt->deg : 0.0};
    row.number = fmt::format("{}", candidate.rank);
    row.tie = candidate.tie;
    row.undercut = undercut_area(candidate);
    for (int axis = 0; axis < 3; ++axis)
      row.direction[static_cast<std::size_t>(axis)] = with_minus(component_text(direction[axis], 3));
    for (std::size_t k = 0; k < k_sphere_figures.size(); ++k)
      row.figures[k] = picture_text(k_sphere_figures[k], model, candidate);
    row.reasons = shorter_reasons(candidate.candidate);
    content.rows.push_back(std::move(row));
  }
  return content;
}

ContactTile contact_tile(const PartModel& model, const SweepCandidate& candidate) {
  ContactTile tile;
  tile.number = fmt::format("{}", candidate.rank);
  tile.heading = fmt::format("along {}", with_minus(direction_words(candidate.classification.direction)));
  if (!candidate.tie.empty()) tile.remark = fmt::format("tie {}", candidate.tie);
  for (const std::string_view key : k_tile_figures) {
    tile.figures.push_back(
        {figure_heading(direction_figure(key), model), picture_text(key, model, candidate)});
  }
  tile.figures.front().value += " ± " + picture_text("undercut_uncertainty", model, candidate);
  tile.reasons = shorter_reasons(candidate.candidate);
  if (const std::string actions = side_actions_text(model, candidate); !actions.empty()) {
    for (std::string& reason : tile.reasons) reason = actions + "  ·  " + reason;
    tile.reasons.push_back(actions);
  }
  return tile;
}

double scale_of(const StillSettings& settings) {
  return std::min(settings.size.x / k_full_scale_px.x, settings.size.y / k_full_scale_px.y);
}

/// The part's regions for each of the best directions with their figures. View, look and regions of the
/// settings count, and the scale that their size stands for. An automatic view is the same for all tiles.
/// Every tile wants its regions computed, which takes a second for millions of facets. Throws Cancelled.
Image sweep_contact_sheet(const PicturedSweep& sweep, const StillSettings& settings,
                          const Progress& progress) {
  const SweepResult& result = sweep.result;
  const double scale = scale_of(settings);
  StillSettings still = settings;
  still.legend = false;
  still.size = glm::max(glm::ivec2(glm::round(scale * glm::dvec2(k_tile_width, k_tile_height))), 16);
  const std::size_t shown = std::min(result.candidates.size(), k_most_tiles);
  ContactSheet sheet{.title = part_name(sweep.model->part),
                     .dark = settings.theme == Theme::dark,
                     .palette = settings.look.palette};
  sheet.line = shown == 0 ? "No direction was measured to the end."
                          : fmt::format("The best {} of {} scored{}, all seen from the same side",
                                        plural(shown, "parting direction"), result.evaluated.size(),
                                        result.complete ? "" : ", not complete");
  StillPainter painter(sweep.context, sweep.model);
  std::vector<Classification> split;
  for (std::size_t k = 0; k < shown; ++k) {
    const Query query = result.candidates[k].classification.query();
    split.push_back(classify_exact(*sweep.model, query, Progress(&progress), true));
  }
  if (shown > 0) still.seen_from = painter.seen_best(split);
  for (std::size_t k = 0; k < shown; ++k) {
    ContactTile tile = contact_tile(*sweep.model, result.candidates[k]);
    tile.picture = painter.draw(split[k], still, Progress(&progress));
    sheet.tiles.push_back(std::move(tile));
  }
  return contact_sheet_picture(sheet, scale);
}

}  // namespace

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

Image sweep_sphere_picture(const PartModel& model, const SweepResult& result, const StillSettings& settings) {
  return direction_sphere_picture(settings.size, undercut_field(result), sphere_content(model, result),
                                  settings.theme == Theme::dark);
}

bool write_sweep_pictures(const PicturedSweep& sweep, const StillSettings& settings,
                          const std::string& folder, const Progress& progress) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder, "", "cannot be made a folder: " + error.message());
  const std::filesystem::path there(folder);
  write_png((there / k_sphere_picture).string(), sweep_sphere_picture(*sweep.model, sweep.result, settings));
  try {
    if (progress.cancelled()) return false;
    write_png((there / k_contact_sheet).string(), sweep_contact_sheet(sweep, settings, progress));
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

}  // namespace moldlight
