// A row of a batch with what has become of it: what status, merged tables and the window show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batch/manifest.hpp"
#include "batch/store.hpp"
#include "classify/option.hpp"

namespace moldlight::batch {

struct PartResult {
  std::size_t row = 0;
  std::string path, settings;         // settings as the command line has them, in one line
  std::uint32_t settings_number = 0;  // among those of the manifest
  Digest key{};
  std::string content;  // digest of the file; empty where it could not be read
  ResultState state = ResultState::missing;
  std::string reason;  // of a failure
  std::string unit;    // empty where unknown
  std::optional<double> facets;
  std::optional<bool> closed;
  std::string verdict, sentence;  // its state and what it says; empty where unknown
  std::optional<std::array<double, 3>> direction;
  std::array<std::optional<double>, k_figure_count> figures;
  std::optional<double> elapsed_s;
  std::optional<int> tries;
  bool picture = false, report = false;  // whether they lie beside it
  bool shared = false;                   // with an earlier row of the same content and settings

  [[nodiscard]] std::optional<double> figure(Figure which) const {
    return figures[static_cast<std::size_t>(which)];
  }
  /// Undercut area over area; nothing where either is not known.
  [[nodiscard]] std::optional<double> undercut_share() const;
};

[[nodiscard]] std::string_view state_name(ResultState state);
/// The arguments in one line, as a shell takes them.
[[nodiscard]] std::string settings_text(const std::vector<std::string>& arguments);

struct ReadingCounts {
  std::size_t done = 0, failed = 0, missing = 0;
  std::vector<std::string>
      refused;  // of files that were set aside, since they are no results: which, and why
};

/// Calls `visit` with every row of the batch, or of a shard of it, in order; reads results on all cores, a
/// few at a time, so that memory does not grow with the batch but for the names of its results. What
/// ResultStore::read() refuses counts as missing and is set aside, so that the next run makes it anew. Throws
/// FileError, Cancelled.
ReadingCounts for_each_result(const Manifest& manifest, const Progress& progress,
                              const std::function<void(const PartResult&)>& visit, const Shard& shard = {});

}  // namespace moldlight::batch
