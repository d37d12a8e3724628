#include "io/file_contents.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "io/memory_check.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_chunk_bytes = std::size_t{8} << 20;

/// Closes a file descriptor at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

FileContents::FileContents(const std::string& path, const Progress& progress) {
  // Without O_NONBLOCK, opening a named pipe would wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.number() < 0) throw FileError(path, "", fmt::format("cannot be opened: {}", std::strerror(errno)));
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0) {
    throw FileError(path, "", fmt::format("cannot be examined: {}", std::strerror(errno)));
  }
  if (S_ISDIR(status.st_mode)) throw FileError(path, "", "is a folder; name a part file");
  if (!S_ISREG(status.st_mode))
    throw FileError(path, "", "is not a regular file; save the part to a file first");

  size_ = static_cast<std::size_t>(status.st_size);
  check_memory(path, size_);
  bytes_ = std::make_unique_for_overwrite<char[]>(size_);
  std::size_t done = 0;
  while (done < size_) {
    progress.report("reading", static_cast<double>(done) / static_cast<double>(size_));
    const ssize_t got = ::read(file.number(), bytes_.get() + done, std::min(k_chunk_bytes, size_ - done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw FileError(path, fmt::format("byte {}", done),
                      fmt::format("cannot be read: {}", std::strerror(errno)));
    }
    if (got == 0) {
      throw FileError(path, fmt::format("byte {}", done),
                      "the file shrank while it was read; try again once it is saved");
    }
    done += static_cast<std::size_t>(got);
  }
}

FileContents::FileContents(std::string_view bytes)
    : bytes_(std::make_unique_for_overwrite<char[]>(bytes.size())), size_(bytes.size()) {
  std::copy(bytes.begin(), bytes.end(), bytes_.get());
}

void FileContents::release() {
  bytes_.reset();
  size_ = 0;
}

}  // namespace moldlight
