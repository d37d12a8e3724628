// All results in one table, database and page.
#include "batch/merge.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "base/error.hpp"
#include "batch/csv.hpp"
#include "batch/part_result.hpp"
#include "support/hostile_names.hpp"
#include "unit/batch/small_batch.hpp"

namespace moldlight::batch {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::ScratchFolder;
using Table = std::vector<std::vector<std::string>>;

Table query(const std::string& file, const std::string& statement) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  Table rows;
  const auto take = [](void* table, int count, char** values, char**) {
    std::vector<std::string> row;
    for (int k = 0; k < count; ++k) row.emplace_back(values[k] != nullptr ? values[k] : "NULL");
    static_cast<Table*>(table)->push_back(row);
    return 0;
  };
  char* fault = nullptr;
  EXPECT_EQ(sqlite3_exec(database, statement.c_str(), take, &rows, &fault), SQLITE_OK)
      << (fault != nullptr ? fault : "");
  sqlite3_free(fault);
  sqlite3_close(database);
  return rows;
}

Table read_csv(const std::string& file) {
  std::istringstream stream(file_bytes(file));
  CsvReader reader(stream, file);
  Table rows;
  for (std::vector<std::string> row; reader.next(row);) rows.push_back(row);
  return rows;
}

/// Four parts: two done with 1 and 3 actions, one failed, one without result.
class Merge : public testing::Test {
 protected:
  void SetUp() override {
    plan(4);
    put(0, ResultState::done, test_batch::done(5.0, 1));
    put(1, ResultState::done, test_batch::done(20.0, 3));
    put(2, ResultState::failed, test_batch::failed("holds no facets"));
  }
  void plan(std::size_t rows) {
    fs::create_directories(folder_.file("night"));
    manifest_ = test_batch::plan(folder_.file("night"), rows);
    rows_ = test_batch::rows_of(manifest_);
  }
  void put(std::size_t row, ResultState state, const Json& result) {
    test_batch::put(manifest_, rows_[row], state, result);
  }
  [[nodiscard]] ReadingCounts merge_to(const MergeFiles& files) const {
    return batch::merge(manifest_, files, Progress());
  }

  ScratchFolder folder_;
  Manifest manifest_;
  std::vector<Row> rows_;
};

TEST_F(Merge, TheTableHasEveryRowOnce) {
  const std::string file = folder_.file("all.csv");
  const ReadingCounts counts = merge_to({.csv = file, .sqlite = {}, .html = {}});
  EXPECT_EQ(counts.done, 2u);
  EXPECT_EQ(counts.failed, 1u);
  EXPECT_EQ(counts.missing, 1u);
  const Table table = read_csv(file);
  ASSERT_EQ(table.size(), 5u);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), name) - table[0].begin());
  };
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(table[k + 1][column("path")], rows_[k].path);
  EXPECT_EQ(table[2][column("state")], "done");
  EXPECT_EQ(table[2][column("undercut_area")], "20");
  EXPECT_EQ(table[2][column("undercut_share")], "0.2");
  EXPECT_EQ(table[2][column("side_actions")], "3");
  EXPECT_EQ(table[2][column("unit")], "mm");
  EXPECT_EQ(table[2][column("verdict")], "side-actions");
  EXPECT_EQ(table[2][column("sentence")], "Some undercut.");
  EXPECT_EQ(table[2][column("reasons")], "Two reasons. And another.");
  EXPECT_EQ(table[3][column("state")], "failed");
  EXPECT_EQ(table[3][column("reason")], "holds no facets");
  EXPECT_EQ(table[4][column("state")], "missing");
  EXPECT_EQ(table[4][column("undercut_area")], "");
}

TEST_F(Merge, TheDatabaseAnswersWhatIsAsked) {
  const std::string file = folder_.file("all.db");
  static_cast<void>(merge_to({.csv = {}, .sqlite = file, .html = {}}));
  EXPECT_EQ(query(file, "SELECT path, undercut_share FROM worst"),
            (Table{{"part-1.stl", "0.2"}, {"part-0.stl", "0.05"}}));
  EXPECT_EQ(query(file, "SELECT path, side_actions FROM more_than_two_actions"),
            (Table{{"part-1.stl", "3"}}));
  EXPECT_EQ(query(file, "SELECT path FROM parts WHERE verdict = 'side-actions' ORDER BY row"),
            (Table{{"part-0.stl"}, {"part-1.stl"}}));
  EXPECT_EQ(query(file, "SELECT path, reason FROM failed"), (Table{{"part-2.stl", "holds no facets"}}));
  EXPECT_TRUE(query(file, "SELECT * FROM changed").empty()) << "there was no night before";
  EXPECT_EQ(query(file, "SELECT count(*) FROM parts"), (Table{{"4"}}));
  EXPECT_EQ(query(file, "PRAGMA integrity_check"), (Table{{"ok"}}));
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
}

TEST_F(Merge, TheDatabaseTellsWhatChangedSinceTheLastPlan) {
  const std::string file = folder_.file("all.db");
  static_cast<void>(merge_to({.csv = {}, .sqlite = file, .html = {}}));
  // The next night: a part more, one that failed is done, one has other figures.
  plan(5);
  manifest_.planned_at = "2099-01-01T00:00:00Z";
  put(2, ResultState::done, test_batch::done(1.0, 0));
  put(1, ResultState::done, test_batch::done(21.0, 3));
  for (int again = 0; again < 2; ++again) {
    static_cast<void>(merge_to({.csv = {}, .sqlite = file, .html = {}}));
    EXPECT_EQ(
        query(file,
              "SELECT path, change, undercut_area_before, undercut_area_now FROM changed ORDER BY path"),
        (Table{{"part-1.stl", "result", "20.0", "21.0"},
               {"part-2.stl", "failed to done", "NULL", "1.0"},
               {"part-4.stl", "new", "NULL", "NULL"}}))
        << "a second merge of one plan goes on comparing with the plan before";
  }
}

TEST_F(Merge, AForeignFileIsNotReplacedByADatabase) {
  const std::string file = folder_.write("notes.db", "these are notes");
  EXPECT_THROW(static_cast<void>(merge_to({.csv = {}, .sqlite = file, .html = {}})), FileError);
  EXPECT_EQ(file_bytes(file), "these are notes");
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
}

TEST_F(Merge, NoNameEndsTheScriptOfThePage) {
  rows_[0].path = "</script><b>.stl";
  rows_[1].path = "\xFF\".stl";
  write_plan(manifest_, rows_);
  const std::string file = folder_.file("all.html");
  static_cast<void>(merge_to({.csv = {}, .sqlite = {}, .html = file}));
  const std::string page = file_bytes(file);
  EXPECT_NE(page.find("\\u003c/script>\\u003cb>.stl"), std::string::npos);
  const std::string_view opening = "id=\"batch\">";
  const std::size_t begin = page.find(opening) + opening.size(), end = page.find("</script>", begin);
  const Json list = Json::parse(page.substr(begin, end - begin))["rows"];
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0][1], "</script><b>.stl");
  EXPECT_EQ(list[1][7], 20.0);
  EXPECT_EQ(list[2][3], "holds no facets");
}

TEST_F(Merge, ADamagedResultIsSetAsideAndCountsAsMissing) {
  const std::string file =
      fs::path(ResultStore(manifest_.folder).beside(KeyMaker(manifest_)(rows_[0]), Beside::picture))
          .replace_extension(".json")
          .string();
  fs::resize_file(file, 0);
  const ReadingCounts counts = merge_to({.csv = folder_.file("all.csv"), .sqlite = {}, .html = {}});
  ASSERT_EQ(counts.refused.size(), 1u);
  EXPECT_TRUE(counts.refused[0].starts_with(file)) << counts.refused[0];
  EXPECT_EQ(counts.missing, 2u);
  EXPECT_FALSE(fs::exists(file));
  EXPECT_TRUE(merge_to({.csv = folder_.file("all.csv"), .sqlite = {}, .html = {}}).refused.empty());
}

TEST_F(Merge, AResultUnderAnotherPartsKeyCountsForNeitherStatusNorMerge) {
  const auto file_of = [&](std::size_t row) {
    return fs::path(ResultStore(manifest_.folder).beside(KeyMaker(manifest_)(rows_[row]), Beside::picture))
        .replace_extension(".json");
  };
  fs::create_directories(file_of(3).parent_path());
  fs::copy_file(file_of(1), file_of(3));
  const BatchStatus status = batch_status(manifest_, {}, Progress());
  EXPECT_EQ(status.done, 2u);
  EXPECT_EQ(status.missing, 1u);
  ASSERT_EQ(status.refused.size(), 1u);
  EXPECT_TRUE(status.refused[0].starts_with(file_of(3).string())) << status.refused[0];
  EXPECT_EQ(status_json(manifest_, status)["refused"], status.refused);
}

TEST_F(Merge, NoNameIsObeyedByWhatShowsTheTables) {
  const std::vector<std::string> names = test::hostile_names();
  plan(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) rows_[k].path = names[k];
  write_plan(manifest_, rows_);
  for (std::size_t k = 0; k < names.size(); ++k) put(k, ResultState::failed, test_batch::failed(names[k]));
  const std::string csv = folder_.file("all.csv"), database = folder_.file("all.db"),
                    page = folder_.file("all.html");
  static_cast<void>(merge_to({.csv = csv, .sqlite = database, .html = page}));
  EXPECT_TRUE(test::is_harmless(file_bytes(csv), U"\n"));
  EXPECT_TRUE(test::is_harmless(file_bytes(page), U"\n"));
  const Table table = read_csv(csv);
  ASSERT_EQ(table.size(), names.size() + 1);
  for (std::size_t k = 1; k < table.size(); ++k) {
    for (const std::string& cell : table[k]) EXPECT_NE(cell.find_first_of("=+@"), 0u) << cell;
  }
  const Table parts = query(database, "SELECT path, reason, path_bytes FROM parts ORDER BY row");
  ASSERT_EQ(parts.size(), names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    EXPECT_EQ(parts[k][0], shown_text(names[k]));
    EXPECT_TRUE(test::is_harmless(parts[k][1])) << parts[k][1];
    EXPECT_EQ(parts[k][2], parts[k][0] == names[k] ? "NULL" : names[k]);
  }
  std::string text = status_text(manifest_, batch_status(manifest_, {}, Progress()));
  EXPECT_TRUE(test::is_harmless(text, U"\n")) << text;
}

TEST_F(Merge, StatusCountsByStateAndReason) {
  const BatchStatus status = batch_status(manifest_, {.missing_rows = true}, Progress());
  EXPECT_EQ(status.rows, 4u);
  EXPECT_EQ(status.done, 2u);
  EXPECT_EQ(status.failed, 1u);
  EXPECT_EQ(status.missing, 1u);
  ASSERT_EQ(status.reasons.size(), 1u);
  EXPECT_EQ(status.reasons[0], (std::pair<std::string, std::size_t>("holds no facets", 1)));
  ASSERT_EQ(status.missing_rows.size(), 1u);
  EXPECT_EQ(status.missing_rows[0].second, "part-3.stl");
  EXPECT_EQ(batch_status(manifest_, {.shard = {1, 2}}, Progress()).rows, 2u);
  EXPECT_EQ(status_json(manifest_, status)["done"], 2u);
}

}  // namespace
}  // namespace moldlight::batch
