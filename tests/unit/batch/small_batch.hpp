// A planned batch without parts' files behind it, and results as a run would put them.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "batch/manifest.hpp"
#include "batch/store.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::batch::test_batch {

/// Settings whose only difference is the number.
inline RowSettings settings(int number) {
  return {{fmt::format("--tau={}", number)}, {}, {{"tau_deg", number}}};
}

/// Rows part-0.stl, part-1.stl, … of different contents, all with the first settings.
inline Manifest plan(const std::string& folder, std::size_t count, const std::string& command = "actions") {
  Manifest manifest;
  manifest.folder = folder;
  manifest.version = "1.2.3";
  manifest.command = command;
  manifest.source = "/parts";
  manifest.parts = "../parts";
  manifest.settings = {settings(1), settings(2)};
  std::vector<Row> rows;
  for (std::size_t k = 0; k < count; ++k) {
    Row row;
    row.number = k;
    row.path = fmt::format("part-{}.stl", k);
    row.content = digest_of(row.path);
    rows.push_back(row);
  }
  write_plan(manifest, rows);
  return manifest;
}

inline std::vector<Row> rows_of(const Manifest& manifest) {
  std::vector<Row> rows;
  RowReader reader(manifest);
  for (Row row; reader.next(row);) rows.push_back(row);
  return rows;
}

/// The result of an actions work with so much undercut and so many actions.
inline Json done(double undercut, int actions) {
  Json list = Json::array();
  for (int k = 0; k < actions; ++k) list.push_back({{"kind", "slide"}});
  return {{"outcome", "done"},
          {"tries", 1},
          {"elapsed_s", 0.5},
          {"report",
           {{"part", {{"unit", "mm"}, {"facets", 12}, {"closed", true}, {"area", 100.0}}},
            {"direction", {0.0, 0.0, 1.0}},
            {"patches", {{{"area", undercut}}}},
            {"actions", list},
            {"verdict",
             {{"state", actions > 0 ? "side-actions" : "undercuts"},
              {"sentence", "Some undercut."},
              {"reasons", {"Two reasons.", "And another."}},
              {"undercuts", 1},
              {"undercut_area", undercut},
              {"unreleased_area", 0.0}}}}}};
}

inline Json failed(const std::string& reason) {
  return {{"outcome", "failed"}, {"reason", reason}, {"tries", 2}};
}

inline void put(const Manifest& manifest, const Row& row, ResultState state, const Json& result) {
  ResultStore(manifest.folder).put(KeyMaker(manifest)(row), state, result);
}

}  // namespace moldlight::batch::test_batch
