// moldlight doctor: what the program finds on this machine, and whether it works.
#include <algorithm>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/threads.hpp"
#include "classify/headless.hpp"
#include "cli/flags.hpp"
#include "gui/draw/ui.hpp"
#include "io/readers.hpp"

namespace moldlight::cli {

namespace {

struct DoctorFlags {};

std::string line(std::string_view name, std::string_view what) {
  return fmt::format("{:<12}{}\n", name, what);
}

std::string memory_text() {
  const double bytes =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return fmt::format("{:.1f} GiB", bytes / (1 << 30));
}

std::string threads_text() {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int startable = startable_threads(2 * cores);
  return startable < 2 * cores
             ? fmt::format("{} cores, and only {} threads more may be started", cores, startable)
             : fmt::format("{} cores", cores);
}

int run(const DoctorFlags&, Console& console, const Progress& progress) {
  console.result(line("moldlight", MOLDLIGHT_VERSION) + line("processor", threads_text()) +
                 line("memory", memory_text()));
  bool draws = false;
  for (const BackendReport& report : backend_reports()) {
    progress.report("trying drivers", 0.5);
    const bool works = report.fault.empty();
    draws = draws || works;
    const std::string driver =
        report.renderer.empty() ? "" : report.renderer + (works ? ": draws a known part as computed" : " ");
    console.result(line(report.backend, (works ? "✓ " : "✗ ") + driver + report.fault));
  }
  const auto step = step_reading_program();
  console.result(
      line("STEP", step ? "✓ " + *step : "✗ moldlight-step is not there; STEP files cannot be read"));
  const std::string font = find_interface_font(false).path;
  console.result(line("font", font.empty() ? "✗ none; install fonts-inter or fonts-roboto" : "✓ " + font));
  if (!draws) console.warning("no driver draws: regions and sweeps work, but no pictures and no window");
  return draws ? 0 : k_failure;
}

void add_doctor_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand("doctor", "Check drivers, fonts and helper programs");
  set_work(*command, request, std::make_shared<DoctorFlags>(), run);
}

const RegisteredCommand k_doctor_command({90, "doctor", add_doctor_command});

}  // namespace

}  // namespace moldlight::cli
