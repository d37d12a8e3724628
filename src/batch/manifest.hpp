// The frozen plan of a batch. In the batch's folder `batch.json` says what is done by which version with
// which settings, and names the table of parts: a row a part, with the digest of what the file held when it
// was planned. Written once and read by every machine; a new plan takes its place and leaves the former
// beside it.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "batch/csv.hpp"
#include "classify/json.hpp"
#include "io/file_contents.hpp"

namespace moldlight::batch {

inline constexpr std::string_view k_manifest_name = "batch.json";

/// Settings that rows of a batch share.
struct RowSettings {
  std::vector<std::string> arguments;  // of the subcommand, without the part
  std::vector<std::string> picture;    // those of them that `classify` takes too, without a direction
  Json effective;                      // every setting with its value
};

struct Row {
  std::size_t number = 0;  // in the plan, from 0
  std::string path;        // below the folder of parts, or absolute; bytes as the file system has them
  std::uint32_t settings = 0;
  Digest content{};
  /// An earlier row of the same content and settings, whose result this row shares.
  std::optional<std::size_t> same_as;
  std::string fault;  // why the file could not be read when it was planned; empty: it could
};

struct Manifest {
  std::string folder;      // of the batch; not in the file
  std::string version;     // of the program that planned
  std::string planned_at;  // UTC, "2026-01-31T23:59:59Z"
  std::string command;
  std::vector<std::string> given;  // the settings of all rows as they were given
  std::string source;              // what was planned: absolute folder, pattern or list
  std::string parts;               // folder that paths begin in: absolute, or relative to the batch's folder
  std::vector<RowSettings> settings;
  std::string rows_file;  // in the batch's folder
  std::size_t rows = 0;

  [[nodiscard]] std::string parts_folder() const;
};

/// Throws FileError for a folder that is no batch, and for one that is damaged or of a schema that is not
/// known.
[[nodiscard]] Manifest read_manifest(const std::string& folder);
/// True if the folder, or the file batch.json in it, belongs to a batch.
[[nodiscard]] bool is_batch(const std::string& path);

/// Writes table and manifest, in that order; a manifest that is there is kept under another name, and the
/// results stay. Sets rows, rows_file and planned_at.
void write_plan(Manifest& manifest, const std::vector<Row>& rows);

/// Reads the table of parts, row by row.
class RowReader {
 public:
  explicit RowReader(const Manifest& manifest);
  /// False after the last row; throws FileError for a damaged table.
  [[nodiscard]] bool next(Row& row);

 private:
  [[noreturn]] void damaged(const std::string& what) const;

  const Manifest& manifest_;
  std::string path_;
  std::ifstream file_;
  CsvReader table_;
  std::vector<std::string> fields_;
  std::size_t number_ = 0;
};

/// The rows of one shard of a batch: every `count`-th from `index` on.
struct Shard {
  std::size_t index = 0, count = 1;  // index < count

  [[nodiscard]] bool has(std::size_t row) const { return row % count == index; }
};

/// Names the results of rows.
class KeyMaker {
 public:
  explicit KeyMaker(const Manifest& manifest);
  /// SHA-256 over version, subcommand, effective settings and content.
  [[nodiscard]] Digest operator()(const Row& row) const;

 private:
  std::vector<std::string> beginnings_;  // of what is hashed, for each settings
};

/// Now in UTC, "2026-01-31T23:59:59Z".
[[nodiscard]] std::string utc_now();

}  // namespace moldlight::batch
