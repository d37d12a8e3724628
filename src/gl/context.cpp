#include "gl/context.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moldlight::gl {

namespace {

// The libraries behind the backends do not know of each other, yet Mesa's share one dispatch table per
// thread: whoever binds must know whom to release first.
thread_local Context* current_context = nullptr;

std::string text(const Functions& gl, GLenum name) {
  const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
  return value != nullptr ? value : "";
}

}  // namespace

Context::~Context() { CHECK(owner_ == std::thread::id()); }

void Context::make_current() {
  if (current_context == this) return;
  CHECK(owner_ == std::thread::id());
  const SoftwareGlLock turn(draws_on_cpu_);
  if (current_context != nullptr) current_context->release_current();
  bind();
  owner_ = std::this_thread::get_id();
  current_context = this;
}

void Context::release_current() {
  if (current_context != this) return;
  const SoftwareGlLock turn(draws_on_cpu_);
  unbind();
  owner_ = std::thread::id();
  current_context = nullptr;
}

void Context::initialise(std::string backend, const Functions::ProcAddress& address) {
  make_current();
  try {
    functions_ = Functions::load(address);
    GLint major = 0, minor = 0;
    functions_.GetIntegerv(GL_MAJOR_VERSION, &major);
    functions_.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33)
      throw Error(fmt::format("the driver has OpenGL {}, 3.3 is needed", text(functions_, GL_VERSION)));
    backend_ = std::move(backend);
    renderer_ = text(functions_, GL_RENDERER);
    draws_on_cpu_ =
        std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast"},
                            [this](const char* name) { return renderer_.find(name) != std::string::npos; });
    if (draws_on_cpu_) functions_.take_turns();
  } catch (...) {
    release_current();
    throw;
  }
}

}  // namespace moldlight::gl
