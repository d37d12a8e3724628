// GL contexts without a window.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gl/context.hpp"
#include "gl/headless_backend.hpp"

namespace moldlight::gl {

/// File names under which the libraries are looked for, the first that opens is taken.
struct HeadlessLibraries {
  std::vector<std::string> egl = {"libEGL.so.1"};
  std::vector<std::string> osmesa = {"libOSMesa.so.8", "libOSMesa.so.6"};
};

/// Creates a context and makes it current. Automatic tries EGL device, EGL surfaceless, OSMesa, and the same
/// of an archive that carries its own GL; egl without OSMesa. No X server is contacted. `inspect` throws
/// Error for a context that is not to be used, and the next is tried. Throws std::bad_alloc where drivers
/// would hardly find room, Error that lists what was tried and why each failed.
[[nodiscard]] std::unique_ptr<Context> create_headless_context(
    HeadlessBackend backend, const HeadlessLibraries& libraries = {},
    const std::function<void(const Context&)>& inspect = {});

}  // namespace moldlight::gl
