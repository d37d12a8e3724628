#include "gui/virtual_display.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace moldlight::gui::test {

namespace {

using moldlight::test::Process;
using moldlight::test::ProcessSettings;

constexpr const char *k_server = "/usr/bin/Xvfb", *k_actor = "/usr/bin/xdotool",
                     *k_resources = "/usr/bin/xrdb", *k_camera = "/usr/bin/import",
                     *k_manager = "/usr/bin/openbox";
constexpr double k_patience_s = 120.0;

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(150)); }

}  // namespace

std::string VirtualDisplay::missing() {
  std::string names;
  for (const char* tool : {k_server, k_actor, k_resources, k_camera}) {
    if (!std::filesystem::exists(tool)) names += std::string(names.empty() ? "" : ", ") + tool;
  }
  return names;
}

VirtualDisplay::VirtualDisplay(const glm::ivec2& screen) {
  const std::string geometry = std::to_string(screen.x) + "x" + std::to_string(screen.y) + "x24";
  ProcessSettings settings;
  settings.time_limit_s = 600.0;
  // The server itself looks for a display that is free, and shows it when it is ready.
  server_ = std::make_unique<Process>(std::vector<std::string>{k_server, "-displayfd", "1", "-screen", "0",
                                                               geometry, "-noreset", "-nolisten", "tcp"},
                                      settings);
  if (!server_->wait_for_output_text("\n")) throw std::runtime_error("Xvfb does not start");
  const std::string number = server_->output().substr(0, server_->output().find('\n'));
  environment_ = {"DISPLAY=:" + number, "LIBGL_ALWAYS_SOFTWARE=1"};
  if (!std::filesystem::exists(k_manager)) return;
  settings.environment = environment_;
  manager_ = std::make_unique<Process>(std::vector<std::string>{k_manager, "--sm-disable"}, settings);
  // It is there once the display has desktops, which are a window manager's.
  const auto manages = [&] {
    ProcessSettings asking;
    asking.environment = environment_;
    return Process({k_actor, "get_num_desktops"}, asking).finish().exit_code == 0;
  };
  const auto start = std::chrono::steady_clock::now();
  while (!manages()) {
    pause();
    if (std::chrono::steady_clock::now() - start > std::chrono::duration<double>(k_patience_s))
      throw std::runtime_error("openbox does not start");
  }
}

std::string VirtualDisplay::run(const std::vector<std::string>& arguments) const {
  ProcessSettings settings;
  settings.time_limit_s = k_patience_s;
  settings.environment = environment_;
  auto result = Process(arguments, settings).finish();
  if (result.exit_code != 0) throw std::runtime_error(arguments[0] + " " + arguments[1] + ": " + result.err);
  return std::move(result.out);
}

void VirtualDisplay::set_dots_per_inch(int dpi, const std::string& scratch_file) const {
  std::ofstream(scratch_file) << "Xft.dpi: " << dpi << '\n';
  static_cast<void>(run({k_resources, "-nocpp", "-override", scratch_file}));
}

std::string VirtualDisplay::act(const std::vector<std::string>& arguments) const {
  std::vector<std::string> all = {k_actor};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run(all);
}

std::string VirtualDisplay::find_window(const std::string& title) const {
  const std::string found = act({"search", "--sync", "--onlyvisible", "--name", title});
  return found.substr(0, found.find('\n'));
}

glm::ivec2 VirtualDisplay::size_of(const std::string& window) const {
  std::istringstream lines(act({"getwindowgeometry", "--shell", window}));
  glm::ivec2 size(0);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("WIDTH=")) size.x = std::stoi(line.substr(6));
    if (line.starts_with("HEIGHT=")) size.y = std::stoi(line.substr(7));
  }
  return size;
}

Image VirtualDisplay::picture_of(const std::string& window) const {
  const glm::ivec2 size = size_of(window);
  const std::string bytes = run({k_camera, "-silent", "-window", window, "-depth", "8", "rgba:-"});
  return {size.x, size.y, {bytes.begin(), bytes.end()}};
}

Image VirtualDisplay::settled_picture_of(const std::string& window) const {
  constexpr int k_same = 3;
  const auto start = std::chrono::steady_clock::now();
  Image picture = picture_of(window);
  for (int same = 0; same < k_same;) {
    pause();
    Image next = picture_of(window);
    same = next.rgba == picture.rgba ? same + 1 : 0;
    picture = std::move(next);
    if (std::chrono::steady_clock::now() - start > std::chrono::duration<double>(k_patience_s))
      throw std::runtime_error("the window does not come to rest");
  }
  return picture;
}

std::size_t colours_of(const Image& image) {
  std::set<std::array<std::uint8_t, 3>> seen;
  for (std::size_t k = 0; k + 3 < image.rgba.size(); k += 4)
    seen.insert({image.rgba[k], image.rgba[k + 1], image.rgba[k + 2]});
  return seen.size();
}

}  // namespace moldlight::gui::test
