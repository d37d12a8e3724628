#include "io/atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "io/file_contents.hpp"

namespace moldlight {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_buffer_bytes = std::size_t{1} << 20;
constexpr int k_max_link_hops = 40;

constexpr std::string_view k_beginning = ".moldlight-", k_ending = ".part";
/// No program that we cannot see writes to a file for so long and goes on later. One that is there may sleep
/// with its machine; in the longer time its number is more likely another's.
constexpr std::chrono::minutes k_leftover_age(10), k_leftover_age_beside_process(24 * 60);

/// Where a process has its number to itself: this run of the machine, and what of its processes ours sees.
const std::string& place_of_processes() {
  static const std::string k_place = [] {
    std::string facts;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> facts;
    std::error_code ignored;
    facts += fs::read_symlink("/proc/self/ns/pid", ignored).string();
    return hex_of(digest_of(facts)).substr(0, 8);
  }();
  return k_place;
}

/// Whether the program that made a file of this name cannot come back to it.
bool is_left_behind(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(k_beginning) || !name.ends_with(k_ending)) return false;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return false;
  const std::string ours = fmt::format("{}{}-", k_beginning, place_of_processes());
  auto age = k_leftover_age;
  if (name.starts_with(ours)) {
    const auto process =
        number_from<pid_t>(name.substr(ours.size(), name.find('-', ours.size()) - ours.size()));
    if (process && *process > 0) {
      if (::kill(*process, 0) != 0 && errno == ESRCH) return true;
      age = k_leftover_age_beside_process;
    }
  }
  const auto written = fs::last_write_time(file, error);
  return !error && fs::file_time_type::clock::now() - written > age;
}

/// Once a folder, since some get thousands of files.
void remove_leftovers_once(const std::string& folder) {
  static std::mutex mutex;
  static std::set<std::string> done;
  {
    const std::lock_guard lock(mutex);
    if (!done.insert(folder).second) return;
  }
  remove_leftovers(folder);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(path) {
  if (path.empty()) fail(ENOENT);
  std::error_code error;
  for (int hops = 0; fs::is_symlink(target_, error); ++hops) {
    if (hops == k_max_link_hops) fail(ELOOP);
    target_ = (fs::path(target_).parent_path() / fs::read_symlink(target_, error)).string();
    if (error) fail(error.value());
  }
  struct stat status = {};
  const bool there = ::stat(target_.c_str(), &status) == 0;
  if (there && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (there && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  // Renaming would replace even a file that its owner has protected from writing.
  if (there && ::access(target_.c_str(), W_OK) != 0) fail(errno);
  open_beside_target();
  if (there) static_cast<void>(::fchmod(descriptor_, status.st_mode & 07777));
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::open_beside_target() {
  const std::string folder = fs::path(target_).parent_path().string();
  remove_leftovers_once(folder);
  do {
    temporary_ = temporary_path(folder);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail(errno);
}

void AtomicFile::write(std::string_view bytes) {
  CHECK(descriptor_ >= 0);
  buffer_ += bytes;
  if (buffer_.size() >= k_buffer_bytes) flush();
}

void AtomicFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void AtomicFile::put_on_disk() {
  flush();
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(errno);
}

void AtomicFile::commit() {
  put_on_disk();
  if (!temporary_.empty()) {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
  }
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail(errno);
}

void AtomicFile::fail(int error_number) const {
  const char* advice = error_number == ENOENT   ? "; does its folder exist?"
                       : error_number == ENOSPC ? "; make room or name another place"
                                                : "";
  throw FileError(path_, "", fmt::format("cannot be written: {}{}", std::strerror(error_number), advice));
}

std::string temporary_path(const std::string& folder) {
  static std::atomic<unsigned> counter = 0;
  return (fs::path(folder) /
          fmt::format("{}{}-{}-{}{}", k_beginning, place_of_processes(), ::getpid(), counter++, k_ending))
      .string();
}

void remove_leftovers(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (is_left_behind(entry->path())) fs::remove(entry->path(), ignored);
  }
}

void write_file(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace moldlight
