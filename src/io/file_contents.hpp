// A whole file in memory, and whether there is memory for what is made of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "base/progress.hpp"

namespace moldlight {

/// Owns what ::open() and the like return: movable, none (-1) when default-constructed or moved from.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  /// Negative where there is none.
  [[nodiscard]] int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

/// Both ends of a pipe, which programs that are started do not have; none for the reason in errno.
struct Pipe {
  Pipe() {
    std::array<int, 2> ends = {-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    reading = Descriptor(ends[0]);
    writing = Descriptor(ends[1]);
  }
  Descriptor reading, writing;
};

/// The first bytes of a file, and how many it has in all.
struct FileBeginning {
  static constexpr std::size_t k_most_bytes = 4096;
  std::string_view bytes;
  std::uint64_t size = 0;
};

/// Read, not mapped: a program that saves the part anew while it is read must not end ours.
class FileContents {
 public:
  using Look = std::function<void(const FileBeginning& file)>;

  /// Reads the regular file `path`, of any size. `look` gets its beginning before there is any room for the
  /// rest, and may throw. Throws FileError where it cannot be read.
  FileContents(const std::string& path, const Progress& progress, const Look& look = {});
  /// A copy of bytes that are in memory already.
  explicit FileContents(std::string_view bytes);

  [[nodiscard]] std::string_view bytes() const { return {bytes_.get(), size_}; }
  /// Gives the memory back; bytes() is empty from then on.
  void release();

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

/// Throws FileError for `path` where `bytes`, about to be taken, are not there: a system that lends
/// more than it has would end the program later, without a word. Cheap for small amounts.
void check_memory(const std::string& path, std::uint64_t bytes);

using Digest = std::array<std::uint8_t, 32>;

struct DigestHash {
  [[nodiscard]] std::size_t operator()(const Digest& digest) const {
    std::size_t value;
    std::memcpy(&value, digest.data(), sizeof(value));
    return value;
  }
};

[[nodiscard]] Digest digest_of(std::string_view bytes);

struct FileDigest {
  Digest digest{};
  int error = 0;  // errno where the file cannot be read; 0: it was
};
/// Of a regular file's content; throws Cancelled.
[[nodiscard]] FileDigest digest_of_file(const std::string& path, const Progress& progress);

/// 64 hexadecimal digits in lower case.
[[nodiscard]] std::string hex_of(const Digest& digest);
/// Nothing for what is no such text.
[[nodiscard]] std::optional<Digest> digest_from(std::string_view hex);

}  // namespace moldlight
