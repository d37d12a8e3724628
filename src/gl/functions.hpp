// The GL entry points that moldlight uses, loaded for one context: no global state, no loader library.
#pragma once

#include <functional>

#include <GL/glcorearb.h>

#include "base/error.hpp"
#include "gl/turn.hpp"

namespace moldlight::gl {

// X(<member>, <typedef>): gl.<member>(…) is gl<member>(…). Keep it to what OpenGL 3.3 core has.
#define MOLDLIGHT_GL_FUNCTIONS(X)                              \
  X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                     \
  X(AttachShader, PFNGLATTACHSHADERPROC)                       \
  X(BeginQuery, PFNGLBEGINQUERYPROC)                           \
  X(BindBuffer, PFNGLBINDBUFFERPROC)                           \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                 \
  X(BindTexture, PFNGLBINDTEXTUREPROC)                         \
  X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                 \
  X(BlendEquation, PFNGLBLENDEQUATIONPROC)                     \
  X(BlendFuncSeparate, PFNGLBLENDFUNCSEPARATEPROC)             \
  X(BlitFramebuffer, PFNGLBLITFRAMEBUFFERPROC)                 \
  X(BufferData, PFNGLBUFFERDATAPROC)                           \
  X(BufferSubData, PFNGLBUFFERSUBDATAPROC)                     \
  X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)   \
  X(ClearBufferfv, PFNGLCLEARBUFFERFVPROC)                     \
  X(ClearBufferuiv, PFNGLCLEARBUFFERUIVPROC)                   \
  X(ColorMask, PFNGLCOLORMASKPROC)                             \
  X(CompileShader, PFNGLCOMPILESHADERPROC)                     \
  X(CreateProgram, PFNGLCREATEPROGRAMPROC)                     \
  X(CreateShader, PFNGLCREATESHADERPROC)                       \
  X(CullFace, PFNGLCULLFACEPROC)                               \
  X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                     \
  X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)           \
  X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                     \
  X(DeleteQueries, PFNGLDELETEQUERIESPROC)                     \
  X(DeleteShader, PFNGLDELETESHADERPROC)                       \
  X(DeleteTextures, PFNGLDELETETEXTURESPROC)                   \
  X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)           \
  X(DepthFunc, PFNGLDEPTHFUNCPROC)                             \
  X(DepthMask, PFNGLDEPTHMASKPROC)                             \
  X(Disable, PFNGLDISABLEPROC)                                 \
  X(DrawArrays, PFNGLDRAWARRAYSPROC)                           \
  X(DrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC)         \
  X(DrawBuffers, PFNGLDRAWBUFFERSPROC)                         \
  X(DrawElements, PFNGLDRAWELEMENTSPROC)                       \
  X(Enable, PFNGLENABLEPROC)                                   \
  X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC) \
  X(EndQuery, PFNGLENDQUERYPROC)                               \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)       \
  X(FramebufferTextureLayer, PFNGLFRAMEBUFFERTEXTURELAYERPROC) \
  X(GenBuffers, PFNGLGENBUFFERSPROC)                           \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                 \
  X(GenQueries, PFNGLGENQUERIESPROC)                           \
  X(GenTextures, PFNGLGENTEXTURESPROC)                         \
  X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                 \
  X(GetActiveUniform, PFNGLGETACTIVEUNIFORMPROC)               \
  X(GetError, PFNGLGETERRORPROC)                               \
  X(GetIntegerv, PFNGLGETINTEGERVPROC)                         \
  X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)             \
  X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                       \
  X(GetQueryObjectuiv, PFNGLGETQUERYOBJECTUIVPROC)             \
  X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)               \
  X(GetShaderiv, PFNGLGETSHADERIVPROC)                         \
  X(GetString, PFNGLGETSTRINGPROC)                             \
  X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)           \
  X(LinkProgram, PFNGLLINKPROGRAMPROC)                         \
  X(PixelStorei, PFNGLPIXELSTOREIPROC)                         \
  X(ReadBuffer, PFNGLREADBUFFERPROC)                           \
  X(ReadPixels, PFNGLREADPIXELSPROC)                           \
  X(ShaderSource, PFNGLSHADERSOURCEPROC)                       \
  X(TexBuffer, PFNGLTEXBUFFERPROC)                             \
  X(TexImage2D, PFNGLTEXIMAGE2DPROC)                           \
  X(TexImage3D, PFNGLTEXIMAGE3DPROC)                           \
  X(TexParameteri, PFNGLTEXPARAMETERIPROC)                     \
  X(TexSubImage2D, PFNGLTEXSUBIMAGE2DPROC)                     \
  X(TexSubImage3D, PFNGLTEXSUBIMAGE3DPROC)                     \
  X(Uniform1f, PFNGLUNIFORM1FPROC)                             \
  X(Uniform1i, PFNGLUNIFORM1IPROC)                             \
  X(Uniform1ui, PFNGLUNIFORM1UIPROC)                           \
  X(Uniform2f, PFNGLUNIFORM2FPROC)                             \
  X(Uniform2i, PFNGLUNIFORM2IPROC)                             \
  X(Uniform3f, PFNGLUNIFORM3FPROC)                             \
  X(Uniform4f, PFNGLUNIFORM4FPROC)                             \
  X(UniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC)               \
  X(UseProgram, PFNGLUSEPROGRAMPROC)                           \
  X(VertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC)         \
  X(VertexAttribIPointer, PFNGLVERTEXATTRIBIPOINTERPROC)       \
  X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)         \
  X(Viewport, PFNGLVIEWPORTPROC)

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
    const Turn turn(takes_turns_);
    return call_(arguments...);
  }

 private:
  Result (*call_)(Arguments...) = nullptr;
  bool takes_turns_ = false;
};

/// Every entry of one context. Valid while that context is current on the calling thread.
struct Functions {
#define MOLDLIGHT_GL_MEMBER(name, type) Entry<type> name;
  MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_MEMBER)
#undef MOLDLIGHT_GL_MEMBER

  using ProcAddress = std::function<void*(const char*)>;
  /// Loads every entry; throws Error naming the first that the driver lacks.
  [[nodiscard]] static Functions load(const ProcAddress& address) {
    Functions gl;
#define MOLDLIGHT_GL_LOAD(name, type) \
  if (!gl.name.load(address("gl" #name))) throw Error("the OpenGL driver lacks gl" #name);
    MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_LOAD)
#undef MOLDLIGHT_GL_LOAD
    return gl;
  }
  void take_turns() {
#define MOLDLIGHT_GL_TAKE_TURNS(name, type) name.take_turns();
    MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_TAKE_TURNS)
#undef MOLDLIGHT_GL_TAKE_TURNS
  }
};

}  // namespace moldlight::gl
