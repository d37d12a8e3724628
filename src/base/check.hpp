// CHECK: our own mistakes end the program in every build, with the place and the broken condition.
#pragma once

namespace moldlight {

[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace moldlight

#define CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::moldlight::check_failed(#condition, __FILE__, __LINE__))
