// The GL context that a setting asks for.
#pragma once

#include <memory>

#include "gl/context.hpp"
#include "session/settings.hpp"

namespace moldlight {

/// A context without a window, current on the calling thread. Throws Error that says what was tried and why
/// each failed.
[[nodiscard]] inline std::unique_ptr<gl::Context> create_context(Backend backend) {
  return gl::create_headless_context(backend);
}

}  // namespace moldlight
