// What is said of a change between two revisions: its title and its figures as text.
#pragma once

#include <string>

#include "classify/figure_table.hpp"
#include "compare/revision_changes.hpp"

namespace moldlight {

/// Of a change; a dash where there is nothing.
struct ChangeWords {
  std::string before = "–", now = "–";  // areas
  std::string volume = {};              // that came or went, with its sign; empty where it is not known
  std::string more = {};
};

/// Of a comparison, which must outlive it.
class ChangeWording {
 public:
  explicit ChangeWording(const Comparison& comparison);

  [[nodiscard]] ChangeWords of(const RevisionChange& change) const;
  /// "undercut 556.0, was 540.1 · core …"
  [[nodiscard]] std::string regions() const;

 private:
  [[nodiscard]] ChangeWords of_place(const ChangedPlace& place) const;
  [[nodiscard]] ChangeWords of_undercut(const MatchedChange& change) const;
  [[nodiscard]] ChangeWords of_action(const MatchedChange& change) const;
  [[nodiscard]] std::string area_text(double value) const;
  [[nodiscard]] std::string length_text(double value) const;

  const Comparison& comparison_;
  FigureStyle style_;
};

/// "new surface", "core, now undercut", "undercut grown", "side action gone".
[[nodiscard]] std::string change_title(const Revisions& revisions, std::size_t change);

}  // namespace moldlight
