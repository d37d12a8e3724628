// The report that the window writes: a page, a live one, and pages of paper, in the background.
#include <filesystem>

#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

using moldlight::test::file_bytes;

class WindowReports : public WindowWithPart {
 protected:
  WindowReports() {
    window.wait_until_measured();
    enter(Step::report);
  }

  /// Writes it, and waits until something is said of it.
  [[nodiscard]] const Toast& write() {
    click("Write the report");
    EXPECT_TRUE(state().exporting);
    for (int i = 0; i < 200'000 && state().toasts.empty(); ++i) window.frame();
    EXPECT_EQ(state().toasts.size(), 1U);
    EXPECT_FALSE(state().exporting);
    return state().toasts.front();
  }
  [[nodiscard]] std::string html() const { return part.output("cup-report.html"); }
  [[nodiscard]] std::string pdf() const { return part.output("cup-report.pdf"); }
  [[nodiscard]] bool live() const {
    return file_bytes(html()).find("<script type=\"application/json\" id=\"live\">") != std::string::npos;
  }
};

TEST_F(WindowReports, ALivePageAndPaperBesideThePart) {
  click("Live page");
  const Toast& said = write();
  EXPECT_FALSE(said.failure) << said.text;
  EXPECT_EQ(said.text, "Report written to " + html() + " and " + pdf());
  EXPECT_TRUE(live());
  const std::string page = file_bytes(html());
  EXPECT_NE(page.find("moldlight classify cup.obj"), std::string::npos) << "the command that makes it again";
  EXPECT_NE(page.find("--html=cup-report.html --live --pdf=cup-report.pdf"), std::string::npos);
  EXPECT_NE(page.find(verdict_card(state()).sentence), std::string::npos) << "the window's verdict";
  EXPECT_TRUE(file_bytes(pdf()).starts_with("%PDF"));
}

TEST_F(WindowReports, OfTheMoldThereIsNoLivePage) {
  click("Report of=Mold");
  click("Live page");
  click("Pages of paper (PDF)");
  const Toast& said = write();
  EXPECT_EQ(said.text, "Report written to " + html());
  EXPECT_FALSE(live());
  EXPECT_FALSE(std::filesystem::exists(pdf()));
}

TEST_F(WindowReports, WithoutASweepThereIsNoneOfDirections) {
  click("Report of=Directions");
  click("Write the report");
  EXPECT_FALSE(state().exporting);
  EXPECT_TRUE(state().toasts.empty());
}

TEST_F(WindowReports, GivenUpLeavesNoFile) {
  click("Live page");
  click("Write the report");
  ASSERT_TRUE(state().exporting);
  click("Cancel");
  for (int i = 0; i < 200'000 && state().toasts.empty(); ++i) window.frame();
  ASSERT_EQ(state().toasts.size(), 1U);
  EXPECT_EQ(state().toasts.front().text, "Nothing was written");
  EXPECT_FALSE(std::filesystem::exists(html()));
  EXPECT_FALSE(std::filesystem::exists(pdf()));
}

TEST_F(WindowReports, AFolderThatIsNotThereIsSaid) {
  click("Report path");
  key({.key = 'A', .ctrl = true});
  window.type("/nowhere/at/all");
  window.frames(2);
  const Toast& said = write();
  EXPECT_TRUE(said.failure);
  EXPECT_NE(said.text.find("/nowhere/at/all.html"), std::string::npos) << said.text;
  EXPECT_FALSE(state().dialogs.exporting) << "it was not asked for there";
}

}  // namespace
}  // namespace moldlight::gui::test
