#include "gui/view/small_pictures.hpp"

#include <exception>
#include <utility>

#include "base/error.hpp"
#include "batch/store.hpp"
#include "gui/view/scene.hpp"
#include "io/png.hpp"

namespace moldlight::gui {

namespace {

constexpr int k_map_resolution = 512;
/// So many of a batch are kept: some screens full.
constexpr std::size_t k_most_of_batch = 500;

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

BatchPictures::BatchPictures(const gl::Context& context, std::string batch_folder)
    : context_(&context), folder_(std::move(batch_folder)) {}

unsigned BatchPictures::texture(const Digest& key) {
  if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
  if (++read_ > k_a_frame) return 0;
  if (textures_.size() >= k_most_of_batch) textures_.clear();
  gl::Texture& texture = textures_[key];
  try {
    texture = gl::picture_texture(context_->functions(),
                                  read_png(batch::ResultStore(folder_).beside(key, batch::Beside::picture)));
  } catch (const Error&) {  // its place stays empty
  }
  return texture.name();
}

}  // namespace moldlight::gui
