#include "gui/view/revision_view.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "classify/figure_table.hpp"
#include "classify/still_picture.hpp"
#include "compare/change_words.hpp"
#include "gui/draw/widgets.hpp"
#include "mold/draft.hpp"
#include "render/surface_sheets.hpp"

namespace moldlight::gui {

namespace {

using Of = RevisionChange::Of;

/// Of what the picture's height spans, by which lit surface is drawn nearer to the eye: more than the depth
/// of some pixels, by which refining moves the part's.
constexpr double k_nearer = 0.003;
constexpr double k_least_change_reach = 0.04;  // of a picture of a change, unit frame

std::string change_area_text(const AppState& state, double area) {
  return FigureStyle(*state.model).with_unit(FigureKind::area, area);
}

}  // namespace

glm::dmat4 nearer(const Camera& camera) {
  const double by = k_nearer * camera.height;
  if (camera.projection == Projection::orthographic)
    return glm::translate(glm::dmat4(1.0), by * camera.toward_viewer());
  const glm::dmat4 to_eye = glm::translate(glm::dmat4(1.0), camera.eye());
  return glm::translate(glm::scale(to_eye, glm::dvec3(1.0 - by / camera.eye_distance())), -camera.eye());
}

Camera FrameTie::camera(Camera camera) const {
  camera.target = point(camera.target);
  camera.height *= from.diagonal / to.diagonal;
  return camera;
}

CutPlane FrameTie::plane(CutPlane plane) const {
  plane.foot = point(plane.foot);
  plane.offset = glm::dot(plane.normal, point(plane.offset * plane.normal));
  plane.extent *= from.diagonal / to.diagonal;
  return plane;
}

FrameTie tie_of(const AppState& state, const PreparedRevision& revision) {
  return {state.model->frame, revision.part.model->frame};
}

float picture_shift(const SplitView& split, const glm::ivec2& window, int side) {
  return static_cast<float>(window.x - split.left - side);
}

bool is_lit(const AppState& state) {
  const RevisionState& revisions = state.revisions;
  return revisions.result && revisions.prepared && revisions.result->comparison.a.model == state.model &&
         revisions.result->comparison.b.model == revisions.prepared->part.model;
}

ViewBody lit_body(const PartModel& model, const SplitMesh& surface, Colour colour,
                  const std::optional<CutPlane>& cut) {
  SurfaceSheets sheets(model.frame, colour, cut);
  for (std::size_t k = 0; k < surface.pieces.size(); ++k) {
    std::array corners{surface.corner(k, 0), surface.corner(k, 1), surface.corner(k, 2)};
    const glm::dvec3& normal = model.geometry.normals[surface.pieces[k].facet];
    sheets.add(corners, normal);
    std::swap(corners[1], corners[2]);
    sheets.add(corners, -normal);
  }
  return std::move(sheets.body);
}

const std::shared_ptr<const std::vector<ViewBody>>& LitBodies::of(const AppState& state, bool second,
                                                                  const std::optional<CutPlane>& cut) {
  const auto result = is_lit(state) ? state.revisions.result : nullptr;
  const auto& chosen = state.revision_choices.chosen;
  if (result != result_ || chosen != chosen_ || cut != cut_) {
    result_ = result;
    chosen_ = chosen;
    cut_ = cut;
    bodies_ = result ? std::make_shared<const std::vector<ViewBody>>(lit_bodies(*result, second, chosen, cut))
                     : nullptr;
  }
  return bodies_;
}

std::vector<glm::dmat4> lit_places(const AppState& state, const Camera& camera) {
  if (!is_lit(state)) return {};
  const bool regions =
      state.revisions.result->comparison.a.result.direction == state.settings.direction.unit();
  const glm::dmat4 seen = nearer(camera);
  const glm::dmat4 away = glm::translate(glm::dmat4(1.0), 100.0 * k_scene_radius * camera.toward_viewer());
  return {seen, regions ? seen : away, seen};
}

RevisionHover revision_hover(const AppState& state, bool second, const PickedPoint& point) {
  const RevisionState& revisions = state.revisions;
  RevisionHover hover;
  hover.second = second;
  hover.point = point;
  hover.place = glm::dvec3(point.position);
  if (second) {
    const FrameTie tie = tie_of(state, *revisions.prepared);
    hover.place = FrameTie{tie.to, tie.from}.point(hover.place);
  }
  if (point.facet == k_no_facet) return hover;
  const PartModel& model = second ? *revisions.prepared->part.model : *state.model;
  const bool own = second && is_lit(state) && !revisions.stale;
  const glm::dvec3 direction =
      own ? revisions.result->comparison.b.result.direction : state.settings.direction.unit();
  hover.draft_deg = draft_angle_deg(model.geometry.normals[point.facet], direction);
  if (is_lit(state)) hover.change = revisions.result->change_at(second, point);
  return hover;
}

std::vector<std::string> revision_lines(const AppState& state) {
  const auto& hover = state.revisions.hover;
  if (!hover || hover->point.facet == k_no_facet) return {};
  std::vector<std::string> lines;
  if (hover->second)
    lines.push_back(fmt::format("{}  ·  draft {:.1f}°", region_name(hover->point.region), hover->draft_deg));
  if (!hover->change) return lines;
  const Revisions& result = *state.revisions.result;
  const RevisionChange& change = result.changes[*hover->change];
  const SurfaceChange& surface = result.comparison.surface;
  lines.push_back(fmt::format("{}  ·  number {}", change_title(result, *hover->change), *hover->change + 1));
  if (change.of == Of::region) {
    lines.push_back(fmt::format("{} on both", change_area_text(state, surface.regions[change.number].area)));
    return lines;
  }
  const ChangedPlace& place = surface.places[change.number];
  lines.push_back(fmt::format("gone {}  ·  new {}", change_area_text(state, place.gone.area),
                              change_area_text(state, place.added.area)));
  return lines;
}

std::vector<glm::vec3> surroundings(const AppState& state, const RevisionChange& change) {
  const UnitFrame& frame = state.model->frame;
  const Bounds& box = change.bounds;
  const double reach = std::max(0.6 * box.diagonal() / frame.diagonal, k_least_change_reach);
  std::vector<glm::vec3> points = points_around(frame.to_unit(box.center()), reach);
  points.push_back(frame.to_unit(box.min));
  points.push_back(frame.to_unit(box.max));
  return points;
}

glm::dquat seen_from(const AppState& state, std::size_t change) {
  const Revisions& result = *state.revisions.result;
  // On the part that has more of it.
  std::array<double, 2> areas{};
  std::array<std::shared_ptr<const SplitMesh>, 2> marked;
  for (const bool second : {false, true}) {
    const std::size_t k = second ? 1 : 0;
    const std::vector<LitPolygon> lit = result.lit_of(second, change);
    for (const LitPolygon& one : lit) areas[k] += polygon_area(*one.polygon);
    const std::vector<PieceIndex> pieces = result.pieces_of(second, change);
    areas[k] += static_cast<double>(pieces.size());
    auto split = std::make_shared<SplitMesh>(*marked_split(result.part(second), lit));
    for (const PieceIndex piece : pieces) split->pieces[piece].region = Region::undercut;
    marked[k] = std::move(split);
  }
  const std::size_t more = areas[0] > areas[1] ? 0 : 1;
  const ComparedPart& part = result.part(more == 1);
  return revealing_orientation(*part.model, std::span(&marked[more], 1), part.result.direction);
}

void draw_revision_names(const Ui& ui, const AppState& state, const SplitView& split, int side) {
  const float window = screen_size().x, left = static_cast<float>(split.left);
  const auto draw = [&](float from, float to, std::string_view what, const std::string& path) {
    const float room = to - from - ui.px(24);
    const std::string text =
        fitted(ui.fonts.body, fmt::format("{}  ·  {}", what, std::filesystem::path(path).filename().string()),
               std::max(room, ui.px(40)));
    const glm::vec2 size = tag_size(ui, text);
    draw_tag(ui, {0.5F * (from + to), ui.px(k_bar_height + 6) + 0.5F * size.y}, text, ui.colours->text);
  };
  // Beside the titles of folded panels, where there is room.
  const float beside = std::max(static_cast<float>(side), ui.px(k_panel_width + 16));
  if (left - beside < ui.px(96)) return;
  draw(beside, left, "A, before", state.path);
  draw(left, window - beside, "B, now", state.revisions.path);
}

RevisionPicture::RevisionPicture(const gl::Context& context, std::shared_ptr<const PreparedRevision> revision)
    : context_(&context), revision_(std::move(revision)), scene_(context, revision_->part) {}

bool RevisionPicture::draw(const AppState& state, const SplitView& split, SceneSettings settings) {
  const FrameTie tie = tie_of(state, *revision_);
  const RevisionState& revisions = state.revisions;
  settings.view.camera = tie.camera(split.camera);
  if (settings.view.settings.cut) settings.view.settings.cut = tie.plane(*settings.view.settings.cut);
  settings.view.marks = {};
  settings.bodies = lit_places(state, settings.view.camera);
  settings.samples = nullptr;
  settings.split = nullptr;
  if (is_lit(state) && !revisions.stale) {
    const Classification& result = revisions.result->comparison.b.result;
    settings.query.direction = result.direction;
    settings.split = result.split;
  }
  // Until exact regions are known, maps that rest are all there is.
  settings.maps_looked_at = settings.maps_looked_at || !settings.split;
  scene_.take_bodies(lit_.of(state, true, settings.view.settings.cut));
  const gl::ColourTarget& target = sized(target_, *context_, split.size);
  return scene_.draw({target.framebuffer(), split.size}, settings);
}

}  // namespace moldlight::gui
