#include "gl/headless_context.hpp"

#include <new>

#include <fmt/format.h>
#include <sys/mman.h>

#include "base/error.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gl {

namespace {

/// Software drivers take memory unasked and fall over where there is none.
void require_room() {
  constexpr std::size_t k_bytes = std::size_t{320} << 20;
  void* room = ::mmap(nullptr, k_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, k_bytes);
}

}  // namespace

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
