// A folder of its own for a test's files, removed with everything in it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace moldlight::test {

class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes `bytes` to a file of this name and returns its path.
  [[nodiscard]] std::string write(const std::string& name, std::string_view bytes) const;
  /// Path of a file of this name, which need not be there.
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// All bytes of a file; empty where there is none.
[[nodiscard]] std::string file_bytes(const std::filesystem::path& path);

}  // namespace moldlight::test
