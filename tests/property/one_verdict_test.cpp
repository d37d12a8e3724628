// One verdict and one count of a part and a direction, wherever it is shown: over the shared real parts along
// their three axes, and over the shipped ones.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "classify/figures.hpp"
#include "report/describe/describe.hpp"
#include "report/text_writer.hpp"
#include "support/manifest.hpp"
#include "support/shared_parts.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_most_facets = 12000;  // what takes longer is the same code

SweepResult swept_along(const std::shared_ptr<const PartModel>& model, const glm::dvec3& direction) {
  SweepSettings settings;
  settings.kinds = {};
  settings.user_directions = {direction};
  settings.actions = true;
  settings.refine = 0;
  return run_sweep(model, settings, Progress(), {});
}

/// Every text and JSON that has a verdict, made of its own study, as different programs would.
void expect_one_verdict(const std::shared_ptr<const PartModel>& model, const glm::dvec3& direction,
                        const std::string& what) {
  SCOPED_TRACE(what);
  Questions questions;
  questions.query.direction = direction;
  Study regions(model, questions);
  questions.with_actions = true;
  Study actions(model, questions);
  const Progress progress;
  const Verdict counted = regions.verdict(progress), verdict = actions.verdict(progress);
  EXPECT_EQ(counted.undercuts, verdict.undercuts);
  EXPECT_EQ(counted.specks, verdict.specks);
  EXPECT_NEAR(counted.undercut_area, verdict.undercut_area, 1e-9 * model->geometry.total_area);
  EXPECT_EQ(counted.good(), verdict.good());
  EXPECT_EQ(counted.state == VerdictState::unknown, verdict.state == VerdictState::unknown);

  EXPECT_EQ(classify_json(regions, progress)["verdict"], verdict_json(counted));
  EXPECT_EQ(actions_json(actions, progress)["verdict"], verdict_json(verdict));
  const report::Report of_regions = report::classify_report({model, progress}, regions),
                       of_actions = report::actions_report({model, progress}, actions);
  for (const auto& [shown, expected] : {std::pair(&of_regions, &counted), {&of_actions, &verdict}}) {
    EXPECT_TRUE(report::to_text(*shown, {}).starts_with(expected->sentence + "\n")) << expected->sentence;
    EXPECT_EQ(shown->sentence, with_minus(expected->sentence)) << "on pages";
    EXPECT_EQ(shown->tone == report::Tone::good, expected->releasable());
  }
  const SweepResult swept = swept_along(model, direction);
  ASSERT_EQ(swept.candidates.size(), 1U);
  const std::optional<Verdict> listed = verdict_of(*model, swept.candidates.front());
  ASSERT_TRUE(listed.has_value());
  EXPECT_EQ(listed->state, verdict.state);
  EXPECT_EQ(listed->sentence, verdict.sentence);
}

void expect_one_verdict(const fs::path& file, const Progress& progress) {
  const auto model = load_part(file.string(), {}, progress);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    expect_one_verdict(model, direction, file.filename().string() + " along " + "xyz"[axis]);
  }
}

TEST(OneVerdict, OfTheShippedParts) {
  for (const auto& entry : fs::directory_iterator(test::asset_folder() / "parts"))
    if (entry.path().extension() == ".stl") expect_one_verdict(entry.path(), Progress());
}

TEST(OneVerdict, OfTheSharedParts) {
  const auto folder = test::shared_folder();
  if (!folder) GTEST_SKIP() << "no shared parts here";
  std::size_t used = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (!row.facets || *row.facets > k_most_facets || row.file.find('/') != std::string::npos) continue;
    expect_one_verdict(*folder / "parts" / row.file, Progress());
    ++used;
  }
  std::cout << used << " shared parts used\n";
  EXPECT_GT(used, 20U);
}

}  // namespace
}  // namespace moldlight
