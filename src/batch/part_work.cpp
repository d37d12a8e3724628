#include "batch/part_work.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/exit_code.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

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
    if (is_done(child)) {
      Json report = Json::parse(child.out, nullptr, false);
      if (FileStamp(file) != stamp && !last) continue;
      if (report.is_object()) {
        Json result = head(manifest, row, "done");
        result["exit_code"] = child.code;
        result["tries"] = tries;
        result["elapsed_s"] = elapsed_s;
        result["host"] = host_name();
        result["finished_at"] = utc_now();
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
    result["tries"] = tries;
    result["elapsed_s"] = elapsed_s;
    result["host"] = host_name();
    result["finished_at"] = utc_now();
    return {WorkEnd::failed, reason, std::move(result)};
  }
}

std::string make_beside(const Manifest& manifest, const Row& row, const std::string& file, const Json& report,
                        Beside what, const std::string& made, const ChildLimits& limits,
                        const Progress& progress) {
  const RowSettings& settings = manifest.settings[row.settings];
  std::vector<std::string> arguments;
  if (what == Beside::report) {
    arguments = with_part(manifest.command, file, settings.arguments);
    arguments.insert(arguments.end(), {"--html", made});
  } else {
    const auto direction = direction_in(report, manifest.work());
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
