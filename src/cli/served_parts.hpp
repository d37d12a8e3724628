// The parts of a folder that a client may ask about: paths are kept inside it, and what was found of the last
// parts is kept for the next question.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <optional>
#include <string>
#include <utility>

#include "base/progress.hpp"
#include "io/read_options.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

/// A part as it was read, and what is known of it.
struct ServedPart {
  std::string path;  // from the folder
  std::uintmax_t size = 0;
  std::filesystem::file_time_type changed = {};
  ReadOptions reading;
  Study study;
  std::optional<std::pair<MethodSettings, BestDirection>> best = {};
};

/// One thread at a time.
class ServedParts {
 public:
  /// The folder becomes the working directory, so that paths and messages are those of a command that is run
  /// there. Throws FileError for what is no folder.
  explicit ServedParts(const std::string& folder);

  /// A copy of what is known, or the part read anew. Throws FileError for a path that leads out of the
  /// folder, and as load_part().
  [[nodiscard]] ServedPart part(const std::string& path, const ReadOptions& reading,
                                const Progress& progress) const;
  /// In place of what was known of it; the part that was asked about longest ago is forgotten.
  void keep(ServedPart part);

 private:
  /// Without links and dots.
  [[nodiscard]] std::string inside(const std::string& path) const;

  std::filesystem::path folder_;
  std::list<ServedPart> parts_;  // the last one first
};

}  // namespace moldlight::cli
