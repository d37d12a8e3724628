// A shared library opened at run time, so that the program starts on machines that lack it.
#pragma once

#include <string>
#include <vector>

namespace moldlight::gl {

/// Stays open to the end of the process: GL drivers leave thread-exit handlers behind that must not be
/// unmapped.
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

}  // namespace moldlight::gl
