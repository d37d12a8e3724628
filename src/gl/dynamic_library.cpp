#include <dlfcn.h>

#include "base/error.hpp"
#include "gl/headless_backends.hpp"

namespace moldlight::gl {

DynamicLibrary::DynamicLibrary(const std::vector<std::string>& names) {
  std::string reasons;
  for (const std::string& name : names) {
    handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      name_ = name;
      return;
    }
    const char* reason = dlerror();
    reasons +=
        (reasons.empty() ? "" : ", ") + std::string(reason != nullptr ? reason : name + " does not open");
  }
  throw Error(reasons.empty() ? "no library named" : reasons);
}

void* DynamicLibrary::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (address == nullptr) throw Error(name_ + " has no " + name);
  return address;
}

}  // namespace moldlight::gl
