// Planning a batch: which parts a folder, a pattern or a list names, with which settings, and what each file
// holds.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "batch/manifest.hpp"

namespace moldlight::batch {

/// A setting as the command line takes it: the flag's name without dashes, and its value.
using NamedValue = std::pair<std::string, std::string>;

/// A part that is to be planned.
struct PlanEntry {
  std::string path;  // absolute, or relative to the folder of parts
  std::vector<NamedValue> settings;
  std::string place;  // in the list, for messages: "line 12"
};

struct PlanSource {
  std::string parts;  // absolute folder that paths begin in
  std::vector<PlanEntry> entries;
  std::size_t left_out = 0;  // links that lead out of the folder
};

/// A folder is read with all folders in it, by the names of part files, but for links that lead out of it; a
/// CSV list has a column `path`, whose relative paths begin in the list's folder, and a column a setting
/// (`unit`, `direction`, …), empty where the common one holds; everything else is a pattern with *, ? and [
/// ]. Sorted, a list in its own order. Throws FileError for what names no part, and for a list that cannot be
/// read.
[[nodiscard]] PlanSource read_plan_source(const std::string& source, const Progress& progress);

/// The settings of a row, checked, where `row` goes before what all rows have; throws UsageError.
using SettingsMaker = std::function<RowSettings(const std::vector<NamedValue>& row)>;

/// Reads every file for its digest, on all cores, and fills the manifest's settings, source and parts.
/// Files that cannot be read are rows with a fault.
[[nodiscard]] std::vector<Row> plan_rows(Manifest& manifest, const PlanSource& source,
                                         const SettingsMaker& settings, const Progress& progress);

}  // namespace moldlight::batch
