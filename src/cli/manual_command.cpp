// moldlight manual: the manual page, the shells' completion and lists for the documentation, made from the
// commands, their flags and the window's keys.
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/flags.hpp"
#include "cli/help.hpp"
#include "gui/commands.hpp"

namespace moldlight::cli {

namespace {

/// What is read of the environment.
constexpr std::pair<std::string_view, std::string_view> k_environment[] = {
    {"NO_COLOR", "No colours in the terminal, whatever its value"},
    {"TERM", "dumb: no colours and no moving line of progress"},
    {"XDG_STATE_HOME", "Folder where the window keeps recent parts and settings [default ~/.local/state]"},
    {"XDG_PICTURES_DIR", "Folder where the window saves pictures [default ~/Pictures]"},
    {"MESA_SHADER_CACHE_DIR, XDG_CACHE_HOME", "Folder where the OpenGL driver keeps compiled shaders"}};

struct ManualFlags {
  std::string form = "man";
  const CLI::App* program = nullptr;
};

/// A command that does something, and what is typed for it: "sweep", "batch run".
struct NamedCommand {
  std::string name;
  const CLI::App* command;
};

std::vector<NamedCommand> commands_of(const CLI::App& program, const std::string& before = "") {
  std::vector<NamedCommand> all;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    const std::string name = before + command->get_name();
    const std::vector<NamedCommand> parts = commands_of(*command, name + " ");
    if (parts.empty()) all.push_back({name, command});
    all.insert(all.end(), parts.begin(), parts.end());
  }
  return all;
}

/// A command that is only the first word of others, and their second words.
struct CommandGroup {
  std::string name;
  std::vector<std::string> words;
};

std::vector<CommandGroup> groups_of(const CLI::App& program) {
  std::vector<CommandGroup> groups;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    CommandGroup group{command->get_name(), command_names(*command)};
    if (!group.words.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

struct FlagText {
  std::string name, value, help, letter;  // letter: "-d"; empty where there is none
  std::vector<std::string> words;         // values that it takes, where they are few
};

std::vector<FlagText> flag_texts(const CLI::App& command) {
  std::vector<FlagText> texts;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_lnames().empty()) continue;
    FlagText text{
        "--" + option->get_lnames().front(), option->get_option_text(), option->get_description(), {}, {}};
    if (!option->get_snames().empty()) text.letter = "-" + option->get_snames().front();
    const bool is_list = text.value.find('|') != std::string::npos;
    // Capitals stand for something else: FILE, N, …
    if (is_list && std::ranges::none_of(text.value, [](char c) { return c >= 'A' && c <= 'Z'; }))
      text.words = CLI::detail::split(text.value, '|');
    if (!text.help.empty() && text.help.back() == '.') text.help.pop_back();
    texts.push_back(std::move(text));
  }
  return texts;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return CLI::detail::find_and_replace(std::move(text), what, with);
}

/// Text of a manual page: no line begins with a dot, and hyphens stay hyphens.
std::string roff(const std::string& text) {
  return "\\&" + replaced(replaced(replaced(text, "\\", "\\e"), "-", "\\-"), "\n", "\n\\&");
}

std::string manual(const CLI::App& program) {
  std::string text = fmt::format(
      ".TH MOLDLIGHT 1 \"\" \"moldlight {}\" \"User commands\"\n.SH NAME\nmoldlight \\- mold\\-piece regions "
      "and parting directions of injection\\-molded parts\n.SH SYNOPSIS\n",
      MOLDLIGHT_VERSION);
  std::string commands;
  for (const auto& [name, command] : commands_of(program)) {
    std::string places;
    for (const CLI::Option* option : command->get_options())
      if (option->get_positional()) places += fmt::format("\\fI{}\\fR ", option->get_name());
    text += fmt::format(".B moldlight {}\n{}[\\fIflags\\fR]\n.br\n", name, places);
    commands += fmt::format(".SH MOLDLIGHT {}\n{}.\n", name, roff(command->get_description()));
    for (const FlagText& flag : flag_texts(*command))
      commands += fmt::format(".TP\n\\fB{}\\fR \\fI{}\\fR{}\n{}.\n", roff(flag.name), roff(flag.value),
                              flag.letter.empty() ? "" : fmt::format(", \\fB{}\\fR", roff(flag.letter)),
                              roff(flag.help));
  }
  text += fmt::format(".SH DESCRIPTION\n{}.\n", roff(program.get_description())) + commands;
  text += ".SH EXAMPLES\n";
  for (const CommandExample& example : command_examples())
    text += fmt::format("{}:\n.PP\n.nf\n.RS\n{}\n.RE\n.fi\n.PP\n", roff(std::string(example.what_for)),
                        roff(std::string(example.line)));
  text += ".SH ENVIRONMENT\n";
  for (const auto& [name, meaning] : k_environment)
    text += fmt::format(".TP\n\\fB{}\\fR\n{}.\n", name, roff(std::string(meaning)));
  text += ".SH EXIT STATUS\n";
  for (const ExitCode& each : k_exit_codes)
    text += fmt::format(".TP\n{}\n{}.\n", each.code, roff(std::string(each.meaning)));
  return text;
}

std::string bash_completion(const CLI::App& program) {
  std::vector<std::string> names;
  std::string flags, values;
  for (const CLI::App* command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  std::string groups;
  for (const CommandGroup& group : groups_of(program))
    groups += fmt::format(
        "  if [[ $command == {0} ]]; then\n    [[ $COMP_CWORD -ne 2 ]] || {{ COMPREPLY=($(compgen -W \"{1}\" "
        "-- \"$word\")); return; }}\n    command=\"{0} ${{COMP_WORDS[2]}}\"\n  fi\n",
        group.name, fmt::join(group.words, " "));
  for (const auto& [name, command] : commands_of(program)) {
    std::vector<std::string> of_command;
    for (const FlagText& flag : flag_texts(*command)) {
      of_command.push_back(flag.name);
      if (!flag.words.empty())
        values += fmt::format("    \"{}:{}\") COMPREPLY=($(compgen -W \"{}\" -- \"$word\")); return ;;\n",
                              name, flag.name, fmt::join(flag.words, " "));
    }
    flags += fmt::format("    \"{}\") flags=\"{}\" ;;\n", name, fmt::join(of_command, " "));
  }
  return fmt::format(R"(_moldlight() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} flags=""
  if [[ $COMP_CWORD -eq 1 ]]; then
    COMPREPLY=($(compgen -W "{}" -- "$word") $(compgen -f -- "$word"))
    return
  fi
{}  case "$command:${{COMP_WORDS[COMP_CWORD-1]}}" in
{}  esac
  case "$command" in
{}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$flags" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _moldlight moldlight
)",
                     fmt::join(names, " "), groups, values, flags);
}

/// Within brackets and colons of _arguments, in single quotes.
std::string zsh_text(std::string text) {
  for (const auto& [what, with] : {std::pair{"'", "’"}, {"[", "("}, {"]", ")"}, {":", ";"}})
    text = replaced(std::move(text), what, with);
  return text;
}

std::string zsh_completion(const CLI::App& program) {
  std::string commands, groups, flags;
  for (const CLI::App* command : program.get_subcommands(nullptr))
    commands += fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
  for (const CommandGroup& group : groups_of(program))
    groups += fmt::format(
        "  if [[ $command == {0} ]]; then\n    if (( CURRENT == 2 )); then compadd {1}; return; fi\n"
        "    command=\"{0} $words[2]\"; shift words; (( CURRENT-- ))\n  fi\n",
        group.name, fmt::join(group.words, " "));
  for (const auto& [name, command] : commands_of(program)) {
    flags += fmt::format("    \"{}\") _arguments \\\n", name);
    for (const FlagText& flag : flag_texts(*command)) {
      const std::string values =
          flag.words.empty() ? "_files" : fmt::format("({})", fmt::join(flag.words, " "));
      flags += fmt::format("      '{}[{}]{}' \\\n", flag.name, zsh_text(flag.help),
                           flag.value.empty() ? "" : fmt::format(":{}:{}", zsh_text(flag.value), values));
    }
    flags += "      '*:part:_files' ;;\n";
  }
  return fmt::format(R"(#compdef moldlight
_moldlight() {{
  local -a commands=(
{})
  if (( CURRENT == 2 )); then
    _describe command commands
    _files
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
{}  case $command in
{}  esac
}}
_moldlight "$@"
)",
                     commands, groups, flags);
}

std::string flag_lists(const CLI::App& program) {
  std::string text;
  for (const auto& [name, command] : commands_of(program)) {
    text += fmt::format("\n## {}\n\n{}.\n\n", name, command->get_description());
    for (const FlagText& flag : flag_texts(*command))
      text += fmt::format("- `{}{}{}`{}: {}.\n", flag.name, flag.value.empty() ? "" : " ", flag.value,
                          flag.letter.empty() ? "" : fmt::format(", `{}`", flag.letter), flag.help);
  }
  return text;
}

std::string key_tables() {
  using enum gui::HelpLine::Group;
  std::string text;
  for (const auto& [group, title] :
       {std::pair{direction, "direction"}, {view, "view"}, {program, "program"}}) {
    text += fmt::format("\n| {} | what it does |\n|---|---|\n", title);
    for (const gui::HelpLine& line : gui::help_lines(group))
      text += fmt::format("| {} | {} |\n", line.keys, line.meaning);
  }
  return text;
}

int run(const ManualFlags& flags, Console& console, const Progress&) {
  console.result(flags.form == "bash"    ? bash_completion(*flags.program)
                 : flags.form == "zsh"   ? zsh_completion(*flags.program)
                 : flags.form == "flags" ? flag_lists(*flags.program)
                 : flags.form == "keys"  ? key_tables()
                                         : manual(*flags.program));
  return 0;
}

void add_manual_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "manual", "Print the manual page, a shell completion, or flags and keys in Markdown");
  const auto flags = std::make_shared<ManualFlags>();
  flags->program = &program;
  add_text_flag(*command, {"--form", "man|bash|zsh|flags|keys", "Form of the output [default man]"},
                [flags](const std::string& text) {
                  static_cast<void>(parse_word({text, "--form"}, {"man", "bash", "zsh", "flags", "keys"}));
                  flags->form = text;
                });
  set_work(*command, request, flags, run);
}

const RegisteredCommand k_manual_command({100, "manual", add_manual_command});

}  // namespace

}  // namespace moldlight::cli
