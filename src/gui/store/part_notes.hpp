// The user's settings and bookmarks for one part, in a small JSON beside or away from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_settings.hpp"
#include "classify/settings.hpp"
#include "compare/comparison.hpp"
#include "gui/store/user_state.hpp"
#include "parting/draft/finish.hpp"
#include "parting/mold_settings.hpp"

namespace moldlight::gui {

/// A parting direction worth coming back to.
struct Bookmark {
  std::string note;
  glm::dvec3 direction{0, 0, 1};            // unit
  std::optional<ActionSettings> actions{};  // that were set for it, pins among them

  bool operator==(const Bookmark&) const = default;
};

/// How another revision is compared; its side actions are asked for as the part's own.
struct RevisionSettings : CompareSettings {
  bool each_best = false;  // B has its own best direction, else the part's

  bool operator==(const RevisionSettings&) const = default;
};
/// What is not among compare_options().
[[nodiscard]] std::span<const Option<RevisionSettings>> revision_options();

/// The draft that walls must have: what is said of draft depends on it, and its colours; no region does.
struct RequiredDraft : FinishSettings {
  double deg = 1.0;                       // [0.1, 10], of faces without a finish
  std::vector<FaceFinish> finishes = {};  // rising

  bool operator==(const RequiredDraft&) const = default;
};
[[nodiscard]] std::span<const Option<RequiredDraft>> required_draft_options();

/// What undo and redo go through.
struct EditedSettings : Query {
  LookSettings look;
  RequiredDraft required_draft = {};
  ActionSettings actions = {};
  MoldSettings mold = {};
  RevisionSettings revision = {};

  bool operator==(const EditedSettings&) const = default;
};

struct PartNotes {
  EditedSettings settings;
  std::vector<Bookmark> bookmarks;
  std::string unit = {};  // see ReadOptions::unit

  bool operator==(const PartNotes&) const = default;
};

/// Schema moldlight.view/3.
[[nodiscard]] std::string part_notes_json(const PartNotes& notes, const std::string& part_path);
/// Takes what part_notes_json writes, and an object of its settings alone. What the text does not
/// say stays as in `notes`. Throws UsageError that says what is wrong.
[[nodiscard]] PartNotes parse_part_notes(std::string_view json, PartNotes notes);

/// "<part>.moldlight.json" beside the part; used if it exists.
[[nodiscard]] std::string notes_path_beside(const std::string& part_path);
/// The file of this part's notes: beside it where one exists, else in the user's state folder; empty where
/// there is neither.
[[nodiscard]] std::string notes_path(const std::string& part_path);

}  // namespace moldlight::gui
