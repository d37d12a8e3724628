// Reads a part from bytes given in a test, through a file.
#pragma once

#include <string>
#include <string_view>

#include "base/error.hpp"
#include "io/part_formats.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::test {

inline Part read_bytes(const std::string& name, std::string_view bytes, const ReadOptions& options = {}) {
  const ScratchFolder folder;
  return read_part(folder.write(name, bytes), options, Progress());
}

/// The message of the error that reading ends with, without the file's folder; "no error" where it succeeds.
inline std::string read_error(const std::string& name, std::string_view bytes,
                              const ReadOptions& options = {}) {
  const ScratchFolder folder;
  const std::string path = folder.write(name, bytes);
  try {
    static_cast<void>(read_part(path, options, Progress()));
  } catch (const FileError& error) {
    const std::string text = error.what();
    return text.starts_with(path) ? text.substr(path.size() - name.size()) : "names no file: " + text;
  }
  return "no error";
}

}  // namespace moldlight::test
