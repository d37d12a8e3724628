// A whole file in memory. Read, not mapped: a program that saves the part anew while it is read must not end
// ours.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "base/progress.hpp"

namespace moldlight {

class FileContents {
 public:
  /// Reads the regular file `path`, of any size. Throws FileError where it cannot be read.
  FileContents(const std::string& path, const Progress& progress);
  /// A copy of bytes that are in memory already.
  explicit FileContents(std::string_view bytes);

  [[nodiscard]] std::string_view bytes() const { return {bytes_.get(), size_}; }
  /// Gives the memory back; bytes() is empty from then on.
  void release();

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

}  // namespace moldlight
