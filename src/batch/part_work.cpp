#include "batch/part_work.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "batch/part_result.hpp"
#include "io/file_contents.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int k_look_ms = 20;
constexpr int k_no_program = 127;
constexpr std::size_t k_most_text = std::size_t{1} << 28;  // bytes; a report is far smaller

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void check_pipe(const Pipe& pipe) {
  if (pipe.reading.number() < 0)
    throw Error(fmt::format("no pipe to a process of a part: {}", std::strerror(errno)));
}

/// Takes what is there; closes the end of the pipe.
void take(Descriptor& reading, std::string& text) {
  std::array<char, 65536> buffer;
  const ssize_t count = ::read(reading.number(), buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return;
  if (count <= 0) return reading.close();
  if (text.size() < k_most_text) text.append(buffer.data(), static_cast<std::size_t>(count));
}

/// Resident bytes of a process and those it has started.
std::size_t resident_bytes(pid_t process) {
  static const auto k_page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  std::size_t total_pages = 0, pages = 0;
  std::ifstream memory(fmt::format("/proc/{}/statm", process));
  if (memory >> total_pages >> pages) total_pages = pages;
  std::size_t bytes = total_pages * k_page;
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process));
  for (pid_t child = 0; children >> child;) bytes += resident_bytes(child);
  return bytes;
}

/// In the child, between fork and exec: system calls alone.
[[noreturn]] void become(char* const* arguments, char* const* environment, const Pipe& out, const Pipe& err,
                         pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(k_no_program);
  // Where memory runs short, the part goes rather than the run.
  if (const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0)
    static_cast<void>(!::write(score, "1000", 4));
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out.writing.number(), STDOUT_FILENO);
  ::dup2(err.writing.number(), STDERR_FILENO);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::execve("/proc/self/exe", arguments, environment);
  ::_exit(k_no_program);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment_with(int threads) {
  std::vector<std::string> environment;
  const std::string beginning = std::string(k_threads_variable) + "=";
  for (char** entry = ::environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with(beginning)) environment.emplace_back(*entry);
  environment.push_back(fmt::format("{}{}", beginning, threads));
  return environment;
}

constexpr std::string_view k_schema = "moldlight.batch.result/1";
constexpr std::string_view k_picture_size = "240x180";
/// After its process was ended from outside: whoever ends all processes of a job gets to this one, too.
constexpr std::chrono::milliseconds k_wait_for_own_end(500);

/// Notices a file that was replaced while it was read.
struct FileStamp {
  std::array<std::int64_t, 5> values{};

  explicit FileStamp(const std::string& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) return;
    values = {static_cast<std::int64_t>(status.st_dev), static_cast<std::int64_t>(status.st_ino),
              static_cast<std::int64_t>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
  }
  bool operator==(const FileStamp&) const = default;
};

std::string host_name() {
  std::array<char, 256> name{};
  static_cast<void>(::gethostname(name.data(), name.size() - 1));
  return name.data();
}

/// The process's own line on stderr without what every such line begins with.
std::string message_of(const ChildResult& child, const std::string& file) {
  std::string text = child.err;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text.erase(0, text.rfind('\n') + 1);
  for (const std::string& beginning : {std::string("moldlight: "), file + ": "})
    if (text.starts_with(beginning)) text.erase(0, beginning.size());
  return text;
}

std::string reason_of(const ChildResult& child, const std::string& file, const ChildLimits& limits) {
  switch (child.end) {
    case ChildEnd::out_of_time:
      return fmt::format("took longer than {} s", limits.time_s);
    case ChildEnd::out_of_memory:
      return fmt::format("took more than {} MB of memory", limits.memory_bytes >> 20);
    case ChildEnd::signalled:
      return fmt::format("was ended by signal {} ({}{})", child.code, ::strsignal(child.code),
                         child.code == SIGKILL ? ", as where memory runs short" : "");
    default:
      break;
  }
  const std::string message = message_of(child, file);
  return message.empty() ? fmt::format("ended with exit code {} without a message", child.code) : message;
}

/// Whether it did its work, however that came out.
bool is_done(const ChildResult& child) {
  return child.end == ChildEnd::exited &&
         (child.code == 0 || child.code == k_criterion_failed || child.code == k_not_proved);
}

bool is_limit(ChildEnd end) { return end == ChildEnd::out_of_time || end == ChildEnd::out_of_memory; }

/// Somebody asked it to end, politely; the part is not to blame.
bool is_request(const ChildResult& child) {
  if (child.end == ChildEnd::exited) return child.code == k_interrupted;
  return child.end == ChildEnd::signalled &&
         (child.code == SIGTERM || child.code == SIGINT || child.code == SIGHUP);
}

/// The head that every result has.
Json head(const Manifest& manifest, const Row& row, std::string_view outcome) {
  return {{"schema", k_schema},
          {"outcome", outcome},
          {"version", manifest.version},
          {"command", manifest.command},
          {"path", row.path},
          {"content", row.fault.empty() ? Json(hex_of(row.content)) : Json()}};
}

WorkOutcome file_failure(const Manifest& manifest, const Row& row, const std::string& reason) {
  Json result = head(manifest, row, "failed");
  result["kind"] = "file";
  result["reason"] = reason;
  result["tries"] = 0;
  return {WorkEnd::failed, reason, std::move(result)};
}

/// A file that went is one thing, a folder that is not mounted here another.
bool is_removed(const std::string& file, int error) {
  std::error_code ignored;
  return error == EISDIR || error == EINVAL ||
         (error == ENOENT && fs::is_directory(fs::path(file).parent_path(), ignored) &&
          !fs::is_empty(fs::path(file).parent_path(), ignored));
}

std::vector<std::string> with_part(const std::string& command, const std::string& file,
                                   const std::vector<std::string>& settings) {
  std::vector<std::string> arguments = {command, file};
  arguments.insert(arguments.end(), settings.begin(), settings.end());
  return arguments;
}

void wait(std::chrono::milliseconds time, const Progress& progress) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) {
    if (progress.cancelled()) throw Cancelled();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                      const Progress& progress) {
  Pipe out, err;
  for (const Pipe* pipe : {&out, &err}) check_pipe(*pipe);
  std::vector<std::string> words = {"moldlight"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environment_with(limits.threads);
  const std::vector<char*> argv = pointers(words), environment = pointers(variables);
  const pid_t parent = ::getpid();
  const auto start = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw Error(fmt::format("a part's process cannot be started: {}", std::strerror(errno)));
  if (child == 0) become(argv.data(), environment.data(), out, err, parent);
  out.writing.close();
  err.writing.close();

  ChildResult result;
  const auto end_it = [&](ChildEnd why) {
    if (result.end != ChildEnd::exited) return;
    result.end = why;
    ::kill(-child, SIGKILL);
    ::kill(child, SIGKILL);  // before it has a group of its own
  };
  while (out.reading.number() >= 0 || err.reading.number() >= 0) {
    std::array<pollfd, 2> waits = {pollfd{out.reading.number(), POLLIN, 0},
                                   pollfd{err.reading.number(), POLLIN, 0}};
    ::poll(waits.data(), waits.size(), k_look_ms);
    if (waits[0].revents != 0) take(out.reading, result.out);
    if (waits[1].revents != 0) take(err.reading, result.err);
    if (progress.cancelled()) end_it(ChildEnd::cancelled);
    if (limits.time_s > 0.0 && seconds_since(start) > limits.time_s) end_it(ChildEnd::out_of_time);
    if (limits.memory_bytes > 0 && resident_bytes(child) > limits.memory_bytes)
      end_it(ChildEnd::out_of_memory);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (result.end == ChildEnd::exited && WIFSIGNALED(status)) result.end = ChildEnd::signalled;
  result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  if (result.end == ChildEnd::exited && result.code == k_no_program && result.out.empty() &&
      result.err.empty())
    throw Error("a part's process cannot be started: the program itself is not to be read any more");
  return result;
}

WorkOutcome work_on(const Manifest& manifest, const Row& row, const std::string& file,
                    const WorkSettings& settings, const Progress& progress) {
  if (!row.fault.empty())
    return file_failure(manifest, row, "could not be read when it was planned: " + row.fault);
  std::vector<std::string> arguments =
      with_part(manifest.command, file, manifest.settings[row.settings].arguments);
  arguments.insert(arguments.end(), {"--json", "-", "--quiet"});
  for (int tries = 1;; ++tries) {
    const FileStamp stamp(file);
    const FileDigest digest = digest_of_file(file, progress);
    if (digest.error != 0) {
      const std::string why = std::strerror(digest.error);
      if (is_removed(file, digest.error))
        return file_failure(manifest, row, "is gone since it was planned: " + why);
      return {WorkEnd::unreachable, "cannot be read from here: " + why, {}};
    }
    if (digest.digest != row.content)
      return file_failure(manifest, row, "has changed since it was planned; plan again");
    const auto start = std::chrono::steady_clock::now();
    const ChildResult child = run_child(arguments, settings.limits, progress);
    if (child.end == ChildEnd::cancelled) throw Cancelled();
    const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool last = tries > settings.retries;
    const auto add_facts = [&](Json& result) {
      result["tries"] = tries;
      result["elapsed_s"] = elapsed_s;
      result["host"] = host_name();
      result["finished_at"] = utc_now();
    };
    if (is_done(child)) {
      Json report = Json::parse(child.out, nullptr, false);
      if (FileStamp(file) != stamp && !last) continue;
      if (report.is_object()) {
        Json result = head(manifest, row, "done");
        result["exit_code"] = child.code;
        add_facts(result);
        result["report"] = std::move(report);
        return {WorkEnd::done, "", std::move(result)};
      }
    }
    const bool from_outside =
        is_request(child) || (child.end == ChildEnd::signalled && child.code == SIGKILL);
    if (from_outside) wait(k_wait_for_own_end, progress);
    if (!last && !is_limit(child.end)) continue;
    const std::string reason = reason_of(child, file, settings.limits);
    if (is_request(child)) return {WorkEnd::ended, "its process was ended from outside", {}};
    Json result = head(manifest, row, "failed");
    result["kind"] = child.end == ChildEnd::exited        ? "exit"
                     : child.end == ChildEnd::signalled   ? "signal"
                     : child.end == ChildEnd::out_of_time ? "time"
                                                          : "memory";
    if (!is_limit(child.end)) result[child.end == ChildEnd::exited ? "exit_code" : "signal"] = child.code;
    result["reason"] = reason;
    add_facts(result);
    return {WorkEnd::failed, reason, std::move(result)};
  }
}

std::string make_beside(const Manifest& manifest, const Row& row, const std::string& file, const Json& report,
                        Beside what, const std::string& made, const ChildLimits& limits,
                        const Progress& progress) {
  const RowSettings& settings = manifest.settings[row.settings];
  std::vector<std::string> arguments;
  if (what != Beside::picture) {
    arguments = with_part(manifest.command, file, settings.arguments);
    arguments.insert(arguments.end(), {"--html", made});
    if (what == Beside::live_report) arguments.emplace_back("--live");
  } else {
    const auto direction = direction_in(report);
    if (!direction) return "its report names no direction";
    arguments = with_part("classify", file, settings.picture);
    arguments.insert(arguments.end(),
                     {fmt::format("--direction={},{},{}", (*direction)[0], (*direction)[1], (*direction)[2]),
                      "--image", made, "--size", std::string(k_picture_size)});
  }
  arguments.emplace_back("--quiet");
  const ChildResult child = run_child(arguments, limits, progress);
  if (child.end == ChildEnd::cancelled) throw Cancelled();
  return is_done(child) ? "" : reason_of(child, file, limits);
}

}  // namespace moldlight::batch
