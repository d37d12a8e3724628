#include "session/headless.hpp"

namespace moldlight {

std::unique_ptr<gl::Context> create_context(Backend backend) {
  switch (backend) {
    case Backend::egl:
      return gl::create_headless_context(gl::HeadlessBackend::egl);
    case Backend::osmesa:
      return gl::create_headless_context(gl::HeadlessBackend::osmesa);
    case Backend::automatic:
      break;
  }
  return gl::create_headless_context(gl::HeadlessBackend::automatic);
}

}  // namespace moldlight
