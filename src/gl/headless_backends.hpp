// Backends of create_headless_context, one function each, with the libraries that they open, and
// the environment that Mesa reads before its first context.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/context.hpp"

namespace moldlight::gl {

/// A shared library opened at run time, so that the program starts on machines that lack it. Stays open to
/// the end of the process: GL drivers leave thread-exit handlers behind that must not be unmapped.
class DynamicLibrary {
 public:
  /// Opens the first of `names` that opens; its symbols stay out of the process's global scope. Throws Error
  /// with the reason for each.
  explicit DynamicLibrary(const std::vector<std::string>& names);

  /// Sets `function` to the entry `name`; throws Error where the library lacks it.
  template <typename Function>
  void load(Function*& function, const char* name) const {
    function = reinterpret_cast<Function*>(symbol(name));
  }

 private:
  [[nodiscard]] void* symbol(const char* name) const;

  void* handle_ = nullptr;
  std::string name_;
};

/// The backends: each makes its context current and throws Error with the reason where that fails. This one
/// is on the first device that EGL lists and that gives a context: a GPU where there is one, else the
/// software device.
[[nodiscard]] std::unique_ptr<Context> create_egl_device_context(const std::vector<std::string>& libraries);

/// On Mesa's platform without surfaces.
[[nodiscard]] std::unique_ptr<Context> create_egl_surfaceless_context(
    const std::vector<std::string>& libraries);

/// Mesa's software renderer without EGL.
[[nodiscard]] std::unique_ptr<Context> create_osmesa_context(const std::vector<std::string>& libraries);

/// True if Mesa will find a writable folder for its shader cache, which saves a start 30 ms of compiling.
[[nodiscard]] bool shader_cache_is_writable();

/// Keeps Mesa quiet on stderr: turns its shader cache off where the folder cannot be written, and its
/// warnings about devices that it passes over. What the user has set stays. Acts once a process; call it
/// before a context is created, while no other thread reads the environment.
void prepare_mesa_environment();

}  // namespace moldlight::gl
