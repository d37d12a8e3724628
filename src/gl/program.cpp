#include "gl/program.hpp"

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moldlight::gl {

namespace {

using Shader = Handle<&Functions::DeleteShader>;

template <typename GetParameter, typename GetLog>
std::string info_log(GetParameter get_parameter, GetLog get_log, GLuint name) {
  GLint length = 0;
  get_parameter(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  if (length > 0) get_log(name, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

Shader compile(const Functions& gl, GLenum stage, const ShaderText& source) {
  Shader shader(gl, gl.CreateShader(stage));
  const char* text = source.text.c_str();
  gl.ShaderSource(shader.name(), 1, &text, nullptr);
  gl.CompileShader(shader.name());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE)
    throw Error(readable_log(source, info_log(gl.GetShaderiv, gl.GetShaderInfoLog, shader.name())));
  return shader;
}

// Uniforms in the default block with their locations; of an array, its own name and each element's.
std::map<std::string, GLint, std::less<>> active_uniforms(const Functions& gl, GLuint program) {
  std::map<std::string, GLint, std::less<>> uniforms;
  GLint count = 0, longest = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  std::string buffer(static_cast<std::size_t>(longest) + 1, '\0');
  for (GLint index = 0; index < count; ++index) {
    GLsizei length = 0;
    GLint size = 0;
    GLenum type = 0;
    gl.GetActiveUniform(program, static_cast<GLuint>(index), static_cast<GLsizei>(buffer.size()), &length,
                        &size, &type, buffer.data());
    const std::string name(buffer.data(), static_cast<std::size_t>(length));
    const GLint location = gl.GetUniformLocation(program, name.c_str());
    if (location < 0) continue;
    uniforms[name] = location;
    if (!name.ends_with("[0]")) continue;
    const std::string base = name.substr(0, name.size() - 3);
    uniforms[base] = location;
    for (GLint element = 1; element < size; ++element) {
      const std::string element_name = fmt::format("{}[{}]", base, element);
      uniforms[element_name] = gl.GetUniformLocation(program, element_name.c_str());
    }
  }
  return uniforms;
}

}  // namespace

Program::Program(const Functions& gl, const ProgramSources& sources, std::span<const ShaderFile> files)
    : gl_(&gl), program_(gl, gl.CreateProgram()), name_(sources.vertex) {
  const std::pair<GLenum, std::string_view> stages[] = {{GL_VERTEX_SHADER, sources.vertex},
                                                        {GL_FRAGMENT_SHADER, sources.fragment}};
  std::vector<Shader> shaders;
  for (const auto& [stage, path] : stages) {
    if (path.empty()) continue;
    if (stage != GL_VERTEX_SHADER) name_.append(" + ").append(path);
    shaders.push_back(compile(gl, stage, expand_shader(path, sources.defines, files)));
    gl.AttachShader(program_.name(), shaders.back().name());
  }
  gl.LinkProgram(program_.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    throw Error(
        readable_log({{}, {name_}, {}}, info_log(gl.GetProgramiv, gl.GetProgramInfoLog, program_.name())));
  }
  uniforms_ = active_uniforms(gl, program_.name());
}

void use_no_program(const Functions& gl) { gl.UseProgram(0); }

void Program::set_texture(std::string_view name, int unit, GLenum target, const Texture& texture) const {
  gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_->BindTexture(target, texture.name());
  gl_->Uniform1i(location(name), unit);
}

GLint Program::location(std::string_view name) const {
  const auto found = uniforms_.find(name);
  if (found == uniforms_.end())
    check_failed(fmt::format("an active uniform {} in {}", name, name_).c_str(), __FILE__, __LINE__);
  return found->second;
}

std::shared_ptr<Programs> Programs::of(const Functions& gl) {
  std::shared_ptr<Programs> programs = gl.programs.lock();
  if (!programs) gl.programs = programs = std::make_shared<Programs>(gl);
  return programs;
}

const Program& Programs::use(std::string_view vertex, std::string_view fragment,
                             const std::vector<std::string_view>& defines) {
  std::string key(vertex);
  key.append(" ").append(fragment);
  for (const std::string_view define : defines) key.append(" ").append(define);
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    ProgramSources sources{.vertex = vertex, .fragment = fragment};
    for (const std::string_view define : defines)
      if (!define.empty()) sources.defines.emplace_back(define, "1");
    found = programs_.emplace(std::move(key), Program(*gl_, sources)).first;
  }
  found->second.use();
  return found->second;
}

}  // namespace moldlight::gl
