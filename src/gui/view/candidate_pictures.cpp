#include "gui/view/candidate_pictures.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/error.hpp"
#include "batch/store.hpp"
#include "io/png.hpp"
#include "mold/map_frame.hpp"
#include "study/study.hpp"

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

constexpr int k_small_maps = 512;
constexpr int k_refinements = 6;
constexpr double k_candidate_fill = 0.9;
/// Of the lines in a small picture, to those in a large one.
constexpr double k_thin = 0.6;

/// From aside and above, as the pull sees above: what is under the part's ledges shows, and where it opens
/// too.
Camera clearest_view(const PartModel& model, const glm::dvec3& direction, const glm::ivec2& size) {
  const MapFrame frame = map_frame(direction);
  Camera camera;
  camera.orientation = looking_along(-(0.62 * frame.z + 0.62 * frame.x + 0.48 * frame.y), frame.z);
  return fitted(camera, unit_positions(model.part.mesh, model.frame), size, k_candidate_fill);
}

}  // namespace

std::vector<unsigned> textures_of(const PictureTargets& pictures) {
  std::vector<unsigned> names;
  for (const auto& picture : pictures) names.push_back(picture ? picture->texture() : 0);
  return names;
}

gl::ColourTarget& sized(std::optional<gl::ColourTarget>& picture, const gl::Context& context,
                        const glm::ivec2& size) {
  if (!picture || picture->size() != size) picture.emplace(context.functions(), size);
  return *picture;
}

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

BodyPictures::BodyPictures(const gl::Context& context, std::shared_ptr<const LoadedPart> whole)
    : context_(&context),
      whole_(std::move(whole)),
      buffers_(context.functions(), {.mesh = whole_->model->part.mesh,
                                     .geometry = whole_->model->geometry,
                                     .frame = whole_->model->frame,
                                     .concave_edges = {}}),
      view_(context.functions(), *whole_->geometry) {}

unsigned BodyPictures::texture(std::size_t body, Theme theme, float scale) {
  const glm::ivec2 size(glm::round(k_size * scale));
  if (size != size_ || theme != theme_) {
    pictures_.clear();
    pictures_.resize(whole_->model->part.bodies.size());
    size_ = size;
    theme_ = theme;
  }
  auto& picture = pictures_[body];
  if (picture) return picture->texture();
  if (++asked_ > 1) return 0;
  const Body& found = whole_->model->part.bodies[body];
  std::vector<std::uint8_t> hidden(whole_->geometry->facets.size(), 1);
  std::fill_n(hidden.begin() + found.first_facet, found.facet_count, std::uint8_t{0});
  const ViewGeometry alone = shown_part(*whole_->geometry, hidden);
  view_.set_geometry(alone);
  std::vector<glm::vec3> points;
  for (const auto& facet : alone.facets)
    for (const VertexIndex corner : facet)
      if (facet[0] != facet[1]) points.push_back(alone.vertices[corner].position);
  View view;
  view.camera.orientation = standard_orientation(StandardView::isometric);
  view.camera = fitted(view.camera, points, size, k_candidate_fill);
  view.settings.theme = theme;
  view.settings.colour_mode = ColourMode::plain;
  view.settings.backdrop = Backdrop::none;
  view.settings.arrows = view.settings.feature_edges = false;
  view.settings.samples = 4;
  picture.emplace(context_->functions(), size);
  view_.draw_final({.framebuffer = picture->framebuffer(), .size = size}, {.part = buffers_}, view);
  return picture->texture();
}

SplitView split_view_of(const Camera& camera, const glm::ivec2& window, std::size_t candidate, int side) {
  SplitView split{.candidate = candidate, .left = window.x / 2, .size = {}, .camera = camera};
  split.size = {window.x - split.left, window.y};
  // What is in the middle of the left half's free part is in the middle of the right one's too.
  const int shift = window.x - split.left - side;
  const double aside = 0.5 * window.x - (split.left + 0.5 * split.size.x) + shift;
  split.camera = panned(camera, {aside, 0.0}, split.size);
  return split;
}

void draw_split(const Ui& ui, const SplitView& split, unsigned texture) {
  ImDrawList& list = scene_list();
  const auto left = static_cast<float>(split.left), right = left + static_cast<float>(split.size.x);
  const auto bottom = static_cast<float>(split.size.y);
  list.AddImage(texture_id(texture), ImVec2(left, 0.0F), ImVec2(right, bottom), ImVec2(0, 1), ImVec2(1, 0));
  list.AddRectFilled(ImVec2(left - 0.5F * ui.px(2), 0.0F), ImVec2(left + 0.5F * ui.px(2), bottom),
                     ui.colours->line);
}

CandidatePictures::CandidatePictures(const gl::Context& context, const LoadedPart& part,
                                     std::shared_ptr<const SweepResult> result, std::function<void()> wake)
    : context_(&context),
      result_(std::move(result)),
      scene_(context, part),
      small_(result_->candidates.size()),
      job_({.wake = std::move(wake)}) {}

bool CandidatePictures::draw_next(const ViewSettings& view, const glm::ivec2& size_px) {
  const bool fits = std::all_of(small_.begin(), small_.end(),
                                [&](const auto& target) { return !target || target->size() == size_px; });
  if (!fits || theme_ != view.theme || palette_ != view.palette) {
    for (auto& target : small_) target.reset();
    theme_ = view.theme;
    palette_ = view.palette;
  }
  const auto missing = std::find(small_.begin(), small_.end(), std::nullopt);
  if (missing == small_.end()) return false;
  const SweepCandidate& candidate = result_->candidates[static_cast<std::size_t>(missing - small_.begin())];
  missing->emplace(context_->functions(), size_px);
  SceneSettings scene;
  scene.query = {candidate.candidate.direction, result_->settings.method};
  scene.query.method.resolution = std::min(scene.query.method.resolution, k_small_maps);
  scene.view.settings.theme = view.theme;
  scene.view.settings.palette = view.palette;
  scene.view.settings.required_draft_deg = view.required_draft_deg;
  scene.view.settings.pixel_scale = k_thin * view.pixel_scale;
  scene.view.settings.arrows = false;
  scene.view.camera = clearest_view(*scene_.part().model, candidate.candidate.direction, size_px);
  for (int pass = 0; pass < k_refinements; ++pass)
    if (!scene_.draw({.framebuffer = (*missing)->framebuffer(), .size = size_px}, scene)) break;
  return std::find(missing, small_.end(), std::nullopt) != small_.end();
}

bool CandidatePictures::draw_beside(const SplitView& split, SceneSettings settings) {
  settings.query.direction = result_->candidates[split.candidate].candidate.direction;
  settings.view.camera = split.camera;
  settings.view.marks = {};
  if (wanted_ != settings.query) {
    wanted_ = settings.query;
    job_.follow([model = scene_.part().model, query = settings.query](const Progress& progress) {
      return Split{query, Study(model, {.query = query}).find<SplitRegions>(progress).result.split};
    });
  }
  if (auto found = job_.take(); found && found->result) split_ = std::move(found->result);
  settings.split = split_ && split_->of == settings.query ? split_->mesh : nullptr;
  const gl::ColourTarget& target = sized(beside_, *context_, split.size);
  return scene_.draw({target.framebuffer(), split.size}, settings);
}

}  // namespace moldlight::gui
