// Every option of every table has a control that changes it, shows the change, and is undone.
#include <algorithm>

#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/window_with_part.hpp"
#include "sweep/direction_figures.hpp"

namespace moldlight::gui::test {
namespace {

class Controls : public WindowWithPart {
 protected:
  void type_into(const std::string& field, const std::string& number) {
    click(field);
    window.type(number);
    window.frame();
    key({.key = k_enter});
  }

  /// Changes it by its control.
  template <typename S>
  void use(const Option<S>& option, const S& settings) {
    const std::string label(option.label);
    std::visit(moldlight::detail::Overloaded{
                   [&](const RealKind<S>& kind) {
                     slide(label, settings.*kind.member > 0.5 * (kind.min + kind.max) ? 0.2F : 0.8F);
                   },
                   [&](const PositiveKind<S>&) { type_into(std::string(option.key), "0.25"); },
                   [&](const IntegerKind<S>&) { slide(label, 0.7F); },
                   [&](const SwitchKind<S>&) { click(label); },
                   [&](const ChoiceKind<S>& kind) {
                     const auto other = static_cast<std::size_t>(kind.get(settings) == 0 ? 1 : 0);
                     click(label + "=" + std::string(kind.words[other]));
                   },
                   [&](const DirectionsKind<S>&) {},
                   [&](const SetKind<S>& kind) { click(std::string(kind.words.front())); },
                   [&](const TextKind<S>& kind) { click(label + "=" + std::string(kind.words.back())); },
               },
               option.kind);
  }

  template <typename S, typename Get>
  void walk(std::span<const Option<S>> options, const Get& get, bool undoable) {
    for (const Option<S>& option : options) {
      const S before = get();
      const std::string text_before = option_text(option, before);
      use(option, before);
      const std::string text_after = option_text(option, get());
      EXPECT_NE(text_after, text_before) << option.key << ": its control changes nothing";
      // Only this option has changed, and its value is one that the command line takes.
      S expected = before;
      ASSERT_NO_THROW(set_option(option, expected, text_after)) << option.key;
      EXPECT_EQ(get(), expected) << option.key;
      // Through JSON and back.
      S read = before;
      set_options(options, read, options_json(options, get()));
      EXPECT_EQ(read, get()) << option.key;
      if (!undoable) continue;
      undo();
      EXPECT_EQ(option_text(option, get()), text_before) << option.key << ": undo";
    }
  }
};

TEST_F(Controls, OfTheMethod) {
  const auto settings = [&] { return method(); };
  const std::span<const Option<MethodSettings>> options = method_options();
  std::size_t folded = 0;
  enter(Step::part);
  turn_maps_drawer();
  for (std::size_t k = 0; k < options.size(); ++k) {
    const bool fold = std::ranges::find(k_accuracy_options, options[k].key) != k_accuracy_options.end();
    if (fold) click("Accuracy");
    walk(options.subspan(k, 1), settings, true);
    if (!fold) continue;
    move_to({640, 60});  // beside it: it closes
    press();
    ++folded;
  }
  EXPECT_EQ(folded, k_accuracy_options.size());
}

TEST_F(Controls, OfTheLook) {
  window.resize({1280, 800});  // the panel is whole with a section's controls
  window.settle();
  turn_maps_drawer();
  click("Section=along");  // its place and its turn are shown with it
  const auto shown = [&] { return state().settings.look; };
  const auto opening = std::ranges::find(look_options(), "open_mold", &Option<LookSettings>::key);
  const auto number = static_cast<std::size_t>(opening - look_options().begin());
  walk(look_options().first(number), shown, true);
  walk(look_options().subspan(number + 1), shown, true);
  enter(Step::mold);
  walk(look_options().subspan(number, 1), shown, true);
}

TEST_F(Controls, OfTheWindow) {
  click("settings");
  walk(
      window_options(), [&] { return state().window; }, false);
}

TEST_F(Controls, OfTheSweep) {
  using S = SweepSettings;
  const auto json = [](const S& settings) { return options_json(sweep_options(), settings); };
  const auto shown = [&]() -> const S& { return state().sweep_choices.options; };
  click("options");
  for (const Option<S>& option : sweep_options()) {
    if (!has_control(option)) continue;
    const S before = shown();
    if (const auto* integer = std::get_if<IntegerKind<S>>(&option.kind)) {
      type_into(std::string(option.key), std::to_string(integer->max));
    } else if (const auto* real = std::get_if<RealKind<S>>(&option.kind)) {
      type_into(std::string(option.key), real_text(real->max));
    } else {
      use(option, before);
    }
    EXPECT_NE(option_text(option, shown()), option_text(option, before))
        << option.key << ": its control changes nothing";
    S expected = before;
    set_option(option, expected, option_text(option, shown()));
    EXPECT_EQ(json(shown()), json(expected)) << option.key;
  }
  EXPECT_EQ(shown().objective.text, objective_names().back());
  std::vector<CandidateKind> kinds = shown().kinds;
  while (!kinds.empty()) {
    click(std::string(candidate_kind_name(kinds.back())));
    kinds.pop_back();
    EXPECT_EQ(shown().kinds, kinds);
  }
}

TEST_F(Controls, RightClickResets) {
  enter(Step::part);
  slide("Near-vertical below", 0.9F);
  EXPECT_GT(method().tau_deg, 5.0);
  move_to(window.control("Near-vertical below").centre());
  window.set_button(1, true);
  window.frame();
  window.set_button(1, false);
  window.frames(3);
  move_to(window.control("Near-vertical below").centre() + glm::vec2(30, 14));
  press();
  EXPECT_EQ(method().tau_deg, MethodSettings{}.tau_deg);
}

TEST_F(Controls, ValuesAreTypedAfterADoubleClick) {
  enter(Step::part);
  move_to(window.control("Near-vertical below").centre());
  press();
  press();
  window.type("2.5");
  window.frame();
  key({.key = k_enter});
  EXPECT_EQ(method().tau_deg, 2.5);
}

}  // namespace
}  // namespace moldlight::gui::test
