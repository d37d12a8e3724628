// Settings and bookmarks of a part: written, read back, and read as an older version wrote them.
#include "gui/store/part_notes.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace moldlight::gui {
namespace {

TEST(PartNotes, AreReadBackAsTheyWereWritten) {
  PartNotes notes;
  notes.method.direction = {0.6, 0.0, 0.8};
  notes.method.resolution = 512;
  notes.look.regions_by = RegionsBy::maps;
  notes.look.mark_difference = true;
  notes.bookmarks.push_back({.note = "hook", .direction = {0, 1, 0}});
  EXPECT_EQ(parse_part_notes(part_notes_json(notes, "part.stl"), {}), notes);
}

/// What had no other default then is not taken for a wish.
TEST(PartNotes, OfAnOlderVersionKeepWhatStillMeansTheSame) {
  const PartNotes notes = parse_part_notes(
      R"({"schema": "moldlight.view/1", "settings": {"tau_deg": 2.5, "kernel": 3, "readout": "samples",
          "exact_rays": true}, "look": {"hatching": false}})",
      {});
  PartNotes expected;
  expected.method.tau_deg = 2.5;
  expected.look.hatching = false;
  EXPECT_EQ(notes, expected);
  EXPECT_EQ(parse_part_notes(R"({"schema": "moldlight.view/1", "bookmarks": []})", {}), PartNotes{});
  EXPECT_THROW(static_cast<void>(parse_part_notes(R"({"schema": "moldlight.view/9"})", {})), UsageError);
}

}  // namespace
}  // namespace moldlight::gui
