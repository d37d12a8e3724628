// The window's view of its part: the picture, its camera, the surface under the cursor.
#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "classify/still_picture.hpp"
#include "gl/program.hpp"
#include "gui/app.hpp"
#include "gui/view/mold_view.hpp"
#include "gui/view/side_actions.hpp"
#include "render/shown_points.hpp"

namespace moldlight::gui {

constexpr float k_names_height = 32.0F;  // of two revisions, layout units
constexpr int k_film_samples = 4;        // of each of its pictures
constexpr double k_resting_share = 0.5;  // of its travel, at which a body stands where nothing moves

std::vector<unsigned> App::shipped_pictures(const Ui& ui) {
  if (state_.model || loading_part()) return {};
  thumbnails_.update(static_cast<int>(ui.px(k_start_picture_size)), state_.window.theme);
  return thumbnails_.textures();
}

unsigned App::body_picture(std::size_t body) {
  if (!body_pictures_ || body_pictures_->of() != state_.bodies.whole)
    body_pictures_ = std::make_unique<BodyPictures>(*context_, state_.bodies.whole);
  return body_pictures_->texture(body, state_.window.theme, scale_);
}

void App::follow_figures() {
  const auto& shown = state_.figures.shown;
  if (!shown || followed_ == state_.figures.revision) return;
  followed_ = state_.figures.revision;
  const double least = std::max(shown->uncertainty.total(), 1e-4 * shown->total_area);
  glow_.see(shown->areas[Region::undercut] > least, now_s_, state_.window.motion);
  measure_face();
}

void App::mark_faces() {
  std::vector<std::uint32_t> faces;
  if (state_.draft_choices.kind.empty()) {
    if (state_.face) faces.push_back(state_.face->number);
  } else {
    for (const FaceFinish& one : state_.settings.required_draft.finishes)
      if (one.finish.name == state_.draft_choices.finish()) faces.push_back(one.face);
  }
  scene_->mark_faces(faces);
}

void App::measure_face() {
  if (!state_.face || !state_.figures.shown) return;
  state_.face->figures =
      face_figures(*state_.model, *state_.figures.shown, state_.faces->facets(state_.face->number));
}

void App::find_actions(bool moving) {
  ActionsState& actions = state_.actions;
  ActionChoices& choices = state_.action_choices;
  const std::shared_ptr<const ActionPlan> former = actions.plan;
  const std::uint64_t revision = actions.revision;
  study_.find_actions(state_, actions, {.moving = moving});
  if (choices.wish && !own_direction(state_.settings.actions, *choices.wish)) choices.wish.reset();
  if (actions.plan == former) return;
  settle_frames_ = k_settle_frames;
  if (choices.chosen)
    choices.chosen = actions.plan && former
                         ? nearest_undercut(*actions.plan, former->undercuts[*choices.chosen].undercut)
                         : std::nullopt;
  if (actions.revision == revision) return;
  const auto wish = std::exchange(choices.wish, std::nullopt);
  const SideAction* const action = chosen_action(state_);
  if (wish && !(action != nullptr && is_along(*action, *wish)))
    say("This direction is blocked: the side action keeps its own", false);
}

void App::find_mold(bool moving) {
  MoldState& mold = state_.mold;
  const auto former = mold.line;
  const auto solids = mold.solids;
  const std::size_t pieces = mold.pieces.size();
  study_.find_mold(
      state_, mold,
      {.moving = moving, .solids = steel_wanted() || is_at(state_, Step::mold) || presentation_});
  if (mold.line == former && mold.solids == solids && mold.pieces.size() == pieces) return;
  settle_frames_ = k_settle_frames;
  auto& loop = state_.mold_choices.loop;
  if (mold.line != former && loop)
    loop = mold.line && former ? nearest_loop(*mold.line, *former, *loop) : std::nullopt;
}

bool App::steel_wanted() const {
  const LookSettings& look = state_.settings.look;
  if (!state_.model || state_.window.halves == HalvesLook::surface || split_view() || shown_pieces(state_))
    return false;
  // In a presentation the slides are seen to move: the halves would hide them.
  if (presentation_) return presented_.open > slides_end(state_.actions.plan.get());
  return look.open_mold > 0.0 || open_now() > 0.0 ||
         (is_at(state_, Step::mold) && look.section != Section::off);
}

bool App::line_shown() const {
  return !split_view() && (state_.settings.look.parting_line || looks_at_line(state_) || steel_wanted());
}

double App::arrows_apart(double open) const {
  const auto& solids = state_.mold.solids;
  if (!steel_wanted() || !solids || solids->shown.empty()) return open;
  return open + block_margin(state_.settings.mold, state_.model->frame.diagonal) /
                    state_.model->frame.diagonal / k_mold_travel;
}

void App::pick() {
  state_.hover.reset();
  state_.span.reset();
  state_.revisions.hover.reset();
  if (!scene_ || presentation_ || !viewport_.hovers() || flight_.flying() || !ImGui::IsMousePosValid())
    return;
  const glm::ivec2 pixel(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size_.x || pixel.y >= size_.y) return;
  const auto split = split_view();
  const bool second = split && pixel.x >= split->left;
  if (second && !revision_) return;
  const auto point = second ? revision_->pick({pixel.x - split->left, pixel.y}) : scene_->pick(pixel);
  if (!point) return;
  if (revision_) state_.revisions.hover = revision_hover(state_, second, *point);
  if (second) return;
  if (point->facet != k_no_facet) state_.hover = describe(*state_.model, state_.settings, *point);
  if (!state_.cut || open_now() > 0.0) return;
  // The plane's point on the line of sight, if it lies before the surface.
  const Camera& camera = state_.camera;
  const glm::dvec3 seen(point->position);
  const glm::dvec3 toward =
      camera.projection == Projection::perspective ? camera.eye() - seen : camera.toward_viewer();
  const double height = state_.cut->offset - glm::dot(seen, state_.cut->normal);
  const double rise = glm::dot(toward, state_.cut->normal);
  if (rise <= 0.0 || height < -1e-4) return;
  state_.span =
      cut_span(*state_.model, *state_.cut, state_.settings.direction.unit(), seen + height / rise * toward);
}

SceneSettings App::scene_settings() const {
  SceneSettings scene;
  scene.query = state_.settings;
  const LookSettings& look = state_.settings.look;
  ViewSettings& shown = scene.view.settings;
  shown = {look};
  if (revision_) {
    constexpr double k_dimmed = 0.75;
    shown.dimmed = is_lit(state_) ? k_dimmed : 0.0;
  }
  shown.samples = film_ ? std::min(k_film_samples, options_.picture_samples) : options_.picture_samples;
  if (presentation_) shown.ground = presented_.floor;
  shown.theme = state_.window.theme;
  shown.required_draft_deg = state_.settings.required_draft.deg;
  shown.open_mold = opened().halves;
  if (shown_pieces(state_) != nullptr) shown.colour_mode = ColourMode::plain;
  const auto& solids = state_.mold.solids;
  if (steel_wanted() && solids && !solids->shown.empty()) {
    shown.steel = {.shown = true,
                   .clear = state_.window.halves == HalvesLook::clear,
                   .opened = std::exchange(shown.open_mold, 0.0),
                   .first = opened().slides,
                   .last = opened().lifters,
                   .of = scene_->steel()};
    shown.arrows_apart = arrows_apart(shown.steel.opened);
  }
  // The mold's line in place of the borders of regions, where it is known.
  if (state_.mold.line && !revision_) shown.parting_line = false;
  shown.pixel_scale = scale_;
  shown.cut = scene_->section(look, state_.settings.direction.unit());
  shown.cut_arrow = true;
  scene.view.camera = state_.camera;
  scene.direction_moves = direction_moves_;
  const bool marked = look.mark_difference;
  const bool by_maps = maps_shown(state_);
  scene.maps_looked_at = by_maps || marked || state_.dialogs.large_map.has_value();
  if (marked || shown.parting_line || !by_maps || state_.divider) scene.split = state_.figures.split;
  if (by_maps) scene.samples = state_.figures.samples;
  if (state_.divider)
    shown.maps_left_of_px = divider_place(*state_.divider, layout_.free_area(state_.dialogs.panels_hidden));
  ViewMarks& marks = scene.view.marks;
  marks.undercut_glow = glow_.at(now_s_);
  marks.others_gray = lit_now().has_value();
  if (marks.others_gray && lit_now()->of == Subject::Of::region) marks.lit = lit_now()->region;
  const double share = state_.window.motion ? action_loop_.at(now_s_) : k_resting_share;
  scene.bodies = sheets_     ? std::vector{nearer(state_.camera)}
                 : revision_ ? lit_places(state_, state_.camera)
                             : body_places(state_, open_now(), share, steel_wanted());
  if (state_.face) marks.chosen = state_.face->number;
  if (state_.hover) {
    marks.hovered = state_.faces->of_facet[state_.hover->point.facet];
    if (state_.hover->blocker) marks.blocking = state_.faces->of_facet[state_.hover->blocker->facet];
  }
  return scene;
}

bool App::draw(const ViewTarget& target) {
  bool refining = false;
  if (rehearsal_ && !rehearsal_->draw_next(target.framebuffer)) rehearsal_.reset();
  if (const auto split = split_view()) {
    refining = revision_ ? revision_->draw(state_, *split, scene_settings())
                         : pictures_->draw_beside(*split, scene_settings());
  }
  if (scene_) {
    light_subject();
    scene_->take_bodies(revision_ ? lit_.of(state_, false, state_.cut)
                        : sheets_ ? sheets_
                                  : shown_bodies(state_));
    scene_->take_mold({.line = line_shown() ? state_.mold.line : nullptr,
                       .loop = state_.mold_choices.loop,
                       .solids = state_.mold.solids});
    scene_->explain(state_.hover ? state_.hover->blocker : std::nullopt, state_.span);
    refining = scene_->draw(target, scene_settings()) || refining;
    while (film_ && refining) refining = scene_->draw(target, scene_settings());
    show_comparison();
  } else {
    draw_backdrop(tools_, target, state_.window.theme);
  }
  // ImGui goes back to the program that was in use, which may be deleted by then.
  gl::use_no_program(context_->functions());
  imgui_.draw();
  add_to_film(target);
  if (refining || rehearsal_) next_frame_s_ = now_s_;
  return refining_ = refining;
}

std::optional<Subject> App::lit_now() const {
  return revision_ || presentation_ || open_now() > 0.0 ? std::nullopt : state_.lit;
}

void App::light_subject() {
  const std::optional<Subject> wanted = lit_now();
  const auto subject = wanted ? std::optional(std::pair(*wanted, state_.figures.split)) : std::nullopt;
  if (subject == lit_subject_) return;
  lit_subject_ = subject;
  sheets_.reset();
  std::vector<ViewSegment> edges;
  if (wanted && wanted->of != Subject::Of::region) {
    const PartModel& model = *state_.model;
    const SubjectSurface lit =
        surface_of(*wanted, model, state_.figures.split.get(), state_.actions.plan.get());
    const auto at = [&](VertexIndex vertex) { return model.frame.to_unit(model.part.mesh.vertices[vertex]); };
    for (const auto& [a, b] : lit.edges) edges.push_back({at(a), at(b)});
    const bool fault = wanted->of >= Subject::Of::open_edges;
    const Colour undercut = region_colour(Region::undercut, state_.settings.look.palette);
    sheets_ = std::make_shared<const std::vector<ViewBody>>(
        1, lit_body(model, lit.mesh, fault ? k_block_mark : undercut, state_.cut));
  }
  scene_->mark_edges(edges);
}

void App::show_comparison() {
  Figures& figures = state_.figures;
  const auto former = figures.maps;
  if (!maps_shown(state_) || direction_moves_) {
    figures.maps.reset();
  } else if (figures.samples) {  // until they are there the last comparison stays
    figures.maps = scene_->comparison();
  }
  if (figures.maps != former) next_frame_s_ = now_s_;
}

OpenedMold App::opened() const {
  if (!state_.model || shown_pieces(state_)) return {};
  return opened_mold(state_.actions.plan.get(), open_now());
}

std::vector<glm::vec3> App::points_shown(double open, bool steel) const {
  const OpenedMold opened =
      shown_pieces(state_) ? OpenedMold() : opened_mold(state_.actions.plan.get(), open);
  std::vector<glm::vec3> outermost = state_.extremes;
  if (revision_) {
    const FrameTie tie = tie_of(state_, *revision_->of());
    const FrameTie back{tie.to, tie.from};
    for (const glm::vec3& point : revision_->of()->part.geometry->extremes)
      outermost.emplace_back(back.point(glm::dvec3(point)));
  }
  if (steel) {
    const std::vector<glm::vec3> block = block_corners(state_);
    outermost.insert(outermost.end(), block.begin(), block.end());
  }
  auto whole = points_to_show(outermost, state_.settings.direction.unit(), opened.halves);
  if (open > 0.0) {
    const std::vector<glm::vec3> moved = points_of_bodies(state_, open, steel);
    whole.insert(whole.end(), moved.begin(), moved.end());
  }
  return whole;
}

void App::fit(const Camera& camera, bool at_once) {
  fitted_area_ = fit_area();
  fitted_steel_ = steel_fit();
  const std::vector<glm::vec3> whole = points_shown(wanted_opening(), steel_wanted());
  fitted_ = fitted_to(camera, fitted_points_.empty() ? whole : fitted_points_, fitted_area_);
  if (!at_once && state_.window.motion) return flight_.start(state_.camera, *fitted_, now_s_);
  if (at_once) flight_.stop();
  state_.camera = *fitted_;
}

void App::turn_camera(const glm::dquat& orientation) {
  if (!state_.model) return;
  Camera camera = state_.camera;
  camera.orientation = orientation;
  fit(camera, false);
}

void App::look_at(SplitMesh undercuts, std::vector<glm::vec3> points) {
  const auto shown = std::make_shared<const SplitMesh>(std::move(undercuts));
  fitted_points_ = std::move(points);
  turn_camera(revealing_orientation(*state_.model, std::span(&shown, 1), state_.settings.direction.unit()));
}

void App::keep_fitted() {
  if (!fitted_ || presentation_ || state_.dialogs.panels_hidden) return;
  if (!flight_.flying() && !(state_.camera == *fitted_)) {
    fitted_.reset();
    return;
  }
  // Steel that comes or goes is seen whole, once no hand opens it any more.
  if (steel_fit() != fitted_steel_ && !ImGui::IsAnyItemActive()) {
    fitted_points_.clear();
    return fit(*fitted_, false);
  }
  const FreeArea area = fit_area();
  if (area.window == fitted_area_.window && area.max.y == fitted_area_.max.y) return;
  fit(*fitted_, area.window != fitted_area_.window);
}

void App::turn_direction(bool held) {
  if (!turn_.flying()) return;
  if (held) {
    turn_.stop();
    return;
  }
  state_.settings.direction = turn_.at(now_s_);
  if (!turn_.flying()) history_.settle(state_.settings);
  settle_frames_ = k_settle_frames;
}

int App::split_side() const {
  const FreeArea area = layout_.free_area(state_.dialogs.panels_hidden);
  return std::max(area.min.x, size_.x - area.max.x);
}

std::optional<SplitView> App::split_view() const {
  if (!scene_) return std::nullopt;
  if (revision_) return split_view_of(state_.camera, size_, 0, split_side());
  const auto& compared = state_.sweep_choices.compared;
  if (!pictures_ || !compared || *compared >= pictures_->result()->candidates.size()) return std::nullopt;
  return split_view_of(state_.camera, size_, *compared, split_side());
}

FreeArea App::fit_area() const {
  FreeArea area = layout_.free_area(state_.dialogs.panels_hidden);
  if (!split_view()) return area;
  // Both halves show what one of them has room for, below the names, or the table of their difference.
  area.min.x = split_side();
  area.max.x = size_.x / 2;
  area.min.y += static_cast<int>((revision_ ? k_names_height : k_comparison_height) * scale_);
  return area;
}

}  // namespace moldlight::gui
