// Two revisions for a page's view.
#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "compare/compare_picture.hpp"
#include "report/describe/parts.hpp"

namespace moldlight::report {

namespace {

/// Half of what the part takes along an axis, about the centre of the view.
double half_extent(const PartModel& model, const glm::dvec3& centre, const glm::dvec3& axis) {
  double most = 0.0;
  for (const glm::dvec3& corner : model.health.bounds.corners())
    most = std::max(most, std::abs(glm::dot(corner - centre, axis)));
  return most;
}

void add_lit(const Comparison& comparison, Revision revision, const glm::dvec3& shift, ModelView& view) {
  const FigureStyle style(*comparison.a.model);
  for (StillBody& body : lit_bodies(comparison, revision)) {
    const auto group = static_cast<std::uint16_t>(view.groups.size());
    // What is of another region is lit on both parts, and is one line of the legend.
    const std::string name = body.label == "gone"  ? "Gone"
                             : body.label == "new" ? "New"
                                                   : "Of another region";
    const auto before = std::ranges::find(view.groups, name, &ViewGroup::name);
    const double lit = body.label == "gone"  ? comparison.surface.gone.area
                       : body.label == "new" ? comparison.surface.added.area
                                             : comparison.surface.other_region();
    ViewGroup added{.colour = body.colour, .stays_opaque = true, .shift = shift, .without_edges = true};
    if (before == view.groups.end()) {
      added.name = name;
      added.aside = style.with_unit(FigureKind::area, lit);
    } else {
      added.shown_with = static_cast<std::size_t>(before - view.groups.begin());
    }
    view.groups.push_back(std::move(added));
    std::vector<std::uint16_t> groups(body.mesh.facets.size(), group);
    view.surfaces.push_back({std::move(body.mesh), std::move(groups)});
  }
}

}  // namespace

ModelView comparison_view(const ReportContext& context, const Comparison& comparison,
                          const glm::dvec3& to_viewer) {
  ModelView view = region_view(context, comparison.b.result, to_viewer);
  ReportContext of_a = context;
  of_a.model = comparison.a.model;
  ModelView a = region_view(of_a, comparison.a.result, to_viewer);
  const glm::dvec3 right = glm::normalize(glm::cross(view.direction, to_viewer));
  constexpr double k_room = 1.08;  // between the parts
  const glm::dvec3 aside = k_room * right *
                           std::max(half_extent(*comparison.a.model, view.centre, right),
                                    half_extent(*comparison.b.model, view.centre, right));
  const FigureStyle style(*comparison.a.model);
  view.opens = "Move the parts apart";
  view.opened = 1.0;
  for (const Region region : k_regions) {
    ViewGroup& group = view.groups[static_cast<std::size_t>(region)];
    group.aside = fmt::format("{} → {}", style.text(FigureKind::area, comparison.a.result.areas[region]),
                              style.with_unit(FigureKind::area, comparison.b.result.areas[region]));
    group.shift = aside;
  }
  const std::size_t own = view.groups.size();
  for (std::size_t k = 0; k < a.groups.size(); ++k) {
    ViewGroup group = a.groups[k];
    group.name.clear();
    group.aside.clear();
    group.shift = -aside;
    group.shown_with = k;
    view.groups.push_back(std::move(group));
  }
  for (std::uint16_t& group : a.surfaces.front().group_of_facet)
    group = static_cast<std::uint16_t>(group + own);
  view.surfaces.push_back(std::move(a.surfaces.front()));
  add_lit(comparison, Revision::a, -aside, view);
  add_lit(comparison, Revision::b, aside, view);
  return view;
}

}  // namespace moldlight::report
