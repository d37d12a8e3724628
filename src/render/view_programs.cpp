#include "render/view_programs.hpp"

namespace moldlight {

const gl::Program& ViewPrograms::use(std::string_view vertex, std::string_view fragment,
                                     const std::vector<std::string_view>& defines) {
  std::string key(vertex);
  key.append(" ").append(fragment);
  for (const std::string_view define : defines) key.append(" ").append(define);
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    gl::ProgramSources sources{.vertex = vertex, .fragment = fragment};
    for (const std::string_view define : defines) {
      if (!define.empty()) sources.defines.emplace_back(define, "1");
    }
    found = programs_.emplace(std::move(key), gl::Program(*gl_, sources)).first;
  }
  found->second.use();
  return found->second;
}

}  // namespace moldlight
