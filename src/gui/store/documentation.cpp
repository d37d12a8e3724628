#include "gui/store/documentation.hpp"

#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

bool on_a_desktop() { return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr; }

/// Starts the desktop's own opener and does not wait for it; false where there is none.
bool open_on_desktop(const std::string& path) {
  std::string shell = "sh", flag = "-c", name = path;
  std::string script =
      "command -v xdg-open >/dev/null || exit 1; xdg-open \"$0\" >/dev/null 2>&1 </dev/null &";
  char* const arguments[] = {shell.data(), flag.data(), script.data(), name.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "sh", nullptr, nullptr, arguments, ::environ) != 0) return false;
  int status = 0;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string open_documentation() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path page = fs::weakly_canonical(program / "../share/doc/moldlight/html/index.html", error);
  if (!fs::is_regular_file(page, error))
    return "The documentation is not installed; its sources are in docs/";
  if (on_a_desktop() && open_on_desktop(page.string())) return "The documentation opens in the browser";
  return fmt::format("The documentation is {}", page.string());
}

}  // namespace moldlight::gui
