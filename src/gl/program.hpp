// Shader programs from the embedded files. A name that the program does not have is an error, never silence.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/objects.hpp"
#include "gl/shader_text.hpp"

namespace moldlight::gl {

/// Paths below shaders/; `fragment` may be empty. Lines `#include "common/x.glsl"` are replaced by that file
/// (once a stage). `defines` become `#define NAME VALUE` after the #version line.
struct ProgramSources {
  std::string_view vertex;
  std::string_view fragment = {};
  Defines defines = {};
};

/// Leaves no program in use.
void use_no_program(const Functions& gl);

class Program {
 public:
  /// Compiles and links; throws Error with file, line and the driver's first complaint.
  Program(const Functions& gl, const ProgramSources& sources,
          std::span<const ShaderFile> files = shader_files());

  void use() const { gl_->UseProgram(program_.name()); }
  /// Each sets a uniform of the program in use; CHECKs that the program has an active uniform of that name.
  /// Element k of an array is "name[k]".
  void set(std::string_view name, float value) const { gl_->Uniform1f(location(name), value); }
  void set(std::string_view name, double value) const { set(name, static_cast<float>(value)); }
  void set(std::string_view name, int value) const { gl_->Uniform1i(location(name), value); }
  void set(std::string_view name, std::uint32_t value) const { gl_->Uniform1ui(location(name), value); }
  void set(std::string_view name, const glm::vec2& value) const {
    gl_->Uniform2f(location(name), value.x, value.y);
  }
  void set(std::string_view name, const glm::ivec2& value) const {
    gl_->Uniform2i(location(name), value.x, value.y);
  }
  void set(std::string_view name, const glm::vec3& value) const {
    gl_->Uniform3f(location(name), value.x, value.y, value.z);
  }
  void set(std::string_view name, const glm::vec4& value) const {
    gl_->Uniform4f(location(name), value.x, value.y, value.z, value.w);
  }
  void set(std::string_view name, const glm::mat4& value) const {
    gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
  }
  /// Binds `texture` to unit `unit` and points the sampler `name` there.
  void set_texture(std::string_view name, int unit, GLenum target, const Texture& texture) const;
  [[nodiscard]] bool has(std::string_view name) const { return uniforms_.contains(name); }

 private:
  [[nodiscard]] GLint location(std::string_view name) const;

  const Functions* gl_;
  Handle<&Functions::DeleteProgram> program_;
  std::string name_;
  std::map<std::string, GLint, std::less<>> uniforms_;
};

/// Programs of the embedded files, each variant compiled when it is first needed.
class Programs {
 public:
  explicit Programs(const Functions& gl) : gl_(&gl) {}
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;
  /// Those of the context, which all that draw in it share: a driver makes a program's code anew for each
  /// copy of it, where that is first drawn with. They go with the last who holds them.
  [[nodiscard]] static std::shared_ptr<Programs> of(const Functions& gl);
  /// A card's driver was seen to draw nothing by a program made after one was deleted that was in use.
  ~Programs() {
    if (!programs_.empty()) use_no_program(*gl_);
  }

  /// The program of these files below shaders/ with each of `defines` defined, in use from now on; empty
  /// defines are left out. Throws Error where it does not compile.
  const Program& use(std::string_view vertex, std::string_view fragment,
                     const std::vector<std::string_view>& defines = {});
  /// How many have been compiled.
  [[nodiscard]] std::size_t count() const { return programs_.size(); }

 private:
  const Functions* gl_;
  std::map<std::string, Program, std::less<>> programs_;
};

}  // namespace moldlight::gl
