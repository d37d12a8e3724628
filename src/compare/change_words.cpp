#include "compare/change_words.hpp"

#include <fmt/format.h>

#include "classify/number_format.hpp"
#include "mold/direction.hpp"

namespace moldlight {

using Of = RevisionChange::Of;

ChangeWording::ChangeWording(const Comparison& comparison)
    : comparison_(comparison), style_(*comparison.a.model) {}

std::string ChangeWording::area_text(double value) const {
  return grouped(style_.text(FigureKind::area, value));
}

std::string ChangeWording::length_text(double value) const {
  return grouped(style_.with_unit(FigureKind::length, value));
}

ChangeWords ChangeWording::of(const RevisionChange& change) const {
  switch (change.of) {
    case Of::place:
      return of_place(comparison_.surface.places[change.number]);
    case Of::region: {
      const std::string area = area_text(comparison_.surface.regions[change.number].area);
      return {.before = area, .now = area, .more = "same surface, other region"};
    }
    case Of::undercut:
      return of_undercut(comparison_.undercuts[change.number]);
    case Of::action:
      return of_action(comparison_.actions[change.number]);
  }
  return {};
}

std::string ChangeWording::regions() const {
  std::string text;
  const Classification &a = comparison_.a.result, &b = comparison_.b.result;
  for (const Region region : {Region::undercut, Region::core, Region::cavity, Region::both}) {
    text += fmt::format("{}{} {}, was {}", text.empty() ? "" : "  ·  ", region_name(region),
                        area_text(b.areas[region]), area_text(a.areas[region]));
  }
  return fmt::format("{}  {}", text, powered_unit(comparison_.a.model->part, 2));
}

ChangeWords ChangeWording::of_place(const ChangedPlace& place) const {
  ChangeWords words;
  if (place.gone.area > 0.0) words.before = area_text(place.gone.area);
  if (place.added.area > 0.0) words.now = area_text(place.added.area);
  if (comparison_.surface.closed)
    words.volume = with_minus(grouped(style_.change(FigureKind::volume, place.volume.volume)));
  words.more = length_text(place.bounds.diagonal()) + " across";
  return words;
}

ChangeWords ChangeWording::of_undercut(const MatchedChange& change) const {
  ChangeWords words;
  const auto undercut = [&](const ComparedPart& part, std::size_t number, std::string& area) {
    const UndercutReport& one = part.plan->undercuts[number];
    area = area_text(one.undercut.area);
    return one.depth ? fmt::format("{} deep", length_text(*one.depth)) : std::string("not released");
  };
  std::string was, now;
  if (change.a) was = undercut(comparison_.a, *change.a, words.before);
  if (change.b) now = undercut(comparison_.b, *change.b, words.now);
  words.more = was.empty() || now.empty() || was == now ? (now.empty() ? was : now)
                                                        : fmt::format("{}, now {}", was, now);
  return words;
}

ChangeWords ChangeWording::of_action(const MatchedChange& change) const {
  ChangeWords words;
  const auto action = [&](const ActionPlan& plan, std::size_t number, std::string& area) {
    const SideAction& one = plan.actions[number];
    area = area_text(one.area);
    return with_minus(fmt::format("{} {} travel {}", facts(one.kind).singular, direction_words(one.direction),
                                  length_text(one.travel)));
  };
  std::string was, now;
  if (change.a) was = action(*comparison_.a.plan, *change.a, words.before);
  if (change.b) now = action(*comparison_.b.plan, *change.b, words.now);
  words.more = !(change.a && change.b)           ? was + now
               : change.kind == ChangeKind::same ? now
                                                 : fmt::format("{}, was {}", now, was);
  return words;
}

std::string change_title(const Revisions& revisions, std::size_t number) {
  const RevisionChange& change = revisions.changes[number];
  switch (change.of) {
    case Of::place:
      return change.kind == ChangeKind::changed ? "surface changed"
                                                : fmt::format("surface {}", change_name(change.kind));
    case Of::region: {
      const ChangedRegion& region = revisions.comparison.surface.regions[change.number];
      return fmt::format("{}, now {}", region_name(region.from), region_name(region.to));
    }
    case Of::undercut:
      return fmt::format("undercut {}", change_name(change.kind));
    case Of::action:
      return fmt::format("side action {}", change_name(change.kind));
  }
  return {};
}

}  // namespace moldlight
