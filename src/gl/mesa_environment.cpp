#include <cstdlib>
#include <filesystem>
#include <mutex>

#include <unistd.h>

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

}  // namespace

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

}  // namespace moldlight::gl
