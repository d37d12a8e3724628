// The programs of a picture, each variant compiled when it is first needed.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gl/program.hpp"

namespace moldlight {

class ViewPrograms {
 public:
  explicit ViewPrograms(const gl::Functions& gl) : gl_(&gl) {}

  /// The program of these files below shaders/ with each of `defines` defined, in use from now on; empty
  /// defines are left out. Throws Error where it does not compile.
  const gl::Program& use(std::string_view vertex, std::string_view fragment,
                         const std::vector<std::string_view>& defines = {});

 private:
  const gl::Functions* gl_;
  std::map<std::string, gl::Program, std::less<>> programs_;
};

}  // namespace moldlight
