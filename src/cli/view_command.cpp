// moldlight view: the window, or its picture where there is no display.
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/error.hpp"
#include "base/supervisor.hpp"
#include "classify/frame_benchmark.hpp"
#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "classify/option_json.hpp"
#include "cli/flags.hpp"
#include "gui/store/files.hpp"
#include "gui/window.hpp"
#include "io/atomic_file.hpp"
#include "mesh/length_unit.hpp"
#include "replay/script.hpp"
#include "replay/window_record.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::cli {

namespace {

/// The window's panels want so much room.
constexpr glm::ivec2 k_least_size(320, 240);

struct ViewFlags {
  std::string part, compare;
  ReadOptions reading;
  gui::PartNotes notes;
  gui::WindowSettings window;
  Json window_given = Json::object();
  std::string screenshot, script, settings, saved;
  glm::ivec2 size{1280, 720};
  float scale = 1.0F;
  bool settings_given = false, benchmark = false, best_direction = false;
};

std::string read_whole(const std::string& path) {
  auto text = gui::read_text(path);
  if (!text) throw FileError(path, "", "cannot be read");
  return *text;
}

int print_frame_times(const ViewFlags& flags, Console& console, const Progress& progress) {
  if (flags.part.empty()) throw UsageError("--benchmark needs a PART");
  const auto model = load_part(flags.part, flags.reading, progress);
  const auto context = create_context(flags.notes.settings.method.backend);
  const FrameTimes times = measure_frames(*context, model, flags.notes.settings, flags.size, progress);
  console.result(fmt::format("# {}, {}, {}x{}\n{}", context->backend(), context->renderer(), flags.size.x,
                             flags.size.y, frame_times_text(times)));
  return 0;
}

std::optional<gui::PartNotes> given_notes(const ViewFlags& flags, const Progress& progress) {
  std::optional<gui::PartNotes> notes;
  if (flags.settings_given) notes = flags.notes;
  if (flags.best_direction) {
    if (flags.part.empty()) throw UsageError("--direction best needs a PART");
    const auto model = load_part(flags.part, flags.reading, progress);
    notes->settings.direction = best_direction(model, flags.notes.settings.method, progress).direction;
  }
  return notes;
}

int open_window(const ViewFlags& flags, const Progress& progress) {
  // Before the display, which may be missing, too.
  for (const std::string& file : {flags.part, flags.compare})
    if (!file.empty() && ::access(file.c_str(), R_OK) != 0)
      throw FileError(file, "", fmt::format("cannot be opened: {}", std::strerror(errno)));
  WorkRecord record;
  const Supervised supervised = supervise(record);
  if (supervised.exit_code) return *supervised.exit_code;
  gui::Resumed begun{.opened = {.part = flags.part, .compare = flags.compare}};
  if (const auto& crash = supervised.forerunner)
    begun = gui::resume(gui::parse_record(crash->record), crash->cause);
  record.write(gui::record_text(begun.opened));
  gui::run_window({.part = begun.opened.part,
                   .compare = begun.opened.compare,
                   .reading = flags.reading,
                   .notes = supervised.forerunner ? std::nullopt : given_notes(flags, progress),
                   .window = flags.window_given,
                   .remark = begun.said,
                   .after_frame =
                       [&, noted = gui::WindowRecord()](const gui::AppState& state) mutable {
                         gui::WindowRecord now = gui::record_of(state);
                         now.former_work = begun.opened.former_work;
                         now.former_part = begun.opened.former_part;
                         if (now != noted) record.write(gui::record_text(noted = std::move(now)));
                       }},
                  progress);
  return 0;
}

int run(const ViewFlags& flags, Console& console, const Progress& progress) {
  if (flags.benchmark) return print_frame_times(flags, console, progress);
  if (flags.screenshot.empty() && !flags.script.empty()) throw UsageError("--script needs --screenshot");
  if (!flags.compare.empty() && flags.part.empty()) throw UsageError("--compare needs a PART");
  if (flags.screenshot.empty() && flags.saved.empty()) return open_window(flags, progress);
  const auto notes = given_notes(flags, progress);
  if (!flags.saved.empty()) {
    check_outputs({.inputs = {{"PART", flags.part}, {"--settings", flags.settings}},
                   .files = {{"--save-settings", flags.saved}}});
    gui::PartNotes saved = notes.value_or(gui::PartNotes{});
    if (!flags.reading.unit.empty()) saved.unit = parse_length_unit(flags.reading.unit).name;
    write_file(flags.saved, gui::part_notes_json(saved, flags.part));
    return 0;
  }
  check_outputs({.inputs = {{"PART", flags.part},
                            {"--compare", flags.compare},
                            {"--settings", flags.settings},
                            {"--script", flags.script}},
                 .files = {{"--screenshot", flags.screenshot}}});
  gui::OffscreenOptions window;
  window.size = flags.size;
  window.content_scale = flags.scale;
  window.user.window = flags.window;
  window.reading = flags.reading;
  window.shipped_parts = gui::shipped_parts();
  gui::take_screenshot(
      {.part = flags.part,
       .compare = flags.compare,
       .output = flags.screenshot,
       .script = flags.script.empty() ? std::nullopt : std::optional(read_whole(flags.script)),
       .notes = notes,
       .window = window});
  return 0;
}

void add_view_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand("view", "Open the window");
  const auto flags = std::make_shared<ViewFlags>();
  command->add_option("PART", flags->part,
                      "Part file, recognised by its content. Without one, the window asks for it");
  // Read before the other flags, which then change single settings of it.
  add_text_flag(*command,
                {"--settings", "FILE.json",
                 "Settings and bookmarks as the window saves them, or a JSON object of settings"},
                [flags](const std::string& path) {
                  flags->notes = gui::parse_part_notes(read_whole(path), flags->notes);
                  flags->settings = path;
                  flags->settings_given = true;
                })
      ->check(named())
      ->trigger_on_parse();
  CLI::Option* save =
      add_file_flag(*command, flags->saved,
                    {"--save-settings", "FILE.json",
                     "Write the settings of all panels, as the flags give them, and open no window"});
  add_file_flag(*command, flags->screenshot,
                {"--screenshot", "OUT.png",
                 "Write a picture of the window instead of opening it. No display is needed"})
      ->excludes(save);
  add_size_flag(*command, flags->size, "Size of the window's picture", k_least_size);
  add_text_flag(*command,
                {"--scale", "FACTOR",
                 "Content scale of the picture, as on a high-resolution monitor [0.5 to 4; default 1]"},
                [flags](const std::string& text) {
                  flags->scale = static_cast<float>(parse_real({text, "--scale"}, 0.5, 4.0));
                });
  add_file_flag(*command, flags->script,
                {"--script", "EVENTS.json", "Play these input events before the picture"});
  command
      ->add_flag("--benchmark", flags->benchmark,
                 "Print frame times without a display: plain shading, regions at rest, and regions with a "
                 "direction that changes every frame, while the camera moves and while it rests")
      ->excludes(save);
  CLI::Option* compare =
      add_file_flag(*command, flags->compare,
                    {"--compare", "FILE", "Show another revision of the part beside it and compare them"});
  add_option_flags(*command, reading_options(), flags->reading);
  add_direction_flag(*command, {flags->notes.settings.direction, flags->best_direction}, "default 0,0,1");
  add_option_flags(*command, method_options(), flags->notes.settings.method);
  add_option_flags(*command, look_options(), flags->notes.settings.look);
  CompareSettings& revision = flags->notes.settings.revision;
  for (const Option<CompareSettings>& option : compare_options())
    add_option_flag(*command, option, revision)->needs(compare);
  add_option_flags(*command, gui::window_options(), flags->window);
  command->callback([command, flags, &request] {
    const auto window = options_json(gui::window_options(), flags->window);
    for (const auto& option : gui::window_options()) {
      const std::string key(option.key);
      if (command->count(std::string(option.flag)) > 0) flags->window_given[key] = window[key];
    }
    for (const CLI::Option* option : command->get_options()) {
      const std::string name = option->get_name();
      const auto names = [&](const auto& entry) { return entry.flag == name; };
      flags->settings_given =
          flags->settings_given ||
          (option->count() > 0 &&
           (name == "--direction" || std::ranges::any_of(method_options(), names) ||
            std::ranges::any_of(look_options(), names) || std::ranges::any_of(compare_options(), names)));
    }
    request.body = [flags](Console& console, const Progress& progress) {
      return run(*flags, console, progress);
    };
  });
}

const RegisteredCommand k_view_command({70, "view", add_view_command});

}  // namespace

}  // namespace moldlight::cli
