// The part: what the file has, its unit, the body that is molded, and the tolerances of its regions.

#include <fmt/format.h>
#include <glm/common.hpp>

#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/step_panels.hpp"

namespace moldlight::gui {

namespace {

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

void draw_part_controls(const PanelContext& context, BodiesPanel& bodies, const PictureOf& pictures) {
  const Ui& ui = context.ui;
  const PartModel& model = *context.state.model;
  glm::vec3 least(0.0F), most(0.0F);
  for (const glm::vec3& point : context.state.extremes) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  const glm::dvec3 size = model.frame.diagonal * glm::dvec3(most - least);
  hint(ui, fmt::format("{} facets · {} × {} × {} {}", grouped(std::to_string(model.part.mesh.facets.size())),
                       rounded(size.x), rounded(size.y), rounded(size.z), length_unit(model.part)));
  for (const std::string& repair : model.part.repairs) hint(ui, repair);
  for (const std::string& each : model.warnings) warning(ui, each);
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  draw_unit(context);
  if (model.part.unit.empty()) hint(ui, "The file names no unit. Choose one.");
  bodies.draw(context, pictures);
  option_row(ui, option_named(reading_options(), "repair"), context.edits.reading);
  MethodSettings& method = context.edits.settings.method;
  const PartLengths lengths(context.state);
  option_row(ui, option_named(method_options(), "tau_deg"), method);
  option_row(
      ui, option_named(method_options(), "tolerance"), method,
      {.lengths = &lengths, .unset = fmt::format("{:.3g}", lateral_tolerance(method, lengths.diagonal))});
}

}  // namespace moldlight::gui
