#include "gl/headless_context.hpp"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/own_files.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gl {

namespace {

namespace fs = std::filesystem;

bool can_write(const fs::path& folder) { return ::access(folder.c_str(), W_OK | X_OK) == 0; }

// Mesa makes the last component of a path itself, but nothing above it.
bool can_write_or_make(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder, ignored) ? can_write(folder) : can_write(folder.parent_path());
}

/// Software drivers take memory unasked and fall over where there is none.
void require_room() {
  constexpr std::size_t k_bytes = std::size_t{320} << 20;
  void* room = ::mmap(nullptr, k_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, k_bytes);
}

}  // namespace

DynamicLibrary::DynamicLibrary(const std::vector<std::string>& names) {
  std::string reasons;
  for (const std::string& name : names) {
    handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      name_ = name;
      return;
    }
    const char* reason = dlerror();
    reasons +=
        (reasons.empty() ? "" : ", ") + std::string(reason != nullptr ? reason : name + " does not open");
  }
  throw Error(reasons.empty() ? "no library named" : reasons);
}

void* DynamicLibrary::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (address == nullptr) throw Error(name_ + " has no " + name);
  return address;
}

bool shader_cache_is_writable() {
  if (const char* folder = std::getenv("MESA_SHADER_CACHE_DIR")) return can_write_or_make(folder);
  fs::path parent;
  if (const char* caches = std::getenv("XDG_CACHE_HOME")) {
    parent = caches;
  } else if (const char* home = std::getenv("HOME")) {
    parent = fs::path(home) / ".cache";
  } else {
    return false;
  }
  std::error_code ignored;
  const fs::path cache = parent / "mesa_shader_cache";
  return fs::exists(cache, ignored) ? can_write(cache) : can_write_or_make(parent);
}

void prepare_mesa_environment() {
  static std::once_flag once;
  std::call_once(once, [] {
    constexpr int k_keep_the_users = 0;
    if (!shader_cache_is_writable()) ::setenv("MESA_SHADER_CACHE_DISABLE", "true", k_keep_the_users);
    ::setenv("EGL_LOG_LEVEL", "fatal", k_keep_the_users);
  });
}

namespace {

struct Wanted {
  HeadlessBackend backend;
  const std::function<void(const Context&)>& inspect;
};

/// Tries the libraries in the order that the header says; null, and why in `reasons`, if none will do.
std::unique_ptr<Context> context_of(const HeadlessLibraries& libraries, const Wanted& wanted,
                                    std::string& reasons) {
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
  for (const Attempt& attempt : attempts) {
    if (wanted.backend != HeadlessBackend::automatic && wanted.backend != attempt.belongs_to) continue;
    try {
      std::unique_ptr<Context> context = attempt.create(attempt.names);
      if (wanted.inspect) wanted.inspect(*context);
      return context;
    } catch (const Error& error) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", attempt.name, error.what());
    }
  }
  return nullptr;
}

/// The software GL that an archive carries beside the program, for machines that have none.
std::optional<HeadlessLibraries> carried_libraries() {
  constexpr const char* k_places[] = {"../lib/moldlight/gl"};
  const auto folder = own_file(k_places);
  if (!folder) return std::nullopt;
  static std::once_flag once;
  std::call_once(once, [&folder] {
    constexpr int k_replace = 1;
    ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", (*folder / "vendor.json").c_str(), k_replace);
    ::setenv("LIBGL_DRIVERS_PATH", folder->c_str(), k_replace);
    // ImGui asks for it by this name, and then gets what is open.
    dlopen((*folder / "libGL.so.1").c_str(), RTLD_NOW | RTLD_LOCAL);
  });
  return HeadlessLibraries{{*folder / "libEGL.so.1"}, {*folder / "libOSMesa.so.8"}};
}

}  // namespace

std::unique_ptr<Context> create_headless_context(HeadlessBackend backend, const HeadlessLibraries& libraries,
                                                 const std::function<void(const Context&)>& inspect) {
  prepare_mesa_environment();
  const SoftwareGlLock turn(true);
  require_room();
  const Wanted wanted = {backend, inspect};
  std::string reasons;
  if (auto context = context_of(libraries, wanted, reasons)) return context;
  if (const auto carried = carried_libraries())
    if (auto context = context_of(*carried, wanted, reasons)) return context;
  throw Error(fmt::format(
      "no OpenGL 3.3 context without a window ({}); install {}", reasons,
      backend == HeadlessBackend::osmesa ? "libosmesa6" : "libegl1 and libgl1-mesa-dri, or a GPU driver"));
}

}  // namespace moldlight::gl
