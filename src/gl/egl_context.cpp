// EGL contexts without surfaces, on a device or on Mesa's surfaceless platform. The platform is always named,
// so no X server and no Wayland compositor is asked. EGL_EXT_platform_device, EGL_MESA_platform_surfaceless.
#define EGL_NO_X11
#include <string_view>
#include <utility>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gl {

namespace {

struct Egl {
  decltype(&eglGetProcAddress) proc_address;
  decltype(&eglGetError) get_error;
  decltype(&eglQueryString) query_string;
  decltype(&eglInitialize) initialize;
  decltype(&eglBindAPI) bind_api;
  decltype(&eglCreateContext) create_context;
  decltype(&eglDestroyContext) destroy_context;
  decltype(&eglMakeCurrent) make_current;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;

  explicit Egl(const std::vector<std::string>& names) {
    const DynamicLibrary library(names);
    library.load(proc_address, "eglGetProcAddress");
    library.load(get_error, "eglGetError");
    library.load(query_string, "eglQueryString");
    library.load(initialize, "eglInitialize");
    library.load(bind_api, "eglBindAPI");
    library.load(create_context, "eglCreateContext");
    library.load(destroy_context, "eglDestroyContext");
    library.load(make_current, "eglMakeCurrent");
    require_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
    get_platform_display = extension_entry<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  }

  template <typename Entry>
  [[nodiscard]] Entry extension_entry(const char* name) const {
    const auto entry = reinterpret_cast<Entry>(proc_address(name));
    if (entry == nullptr) throw Error(std::string("EGL has no ") + name);
    return entry;
  }

  void require_extension(EGLDisplay display, std::string_view name) const {
    const char* list = query_string(display, EGL_EXTENSIONS);
    std::string_view rest = list != nullptr ? list : "";
    while (!rest.empty()) {
      const std::size_t end = rest.find(' ');
      if (rest.substr(0, end) == name) return;
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    throw Error(fmt::format("EGL has no {}", name));
  }

  [[nodiscard]] Error failure(const char* call) const {
    return Error(fmt::format("{} fails with EGL error 0x{:04x}", call, get_error()));
  }
};

class EglContext final : public Context {
 public:
  EglContext(const Egl& egl, EGLenum platform, void* device, const char* backend)
      : egl_(egl), display_(egl_.get_platform_display(platform, device, nullptr)) {
    if (display_ == EGL_NO_DISPLAY) throw egl_.failure("eglGetPlatformDisplayEXT");
    // Never terminated: a display is one for the whole process, and contexts of other threads may live on it.
    if (egl_.initialize(display_, nullptr, nullptr) == EGL_FALSE) throw egl_.failure("eglInitialize");
    for (const char* extension :
         {"EGL_KHR_create_context", "EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
      egl_.require_extension(display_, extension);
    }
    if (egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE) throw egl_.failure("eglBindAPI");
    for (const auto& [major, minor] : {std::pair{4, 5}, std::pair{3, 3}}) {
      const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                   major,
                                   EGL_CONTEXT_MINOR_VERSION_KHR,
                                   minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                   EGL_NONE};
      context_ = egl_.create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
      if (context_ != EGL_NO_CONTEXT) break;
    }
    if (context_ == EGL_NO_CONTEXT) throw egl_.failure("eglCreateContext");
    try {
      initialise(backend,
                 [this](const char* name) { return reinterpret_cast<void*>(egl_.proc_address(name)); });
    } catch (...) {
      egl_.destroy_context(display_, context_);
      throw;
    }
  }
  ~EglContext() override {
    release_current();
    const SoftwareGlLock turn(draws_on_cpu());
    egl_.destroy_context(display_, context_);
  }

 private:
  // Which API a thread has bound decides what eglMakeCurrent releases, and a new thread has OpenGL ES.
  void bind() override {
    if (egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE ||
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      throw egl_.failure("eglMakeCurrent");
    }
  }
  void unbind() noexcept override {
    egl_.bind_api(EGL_OPENGL_API);
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

  Egl egl_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

std::vector<EGLDeviceEXT> devices(const Egl& egl) {
  egl.require_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration");
  egl.require_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device");
  const auto query = egl.extension_entry<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (query(0, nullptr, &count) == EGL_FALSE) throw egl.failure("eglQueryDevicesEXT");
  std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
  if (count > 0 && query(count, found.data(), &count) == EGL_FALSE) throw egl.failure("eglQueryDevicesEXT");
  found.resize(static_cast<std::size_t>(count));
  return found;
}

}  // namespace

std::unique_ptr<Context> create_egl_device_context(const std::vector<std::string>& libraries) {
  const Egl egl(libraries);
  std::string reasons;
  int index = 0;
  for (const EGLDeviceEXT device : devices(egl)) {
    try {
      return std::make_unique<EglContext>(egl, EGL_PLATFORM_DEVICE_EXT, device, "EGL device");
    } catch (const Error& error) {
      reasons += fmt::format("{}device {}: {}", reasons.empty() ? "" : ", ", index++, error.what());
    }
  }
  throw Error(reasons.empty() ? "EGL lists no device" : reasons);
}

std::unique_ptr<Context> create_egl_surfaceless_context(const std::vector<std::string>& libraries) {
  const Egl egl(libraries);
  egl.require_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless");
  return std::make_unique<EglContext>(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY,
                                      "EGL surfaceless");
}

}  // namespace moldlight::gl
