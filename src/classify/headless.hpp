// The GL context that a setting asks for, and whether its driver draws what it should.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "classify/settings.hpp"
#include "gl/context.hpp"

namespace moldlight {

/// Draws the maps of a small known part and compares them with those of the scan converter, texel by texel,
/// in a few milliseconds. What is wrong, in words that go after the driver's name; empty if nothing is. The
/// context must be current.
[[nodiscard]] std::string driver_fault(const gl::Context& context);

/// A context without a window, current on the calling thread, whose driver draws rightly. Throws Error that
/// says what was tried and why each failed.
[[nodiscard]] std::unique_ptr<gl::Context> create_context(Backend backend);

/// What stands in the way of a backend, or its driver's name.
struct BackendReport {
  std::string backend, renderer;  // empty renderer: there is no context
  std::string fault;
};
/// All backends, tried one after the other.
[[nodiscard]] std::vector<BackendReport> backend_reports();

}  // namespace moldlight
