// The backends behind create_headless_context, one function each. Every one makes its context current and
// throws Error with the reason where that fails.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/context.hpp"

namespace moldlight::gl {

/// On the first device that EGL lists and that gives a context: a GPU where there is one, else the software
/// device.
[[nodiscard]] std::unique_ptr<Context> create_egl_device_context(const std::vector<std::string>& libraries);

/// On Mesa's platform without surfaces.
[[nodiscard]] std::unique_ptr<Context> create_egl_surfaceless_context(
    const std::vector<std::string>& libraries);

/// Mesa's software renderer without EGL.
[[nodiscard]] std::unique_ptr<Context> create_osmesa_context(const std::vector<std::string>& libraries);

}  // namespace moldlight::gl
