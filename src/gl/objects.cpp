#include "gl/objects.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/error.hpp"

namespace moldlight::gl {

namespace {

std::string_view error_name(GLenum error) {
  constexpr std::pair<GLenum, std::string_view> k_names[] = {
      {GL_INVALID_ENUM, "GL_INVALID_ENUM"},
      {GL_INVALID_VALUE, "GL_INVALID_VALUE"},
      {GL_INVALID_OPERATION, "GL_INVALID_OPERATION"},
      {GL_INVALID_FRAMEBUFFER_OPERATION, "GL_INVALID_FRAMEBUFFER_OPERATION"},
      {GL_OUT_OF_MEMORY, "GL_OUT_OF_MEMORY"}};
  for (const auto& [code, name] : k_names)
    if (code == error) return name;
  return "an unknown error";
}

struct PixelLayout {
  GLenum internal_format, format, type;
};
constexpr PixelLayout k_layouts[] = {{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
                                     {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
                                     {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
                                     {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
                                     {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
                                     {GL_R8, GL_RED, GL_UNSIGNED_BYTE},
                                     {GL_RGBA32F, GL_RGBA, GL_FLOAT}};

// TexImage2D wants a client format even without data, and it must suit the internal one.
PixelLayout pixel_layout(GLenum internal_format) {
  const auto* known = std::ranges::find(k_layouts, internal_format, &PixelLayout::internal_format);
  return known != std::end(k_layouts) ? *known : PixelLayout{internal_format, GL_RGBA, GL_UNSIGNED_BYTE};
}

GLuint generate(const Entry<void (*)(GLsizei, GLuint*)>& entry) {
  GLuint name = 0;
  entry(1, &name);
  return name;
}

void check_size(const Functions& gl, int width, int height) {
  GLint largest = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (width < 1 || height < 1 || width > largest || height > largest) {
    throw Error(fmt::format(
        "the driver has no texture of {} x {} texels, its largest is {} x {}: choose a smaller resolution",
        width, height, largest, largest));
  }
}

/// No mipmaps, no filtering, clamped to the edge.
void read_by_texel(const Functions& gl, GLenum target) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

void check_complete(const Functions& gl, std::size_t colours, bool with_depth) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(fmt::format("the OpenGL driver refuses a framebuffer of {} colours{} (status 0x{:04x})",
                            colours, with_depth ? " and depth" : "", status));
  }
  check_errors(gl, "making a framebuffer");
}

}  // namespace

Buffer make_buffer(const Functions& gl, GLenum target, std::span<const std::byte> bytes) {
  Buffer buffer(gl, generate(gl.GenBuffers));
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  check_errors(gl, "making a buffer");
  return buffer;
}

Texture make_buffer_texture(const Functions& gl, GLenum internal_format, const Buffer& buffer) {
  Texture texture(gl, generate(gl.GenTextures));
  gl.BindTexture(GL_TEXTURE_BUFFER, texture.name());
  gl.TexBuffer(GL_TEXTURE_BUFFER, internal_format, buffer.name());
  check_errors(gl, "making a buffer texture");
  return texture;
}

Texture make_texture_2d(const Functions& gl, GLenum internal_format, int width, int height) {
  check_size(gl, width, height);
  Texture texture(gl, generate(gl.GenTextures));
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  const PixelLayout layout = pixel_layout(internal_format);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, layout.format,
                layout.type, nullptr);
  read_by_texel(gl, GL_TEXTURE_2D);
  check_errors(gl, "making a texture");
  return texture;
}

Texture make_texture_array(const Functions& gl, GLenum internal_format, int size, int layers) {
  check_size(gl, size, size);
  Texture texture(gl, generate(gl.GenTextures));
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
  const PixelLayout layout = pixel_layout(internal_format);
  gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internal_format), size, size, layers, 0,
                layout.format, layout.type, nullptr);
  read_by_texel(gl, GL_TEXTURE_2D_ARRAY);
  check_errors(gl, "making an array of textures");
  return texture;
}

Texture picture_texture(const Functions& gl, const Image& image) {
  Texture texture = make_texture_2d(gl, GL_RGBA8, image.width, image.height);
  const auto row = static_cast<std::ptrdiff_t>(4 * image.width);
  std::vector<std::uint8_t> below(image.rgba.size());
  for (std::ptrdiff_t y = 0; y < image.height; ++y)
    std::copy_n(image.rgba.begin() + (image.height - 1 - y) * row, row, below.begin() + y * row);
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                   below.data());
  return texture;
}

Query make_query(const Functions& gl) { return {gl, generate(gl.GenQueries)}; }

VertexArray make_vertex_array(const Functions& gl) { return {gl, generate(gl.GenVertexArrays)}; }

Framebuffer make_framebuffer(const Functions& gl, const Attachments& attachments) {
  Framebuffer framebuffer(gl, generate(gl.GenFramebuffers));
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  std::vector<GLenum> draw_buffers;
  for (const GLuint colour : attachments.colours) {
    const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw_buffers.size());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, colour, 0);
    draw_buffers.push_back(point);
  }
  if (attachments.depth != 0)
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, attachments.depth, 0);
  if (draw_buffers.empty()) draw_buffers.push_back(GL_NONE);
  gl.DrawBuffers(static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
  gl.ReadBuffer(draw_buffers.front());
  check_complete(gl, attachments.colours.size(), attachments.depth != 0);
  return framebuffer;
}

Framebuffer make_framebuffer(const Functions& gl, const Texture& colour, const Texture* depth) {
  const GLuint name = colour.name();
  return make_framebuffer(gl, {.colours = {&name, 1}, .depth = depth != nullptr ? depth->name() : 0});
}

Framebuffer make_layer_framebuffer(const Functions& gl, const Layer& colour, const Layer& depth) {
  Framebuffer framebuffer(gl, generate(gl.GenFramebuffers));
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour.array.name(), 0, colour.index);
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth.array.name(), 0, depth.index);
  check_complete(gl, 1, true);
  return framebuffer;
}

void check_errors(const Functions& gl, const char* where) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  // A lost context reports errors without end, so the rest of the queue is emptied within bounds.
  for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
  throw Error(fmt::format("OpenGL reports {} when {}", error_name(error), where));
}

ColourTarget::ColourTarget(const Functions& gl, const glm::ivec2& size)
    : gl_(&gl),
      size_(size),
      texture_(make_texture_2d(gl, GL_RGBA8, size.x, size.y)),
      framebuffer_(make_framebuffer(gl, texture_)) {}

std::vector<std::uint8_t> ColourTarget::read() const { return read_colours(*gl_, framebuffer(), size_); }

std::vector<std::uint8_t> read_colours(const Functions& gl, GLuint framebuffer, const glm::ivec2& size) {
  const auto row = static_cast<std::size_t>(size.x) * 4, rows = static_cast<std::size_t>(size.y);
  std::vector<std::uint8_t> below(row * rows), above(row * rows);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  if (framebuffer != 0) gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, below.data());
  for (std::size_t k = 0; k < rows; ++k) {
    std::copy_n(below.begin() + static_cast<std::ptrdiff_t>((rows - 1 - k) * row), row,
                above.begin() + static_cast<std::ptrdiff_t>(k * row));
  }
  return above;
}

}  // namespace moldlight::gl
