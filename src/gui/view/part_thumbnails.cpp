#include "gui/view/part_thumbnails.hpp"

#include <exception>
#include <utility>

#include "gui/view/scene.hpp"

namespace moldlight::gui {

namespace {

constexpr int k_map_resolution = 512;

void draw_thumbnail(const gl::Context& context, const LoadedPart& part, Theme theme,
                    const gl::ColourTarget& target) {
  Scene scene(context, part);
  SceneSettings settings;
  settings.query.method.resolution = k_map_resolution;
  settings.view.settings.theme = theme;
  settings.view.settings.backdrop = Backdrop::none;
  settings.view.settings.samples = 8;
  settings.view.settings.arrows = false;
  Camera camera;
  camera.orientation = standard_orientation(StandardView::isometric);
  settings.view.camera =
      fitted(camera, unit_positions(part.model->part.mesh, part.model->frame), target.size(), 0.8);
  while (scene.draw({.framebuffer = target.framebuffer(), .size = target.size()}, settings)) {
  }
}

}  // namespace

PartThumbnails::PartThumbnails(const gl::Context& context, std::vector<std::string> parts,
                               std::function<void()> wake)
    : context_(&context),
      parts_(std::move(parts)),
      pictures_(parts_.size()),
      job_({.wake = std::move(wake), .wake_for_progress = true}) {}

void PartThumbnails::update(int size_px, Theme theme) {
  if (size_px != size_px_ || theme != theme_) {
    size_px_ = size_px;
    theme_ = theme;
    next_ = 0;
    job_.give_up();
  }
  if (const auto loaded = job_.take()) {
    std::optional<gl::ColourTarget>& picture = pictures_[next_];
    picture.reset();
    try {
      if (loaded->result) {
        picture.emplace(context_->functions(), glm::ivec2(size_px));
        draw_thumbnail(*context_, *loaded->result, theme, *picture);
      }
    } catch (const std::exception&) {
      picture.reset();  // its place stays empty; opening it will say why
    }
    ++next_;
  }
  if (job_.running() || finished()) return;
  job_.start(
      [path = parts_[next_]](const Progress& progress) { return load_for_window(path, {}, progress); });
}

std::vector<unsigned> PartThumbnails::textures() const {
  std::vector<unsigned> names;
  for (const auto& picture : pictures_) names.push_back(picture ? picture->texture() : 0);
  return names;
}

}  // namespace moldlight::gui
