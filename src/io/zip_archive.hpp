// Reads the entries of a zip archive held in memory (libzip). Nothing is ever unpacked to the disk.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "io/read_context.hpp"

struct zip;

namespace moldlight {

class ZipArchive {
 public:
  /// The context's bytes are the archive; they stay in memory as long as it lives. Throws FileError for a
  /// damaged one.
  explicit ZipArchive(const ReadContext& context);

  /// Names are compared exactly first, then without regard to case.
  [[nodiscard]] bool contains(const std::string& entry) const { return find(entry) >= 0; }

  /// Hands the entry's bytes to `sink`, chunk by chunk. Throws FileError for a missing or damaged entry, and
  /// once all entries read together expand to far more than any real part of the archive's size does.
  void read(const std::string& entry, const std::function<void(std::string_view)>& sink);

 private:
  [[nodiscard]] std::int64_t find(const std::string& entry) const;

  const ReadContext& context_;
  std::unique_ptr<zip, void (*)(zip*)> archive_;
  std::uint64_t bytes_left_;  // that may still come out
};

}  // namespace moldlight
