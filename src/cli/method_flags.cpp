#include "cli/method_flags.hpp"

namespace moldlight::cli {

void add_method_flags(CLI::App& command, MethodSettings& settings, DirectionFlag direction) {
  for (const Option<MethodSettings>& option : method_options()) {
    const bool is_direction = option.key == "direction";
    if (is_direction && direction == DirectionFlag::left_out) continue;
    CLI::Option* flag = add_option_flag(command, option, settings);
    if (is_direction && direction == DirectionFlag::required) {
      flag->required()->description(std::string(option.help) + " [required]");
    }
  }
  command.get_option("--kernel")->excludes(command.get_option("--tolerance"));
}

}  // namespace moldlight::cli
