#include "cli/console.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/error.hpp"

namespace moldlight::cli {

namespace {

/// A stage that is over sooner is not shown at all.
constexpr std::chrono::milliseconds k_redraw_interval(100);
constexpr int k_usual_columns = 80;

int terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : k_usual_columns;
}

/// Where the caller has closed a standard stream, the next file that is opened would take its place and get
/// what is meant for it.
void occupy_closed_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0) static_cast<void>(::open("/dev/null", O_RDONLY));
}

void write_stderr(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

std::string failure_text(const std::exception& error) {
  static const std::string k_no_threads =
      "there is not enough memory, or the system allows no more threads or the like: ";
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "there is not enough memory for this part with these settings";
  // TBB's own threads: it throws a std::runtime_error with the name of the call that failed.
  const std::string what = error.what();
  const bool no_threads =
      dynamic_cast<const std::system_error*>(&error) != nullptr || what.starts_with("pthread_");
  return no_threads ? k_no_threads + what : what;
}

Console::Console() : drawn_(std::chrono::steady_clock::now()) {
  occupy_closed_descriptors();
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::strcmp(terminal, "dumb") == 0;
  colour_ = ::isatty(STDOUT_FILENO) == 1 && (no_colour == nullptr || *no_colour == '\0') && !dumb;
  terminal_ = ::isatty(STDERR_FILENO) == 1 && !dumb;
}

Console::~Console() { clear_progress(); }

void Console::result(std::string_view text) {
  const std::lock_guard lock(mutex_);
  clear_progress();
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw Error(fmt::format("stdout: cannot be written: {}", std::strerror(errno)));
}

void Console::warning(std::string_view sentence) {
  if (verbosity_ == Verbosity::quiet) return;
  line(fmt::format("moldlight: warning: {}", one_line(sentence)));
}

void Console::log(std::string_view text) {
  if (verbosity_ != Verbosity::verbose) return;
  line(fmt::format("moldlight: {}", one_line(text)));
}

void Console::failure(std::string_view sentence) { line(fmt::format("moldlight: {}", one_line(sentence))); }

void Console::set_progress_text(ProgressText text, std::chrono::seconds plain_interval) {
  const std::lock_guard lock(mutex_);
  plain_interval_ = plain_interval;
  progress_text_ = std::move(text);
}

void Console::progress(std::string_view stage, double fraction) {
  if (verbosity_ == Verbosity::quiet) return;
  if (verbosity_ == Verbosity::verbose) count_stage(stage);
  if (!terminal_) {
    plain_progress(stage, fraction);
    return;
  }
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now - drawn_ < k_redraw_interval) return;
  drawn_ = now;
  const std::string text = progress_text_
                               ? progress_text_(stage, fraction, terminal_columns())
                               : fmt::format("{} {:.0f} %", stage, 100.0 * std::clamp(fraction, 0.0, 1.0));
  write_stderr("\r\033[K" + text);
  progress_shown_ = true;
}

void Console::count_stage(std::string_view stage) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (counted_ < stages_.size()) stages_[counted_].took += now - counted_from_;
  counted_from_ = now;
  const auto known = std::ranges::find(stages_, stage, &Stage::name);
  counted_ = static_cast<std::size_t>(known - stages_.begin());
  if (known == stages_.end()) stages_.push_back({std::string(stage)});
}

void Console::log_stages() {
  if (verbosity_ != Verbosity::verbose || stages_.empty()) return;
  count_stage(stages_[counted_].name);
  std::string text;
  double all = 0.0;
  for (const Stage& stage : stages_) {
    text += fmt::format("{}{} {:.2f} s", text.empty() ? "" : ", ", stage.name, stage.took.count());
    all += stage.took.count();
  }
  log(fmt::format("{}; {:.2f} s in all", text, all));
}

void Console::plain_progress(std::string_view stage, double fraction) {
  std::string text;
  {
    const std::lock_guard lock(mutex_);
    const bool new_stage = stage != stage_;
    stage_ = stage;
    const auto now = std::chrono::steady_clock::now();
    if (progress_text_ && now - drawn_ >= plain_interval_) {
      drawn_ = now;
      text = progress_text_(stage, fraction, 0);
    } else if (new_stage && verbosity_ == Verbosity::verbose) {
      text = stage;
    }
  }
  if (!text.empty()) line(fmt::format("moldlight: {}", one_line(text)));
}

void Console::line(std::string_view text) {
  const std::lock_guard lock(mutex_);
  clear_progress();
  write_stderr(fmt::format("{}\n", text));
}

void Console::clear_progress() {
  if (progress_shown_) write_stderr("\r\033[K");
  progress_shown_ = false;
}

}  // namespace moldlight::cli
