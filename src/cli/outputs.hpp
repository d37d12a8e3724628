// Where a command writes to: found out before the work, so that an hour of it is not lost to a typing error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moldlight::cli {

/// A file that a flag names; an empty path is a flag not given.
struct OutputFile {
  std::string_view flag;
  std::string path;
};

/// Throws FileError for a file that cannot be written, and UsageError where two flags name one file, where
/// the part itself would be overwritten, and for "-" (commands that write to stdout leave it out of `files`).
/// Nothing is changed or left behind.
void check_output_files(const std::string& part, const std::vector<OutputFile>& files);

/// Throws FileError for a folder that is none, or that cannot be made or written to.
void check_output_folder(const std::string& folder);

}  // namespace moldlight::cli
