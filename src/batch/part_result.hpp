// A row of a batch with what has become of it, for merged tables and the window; how far the batch is, and
// the reasons of the parts that failed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "batch/manifest.hpp"
#include "batch/store.hpp"
#include "classify/json.hpp"
#include "classify/option.hpp"

namespace moldlight::batch {

/// Figures of a part that tables of results have, whatever the work; a work that does not show one leaves it
/// empty.
enum class Figure : std::uint8_t {
  area,
  undercut_area,
  projected_area,
  undercuts,     // how many
  side_actions,  // how many
  unreleased_area,
  pieces,      // directions that a mold of several pieces opens along
  piece_bound  // fewer are impossible
};
inline constexpr std::size_t k_figure_count = 8;
[[nodiscard]] std::string_view figure_name(Figure figure);

/// Settings of reports that change nothing in them but how long they take: no part of a result's key.
[[nodiscard]] std::span<const std::string_view> settings_without_effect();

/// A figure of a report; nothing where it has none.
[[nodiscard]] std::optional<double> figure_in(const Json& report, Figure figure);
/// The direction that a picture is drawn along; nothing where it has none.
[[nodiscard]] std::optional<std::array<double, 3>> direction_in(const Json& report);

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
  std::string reasons;            // what else that says, a sentence after the other
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

struct BatchStatus {
  std::size_t rows = 0, done = 0, failed = 0, missing = 0;
  std::size_t shared = 0;  // rows among them that share the result of another
  /// Reasons of failures with how many rows have each, the most frequent first.
  std::vector<std::pair<std::string, std::size_t>> reasons;
  std::vector<std::pair<std::size_t, std::string>> missing_rows;  // number and path, where asked for
  std::vector<std::string> refused;                               // as ReadingCounts has it
};

struct StatusOptions {
  Shard shard = {};
  bool reasons = true, missing_rows = false;
};

[[nodiscard]] BatchStatus batch_status(const Manifest& manifest, const StatusOptions& options,
                                       const Progress& progress);

/// For reading; ends with a line end.
[[nodiscard]] std::string status_text(const Manifest& manifest, const BatchStatus& status);
/// Schema moldlight.batch.status/1.
[[nodiscard]] Json status_json(const Manifest& manifest, const BatchStatus& status);

}  // namespace moldlight::batch
