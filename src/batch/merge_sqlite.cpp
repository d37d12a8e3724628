// The results in an SQLite database. It is made under another name and renamed, so that whoever reads it sees
// one night or the next.
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/owned.hpp"
#include "base/shown_text.hpp"
#include "batch/merge.hpp"
#include "classify/json.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

constexpr int k_application_id = 0x6D6C6274;  // marks the databases that are made here

constexpr const char* k_indices_and_views = R"(
CREATE INDEX parts_by_path ON parts (path, settings);
CREATE INDEX parts_by_share ON parts (undercut_share DESC);
CREATE INDEX parts_by_actions ON parts (side_actions DESC);
CREATE INDEX parts_by_state ON parts (state);
CREATE INDEX previous_by_path ON previous (path, settings);
CREATE VIEW worst AS
  SELECT * FROM parts WHERE undercut_share IS NOT NULL ORDER BY undercut_share DESC, undercut_area DESC LIMIT 50;
CREATE VIEW more_than_two_actions AS
  SELECT * FROM parts WHERE side_actions > 2 ORDER BY side_actions DESC, undercut_share DESC;
CREATE VIEW failed AS SELECT row, path, settings, reason, tries FROM parts WHERE state = 'failed' ORDER BY reason, path;
CREATE VIEW changed AS
  SELECT now.path, now.settings,
         CASE WHEN was.path IS NULL THEN 'new'
              WHEN now.state <> was.state THEN was.state || ' to ' || now.state
              WHEN now.content IS NOT was.content THEN 'file'
              ELSE 'result' END AS change,
         was.undercut_area AS undercut_area_before, now.undercut_area AS undercut_area_now,
         was.undercuts AS undercuts_before, now.undercuts AS undercuts_now,
         was.side_actions AS side_actions_before, now.side_actions AS side_actions_now, now.reason
  FROM parts AS now LEFT JOIN previous AS was ON was.path = now.path AND was.settings = now.settings
  WHERE EXISTS (SELECT 1 FROM previous)
    AND (was.path IS NULL OR now.state <> was.state OR now.content IS NOT was.content
         OR now.undercut_area IS NOT was.undercut_area OR now.undercuts IS NOT was.undercuts
         OR now.side_actions IS NOT was.side_actions OR now.unreleased_area IS NOT was.unreleased_area
         OR now.pieces IS NOT was.pieces OR now.piece_bound IS NOT was.piece_bound)
  UNION ALL
  SELECT was.path, was.settings, 'gone', was.undercut_area, NULL, was.undercuts, NULL, was.side_actions, NULL, NULL
  FROM previous AS was LEFT JOIN parts AS now ON was.path = now.path AND was.settings = now.settings
  WHERE now.path IS NULL;
)";

/// An open database; errors name the file that the user knows.
class Database {
 public:
  Database(const std::string& file, std::string known_as) : known_as_(std::move(known_as)) {
    sqlite3* opened = nullptr;
    const bool done = sqlite3_open(file.c_str(), &opened) == SQLITE_OK;
    handle_.reset(opened);
    if (!done) fail();
  }

  [[nodiscard]] sqlite3* handle() const { return handle_.get(); }
  void run(const std::string& statements) const {
    if (sqlite3_exec(handle(), statements.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
  }
  [[noreturn]] void fail() const {
    throw FileError(known_as_, "", fmt::format("cannot be written: {}", sqlite3_errmsg(handle())));
  }

 private:
  std::string known_as_;
  Owned<sqlite3, sqlite3_close> handle_;
};

/// A statement that is run over and over with other values.
class Statement {
 public:
  Statement(const Database& database, const std::string& text) : database_(database) {
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(database.handle(), text.c_str(), -1, &prepared, nullptr) != SQLITE_OK)
      database.fail();
    handle_.reset(prepared);
  }

  void bind(std::string_view text) {
    sqlite3_bind_text(handle_.get(), ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
  }
  void bind_bytes(std::string_view bytes) {
    sqlite3_bind_blob(handle_.get(), ++bound_, bytes.data(), static_cast<int>(bytes.size()),
                      SQLITE_TRANSIENT);
  }
  void bind_null() { sqlite3_bind_null(handle_.get(), ++bound_); }
  /// As the column has it, text fit to be shown.
  void bind(const ResultColumn& column, const Json& value) {
    const std::string text = value.is_string() ? shown_text(value.get<std::string>()) : "";
    if (!text.empty() || column.type == "TEXT NOT NULL") return bind(text);
    if (value.is_null() || value.is_string()) return bind_null();
    const double number = value.is_boolean() ? static_cast<double>(value.get<bool>()) : value.get<double>();
    if (column.type == "REAL")
      sqlite3_bind_double(handle_.get(), ++bound_, number);
    else
      sqlite3_bind_int64(handle_.get(), ++bound_, static_cast<sqlite3_int64>(number));
  }
  void run() {
    if (sqlite3_step(handle_.get()) != SQLITE_DONE) database_.fail();
    sqlite3_reset(handle_.get());
    bound_ = 0;
  }
  /// The first column of the first row; nothing where there is none.
  [[nodiscard]] std::optional<std::string> text() {
    if (sqlite3_step(handle_.get()) != SQLITE_ROW) return std::nullopt;
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), 0));
    return bytes != nullptr ? std::optional<std::string>(bytes) : std::nullopt;
  }

 private:
  const Database& database_;
  Owned<sqlite3_stmt, sqlite3_finalize> handle_;
  int bound_ = 0;
};

std::string column_texts() {
  std::string text;
  for (const ResultColumn& column : result_columns())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", column.name, column.type);
  return text;
}

class SqliteSink : public MergeSink {
 public:
  SqliteSink(const std::string& path, const Manifest& manifest)
      : path_(path), temporary_(temporary_path(fs::path(path).parent_path().string())) {
    remove_leftovers(fs::path(path).parent_path().string());
    try {
      database_ = std::make_unique<Database>(temporary_, path);
      database_->run(
          fmt::format("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA application_id={};"
                      "CREATE TABLE batch (name TEXT PRIMARY KEY, value TEXT);"
                      "CREATE TABLE parts ({}, path_bytes BLOB); CREATE TABLE previous ({});",
                      k_application_id, column_texts(), column_texts()));
      if (fs::exists(path)) take_previous(manifest);
      database_->run("BEGIN");
      describe(manifest);
      std::string places = "?";
      for (std::size_t k = 0; k < result_columns().size(); ++k) places += ",?";
      insert_ = std::make_unique<Statement>(*database_, "INSERT INTO parts VALUES (" + places + ")");
    } catch (...) {
      clear_away();
      throw;
    }
  }
  ~SqliteSink() override { clear_away(); }

  void add(const PartResult& result) override {
    Statement& row = *insert_;
    for (const ResultColumn& column : result_columns()) row.bind(column, column.of(result));
    const std::string path = shown_text(result.path);
    path == result.path ? row.bind_null() : row.bind_bytes(result.path);
    row.run();
  }

  void finish() override {
    database_->run("COMMIT");
    database_->run(k_indices_and_views);
    insert_.reset();
    database_.reset();
    const int descriptor = ::open(temporary_.c_str(), O_RDWR | O_CLOEXEC);
    const bool on_disk = descriptor >= 0 && ::fsync(descriptor) == 0;
    if (descriptor >= 0) ::close(descriptor);
    if (!on_disk || ::rename(temporary_.c_str(), path_.c_str()) != 0)
      throw FileError(path_, "", fmt::format("cannot be written: {}", std::strerror(errno)));
    temporary_.clear();
  }

 private:
  void clear_away() {
    insert_.reset();
    database_.reset();
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  /// The parts of the last merge become the previous ones, unless it was of the same plan: then its previous
  /// ones stay.
  void take_previous(const Manifest& manifest) {
    {
      const Database former(path_, path_);
      std::optional<std::string> found;
      try {
        Statement pragma(former, "PRAGMA application_id");
        found = pragma.text();
      } catch (const FileError&) {  // no database at all
      }
      if (found != fmt::format("{}", k_application_id))
        throw FileError(path_, "", "exists and is not a merged batch; name another file");
    }
    Statement attach(*database_, "ATTACH ? AS former");
    attach.bind(path_);
    attach.run();
    {
      Statement planned(*database_, "SELECT value FROM former.batch WHERE name = 'planned_at'");
      const bool same_plan = planned.text() == manifest.planned_at;
      // A version before this one may have had fewer columns.
      Statement names(*database_,
                      "SELECT group_concat(name) FROM pragma_table_info('parts', 'former') "
                      "WHERE name IN (SELECT name FROM pragma_table_info('previous', 'main'))");
      const std::string columns = names.text().value_or("");
      database_->run(fmt::format("INSERT INTO previous ({0}) SELECT {0} FROM former.{1}", columns,
                                 same_plan ? "previous" : "parts"));
    }
    database_->run("DETACH former");
  }

  void describe(const Manifest& manifest) const {
    Statement fact(*database_, "INSERT INTO batch VALUES (?, ?)");
    const std::array<std::pair<const char*, std::string>, 6> facts = {
        {{"planned_at", manifest.planned_at},
         {"merged_at", utc_now()},
         {"version", shown_text(manifest.version)},
         {"command", manifest.command},
         {"source", shown_text(manifest.source)},
         {"parts_folder", shown_text(manifest.parts_folder())}}};
    for (const auto& [name, value] : facts) {
      fact.bind(name);
      fact.bind(value);
      fact.run();
    }
  }

  std::string path_, temporary_;
  std::unique_ptr<Database> database_;
  std::unique_ptr<Statement> insert_;
};

}  // namespace

std::unique_ptr<MergeSink> sqlite_sink(const std::string& path, const Manifest& manifest) {
  return std::make_unique<SqliteSink>(path, manifest);
}

}  // namespace moldlight::batch
