// OpenGL contexts: the interface that windows share with the contexts without a window (EGL device, EGL
// surfaceless, OSMesa), and the making of the latter.
#pragma once

#include <string>
#include <thread>

#include "gl/functions.hpp"

namespace moldlight::gl {

/// A GL 3.3 (or later) core context. There may be no default framebuffer: draw to framebuffer objects only. A
/// thread has one current context at most and a context is current on one thread at most; both are CHECKed.
class Context {
 public:
  virtual ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes the context current on the calling thread, after releasing the one that was. Costs nothing if it
  /// already is.
  void make_current();
  /// Releases it from the calling thread, so that another one may take it; nothing happens if it is not
  /// current here.
  void release_current();

  [[nodiscard]] const Functions& functions() const { return functions_; }
  /// "EGL device", "EGL surfaceless", "OSMesa" or "window".
  [[nodiscard]] const std::string& backend() const { return backend_; }
  /// GL_RENDERER.
  [[nodiscard]] const std::string& renderer() const { return renderer_; }
  /// Whether the renderer is one of Mesa's for machines without a GPU.
  [[nodiscard]] bool draws_on_cpu() const { return draws_on_cpu_; }

 protected:
  Context() = default;
  /// Makes the context current, loads the functions and reads the strings. The constructor of a derived class
  /// calls it last; throws Error where the driver has less than OpenGL 3.3.
  void initialise(std::string backend, const Functions::ProcAddress& address);

  /// The backend's own calls; throw Error with the reason. The destructor of a derived class calls
  /// release_current() before it destroys what unbind() needs.
  virtual void bind() = 0;
  virtual void unbind() noexcept = 0;

 private:
  Functions functions_;
  std::string backend_, renderer_;
  bool draws_on_cpu_ = true;  // until that is known
  std::thread::id owner_;     // the thread on which it is current; none when default-constructed
};

}  // namespace moldlight::gl
