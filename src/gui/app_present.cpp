// The presentation in the window: what its acts are, how it runs, and its film.
#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "classify/still_picture.hpp"
#include "gl/objects.hpp"
#include "gui/app.hpp"
#include "gui/view/side_actions.hpp"
#include "mold/direction.hpp"

namespace moldlight::gui {

namespace {

constexpr int k_widest_film = 1100;    // pixels; a larger window's pictures are halved
constexpr float k_caption_room = 96;   // layout units, below what is shown
constexpr double k_over_floor = 0.02;  // unit frame
constexpr double k_fade_s = 0.6;

}  // namespace

Presentation App::made_presentation() const {
  const ActionPlan* const plan = state_.actions.plan.get();
  const Figures& figures = state_.figures;
  const std::vector<glm::vec3> closed = points_shown(0.0, false), opened = points_shown(1.0, true);
  FreeArea area{.window = size_, .min = {0, 0}, .max = size_};
  area.max.y -= static_cast<int>(k_caption_room * scale_);
  const auto seen = [&](const glm::dquat& orientation, const std::vector<glm::vec3>& points) {
    Camera camera = state_.camera;
    camera.orientation = orientation;
    return fitted_to(camera, points, area);
  };
  const glm::dquat from_above = standard_orientation(StandardView::isometric);
  const glm::dvec3& direction = state_.settings.direction.unit();
  glm::dquat from_undercuts = from_above;
  std::vector<Act> acts;
  acts.push_back(
      {.camera = seen(from_above, closed),
       .caption = fmt::format("{} opens along {}.", std::filesystem::path(state_.path).stem().string(),
                              with_minus(direction_words(direction)))});
  if (figures.split && figures.undercuts && figures.undercuts->count > 0) {
    const UndercutTotals& totals = *figures.undercuts;
    from_undercuts = revealing_orientation(*state_.model, std::span(&figures.split, 1), direction);
    acts.push_back({.camera = seen(from_undercuts, closed),
                    .caption = fmt::format("It has {}: {} of its surface.", plural(totals.count, "undercut"),
                                           area_with_unit(*state_.model, totals.area))});
  }
  const Camera whole = seen(from_above, opened);
  const OpenedMold end = opened_mold(plan, 1.0);
  const double slides = slides_end(plan);
  if (slides > 0.0)
    acts.push_back({.camera = seen(from_undercuts, points_shown(slides, false)),
                    .open = slides,
                    .caption = first_moves_text(*plan)});
  acts.push_back(
      {.length_s = 5.0,
       .camera = whole,
       .open = 1.0,
       .caption = end.lifters > 0.0 ? "The halves open, and the part is ejected." : "The halves open."});
  if (state_.verdict) acts.push_back({.camera = whole, .open = 1.0, .caption = state_.verdict->sentence});
  for (Act& act : acts) {
    for (const glm::vec3& point : points_shown(act.open, act.open > slides))
      act.floor = std::min(act.floor, static_cast<double>(point.z));
    act.floor -= k_over_floor;
  }
  return Presentation(std::move(acts));
}

void App::offer_tour() {
  const auto lid = std::ranges::find_if(options_.shipped_parts, [](const std::string& path) {
    return std::filesystem::path(path).stem() == "enclosure_lid";
  });
  if (lid == options_.shipped_parts.end() || !state_.hints_done.insert(Hint::tour).second) return;
  open(*lid);
  state_.tour.emplace();
}

void App::present() {
  if (!state_.model || state_.revisions.on() || state_.loading) return;
  state_.dialogs = Dialogs();
  state_.sweep_choices.compared.reset();
  state_.divider.reset();
  presentation_.emplace(made_presentation());
  state_.presented.emplace();
  presented_last_s_ = now_s_;
  camera_before_ = state_.camera;
  flight_.stop();
  state_.hover.reset();
}

void App::end_presenting() {
  presentation_.reset();
  without_it_.reset();
  state_.presented.reset();
  state_.camera = *std::exchange(camera_before_, std::nullopt);
  if (film_) say("The film was not finished", true);
  film_.reset();
  settle_frames_ = k_settle_frames;
}

void App::go_on_presenting() {
  Presented& shown = *state_.presented;
  const double since_s = now_s_ - std::exchange(presented_last_s_, now_s_);
  // Made while the part is shown; the mold opens when all of it is there.
  const bool waits = shown.time_s >= presentation_->opens_s() && measuring();
  if (!waits) shown.time_s += film_ ? 1.0 / k_film_rate : shown.paused ? 0.0 : since_s;
  const bool at_end = shown.time_s >= presentation_->length_s();
  shown.recording = film_ != nullptr;
  film_waits_ = waits;
  if (at_end && film_) finish_film();
  if (at_end || (ImGui::IsMouseClicked(0) && !film_)) return end_presenting();
  const Moment moment = presentation_->at(shown.time_s);
  shown.caption = moment.caption;
  state_.camera = moment.camera;
  const auto there = [&](const Moment& at) {  // of slides and halves
    return std::pair(at.open > 0.0, at.open > slides_end(state_.actions.plan.get()));
  };
  if (scene_ && there(presented_) < there(moment)) {  // what is new fades in
    without_it_.emplace(context_->functions(), size_);
    const ViewTarget target{.framebuffer = without_it_->framebuffer(), .size = size_};
    while (scene_->draw(target, scene_settings()) && film_) {
    }
    appeared_s_ = shown.time_s;
  }
  presented_ = moment;
  shown.fade = without_it_ ? std::max(0.0, 1.0 - (shown.time_s - appeared_s_) / k_fade_s) : 0.0;
  shown.fading = shown.fade > 0.0 ? without_it_->texture() : 0;
}

void App::add_to_film(const ViewTarget& target) {
  if (!film_ || film_waits_) return;
  Image picture{target.size.x, target.size.y,
                gl::read_colours(context_->functions(), target.framebuffer, target.size)};
  if (target.size.x > k_widest_film) picture = halved(picture);
  if (glm::ivec2(picture.width, picture.height) != film_size_) return end_presenting();  // another window
  if (attempt([&] { film_->add(picture); })) return;
  film_.reset();
  end_presenting();
}

void App::finish_film() {
  if (attempt([&] { film_->finish(); })) {
    saved_to_ = std::filesystem::path(film_path_).parent_path().string();
    say("Film saved as " + film_path_, false);
  }
  film_.reset();
}

void Commands::present() { app.presentation_ ? app.end_presenting() : app.present(); }

void Commands::pause_presenting() {
  if (app.presentation_) app.state_.presented->paused = !app.state_.presented->paused;
}

void Commands::film(const std::string& path) {
  app.film_size_ = app.size_.x > k_widest_film ? app.size_ / 2 : app.size_;
  app.film_path_ = path;
  if (!app.attempt([&] { app.film_ = begin_film(path, {.size = app.film_size_, .rate = App::k_film_rate}); }))
    return;
  app.present();
  if (!app.presentation_) app.film_.reset();
}

void Commands::keep_view() {
  AppState& state = app.state_;
  if (!app.scene_) return;
  constexpr glm::ivec2 k_size(1400, 940);  // pixels, on a page
  const gl::ColourTarget target(app.context_->functions(), k_size);
  SceneSettings scene = app.scene_settings();
  scene.view.settings.theme = Theme::light;
  scene.view.settings.backdrop = Backdrop::none;
  scene.view.settings.pixel_scale = 1.5;
  scene.view.settings.maps_left_of_px.reset();
  scene.view.marks = {};
  // As much of the scene as the panels leave free.
  const FreeArea area = app.fit_area();
  const glm::dvec2 free(area.max - area.min);
  const double pixel = std::max(scene.view.camera.height / app.size_.y * free.x / k_size.x,
                                scene.view.camera.height / app.size_.y * free.y / k_size.y);
  const glm::dvec2 aside =
      0.5 * glm::dvec2(area.min + area.max - area.window) * (scene.view.camera.height / app.size_.y);
  scene.view.camera.target += aside.x * scene.view.camera.right() - aside.y * scene.view.camera.up();
  scene.view.camera.height = pixel * k_size.y;
  while (app.scene_->draw({.framebuffer = target.framebuffer(), .size = k_size}, scene)) {
  }
  const std::string caption = fmt::format("{}. {}", state.views.size() + 1, verdict_card(state).sentence);
  state.views.push_back({.light = {k_size.x, k_size.y, target.read()}, .text = caption, .caption = caption});
}

void Commands::forget_views() { app.state_.views.clear(); }

}  // namespace moldlight::gui
