// Files that are replaced whole or not at all: written under another name beside the target, then renamed
// onto it.
#pragma once

#include <cstring>
#include <string>
#include <string_view>

namespace moldlight {

/// Until commit() the target stays as it is; without commit() nothing is left behind. A target that is no
/// regular file (a device, a pipe) is written directly. Every failure throws FileError that names the target.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  /// All that was written so far, under its other name: what a full disk refuses is known before commit().
  void put_on_disk();
  /// Puts everything on the disk and in place of the target. Call once, last.
  void commit();

 private:
  void open_beside_target();
  void flush();
  [[noreturn]] void fail(int error_number) const;

  std::string path_;       // as the user gave it, for messages
  std::string target_;     // behind symbolic links
  std::string temporary_;  // empty where the target is written directly
  std::string buffer_;
  int descriptor_ = -1;
};

/// A name in this folder that no other running program uses, for a file that is to be renamed once it is
/// whole.
[[nodiscard]] std::string temporary_path(const std::string& folder);
/// Removes files of such names that programs left behind when they were killed: of this machine those whose
/// program has ended, of others those that nobody has written to for ten minutes.
void remove_leftovers(const std::string& folder);

/// As it lies in memory.
template <typename T>
void append_bytes(std::string& bytes, const T& value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/// Replaces the file by `bytes`, whole or not at all.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace moldlight
