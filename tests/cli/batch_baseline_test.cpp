// A batch against its earlier table: what is new, gone and changed, and criteria on it.
#include <sstream>

#include <gtest/gtest.h>

#include "batch/csv.hpp"
#include "cli/small_parts.hpp"

namespace moldlight {
namespace {

using test::file_bytes;

/// Three parts, done and merged; the table is then as if an earlier night had written it.
class BatchBaseline : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(parts_.plan().exit_code, 0);
    ASSERT_EQ(parts_.batch("run").exit_code, 0);
    ASSERT_EQ(parts_.batch("merge", {"--csv", table()}).exit_code, 0);
    std::istringstream stream(file_bytes(table()));
    batch::CsvReader reader(stream, table());
    for (std::vector<std::string> row; reader.next(row);) rows_.push_back(row);
    ASSERT_EQ(rows_.size(), 4u);
  }
  [[nodiscard]] std::string table() const { return parts_.path("earlier.csv"); }
  [[nodiscard]] std::string& field(std::size_t row, const std::string& column) {
    const auto found = std::ranges::find(rows_[0], column);
    EXPECT_NE(found, rows_[0].end()) << column;
    return rows_[row][static_cast<std::size_t>(found - rows_[0].begin())];
  }
  [[nodiscard]] test::ProcessResult merge(std::vector<std::string> more = {}) {
    std::string text;
    for (const auto& row : rows_) text += batch::csv_record(row);
    static_cast<void>(parts_.folder().write("earlier.csv", text));
    more.insert(more.begin(), {"--baseline", table()});
    return parts_.batch("merge", more);
  }

  test::SmallParts parts_{3};
  std::vector<std::vector<std::string>> rows_;
};

TEST_F(BatchBaseline, TellsNothingOfTheSame) {
  const auto run =
      merge({"--fail-on", "undercut > +0, total > +0, changed-parts > 0, new-parts > 0, gone-parts > 0"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("0 parts new, 0 gone, 0 changed, 3 as before"), std::string::npos) << run.out;
}

TEST_F(BatchBaseline, TellsWhatIsNewAndGone) {
  rows_.pop_back();
  rows_.push_back(rows_.back());
  field(3, "path") = "was there once.off";
  const std::string junit = parts_.path("gate.xml");
  const auto run = merge({"--fail-on", "new-parts > 0, undercut > +0", "--junit", junit});
  EXPECT_EQ(run.exit_code, 3);
  const std::string xml = test::file_bytes(junit);
  EXPECT_NE(xml.find("tests=\"3\" failures=\"1\">\n"), std::string::npos) << xml << "two parts and the batch";
  EXPECT_NE(xml.find("<testcase classname=\"all parts\" name=\"new-parts &gt; 0\"><failure "),
            std::string::npos)
      << xml;
  EXPECT_NE(run.out.find("1 part new, 1 gone, 0 changed, 2 as before"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("new-parts was 0, is 1"), std::string::npos) << run.err;
  EXPECT_EQ(merge({"--fail-on", "gone-parts > 1"}).exit_code, 0);
  EXPECT_EQ(merge({"--fail-on", "gone-parts >= 1"}).exit_code, 3);
}

TEST_F(BatchBaseline, TellsWhichFigureOfWhichPartChanged) {
  const double area = std::stod(field(2, "area"));
  field(2, "area") = fmt::format("{}", area / 1.25);
  const auto run = merge({"--fail-on", "total > +24.9%"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("0 parts new, 0 gone, 1 changed, 2 as before"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find(field(2, "path") + ": total was "), std::string::npos) << run.out;
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  EXPECT_NE(run.err.find(field(2, "path") + ": criterion failed: total > +24.9%"), std::string::npos)
      << run.err;
  EXPECT_EQ(merge({"--fail-on", "total > +25.1%"}).exit_code, 0);
  // What rounding may do is no change.
  field(2, "area") = fmt::format("{}", area * (1.0 + 1e-10));
  EXPECT_EQ(merge({"--fail-on", "total > +0, changed-parts > 0"}).exit_code, 0);
}

TEST_F(BatchBaseline, AFailureThatWasNoneIsAChange) {
  field(1, "state") = "failed";
  const auto run = merge({"--fail-on", "failed-parts > +0"});
  EXPECT_EQ(run.exit_code, 0) << "fewer have failed";
  EXPECT_NE(run.out.find(": state was failed, is done"), std::string::npos) << run.out;
}

TEST_F(BatchBaseline, PartsWithOtherSettingsAreKnownByTheirPath) {
  field(1, "settings") = "--direction=y";
  EXPECT_NE(merge().out.find("0 parts new, 0 gone, 0 changed, 3 as before"), std::string::npos);
}

TEST_F(BatchBaseline, RefusesWhatIsNoTable) {
  static_cast<void>(parts_.folder().write("other.csv", "a,b\n1,2\n"));
  for (const std::string file : {"other.csv", "none.csv", "night/batch.json"}) {
    const auto run = parts_.batch("merge", {"--baseline", parts_.path(file)});
    EXPECT_NE(run.exit_code, 0) << file;
    EXPECT_EQ(run.error_lines(), 1u) << run.err;
    EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
  }
  field(2, "area") = "many";
  const auto run = merge({"--csv", parts_.path("new.csv")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("line 3"), std::string::npos) << run.err;
  EXPECT_EQ(file_bytes(parts_.path("new.csv")), "") << "nothing is left behind";
}

TEST_F(BatchBaseline, RefusesCriteriaThatNothingAnswers) {
  const auto run = merge({"--fail-on", "actions > 0", "--csv", parts_.path("new.csv")});
  EXPECT_EQ(run.exit_code, 2) << "classify counts none";
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  EXPECT_EQ(file_bytes(parts_.path("new.csv")), "");
  EXPECT_EQ(merge({"--csv", table()}).exit_code, 2) << "what is read is not replaced";
  for (const char* change : {"undercut > +0", "new-parts > 0"})
    EXPECT_EQ(parts_.batch("merge", {"--fail-on", change, "--csv", parts_.path("new.csv")}).exit_code, 2)
        << "nothing to compare with";
}

TEST_F(BatchBaseline, TriesWhatFiguresAreNowWithoutATable) {
  const std::string junit = parts_.path("gate.xml");
  const auto run = parts_.batch(
      "merge", {"--fail-on", "verdict > side-actions, total > 1, failed-parts > 0", "--junit", junit});
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_EQ(run.out.find("against"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find(field(2, "path") + ": criterion failed: total > 1: total is "), std::string::npos)
      << run.err;
  EXPECT_NE(file_bytes(junit).find("tests=\"7\" failures=\"3\">"), std::string::npos) << file_bytes(junit);
  EXPECT_EQ(parts_.batch("merge", {"--fail-on", "verdict >= unknown"}).exit_code, 0);
}

TEST_F(BatchBaseline, TriesTheVerdict) {
  const std::string verdict = field(1, "verdict");
  ASSERT_EQ(merge({"--fail-on", "verdict > +0"}).exit_code, 2) << "a state is no number";
  ASSERT_EQ(merge({"--fail-on", "verdict >= " + verdict}).exit_code, 3);
  field(1, "verdict") = verdict == "two-plate" ? "undercuts" : "two-plate";
  const auto run = merge({"--fail-on", "verdict >= unknown"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find(": verdict was "), std::string::npos) << run.out;
  // What an earlier table has not is tried by what it is now.
  field(1, "path") = "was there once.off";
  EXPECT_EQ(merge({"--fail-on", "verdict >= " + verdict}).exit_code, 3);
}

}  // namespace
}  // namespace moldlight
