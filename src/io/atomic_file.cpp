#include "io/atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moldlight {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t k_buffer_bytes = std::size_t{1} << 20;
constexpr int k_max_link_hops = 40;

/// A name that no other running program uses.
std::string temporary_name() {
  static std::atomic<unsigned> counter = 0;
  return fmt::format(".moldlight-{}-{}.part", ::getpid(), counter++);
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
  const fs::path folder = fs::path(target_).parent_path();
  do {
    temporary_ = (folder / temporary_name()).string();
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

void AtomicFile::commit() {
  flush();
  if (!temporary_.empty()) {
    if (::fsync(descriptor_) != 0) fail(errno);
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

void write_file(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace moldlight
