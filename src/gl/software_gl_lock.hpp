// Whose turn it is where the GL draws on the processor.
#pragma once

#include <mutex>

namespace moldlight::gl {

/// While it lives, no other thread makes calls of a GL that draws on the processor: llvmpipe (Mesa 22.3)
/// walks the scenes of all contexts of the process while another thread frees its own, without a lock.
/// Contexts take it for every call by themselves; who calls the GL past them takes it, too. Turns nest.
class SoftwareGlLock {
 public:
  /// `needed`: Context::draws_on_cpu(), or true where that is not known yet.
  explicit SoftwareGlLock(bool needed) : lock_(mutex(), std::defer_lock) {
    if (needed) lock_.lock();
  }

 private:
  static std::recursive_mutex& mutex() {
    static std::recursive_mutex one;
    return one;
  }
  std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace moldlight::gl
