// A report as a terminal shows it.
#include <gtest/gtest.h>

#include "report/writers.hpp"

namespace moldlight::report {
namespace {

Report small_report() {
  Report report;
  report.part = "clip.stl";
  report.subject = "along −z";
  report.sentence = "1 slide releases the undercut.";
  report.lead = {"2 marks are ignored."};
  Table table{{{"region", true},
               {"area mm²"},
               {"why", true, TableColumnRoom::wide},
               {"meaning", true, TableColumnRoom::pages}},
              {}};
  table.rows.push_back({{{"Undercut"}, {"−12.5"}, {"because"}, {"hidden"}}, Mark{{}, true, "\033[31m"}});
  table.rows.push_back({{{"Core"}, {"7"}, {"so"}, {"seen"}}});
  FigureGrid grid;
  grid.figures = {{"Volume", {"3.5"}, "mm³", "closed", "0.1"}, {"Steepest", {"60.0°"}}};
  report.sections = {{"Regions", {table, grid, Text{"Done."}}}, {"Of pages", {Text{"Left out."}}, true}};
  return report;
}

TEST(TextWriter, AlignsTablesAndGrids) {
  EXPECT_EQ(to_text(small_report(), {}),
            "1 slide releases the undercut.\n"
            "  2 marks are ignored.\n"
            "\n"
            "clip.stl along -z\n"
            "\n"
            "Regions\n"
            "region    area mm²\n"
            "Undercut     -12.5\n"
            "Core             7\n"
            "Volume    3.5 mm³ ± 0.1, closed\n"
            "Steepest  60.0°\n"
            "Done.\n");
}

TEST(TextWriter, ShowsMoreWhereThereIsRoom) {
  const std::string wide = to_text(small_report(), {.wide = true});
  EXPECT_NE(wide.find("because"), std::string::npos);
  EXPECT_EQ(wide.find("hidden"), std::string::npos) << "pages alone have it";
}

TEST(TextWriter, ColoursOnRequestOnly) {
  EXPECT_EQ(to_text(small_report(), {}).find('\033'), std::string::npos);
  const std::string coloured = to_text(small_report(), {.colour = true});
  EXPECT_NE(coloured.find("\033[31mUndercut\033[0m"), std::string::npos) << coloured;
}

TEST(TextWriter, HasOneRowOfWhatIsTiny) {
  Report report = small_report();
  Table& table = std::get<Table>(report.sections.front().blocks.front());
  table.tiny = "7 tiny, ignored";
  EXPECT_NE(to_text(report, {}).find("\nCore             7\n7 tiny, ignored\nVolume"), std::string::npos);
  while (table.rows.size() < 57) table.rows.push_back(table.rows.back());
  EXPECT_NE(to_text(report, {}).find("\n… 57 in all; --json lists them.\n7 tiny, ignored\n"),
            std::string::npos);
}

TEST(TextWriter, EndsLongTablesWithTheirNumber) {
  Report report = small_report();
  Table& table = std::get<Table>(report.sections.front().blocks.front());
  while (table.rows.size() < 57) table.rows.push_back(table.rows.back());
  EXPECT_NE(to_text(report, {}).find("\n… 57 in all; --json lists them.\n"), std::string::npos);
  table.rest = "… 99 in all.";
  EXPECT_NE(to_text(report, {}).find("\n… 99 in all.\n"), std::string::npos)
      << "what the table has of its own";
}

}  // namespace
}  // namespace moldlight::report
