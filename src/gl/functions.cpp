#include "gl/functions.hpp"

#include <string>

#include "base/error.hpp"

namespace moldlight::gl {

Functions Functions::load(const ProcAddress& address) {
  Functions gl;
#define MOLDLIGHT_GL_LOAD(name, type)                    \
  gl.name = reinterpret_cast<type>(address("gl" #name)); \
  if (gl.name == nullptr) throw Error("the OpenGL driver lacks gl" #name);
  MOLDLIGHT_GL_FUNCTIONS(MOLDLIGHT_GL_LOAD)
#undef MOLDLIGHT_GL_LOAD
  return gl;
}

}  // namespace moldlight::gl
