// The GL entry points that moldlight uses, loaded for one context: no global state, no loader library.
#pragma once

#include <functional>
#include <memory>

#define GL_GLEXT_PROTOTYPES  // for the types of the entry points alone
#include <GL/glcorearb.h>

#include "base/error.hpp"
#include "gl/software_gl_lock.hpp"

namespace moldlight::gl {

// X(<member>): gl.<member>(…) is gl<member>(…). Keep it to what OpenGL 3.3 core has.
// clang-format off
#define MOLDLIGHT_GL_FUNCTIONS(X) \
  X(ActiveTexture) X(AttachShader) X(BeginQuery) X(BindBuffer) X(BindFramebuffer) X(BindTexture)          \
  X(BindVertexArray) X(BlendEquation) X(BlendFuncSeparate) X(BlitFramebuffer) X(BufferData)               \
  X(BufferSubData) X(CheckFramebufferStatus) X(ClearBufferfv) X(ClearBufferuiv) X(ColorMask)              \
  X(CompileShader) X(CreateProgram) X(CreateShader) X(CullFace) X(DeleteBuffers) X(DeleteFramebuffers)    \
  X(DeleteProgram) X(DeleteQueries) X(DeleteShader) X(DeleteTextures) X(DeleteVertexArrays) X(DepthFunc)  \
  X(DepthMask) X(Disable) X(DrawArrays) X(DrawArraysInstanced) X(DrawBuffers) X(DrawElements) X(Enable)   \
  X(EnableVertexAttribArray) X(EndQuery) X(FramebufferTexture2D) X(FramebufferTextureLayer) X(GenBuffers) \
  X(GenFramebuffers) X(GenQueries) X(GenTextures) X(GenVertexArrays) X(GetActiveUniform) X(GetError)      \
  X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv) X(GetQueryObjectuiv) X(GetShaderInfoLog)            \
  X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram) X(PixelStorei) X(ReadBuffer)           \
  X(ReadPixels) X(ShaderSource) X(TexBuffer) X(TexImage2D) X(TexImage3D) X(TexParameteri)                 \
  X(TexSubImage2D) X(TexSubImage3D) X(Uniform1f) X(Uniform1i) X(Uniform1ui) X(Uniform2f) X(Uniform2i)     \
  X(Uniform3f) X(Uniform4f) X(UniformMatrix4fv) X(UseProgram) X(VertexAttribDivisor)                      \
  X(VertexAttribIPointer) X(VertexAttribPointer) X(Viewport)
// clang-format on

/// An entry point; takes its turn if the GL draws on the processor.
template <typename Pointer>
class Entry;
template <typename Result, typename... Arguments>
class Entry<Result (*)(Arguments...)> {
 public:
  /// False where the driver lacks it.
  bool load(void* address) {
    call_ = reinterpret_cast<Result (*)(Arguments...)>(address);
    return call_ != nullptr;
  }
  void take_turns() { takes_turns_ = true; }
  Result operator()(Arguments... arguments) const {
    const SoftwareGlLock turn(takes_turns_);
    return call_(arguments...);
  }

 private:
  Result (*call_)(Arguments...) = nullptr;
  bool takes_turns_ = false;
};

class Programs;

/// Every entry of one context. Valid while that context is current on the calling thread.
struct Functions {
#define MOLDLIGHT_GL_MEMBER(name) Entry<decltype(&gl##name)> name;
  MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_MEMBER)
#undef MOLDLIGHT_GL_MEMBER
  /// Of this context, while any of its tools live: see Programs::of().
  mutable std::weak_ptr<Programs> programs;

  using ProcAddress = std::function<void*(const char*)>;
  /// Loads every entry; throws Error naming the first that the driver lacks.
  [[nodiscard]] static Functions load(const ProcAddress& address) {
    Functions gl;
#define MOLDLIGHT_GL_LOAD(name) \
  if (!gl.name.load(address("gl" #name))) throw Error("the OpenGL driver lacks gl" #name);
    MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_LOAD)
#undef MOLDLIGHT_GL_LOAD
    return gl;
  }
  void take_turns() {
#define MOLDLIGHT_GL_TAKE_TURNS(name) name.take_turns();
    MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_TAKE_TURNS)
#undef MOLDLIGHT_GL_TAKE_TURNS
  }
};

}  // namespace moldlight::gl
