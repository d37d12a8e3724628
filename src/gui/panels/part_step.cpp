// The part: what its file has, its unit, and the body of the file that is molded.

#include <algorithm>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "classify/figure_table.hpp"
#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/workspace.hpp"

namespace moldlight::gui {

namespace {

/// The bodies of the file, and which of them is shown.
struct Bodies {
  std::vector<std::string> names;
  std::size_t chosen = 0;  // from 1; 0: all as one part
};

Bodies bodies_of(const Part& part) {
  if (part.chosen_body > 0) return {part.file_bodies, part.chosen_body};
  Bodies all;
  for (const Body& body : part.bodies) all.names.push_back(body.name);
  return all;
}

/// The body of the face that was picked, from 1; 0: none, or there is but one.
std::size_t picked_body(const AppState& state) {
  const std::vector<Body>& bodies = state.model->part.bodies;
  if (!state.face || bodies.size() < 2) return 0;
  const FacetIndex facet = state.faces->facets(state.face->number).front();
  const auto after = std::ranges::upper_bound(bodies, facet, {}, &Body::first_facet);
  return static_cast<std::size_t>(after - bodies.begin());
}

/// The unit that the part has; choosing one names or converts it, a reset leaves it to the file.
void draw_unit(const PanelContext& context) {
  const Option<ReadOptions>& option = option_named(reading_options(), "unit");
  const Words& words = std::get<TextKind<ReadOptions>>(option.kind).words;
  std::string& wanted = context.edits.reading.unit;
  const std::string chosen = wanted, as_in_the_file;
  int index = static_cast<int>(std::ranges::find(words, context.state.model->part.unit) - words.begin());
  if (choice(context.ui, {option.label, !chosen.empty()}, words, index))
    wanted = words[static_cast<std::size_t>(index)];
  if (option_menu(context.ui, {option.label, option.help, chosen, as_in_the_file})) wanted.clear();
}

}  // namespace

void BodyList::draw(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Part& part = context.state.model->part;
  const Bodies bodies = bodies_of(part);
  const std::size_t count = bodies.names.size();
  if (count < 2) return;
  std::optional<std::size_t> wanted;
  const std::size_t picked = picked_body(context.state);
  const float gap = ui.px(4), arrow = ui.px(k_row_height), width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  if (icon_button(ui, {"previous body", Icon::chevron_left, "Mold the body before"}))
    wanted = (bodies.chosen + count) % (count + 1);
  ImGui::SameLine(0.0F, gap);
  text_field(ui, "##body filter", filter_,
             {.hint = "filter the bodies", .width = width - 2.0F * (arrow + gap)});
  ImGui::SameLine(0.0F, gap);
  if (icon_button(ui, {"next body", Icon::chevron_right, "Mold the next body"}))
    wanted = (bodies.chosen + 1) % (count + 1);
  const std::string words = lower_letters(filter_.data());
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < count; ++k)
    if (lower_letters(bodies.names[k]).find(words) != std::string::npos) shown.push_back(k + 1);
  const auto choose = [&](std::size_t number) {
    if (bodies.chosen > 0)
      wanted = number;
    else
      context.edits.ask(&Commands::look_at_body, number - 1);
  };
  const auto draw_body = [&](std::size_t k) {
    const std::size_t number = shown[k];
    const std::string id = fmt::format("body {}", number);
    const Row row = list_row(ui, {.id = id.c_str(),
                                  .height = k_row_height,
                                  .chosen = number == bodies.chosen || number == picked,
                                  .marked = cursor_.is_at(k)});
    const std::string& name = bodies.names[number - 1];
    const float top = row.box.centre().y - 0.5F * ui.fonts.body.size;
    const std::string facets =
        bodies.chosen == 0 ? grouped(std::to_string(part.bodies[number - 1].facet_count)) : std::string();
    draw_text(*ImGui::GetWindowDrawList(), {ui.fonts.body, ui.colours->muted},
              {row.box.min.x + ui.px(8), top}, std::to_string(number));
    draw_text(*ImGui::GetWindowDrawList(), {ui.fonts.body, ui.colours->text},
              {row.box.min.x + ui.px(44), top},
              fitted(ui.fonts.body, name.empty() ? "without name" : name,
                     width - ui.px(64) - text_size(ui.fonts.body, facets).x));
    draw_text_to({ui.fonts.body, ui.colours->muted}, row.box.max.x - ui.px(8), top, facets);
    tooltip(ui, name, bodies.chosen > 0 ? "Click to mold this body." : "Click to look at this body.");
    if (row.clicked) choose(number);
  };
  constexpr float k_bodies_share = 0.34F;  // of the window's height, that the list takes at most
  if (const auto pressed = draw_list(
          ui, {.id = "bodies", .count = shown.size(), .row_height = k_row_height, .share = k_bodies_share},
          cursor_, draw_body))
    choose(shown[*pressed]);
  if (bodies.chosen > 0) {
    if (button(ui, "All bodies as one part", {.width = width})) wanted = 0;
  } else {
    ImGui::BeginDisabled(picked == 0);
    if (button(ui, "Mold this body", {.width = width, .strong = picked > 0})) wanted = picked;
    ImGui::EndDisabled();
    if (picked == 0) hint(ui, "All bodies as one part. Click the one that is molded, here or in the view.");
  }
  if (wanted && *wanted != bodies.chosen)
    context.edits.reading.body = *wanted == 0 ? "all" : fmt::format("{}", *wanted);
}

void draw_part_step(const PanelContext& context, BodyList& bodies) {
  const Ui& ui = context.ui;
  const PartModel& model = *context.state.model;
  const FigureStyle style(model);
  const glm::dvec3 size = model.health.bounds.max - model.health.bounds.min;
  const auto length = [&](double value) { return grouped(style.text(FigureKind::length, value)); };
  draw_fact(ui, "Size",
            fmt::format("{} × {} × {} {}", length(size.x), length(size.y), length(size.z),
                        length_unit(model.part)));
  draw_fact(ui, "Surface", style.with_unit(FigureKind::area, model.health.area));
  if (model.health.closed) draw_fact(ui, "Volume", style.with_unit(FigureKind::volume, model.health.volume));
  draw_fact(ui, "Facets", grouped(std::to_string(model.health.facets)));
  draw_fact(ui, "File", model.part.format);
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  draw_unit(context);
  if (model.part.unit.empty())
    draw_note(ui, {.text = "The file states no unit. Choose the one that the part was drawn in.",
                   .icon = Icon::alert,
                   .warning = true});
  option_row(ui, option_named(reading_options(), "repair"), context.edits.reading);
  if (model.warnings.empty()) draw_note(ui, {.text = "The mesh is in order.", .icon = Icon::check});
  for (const std::string& warning : model.warnings)
    draw_note(ui, {.text = warning, .icon = Icon::alert, .warning = true});
  for (const std::string& repair : model.part.repairs) draw_note(ui, {.text = repair, .icon = Icon::check});
  bodies.draw(context);
}

}  // namespace moldlight::gui
