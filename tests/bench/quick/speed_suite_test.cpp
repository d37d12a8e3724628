// The speed suite goes on working: a quick run prints every kind of row with figures that mean something. How
// fast anything is does not matter here.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/process.hpp"

namespace moldlight {
namespace {

/// Numbers of the first line that begins with `name` after leading blanks and the words of the name.
std::vector<double> figures_after(const std::string& text, const std::string& name) {
  std::istringstream lines(text);
  std::vector<double> figures;
  for (std::string line; figures.empty() && std::getline(lines, line);) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start == std::string::npos || line.compare(start, name.size() + 1, name + " ") != 0) continue;
    std::istringstream words(line.substr(start + name.size()));
    for (std::string word; words >> word;) {
      if (word.find_first_not_of("0123456789.") != std::string::npos) continue;
      figures.push_back(std::stod(word));
    }
  }
  return figures;
}

TEST(SpeedSuite, QuickRunPrintsEveryRow) {
  const auto run = test::Process({MOLDLIGHT_BENCH_SPEED, "--quick"}, {}).finish();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* word : {"nan", "inf "}) EXPECT_EQ(run.out.find(word), std::string::npos) << run.out;
  for (const char* engine : {"rays", "rays, one thread", "gl", "exact regions", "paper on GL (a)"}) {
    const std::vector<double> figures = figures_after(run.out, engine);
    ASSERT_GE(figures.size(), 5u) << engine << " in\n" << run.out;
    for (const double figure : figures) {
      EXPECT_TRUE(std::isfinite(figure)) << engine;
      EXPECT_GE(figure, 0.0) << engine;
    }
    EXPECT_GT(figures[0], 0.0) << engine;
  }
  for (const char* section : {"load ", "classify ", "exact ", "exact summary ", "sweep ", "summary "})
    EXPECT_NE(run.out.find(std::string("\n") + section), std::string::npos) << section << " in\n" << run.out;
  const std::size_t summary = run.out.find("\nsummary ");
  ASSERT_NE(summary, std::string::npos);
  const std::vector<double> ratios = figures_after(run.out.substr(summary), "cable_clip");
  ASSERT_EQ(ratios.size(), 8u) << run.out;
  for (std::size_t i = 0; i < ratios.size(); ++i) EXPECT_GT(ratios[i], 0.0) << "column " << i << run.out;
  const std::vector<double> exact =
      figures_after(run.out.substr(run.out.find("\nexact summary ")), "cable_clip");
  ASSERT_EQ(exact.size(), 5u) << run.out;
  for (const double figure : exact) EXPECT_GT(figure, 0.0) << run.out;
  // Errors against exact rays stay small even with the few texels and rays of a quick run.
  EXPECT_LT(ratios[3], 1.0) << "per cent";
}

TEST(SpeedSuite, RefusesWhatItDoesNotKnow) {
  const auto run = test::Process({MOLDLIGHT_BENCH_SPEED, "--slow"}, {}).finish();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.error_lines(), 1u);
}

}  // namespace
}  // namespace moldlight
