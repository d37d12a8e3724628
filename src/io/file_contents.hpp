// A whole file in memory, and whether there is memory for what is made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace moldlight {

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

}  // namespace moldlight
