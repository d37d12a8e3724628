#include "cli/still_flags.hpp"

#include <fmt/format.h>

#include "session/still_picture.hpp"

namespace moldlight::cli {

CLI::Option* add_size_flag(CLI::App& command, glm::ivec2& size, const std::string& help,
                           const glm::ivec2& least) {
  return command
      .add_option_function<std::string>(
          "--size",
          [&size, least](const std::string& text) { size = parse_picture_size(text, "--size", least); },
          fmt::format("{} [default {}x{}]", help, size.x, size.y))
      ->option_text("WxH");
}

}  // namespace moldlight::cli
