#include "gl/context.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gl {

namespace {

// The libraries behind the backends do not know of each other, yet Mesa's share one dispatch table per
// thread: whoever binds must know whom to release first.
thread_local Context* current_context = nullptr;

std::string text(const Functions& gl, GLenum name) {
  const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
  return value != nullptr ? value : "";
}

/// Software drivers take memory unasked and fall over where there is none.
void require_room() {
  constexpr std::size_t k_bytes = std::size_t{320} << 20;
  void* room = ::mmap(nullptr, k_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, k_bytes);
}

}  // namespace

Context::~Context() { CHECK(owner_ == std::thread::id()); }

void Context::make_current() {
  if (current_context == this) return;
  CHECK(owner_ == std::thread::id());
  const Turn turn(draws_on_cpu_);
  if (current_context != nullptr) current_context->release_current();
  bind();
  owner_ = std::this_thread::get_id();
  current_context = this;
}

void Context::release_current() {
  if (current_context != this) return;
  const Turn turn(draws_on_cpu_);
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
    if (major * 10 + minor < 33) {
      throw Error(fmt::format("the driver has OpenGL {}, 3.3 is needed", text(functions_, GL_VERSION)));
    }
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

std::unique_ptr<Context> create_headless_context(HeadlessBackend backend, const HeadlessLibraries& libraries,
                                                 const std::function<void(const Context&)>& inspect) {
  using Create = std::unique_ptr<Context> (*)(const std::vector<std::string>&);
  struct Attempt {
    const char* name;
    HeadlessBackend belongs_to;
    Create create;
    const std::vector<std::string>& names;
  };
  const Attempt attempts[] = {
      {"EGL device", HeadlessBackend::egl, create_egl_device_context, libraries.egl},
      {"EGL surfaceless", HeadlessBackend::egl, create_egl_surfaceless_context, libraries.egl},
      {"OSMesa", HeadlessBackend::osmesa, create_osmesa_context, libraries.osmesa},
  };
  prepare_mesa_environment();
  const Turn turn(true);
  require_room();
  std::string reasons;
  for (const Attempt& attempt : attempts) {
    if (backend != HeadlessBackend::automatic && backend != attempt.belongs_to) continue;
    try {
      std::unique_ptr<Context> context = attempt.create(attempt.names);
      if (inspect) inspect(*context);
      return context;
    } catch (const Error& error) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", attempt.name, error.what());
    }
  }
  throw Error(fmt::format(
      "no OpenGL 3.3 context without a window ({}); install {}", reasons,
      backend == HeadlessBackend::osmesa ? "libosmesa6" : "libegl1 and libgl1-mesa-dri, or a GPU driver"));
}

}  // namespace moldlight::gl
