// A batch in the window: its table, filtered and sorted, and a click that opens a part with its settings.
#include <filesystem>

#include "cli/small_parts.hpp"
#include "gui/jobs/batch_table.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

using moldlight::test::run_moldlight;

constexpr int k_batch_down = 264;  // GLFW's

/// The part along y by a list that says so, one that is broken, one without result.
class BatchInWindow : public WindowWithPart {
 protected:
  void SetUp() override {
    parts.add("junk.stl", "junk");
    static_cast<void>(parts.folder().write("list.csv",
                                           "path,direction,tau,unit\nparts/part-0000.off,y,2,mm\n"
                                           "parts/junk.stl,,,\nparts/part-0001.off,,,\n"));
    ASSERT_EQ(parts.plan("list.csv").exit_code, 0);
    ASSERT_EQ(parts.batch("run", {"--shard", "0/2"}).exit_code, 0);
    ASSERT_EQ(parts.batch("run", {"--shard", "1/2"}).exit_code, 0);
    window.app().open(parts.path("night"));
    window.wait_until_loaded();
    window.settle();
  }
  [[nodiscard]] bool shows(const std::string& text) const {
    for (const DrawnText& drawn : window.app().texts())
      if (drawn.text.find(text) != std::string::npos) return true;
    return false;
  }

  moldlight::test::SmallParts parts{2};
};

TEST_F(BatchInWindow, ShowsItsPartsWithWhatBecameOfThem) {
  ASSERT_TRUE(state().batch);
  EXPECT_TRUE(state().dialogs.batch);
  EXPECT_TRUE(shows("classify: 2 done, 1 failed, 0 missing"));
  for (const char* path : {"parts/part-0000.off", "parts/junk.stl", "parts/part-0001.off"})
    EXPECT_TRUE(shows(path)) << path;
  EXPECT_TRUE(shows("is text, but no STL")) << "why it failed";
}

TEST_F(BatchInWindow, SaysVerdictsAndNamesInFull) {
  window.resize({1440, 900});
  window.settle();
  click("row 0");
  window.wait_until_loaded();
  window.wait_until_measured();
  window.settle();
  const ScreenBox table = window.control("panel Batch");
  EXPECT_GT(table.max.x - table.min.x, 1000.0F) << "below the panels on the sides";
  for (const DrawnText& each : window.app().texts()) {
    const bool here = each.window.starts_with("##Batch");
    EXPECT_FALSE(here && each.text.find("…") != std::string::npos) << each.text;
  }
}

TEST_F(BatchInWindow, AClickOpensThePartWithItsSettings) {
  click("row 0");
  window.wait_until_loaded();
  EXPECT_TRUE(state().path.ends_with("parts/part-0000.off")) << state().path;
  EXPECT_EQ(direction(), glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_EQ(method().tau_deg, 2.0);
  EXPECT_EQ(state().model->part.unit, "mm");
  EXPECT_TRUE(state().dialogs.batch) << "the table stays";
  key({.key = 'L'});
  EXPECT_FALSE(state().dialogs.batch);
  key({.key = 'L'});
  EXPECT_TRUE(state().dialogs.batch) << "the table is a key away";
}

TEST_F(BatchInWindow, TypingFiltersAndAHeadingSorts) {
  window.type("0001");
  window.frames(3);
  EXPECT_TRUE(shows("parts/part-0001.off"));
  EXPECT_FALSE(shows("parts/part-0000.off"));
  key({.key = k_escape});
  key({.key = k_escape});
  EXPECT_FALSE(state().dialogs.batch);
}

TEST_F(BatchInWindow, HasVerdictUnitAndActions) {
  const std::vector<batch::RowColumn> columns = batch::used_columns(state().batch->rows);
  for (const auto column : {batch::RowColumn::verdict, batch::RowColumn::unit})
    EXPECT_NE(std::ranges::find(columns, column), columns.end()) << batch::column_name(column);
  const batch::PartResult& first = state().batch->rows[0];
  ASSERT_FALSE(first.sentence.empty());
  EXPECT_EQ(batch::cell_text(first, batch::RowColumn::verdict), first.sentence);
  EXPECT_EQ(batch::cell_text(first, batch::RowColumn::unit), "mm");
  EXPECT_TRUE(batch::cell_text(state().batch->rows[1], batch::RowColumn::verdict).starts_with("failed: "));
}

TEST_F(BatchInWindow, ArrowKeysGoFromPartToPart) {
  window.type("off");  // the broken one is left out
  window.frames(3);
  key({.key = k_batch_down});
  window.wait_until_loaded();
  const std::string first = state().path;
  EXPECT_TRUE(first.ends_with(".off")) << first;
  EXPECT_TRUE(state().dialogs.batch) << "the table stays";
  key({.key = k_batch_down});
  window.wait_until_loaded();
  const std::string second = state().path;
  EXPECT_TRUE(second.ends_with(".off"));
  EXPECT_NE(first, second);
  key({.key = k_up});
  window.wait_until_loaded();
  EXPECT_EQ(state().path, first);
}

TEST(BatchTable, OrdersAndFiltersRows) {
  std::vector<batch::PartResult> rows;
  for (const char* path : {"b.stl", "a.stl", "c.stl"}) {
    batch::PartResult row;
    row.path = path;
    row.state = batch::ResultState::done;
    rows.push_back(row);
  }
  const auto share = [&](std::size_t row, double undercut) {
    rows[row].figures[static_cast<std::size_t>(batch::Figure::area)] = 10.0;
    rows[row].figures[static_cast<std::size_t>(batch::Figure::undercut_area)] = undercut;
  };
  share(0, 1.0);
  share(2, 2.0);
  using Rows = std::vector<std::size_t>;
  EXPECT_EQ(batch::ordered_rows(rows, {}), (Rows{2, 0, 1})) << "what is not known comes last";
  EXPECT_EQ(batch::ordered_rows(rows, {.filter = {}, .column = batch::RowColumn::share, .descending = false}),
            (Rows{0, 2, 1}));
  EXPECT_EQ(batch::ordered_rows(rows, {.filter = {}, .column = batch::RowColumn::part, .descending = false}),
            (Rows{1, 0, 2}));
  EXPECT_EQ(batch::ordered_rows(
                rows, {.filter = "C.STL done", .column = batch::RowColumn::share, .descending = true}),
            (Rows{2}));
  EXPECT_TRUE(batch::ordered_rows(
                  rows, {.filter = "c.stl failed", .column = batch::RowColumn::share, .descending = true})
                  .empty());
}

}  // namespace
}  // namespace moldlight::gui::test
