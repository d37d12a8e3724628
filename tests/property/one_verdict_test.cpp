// One verdict and one count of a part and a direction, wherever it is shown, in JSON, text, pages, papers and
// the tables of batches: over the shared real parts along their three axes, and over the shipped ones.
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "batch/csv.hpp"
#include "batch/merge.hpp"
#include "classify/number_format.hpp"
#include "page/page.hpp"
#include "report/describe/describe.hpp"
#include "report/writers.hpp"
#include "support/manifest.hpp"
#include "support/pdf.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"
#include "sweep/sweep.hpp"
#include "unit/batch/small_batch.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_most_facets = 12000;  // what takes longer is the same code

Study swept_along(const std::shared_ptr<const PartModel>& model, const glm::dvec3& direction) {
  SweepSettings settings;
  settings.kinds = {};
  settings.user_directions = {direction};
  settings.actions = true;
  settings.refine = 0;
  return Study(model, {.sweep = settings});
}

/// What `moldlight batch merge` shows of these reports of a command: table and page.
void expect_in_tables(const std::string& command, const std::vector<nlohmann::ordered_json>& reports) {
  const test::ScratchFolder folder;
  fs::create_directories(folder.file("night"));
  const batch::Manifest manifest = batch::test_batch::plan(folder.file("night"), reports.size(), command);
  const std::vector<batch::Row> rows = batch::test_batch::rows_of(manifest);
  for (std::size_t k = 0; k < reports.size(); ++k)
    batch::test_batch::put(manifest, rows[k], batch::ResultState::done,
                           {{"outcome", "done"}, {"tries", 1}, {"elapsed_s", 0.5}, {"report", reports[k]}});
  batch::merge(manifest, {.csv = folder.file("all.csv"), .sqlite = {}, .html = folder.file("all.html")},
               Progress());
  const std::string page = test::file_bytes(folder.file("all.html"));
  std::istringstream stream(test::file_bytes(folder.file("all.csv")));
  batch::CsvReader table(stream, "all.csv");
  std::vector<std::string> names, fields;
  ASSERT_TRUE(table.next(names));
  const auto field = [&](std::string_view name) {
    return fields.at(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin()));
  };
  for (const nlohmann::ordered_json& report : reports) {
    const nlohmann::ordered_json& verdict = report.at("verdict");
    ASSERT_TRUE(table.next(fields));
    EXPECT_EQ(field("verdict"), verdict["state"].get<std::string>());
    EXPECT_EQ(field("sentence"), verdict["sentence"].get<std::string>());
    EXPECT_EQ(field("undercuts"), verdict["undercuts"].dump());
    EXPECT_NE(page.find(page::script_json(verdict["sentence"])), std::string::npos) << verdict["sentence"];
  }
}

/// The verdict leads the page, and the paper where it can be read.
void expect_on_pages(report::Report shown, const Verdict& verdict) {
  shown.still.light = empty_image(4, 3);  // what stands for the view, which needs the GL
  EXPECT_NE(report::html_page(shown).find(page::html_text(with_minus(verdict.sentence))), std::string::npos);
  if (!test::has_pdf_reader()) return;
  const std::vector<test::PdfPage> pages = test::pdf_pages(report::pdf_document(shown, report::Paper::a4));
  ASSERT_FALSE(pages.empty());
  std::string words;
  for (const test::PdfWord& word : pages.front().words) words += word.text + " ";
  EXPECT_NE(words.find(with_minus(verdict.sentence)), std::string::npos) << words;
}

using Reports = std::array<std::vector<nlohmann::ordered_json>, 3>;  // of classify, actions, sweep

/// Every text and JSON that has a verdict, made of its own study, as different programs would.
void expect_one_verdict(const std::shared_ptr<const PartModel>& model, const glm::dvec3& direction,
                        const std::string& what, Reports& reports, bool on_pages) {
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
    const bool can_be_built = expected->good() || expected->state == VerdictState::side_actions;
    EXPECT_EQ(shown->tone == report::Tone::good, can_be_built);
    if (on_pages) expect_on_pages(*shown, *expected);
  }
  Study sweep = swept_along(model, direction);
  const SweepResult& swept = sweep.find<SweepResult>(progress);
  ASSERT_EQ(swept.candidates.size(), 1U);
  const std::optional<Verdict> listed = verdict_of(*model, swept.candidates.front());
  ASSERT_TRUE(listed.has_value());
  EXPECT_EQ(listed->state, verdict.state);
  EXPECT_EQ(listed->sentence, verdict.sentence);
  reports[0].push_back(classify_json(regions, progress));
  reports[1].push_back(actions_json(actions, progress));
  reports[2].push_back(sweep_json(sweep, progress));
}

void expect_one_verdict(const fs::path& file, bool on_pages) {
  const auto model = load_part(file.string(), {}, Progress());
  Reports reports;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    expect_one_verdict(model, direction, file.filename().string() + " along " + "xyz"[axis], reports,
                       on_pages);
  }
  for (const auto& [command, found] :
       {std::pair("classify", &reports[0]), {"actions", &reports[1]}, {"sweep", &reports[2]}}) {
    SCOPED_TRACE(command);
    expect_in_tables(command, *found);
  }
}

TEST(OneVerdict, OfTheShippedParts) {
  for (const auto& entry : fs::directory_iterator(test::asset_folder() / "parts"))
    if (entry.path().extension() == ".stl") expect_one_verdict(entry.path(), true);
}

TEST(OneVerdict, OfTheSharedParts) {
  const auto folder = test::shared_folder();
  if (!folder) GTEST_SKIP() << "no shared parts here";
  std::size_t used = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (!row.facets || *row.facets > k_most_facets || row.file.find('/') != std::string::npos) continue;
    expect_one_verdict(*folder / "parts" / row.file, false);
    ++used;
  }
  std::cout << used << " shared parts used\n";
  EXPECT_GT(used, 20U);
}

}  // namespace
}  // namespace moldlight
