#include "actions/actions_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "actions/action_body.hpp"
#include "base/error.hpp"
#include "classify/classify_report.hpp"
#include "classify/number_format.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight {

namespace fs = std::filesystem;

namespace {

/// Whether a file is one that write_action_bodies() writes for this stem.
bool is_action_body(const fs::path& file, const std::string& stem) {
  if (file.extension() != ".stl") return false;
  const std::string name = file.stem().string();
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind) {
    const std::string start = fmt::format("{}_{}_", stem, facts(static_cast<ActionKind>(kind)).name);
    if (!name.starts_with(start) || name.size() == start.size()) continue;
    if (std::all_of(name.begin() + static_cast<std::ptrdiff_t>(start.size()), name.end(),
                    [](char letter) { return letter >= '0' && letter <= '9'; }))
      return true;
  }
  return false;
}

}  // namespace

std::string action_name(const ActionPlan& plan, std::size_t action) {
  return fmt::format("{}_{}", facts(plan.actions[action].kind).name, action + 1);
}

Colour action_colour(std::size_t action) {
  // Apart from each other however many there are, and from the red, green and blue of the regions and halves.
  struct Band {
    double first_deg, width_deg;
  };
  constexpr Band k_bands[] = {{25.0, 45.0}, {172.0, 23.0}, {275.0, 50.0}};
  constexpr double k_all_deg = 118.0, k_golden = 0.6180339887498949;
  double along_deg = k_all_deg * std::fmod(0.75 + k_golden * static_cast<double>(action), 1.0);
  const Band* band = k_bands;
  for (; along_deg > band->width_deg; ++band) along_deg -= band->width_deg;
  const double hue = (band->first_deg + along_deg) / 360.0;
  const auto channel = [&](double offset) {
    const double at = std::fmod(hue + offset, 1.0) * 6.0;
    const double value = std::clamp(std::abs(at - 3.0) - 1.0, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255.0 * (0.25 + 0.65 * value)));
  };
  return {channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)};
}

ActionGroups action_groups(const ActionsReport& report, Palette palette) {
  const SplitMesh& split = *report.result.split;
  ActionGroups found{.groups = region_groups(palette), .of_piece = {}};
  std::vector<MeshGroup>& groups = found.groups;
  const auto first = static_cast<std::uint32_t>(groups.size());
  for (std::size_t k = 0; k < report.plan.actions.size(); ++k)
    groups.push_back({action_name(report.plan, k), action_colour(k)});
  const auto unreleased = static_cast<std::uint32_t>(groups.size());
  groups.push_back({"unreleased", {110, 0, 30}});
  for (std::size_t k = 0; k < split.pieces.size(); ++k) {
    const std::int32_t action = report.plan.action_of_piece[k];
    found.of_piece.push_back(action >= 0 ? first + static_cast<std::uint32_t>(action)
                             : action == k_unreleased_piece
                                 ? unreleased
                                 : static_cast<std::uint32_t>(split.pieces[k].region));
  }
  return found;
}

void write_action_mesh(const std::string& path, const ActionsReport& report, Palette palette) {
  const SplitMesh& split = *report.result.split;
  const ActionGroups found = action_groups(report, palette);
  std::vector<MovingSolid> solids;
  for (std::size_t k = 0; k < report.plan.actions.size(); ++k) {
    const SideAction& action = report.plan.actions[k];
    if (!action.body) continue;
    solids.push_back({.name = "body_of_" + action_name(report.plan, k),
                      .mesh = *action.body->solid,
                      .colour = action_colour(k),
                      .way = action.travel * action.direction,
                      .turn_rad = turn_of(action, 1.0)});
    if (!action.about) continue;
    solids.back().point = action.about->point;
    solids.back().axis = action.about->direction;
  }
  write_grouped_mesh(path,
                     {.mesh = piece_mesh(split),
                      .groups = found.groups,
                      .of_facet = found.of_piece,
                      .what = "action",
                      .title = "side actions",
                      .unit = report.model.part.unit,
                      .name = part_name(report.model.part),
                      .values = [&] { return split_values(report.model, split, report.result.direction); },
                      .solids = solids});
}

std::vector<std::string> write_action_bodies(const std::string& folder, const std::string& stem,
                                             const ActionsReport& report, bool as_step) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "", "cannot be made a folder: " + error.message());
  std::vector<std::string> paths(report.plan.actions.size());
  std::vector<NamedSolid> solids;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const auto& body = report.plan.actions[k].body;
    if (!body) continue;
    paths[k] = (fs::path(folder) / fmt::format("{}_{}.stl", stem, action_name(report.plan, k))).string();
    write_stl(paths[k], *body->solid, action_colour(k));
    solids.push_back({action_name(report.plan, k), body->solid.get(), action_colour(k)});
  }
  const fs::path step = fs::path(folder) / (stem + "_actions.step");
  if (as_step && !solids.empty()) {
    write_solids_step(step.string(), "side actions", solids, report.model.part.unit);
  } else if (as_step) {
    fs::remove(step, error);
  }
  std::vector<fs::path> former;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const bool written = std::ranges::find(paths, entry.path().string()) != paths.end();
    if (!written && is_action_body(entry.path(), stem)) former.push_back(entry.path());
  }
  for (const fs::path& path : former) {
    fs::remove(path, error);
    if (error) throw FileError(path.string(), "", "is out of date and cannot be removed: " + error.message());
  }
  return paths;
}

std::vector<StillBody> pulled_bodies(const ActionsReport& report) {
  std::vector<StillBody> bodies;
  const ActionPlan& plan = report.plan;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    if (!action.body) continue;
    bodies.push_back({*action.body->solid, action_motion(action, 1.0), action_colour(k),
                      fmt::format("{} {}: {:.3g} {}", facts(action.kind).singular, k + 1, action.travel,
                                  length_unit(report.model.part))});
  }
  return bodies;
}

}  // namespace moldlight
