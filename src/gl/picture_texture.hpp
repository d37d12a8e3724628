// A picture in memory as a texture.
#pragma once

#include "base/image.hpp"
#include "gl/objects.hpp"

namespace moldlight::gl {

/// RGBA8, smoothed where it is shown smaller or larger; its rows begin below, as those of what is drawn.
[[nodiscard]] Texture picture_texture(const Functions& gl, const Image& image);

}  // namespace moldlight::gl
