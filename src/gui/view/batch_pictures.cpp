#include "gui/view/batch_pictures.hpp"

#include <utility>

#include "base/error.hpp"
#include "batch/store.hpp"
#include "io/png.hpp"

namespace moldlight::gui {

namespace {

/// So many are kept: some screens full.
constexpr std::size_t k_most = 500;

}  // namespace

BatchPictures::BatchPictures(const gl::Context& context, std::string batch_folder)
    : context_(&context), folder_(std::move(batch_folder)) {}

unsigned BatchPictures::texture(const Digest& key) {
  if (const auto found = textures_.find(key); found != textures_.end()) return found->second.name();
  if (++read_ > k_a_frame) return 0;
  if (textures_.size() >= k_most) textures_.clear();
  gl::Texture& texture = textures_[key];
  try {
    texture = gl::picture_texture(context_->functions(),
                                  read_png(batch::ResultStore(folder_).beside(key, batch::Beside::picture)));
  } catch (const Error&) {  // its place stays empty
  }
  return texture.name();
}

}  // namespace moldlight::gui
