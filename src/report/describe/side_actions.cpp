// The report of side actions.
#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "actions/action_body.hpp"
#include "actions/action_figures.hpp"
#include "actions/actions_files.hpp"
#include "actions/best_changes.hpp"
#include "base/numbers.hpp"
#include "mold/direction.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

constexpr Colour k_unreleased = {110, 0, 30};
constexpr std::size_t k_most_changes = 3;  // that stand beside what is unreleased

Section plan_section(const ActionsReport& found) {
  const ActionPlan& plan = found.plan;
  const FigureStyle style(found.model);
  Section section{"Side actions", {}};
  if (plan.undercuts.empty()) {
    section.add("None.");
    return section;
  }
  if (!plan.actions.empty()) section.add(actions_table(found.model, plan, "/actions"));
  for (const std::string& notice :
       {meetings_text(plan), pins_notice(found.model, plan), rejected_text(found.model, plan)})
    if (!notice.empty()) section.add(notice, TextLook::notice);
  if (!plan.unreleased.empty()) {
    std::string text = fmt::format("No action that was tried releases {} of undercut{} {}.",
                                   style.with_unit(FigureKind::area, plan.unreleased_area),
                                   plan.unreleased.size() == 1 ? "" : "s", numbers_text(plan.unreleased));
    for (const std::size_t undercut : plan.unreleased)
      if (const std::string change = change_text(found, undercut);
          change != "-" && plan.unreleased.size() <= k_most_changes)
        text += fmt::format(" To free undercut {}, {}.", undercut + 1, with_minus(change));
    section.add(text, TextLook::notice);
  }
  if (plan.actions.empty()) return section;
  const std::string small = plan.optimal ? "No cheaper set of the actions that were tried releases as much."
                                         : "A cheaper set may exist: the search ended at its limit.";
  section.add(small, TextLook::quiet);
  return section;
}

/// What would have to be changed of the part instead.
Section changes_section(const ActionsReport& found) {
  Section section{"Without side actions", {}};
  // What is the same for several but for the place is one row.
  struct Change {
    std::string text;
    std::vector<std::size_t> undercuts;
  };
  std::vector<Change> changes;
  for (std::size_t k = 0; k < found.changes.size(); ++k) {
    const std::string text = change_text(found, k, false);
    if (text == "-") continue;
    auto same = std::ranges::find(changes, text, &Change::text);
    if (same == changes.end()) same = changes.insert(changes.end(), {text, {}});
    same->undercuts.push_back(k);
  }
  Table table{{{"#", true}, {"change of the part", true}}, {}};
  for (const Change& change : changes) {
    const std::string each = change.undercuts.size() > 1 ? "each: " : "";
    const std::string text = each.empty() ? change_text(found, change.undercuts.front()) : each + change.text;
    table.rows.push_back({{{numbers_text(change.undercuts)}, {with_minus(text)}}});
  }
  if (table.rows.empty()) {
    section.add("No simple change of the part frees an undercut.");
    return section;
  }
  section.add("These changes of the part would make the side actions unnecessary.");
  for (const SavingChange& change : best_changes(found.plan, found.settings.prices)) {
    std::string saved;
    for (const std::size_t action : change.actions)
      saved += (saved.empty() ? "" : ", ") + action_title(found.plan, action);
    section.add(fmt::format("Changing undercut{} {} saves {}.", change.undercuts.size() == 1 ? "" : "s",
                            numbers_text(change.undercuts), saved));
  }
  section.add(std::move(table));
  return section;
}

std::vector<const Undercut*> undercuts_of(const ActionPlan& plan) {
  std::vector<const Undercut*> undercuts;
  for (const UndercutReport& one : plan.undercuts) undercuts.push_back(&one.undercut);
  return undercuts;
}

Section undercuts_section(const ReportContext& context, Illustrator& pictures, const ActionPlan& plan) {
  const FigureStyle style(*context.model);
  Table table = undercut_table(context, pictures, undercuts_of(plan), undercut_totals(plan), "/undercuts");
  add_columns(style, undercut_figures(), table);
  table.columns.push_back({"released by", true});
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    add_cells(style, found_figures(undercut_figures(), plan.undercuts[k]), fmt::format("/undercuts/{}", k),
              table.rows[k]);
    table.rows[k].cells.push_back({released_by_text(plan, k)});
  }
  return {"Undercuts", {std::move(table)}};
}

/// The part in the colours of what forms it, and the bodies of the actions, each pulled as far as it goes.
ModelView actions_view(const ReportContext& context, const ActionsReport& found, const glm::dvec3& to_viewer,
                       std::span<const StillCallout> callouts) {
  const ActionPlan& plan = found.plan;
  ModelView view = region_view(context, found.result, to_viewer, callouts);
  view.opens = "Pull the side actions";
  view.opened = plan.actions.empty() ? 0.0 : 1.0;
  for (ViewGroup& group : view.groups) group.shift = glm::dvec3(0.0);
  // Of the undercut only what was left out does not stand with what forms it.
  ViewGroup& left_out = view.groups[static_cast<std::size_t>(Region::undercut)];
  left_out.name.clear();
  left_out.aside.clear();
  const std::size_t first = view.groups.size();
  for (std::size_t k = 0; k < plan.actions.size(); ++k)
    view.groups.push_back({.colour = action_colour(k), .stays_opaque = true});
  const std::size_t unreleased = view.groups.size();
  view.groups.push_back({.name = plan.unreleased.empty() ? "" : "Not released",
                         .colour = k_unreleased,
                         .hatched = true,
                         .stays_opaque = true});
  for (std::size_t k = 0; k < plan.action_of_piece.size(); ++k) {
    const std::int32_t action = plan.action_of_piece[k];
    std::uint16_t& group = view.surfaces.front().group_of_facet[k];
    if (action >= 0) group = static_cast<std::uint16_t>(first + static_cast<std::size_t>(action));
    if (action == k_unreleased_piece) group = static_cast<std::uint16_t>(unreleased);
  }
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    if (!action.body) continue;
    ViewGroup group{.name = action_title(plan, k),
                    .aside = fmt::format("{:.3g} {}", action.travel, length_unit(found.model.part)),
                    .colour = action_colour(k),
                    .shift = action.travel * action.direction};
    if (action.kind == ActionKind::unscrew && action.about) {
      group.turn_rad = turn_of(action, 1.0);
      group.point = action.about->point;
      group.axis = action.about->direction;
    }
    const auto number_of_group = static_cast<std::uint16_t>(view.groups.size());
    view.groups.push_back(std::move(group));
    const TriangleMesh& solid = *action.body->solid;
    view.surfaces.push_back({solid, std::vector<std::uint16_t>(solid.facets.size(), number_of_group)});
  }
  return view;
}

}  // namespace

Table actions_table(const PartModel& model, const ActionPlan& plan, const Place& keys) {
  const FigureStyle style(model);
  Table table{{{"action", true}, {"direction"}}, {}};
  add_columns(style, action_figures(), table);
  table.columns.insert(table.columns.end(), {{"free to turn"}, {"undercuts", true}});
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    const std::string& feature = action.feature;
    Row row{{{action_title(plan, k) + (feature.empty() ? "" : ", " + feature)},
             {with_minus(direction_words(action.direction))}},
            Mark{action_colour(k)}};
    add_cells(style, found_figures(action_figures(), action), entry_of(keys, k), row);
    row.cells.push_back({with_minus(freedom_text(action, length_unit(model.part)))});
    row.cells.push_back({numbers_text(action.undercuts)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table bodies_table(const PartModel& model, const ActionPlan& plan, const Place& keys) {
  constexpr std::array<std::string_view, 4> k_turns = {"1: before the mold opens", "2: as the mold opens",
                                                       "3: with the ejection", "4: by hand"};
  const FigureStyle style(model);
  Table table{{{"action", true}, {"moves", true, TableColumnRoom::pages}}, {}};
  add_columns(style, body_figures(), table);
  table.columns.push_back({"in the mold's sequence", true});
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    if (!action.body) continue;
    const auto turn = static_cast<std::size_t>(sequence_of(action.kind));
    Row row{{{action_title(plan, k)}, {std::string(k_turns[turn - 1])}}, Mark{action_colour(k)}};
    add_cells(style, found_figures(body_figures(), action), entry_of(keys, k), row);
    row.cells.push_back({clear_text(action, plan, length_unit(model.part))});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Report actions_report(const ReportContext& context, Study& study) {
  const ActionsReport found = moldlight::actions_report(study, context.progress);
  const ActionPlan& plan = found.plan;
  Report report = begin_report(context, "Side actions", found.result.direction);
  take_verdict(study.verdict(context.progress), report);
  Illustrator pictures(context, found.result);
  if (context.drawn()) {
    const std::vector<StillBody> bodies = pulled_bodies(found);
    const std::vector<StillCallout> callouts = undercut_callouts(*found.result.split, undercuts_of(plan));
    report.still = {
        pictures.whole(callouts, bodies), {}, "The part with its side actions, pulled out", view_caption()};
    report.view = actions_view(context, found, pictures.to_viewer(), callouts);
  }
  report.sections.push_back(plan_section(found));
  if (!plan.actions.empty())
    report.sections.push_back({"Bodies", {bodies_table(found.model, plan, "/actions")}});
  if (!plan.undercuts.empty()) report.sections.push_back(undercuts_section(context, pictures, plan));
  if (!found.changes.empty()) report.sections.push_back(changes_section(found));
  Section regions = regions_section(context, found.result, std::nullopt);
  regions.pages_only = true;
  report.sections.push_back(std::move(regions));
  report.sections.push_back(part_section(context, found.result.warnings));
  report.sections.push_back(repeat_section(context, actions_json(found)["settings"]));
  return report;
}

}  // namespace moldlight::report
