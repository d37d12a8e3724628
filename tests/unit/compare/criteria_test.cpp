// Criteria on figures before and after.
#include "compare/criteria.hpp"

#include <array>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace moldlight {
namespace {

constexpr std::array<std::string_view, 3> k_names = {"undercut", "actions", "reverse-draft"};
constexpr std::array<ComparedFigure, 3> k_figures = {{{"undercut", 100.0, 101.5, 0.1, 1000.0},
                                                      {"actions", 0.0, 2.0, 0.0, 0.0},
                                                      {"reverse-draft", 5.0, 5.05, 0.1, 1000.0}}};

std::size_t met(std::string_view text) {
  return met_criteria(parse_criteria(text, k_names), k_figures).size();
}

TEST(Criteria, CompareChangesAndValues) {
  EXPECT_EQ(met("undercut > +1%"), 1U);
  EXPECT_EQ(met("undercut > +1.5%"), 0U);
  EXPECT_EQ(met("undercut >= +1.5%"), 1U);
  EXPECT_EQ(met("undercut > +1"), 1U);
  EXPECT_EQ(met("undercut > +2"), 0U);
  EXPECT_EQ(met("undercut > 101"), 1U) << "what it is now";
  EXPECT_EQ(met("undercut > 10%"), 1U) << "of the part's surface";
  EXPECT_EQ(met("undercut > 11%"), 0U);
  EXPECT_EQ(met("actions > +0,undercut>+50%"), 1U);
  EXPECT_EQ(met(" actions > 0 , undercut > +1% "), 2U);
  EXPECT_EQ(met("actions > +500%"), 1U) << "there were none";
  EXPECT_EQ(met("undercut > -5"), 1U) << "it may grow by no more than -5";
}

TEST(Criteria, TakeNoChangeWithinItsErrorForOne) {
  EXPECT_EQ(met("reverse-draft > +0"), 0U);
  EXPECT_EQ(met("reverse-draft > +0%"), 0U);
  EXPECT_EQ(met("reverse-draft >= +0"), 1U);
}

TEST(Criteria, SayWhatFailed) {
  const auto sentences = met_criteria(parse_criteria("undercut > +1%", k_names), k_figures);
  ASSERT_EQ(sentences.size(), 1U);
  EXPECT_EQ(sentences.front(), "criterion failed: undercut > +1%: undercut was 100, is 101.5 (+1.50 %)");
}

TEST(Criteria, RefuseWhatMakesNoSense) {
  for (const std::string_view text :
       {"", ",", "undercut", "undercut <", "undercut > ", "undercut > +", "undercut > ten", "undercut > +1%%",
        "undercut > nan", "undercut > inf", "area > 1", "> 1", "undercut > 1,", "undercut > 1 2",
        "undercut > --1"}) {
    EXPECT_THROW(static_cast<void>(parse_criteria(text, k_names)), UsageError) << text;
  }
  EXPECT_THROW(static_cast<void>(met("actions > 5%")), UsageError);
  try {
    static_cast<void>(parse_criteria("a\nb > 1", k_names));
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
  }
}

TEST(Criteria, ShowNoShareThatIsNone) {
  EXPECT_EQ(change_percent(100.0, 101.0), "+1.00 %");
  EXPECT_EQ(change_percent(100.0, 99.0), "-1.00 %");
  for (const double after : {100.0, 99.9999, 100.0001}) EXPECT_EQ(change_percent(100.0, after), "") << after;
  EXPECT_EQ(change_percent(0.0, 5.0), "");
}

TEST(Criteria, TabulateWhatChanged) {
  const std::string table = figure_changes_table(k_figures);
  EXPECT_NE(table.find("undercut"), std::string::npos);
  EXPECT_EQ(table.find("reverse-draft"), std::string::npos) << "within its error";
  EXPECT_EQ(figure_changes_table(std::span(k_figures).last(1)), "No figure changed.\n");
}

}  // namespace
}  // namespace moldlight
