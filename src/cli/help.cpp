#include "cli/help.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/shown_text.hpp"
#include "base/similar_word.hpp"

namespace moldlight::cli {

namespace {

constexpr std::size_t k_help_width = 104;

/// In the order in which the help has them.
constexpr std::array<std::string_view, 13> k_groups = {
    "Part",         "Direction", "Search",       "Tolerances and rules",
    "Side actions", "Work",      "Result",       "Title block of the report",
    "Pictures",     "Window",    "Pass or fail", "Expert: shadow maps",
    "Program"};

struct FlagGroup {
  std::string_view group;
  std::vector<std::string_view> flags;
};

/// Every flag that is in no other row is a rule of its command.
const std::vector<FlagGroup>& flag_groups() {
  static const std::vector<FlagGroup> k_rows = {
      {"Part",
       {"unit", "body", "repair", "weld-tolerance", "linear-deflection", "angular-deflection", "max-facets",
        "align", "compare", "parts"}},
      {"Direction", {"direction", "directions-file", "candidates", "fixed"}},
      {"Search",
       {"directions", "refine", "apart", "thorough", "eps", "max", "scoring-samples", "scoring-resolution",
        "tilt-growth", "prove", "all-free", "proof", "proof-limit", "objective", "rank", "worth",
        "time-limit"}},
      {"Side actions",
       {"actions", "slide-angle", "incline", "lifter-angle", "lifter-room", "lifter-section", "clearance",
        "strip-strain", "bundle-across", "bundle-along", "side-direction", "pins", "least-travel",
        "pin-diameter", "prices"}},
      {"Work", {"stdio", "folder", "anew", "shard", "part-time", "part-memory", "retries", "retry-failed"}},
      {"Result",
       {"json",    "html",   "live",  "pdf",    "paper",      "facets",  "faces",   "mesh", "split-dir",
        "borders", "draft",  "csv",   "bodies", "lines",      "out",     "3mf",     "step", "step-bodies",
        "wide",    "sqlite", "merge", "top",    "thumbnails", "reports", "missing", "form"}},
      {"Title block of the report", {"revision", "material", "company", "author", "note", "date", "logo"}},
      {"Pictures",
       {"image", "image-dir", "size", "view", "theme", "palette", "colouring", "open-mold", "transparency",
        "section", "section-at", "section-turn", "hatching", "feature-edges", "facet-edges", "near-vertical",
        "parting-line", "arrows", "halves"}},
      {"Window",
       {"settings", "screenshot", "script", "scale", "benchmark", "ui-scale", "navigation", "motion",
        "auto-reload", "quick-sweep"}},
      {"Pass or fail",
       {"baseline", "fail-on", "junit", "fail-if-undercut", "fail-unless-proved", "fail-on-error"}},
      {"Expert: shadow maps",
       {"kernel", "kernel-shape", "edge-thickness", "resolution", "readout", "samples", "backend",
        "compare-maps", "regions", "mark-difference", "engine"}},
      {"Program", {"help", "quiet", "verbose", "version", "jobs", "processes"}}};
  return k_rows;
}

std::string group_of(const CLI::Option& option) {
  if (option.get_lnames().empty()) return "Program";
  for (const FlagGroup& row : flag_groups())
    if (std::ranges::count(row.flags, option.get_lnames().front()) > 0) return std::string(row.group);
  return "Tolerances and rules";
}

void arrange(CLI::App& command, const std::string& name) {
  for (CLI::Option* option : command.get_options())
    if (!option->get_positional()) option->group(group_of(*option));
  std::string footer;
  for (const CommandExample& example : command_examples())
    if (example.command == name || example.command.starts_with(name + " "))
      footer +=
          fmt::format("{}\n  {}:\n    {}", footer.empty() ? "Examples:" : "", example.what_for, example.line);
  if (!footer.empty()) command.footer("\n" + footer);
  for (CLI::App* part : command.get_subcommands(nullptr)) arrange(*part, name + " " + part->get_name());
}

}  // namespace

const std::vector<CommandExample>& command_examples() {
  static const std::vector<CommandExample> k_examples = {
      {"info", "Check a file and list its bodies", "moldlight info clip.step"},
      {"classify", "Regions of a clip that opens along z, as a page to send",
       "moldlight classify clip.step -d z --html clip.html"},
      {"classify", "All walls with less than 1.5° of draft, as a table",
       "moldlight classify clip.step -d z --required-draft 1.5 --draft walls.csv"},
      {"sweep", "Find the direction in which the mold should open", "moldlight sweep clip.step"},
      {"actions", "Slides and lifters of the clip, with a picture",
       "moldlight actions clip.step -d z --image clip.png"},
      {"mold", "Parting line for CAD, and the two halves as files",
       "moldlight mold clip.step -d z --lines clip.dxf -o mold --fill-undercut"},
      {"pieces", "Directions of a mold of several pieces, and the part in their colours",
       "moldlight pieces clip.step --mesh clip.ply"},
      {"compare", "Changes of a revision; exit code 3 if the undercut grows by more than 1 %",
       "moldlight compare clip_a.step clip_b.step -d z --fail-on \"undercut > +1%\""},
      {"view", "Open the window with a part", "moldlight view clip.step"},
      {"batch plan", "Plan all parts of a folder along their best direction",
       "moldlight batch plan parts -o results -- classify -d best"},
      {"batch run", "Work until all is done, four parts at a time", "moldlight batch run results --jobs 4"},
      {"batch status", "Count the parts that are done, failed and left", "moldlight batch status results"},
      {"batch merge", "Collect the results in one table", "moldlight batch merge results --csv results.csv"},
      {"serve", "Answer questions about the parts of a folder", "moldlight serve --stdio --folder parts"},
      {"doctor", "Check drivers and helper programs after an installation", "moldlight doctor"},
      {"manual", "Completion of commands and flags in bash", "source <(moldlight manual --form bash)"}};
  return k_examples;
}

void arrange_help(CLI::App& program) {
  for (CLI::Option* option : program.get_options()) option->group("Program");
  program.footer(
      "\nmoldlight help COMMAND prints the flags of a command. moldlight version prints the version.\n"
      "moldlight PART opens the window with a part.");
  for (CLI::App* command : program.get_subcommands(nullptr)) arrange(*command, command->get_name());
}

std::vector<std::string> flags_of(const CLI::App& command) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  return flags;
}

std::vector<std::string> command_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* part : command.get_subcommands(nullptr)) names.push_back(part->get_name());
  return names;
}

std::string fault_text(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* used = &program;
  std::string command = "moldlight";
  while (!used->get_subcommands().empty()) {
    used = used->get_subcommands().front();
    command += " " + used->get_name();
  }
  const std::string advice = "see " + command + " --help";
  std::string fault = error.what();
  for (const auto& [raw, plain] : {std::pair(" requires ", " needs "), {" excludes ", " cannot go with "}})
    fault = CLI::detail::find_and_replace(fault, raw, plain);
  // A mistyped option is why another one is missing.
  const std::vector<std::string> more = program.remaining(true);
  const auto unknown = std::ranges::find_if(more, [](const auto& word) { return word.starts_with('-'); });
  if (unknown != more.end())
    return "there is no option " + one_line(*unknown) + did_you_mean(*unknown, flags_of(*used), advice);
  if (const std::vector<std::string> parts = command_names(*used); !parts.empty())
    return fmt::format("which command? {} {} …; {}", command, fmt::join(parts, "|"), advice);
  if (fault.ends_with(" missing")) return fault.substr(0, fault.find(':')) + " needs a value; " + advice;
  for (const CLI::Option* option : used->get_options())
    if (const std::string name = option->get_name();
        option->get_positional() && fault == name + " is required")
      return fmt::format("{}? {} {} …; {}", name == "DIR" ? "which batch" : "which part", command,
                         used->get_name() == "compare" ? "A B" : name, advice);
  if (!more.empty()) return fmt::format("'{}' is one word too many; {}", one_line(more.front()), advice);
  return fault + "; " + advice;
}

std::string HelpFormatter::make_help(const CLI::App* command, std::string name,
                                     CLI::AppFormatMode mode) const {
  if (mode == CLI::AppFormatMode::Sub) return make_expanded(command);
  std::string text =
      make_description(command) + make_usage(command, std::move(name)) + make_positionals(command);
  for (const std::string_view group : k_groups) {
    const std::vector<const CLI::Option*> options = command->get_options(
        [&](const CLI::Option* option) { return !option->get_positional() && option->get_group() == group; });
    if (!options.empty()) text += make_group(std::string(group), false, options);
  }
  text += make_subcommands(command, mode);
  const std::string footer = make_footer(command);
  return text + (footer.empty() ? "\n" : footer);
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return wrapped_text(option->get_description(), k_help_width - get_column_width());
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : " " + option->get_option_text();
}

}  // namespace moldlight::cli
