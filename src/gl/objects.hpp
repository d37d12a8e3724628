// Owning handles of GL objects. Each remembers its context's functions and deletes its object when it goes;
// that context must be current then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "gl/functions.hpp"

namespace moldlight::gl {

/// A GL object name with the entry that deletes it, one name or an array of them; movable, not copyable;
/// empty when default-constructed.
template <auto k_delete>
class Handle {
 public:
  Handle() = default;
  Handle(const Functions& gl, GLuint name) : gl_(&gl), name_(name) {}
  Handle(Handle&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      gl_ = other.gl_;
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  ~Handle() { reset(); }

  void reset() {
    if (name_ == 0) return;
    const GLuint name = std::exchange(name_, 0);
    if constexpr (std::is_invocable_v<decltype(gl_->*k_delete), GLuint>) {
      (gl_->*k_delete)(name);
    } else {
      (gl_->*k_delete)(1, &name);
    }
  }
  [[nodiscard]] GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  const Functions* gl_ = nullptr;
  GLuint name_ = 0;
};

using Buffer = Handle<&Functions::DeleteBuffers>;
using Texture = Handle<&Functions::DeleteTextures>;
using Framebuffer = Handle<&Functions::DeleteFramebuffers>;
using VertexArray = Handle<&Functions::DeleteVertexArrays>;
using Query = Handle<&Functions::DeleteQueries>;

/// A static buffer with `bytes` in it (GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER or GL_TEXTURE_BUFFER as
/// target).
[[nodiscard]] Buffer make_buffer(const Functions& gl, GLenum target, std::span<const std::byte> bytes);

template <typename T>
[[nodiscard]] Buffer make_buffer(const Functions& gl, GLenum target, std::span<const T> items) {
  return make_buffer(gl, target, std::as_bytes(items));
}

/// A buffer texture over `buffer`, as a shader reads it with texelFetch (GL_RGBA32F, GL_R32UI, …).
[[nodiscard]] Texture make_buffer_texture(const Functions& gl, GLenum internal_format, const Buffer& buffer);

/// An empty 2-D texture without mipmaps, nearest filtering, clamped to its edge. Throws Error where the
/// driver has no room for it.
[[nodiscard]] Texture make_texture_2d(const Functions& gl, GLenum internal_format, int width, int height);

/// The same with `layers` layers (GL_TEXTURE_2D_ARRAY).
[[nodiscard]] Texture make_texture_array(const Functions& gl, GLenum internal_format, int size, int layers);

/// A picture in memory: RGBA8, smoothed where it is shown smaller or larger; its rows begin below, as those
/// of what is drawn.
[[nodiscard]] Texture picture_texture(const Functions& gl, const Image& image);

[[nodiscard]] Query make_query(const Functions& gl);

[[nodiscard]] VertexArray make_vertex_array(const Functions& gl);

/// What a framebuffer draws to; a zero depth leaves it without depth. Colour k is draw buffer k.
struct Attachments {
  std::span<const GLuint> colours;
  GLuint depth = 0;
};
/// A complete framebuffer, left bound to GL_FRAMEBUFFER; throws Error where the driver refuses it.
[[nodiscard]] Framebuffer make_framebuffer(const Functions& gl, const Attachments& attachments);
[[nodiscard]] Framebuffer make_framebuffer(const Functions& gl, const Texture& colour,
                                           const Texture* depth = nullptr);
/// One layer of an array texture.
struct Layer {
  const Texture& array;
  int index;
};
[[nodiscard]] Framebuffer make_layer_framebuffer(const Functions& gl, const Layer& colour,
                                                 const Layer& depth);

/// Throws Error naming `where` if GL reports an error.
void check_errors(const Functions& gl, const char* where);

/// A framebuffer with one RGBA8 colour: what windows are without a window. Needs its context current at every
/// call. What is drawn is kept as it is written, without sRGB conversion.
class ColourTarget {
 public:
  ColourTarget(const Functions& gl, const glm::ivec2& size);

  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
  [[nodiscard]] GLuint texture() const { return texture_.name(); }
  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// Four bytes a pixel, rows from above. Waits for the GL.
  [[nodiscard]] std::vector<std::uint8_t> read() const;

 private:
  const Functions* gl_;
  glm::ivec2 size_;
  Texture texture_;
  Framebuffer framebuffer_;
};

/// Four bytes a pixel of a framebuffer's first colour, rows from above. Waits for the GL.
[[nodiscard]] std::vector<std::uint8_t> read_colours(const Functions& gl, GLuint framebuffer,
                                                     const glm::ivec2& size);

}  // namespace moldlight::gl
