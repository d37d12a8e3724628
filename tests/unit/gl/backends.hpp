// The headless backends as the tests walk them: each that this machine has, by name.
#pragma once

#include <iostream>
#include <memory>
#include <vector>

#include "base/error.hpp"
#include "gl/headless_backends.hpp"
#include "gl/headless_context.hpp"

namespace moldlight::gl {

/// Contexts of all backends that work here, none of them current; shows what is missing and why.
inline std::vector<std::unique_ptr<Context>> available_contexts() {
  const HeadlessLibraries libraries;
  std::vector<std::unique_ptr<Context>> contexts;
  const auto add = [&contexts](auto create, const std::vector<std::string>& names) {
    try {
      contexts.push_back(create(names));
      contexts.back()->release_current();
    } catch (const Error& error) {
      std::cout << "left out: " << error.what() << '\n';
    }
  };
  add(create_egl_device_context, libraries.egl);
  add(create_egl_surfaceless_context, libraries.egl);
  add(create_osmesa_context, libraries.osmesa);
  return contexts;
}

}  // namespace moldlight::gl
