// Settings and bookmarks of a part: written, read back, and read as an older version wrote them.
#include "gui/store/part_notes.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace moldlight::gui {
namespace {

TEST(PartNotes, AreReadBackAsTheyWereWritten) {
  PartNotes notes;
  notes.settings.direction = glm::dvec3(0.6, 0.0, 0.8);
  notes.settings.method.resolution = 512;
  notes.settings.look.regions_by = RegionsBy::maps;
  notes.settings.required_draft.deg = 2.5;
  notes.settings.required_draft.texture_rule = TextureRule::inch;
  notes.settings.required_draft.finishes = {{3, {"shut-off", 3.0}},
                                            {12, *parse_finish("texture 0.05 mm", TextureRule::inch)}};
  notes.settings.look.mark_difference = true;
  notes.unit = "in";
  notes.settings.actions.clearance_mm = 5.0;
  notes.settings.actions.side_directions = {{0.6, 0.0, 0.8}};
  notes.settings.actions.pins = {{.point = {1, 2.5, -3}, .area = 12.75, .kind = ActionKind::lifter},
                                 {.point = {0.1, 0, 0}, .area = 3, .kind = std::nullopt}};
  notes.bookmarks.push_back({.note = "hook", .direction = {0, 1, 0}});
  notes.bookmarks.push_back({.note = "slide", .direction = {1, 0, 0}, .actions = notes.settings.actions});
  EXPECT_EQ(parse_part_notes(part_notes_json(notes, "part.stl"), {}), notes);
}

TEST(PartNotes, KeepADirectionAsItWasTyped) {
  const PartNotes notes = parse_part_notes(R"({"direction": [0, -4, 0], "tau_deg": 2.5})", {});
  EXPECT_EQ(notes.settings.direction.given(), glm::dvec3(0, -4, 0));
  EXPECT_EQ(notes.settings.direction.unit(), glm::dvec3(0, -1, 0));
  EXPECT_EQ(notes.settings.method.tau_deg, 2.5);
  EXPECT_EQ(parse_part_notes(part_notes_json(notes, "part.stl"), {}), notes);
  for (const char* bad :
       {R"({"direction": [0, 0, 0]})", R"({"direction": [0, 1]})", R"({"direction": null})"})
    EXPECT_THROW(static_cast<void>(parse_part_notes(bad, {})), UsageError) << bad;
}

/// What had no other default then is not taken for a wish.
TEST(PartNotes, OfAnOlderVersionKeepWhatStillMeansTheSame) {
  const PartNotes notes = parse_part_notes(
      R"({"schema": "moldlight.view/1", "settings": {"tau_deg": 2.5, "kernel": 3, "readout": "samples",
          "exact_rays": true}, "look": {"hatching": false}})",
      {});
  PartNotes expected;
  expected.settings.method.tau_deg = 2.5;
  expected.settings.look.hatching = false;
  EXPECT_EQ(notes, expected);
  EXPECT_EQ(parse_part_notes(R"({"schema": "moldlight.view/1", "bookmarks": []})", {}), PartNotes{});
  EXPECT_THROW(static_cast<void>(parse_part_notes(R"({"schema": "moldlight.view/9"})", {})), UsageError);
}

TEST(PartNotes, OfVersionTwoTellALookInItsOwnWords) {
  const PartNotes notes = parse_part_notes(
      R"({"schema": "moldlight.view/2", "look": {"others_opacity": 0.25, "section": true,
          "section_height": 0.75, "contour_edges": true}})",
      {});
  PartNotes expected;
  expected.settings.look.transparency = 0.75;
  expected.settings.look.section = Section::across;
  expected.settings.look.section_at = 0.75;
  expected.settings.look.parting_line = true;
  EXPECT_EQ(notes, expected);
  EXPECT_EQ(parse_part_notes(R"({"schema": "moldlight.view/2", "look": {"section": false}})", {}),
            PartNotes{});
}

TEST(PartNotes, RefuseAUnitThatIsNone) {
  for (const char* bad : {R"("furlong")", "7", "null"}) {
    const std::string text = fmt::format(R"({{"schema": "moldlight.view/3", "unit": {}}})", bad);
    EXPECT_THROW(static_cast<void>(parse_part_notes(text, {})), UsageError) << bad;
  }
}

TEST(PartNotes, RefuseInOneLineWhateverIsInThem) {
  for (const char* bad :
       {R"({"back\nd": 1})", R"({"kernel_shape": "one\nsided"})", R"({"tau_deg": "1\n2"})"}) {
    try {
      static_cast<void>(parse_part_notes(bad, {}));
      ADD_FAILURE() << bad;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
    }
  }
}

/// Whose squared length is no double.
TEST(PartNotes, BookmarksOfAnyLengthAreDirections) {
  const PartNotes notes = parse_part_notes(
      R"({"schema": "moldlight.view/2", "bookmarks": [{"direction": [0, 3e200, 4e200]},
          {"direction": [0, 0, -1e-200]}]})",
      {});
  ASSERT_EQ(notes.bookmarks.size(), 2U);
  EXPECT_NEAR(glm::distance(notes.bookmarks[0].direction, glm::dvec3(0, 0.6, 0.8)), 0.0, 1e-15);
  EXPECT_EQ(notes.bookmarks[1].direction, glm::dvec3(0, 0, -1));
}

}  // namespace
}  // namespace moldlight::gui
