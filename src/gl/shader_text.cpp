#include "gl/shader_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

#include "base/error.hpp"

namespace moldlight::gl {

namespace {

std::string_view take_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return line;
}

// The path between the quotes of an #include line; empty for any other line.
std::string_view included_path(std::string_view line) {
  if (!line.starts_with("#include")) return {};
  const std::size_t open = line.find('"');
  const std::size_t close = line.rfind('"');
  return open < close ? line.substr(open + 1, close - open - 1) : std::string_view();
}

class Expansion {
 public:
  Expansion(const Defines& defines, std::span<const ShaderFile> sources)
      : defines_(defines), sources_(sources) {}

  void append(std::string_view path, std::string_view included_from) {
    if (std::find(result_.files.begin(), result_.files.end(), path) != result_.files.end()) return;
    const std::string_view text = find(path, included_from);
    const std::size_t index = result_.files.size();
    result_.files.emplace_back(path);
    append_lines(path, text, index);
  }

  [[nodiscard]] ShaderText take() { return std::move(result_); }

 private:
  void append_lines(std::string_view path, std::string_view rest, std::size_t index) {
    bool has_version = index > 0;
    for (int number = 1; !rest.empty(); ++number) {
      const std::string_view line = take_line(rest);
      if (const std::string_view other = included_path(line); !other.empty()) {
        append(other, path);
        continue;
      }
      append_line(line, {index, number});
      if (has_version || !line.starts_with("#version")) continue;
      has_version = true;
      for (const auto& [name, value] : defines_)
        append_line(fmt::format("#define {} {}", name, value), {index, number});
    }
    if (!has_version) throw Error(fmt::format("shaders/{}: no #version line", path));
  }

  void append_line(std::string_view line, ShaderText::Origin origin) {
    result_.text.append(line).append("\n");
    result_.origins.push_back(origin);
  }

  [[nodiscard]] std::string_view find(std::string_view path, std::string_view included_from) const {
    const auto found = std::find_if(sources_.begin(), sources_.end(),
                                    [path](const ShaderFile& file) { return file.path == path; });
    if (found != sources_.end()) return found->text;
    throw Error(fmt::format("shaders/{}: no such file{}{}", path,
                            included_from.empty() ? "" : ", included from shaders/", included_from));
  }

  const Defines& defines_;
  std::span<const ShaderFile> sources_;
  ShaderText result_;
};

bool skip(std::string_view& rest, std::string_view prefix) {
  if (!rest.starts_with(prefix)) return false;
  rest.remove_prefix(prefix.size());
  return true;
}

// Takes a number of digits off the front; 0 if there is none.
std::size_t take_number(std::string_view& rest) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error != std::errc()) return 0;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return number;
}

// Takes the place off the front of a message and returns its line in the text; 0 if it names none. Mesa
// writes "0:12(5): error: …", NVIDIA "0(12) : error C1008: …", others "ERROR: 0:12: …".
std::size_t take_place(std::string_view& message) {
  std::string_view rest = message;
  skip(rest, "ERROR: ");
  if (!skip(rest, "0:") && !skip(rest, "0(")) return 0;
  const std::size_t line = take_number(rest);
  const std::size_t text = rest.find_first_of(": ");
  if (line == 0 || text == std::string_view::npos) return 0;
  rest.remove_prefix(text);
  rest.remove_prefix(std::min(rest.find_first_not_of(": "), rest.size()));
  message = rest;
  return line;
}

bool speaks_of_error(std::string_view line) {
  std::string lower(line);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return lower.find("error") != std::string::npos;
}

}  // namespace

ShaderText expand_shader(std::string_view path, const Defines& defines, std::span<const ShaderFile> files) {
  Expansion expansion(defines, files);
  expansion.append(path, {});
  return expansion.take();
}

std::string es_text(const ShaderText& shader) {
  const std::size_t version = shader.text.find("#version"), end = shader.text.find('\n', version);
  return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
         "precision highp usampler2D;\nprecision highp usampler2DArray;\n" +
         shader.text.substr(end + 1);
}

std::string readable_log(const ShaderText& shader, std::string_view log) {
  std::string_view first;
  int errors = 0;
  for (std::string_view rest = log; !rest.empty();) {
    const std::string_view line = take_line(rest);
    if (line.empty()) continue;
    const bool is_error = speaks_of_error(line);
    if (first.empty() || (is_error && errors == 0)) first = line;
    errors += is_error ? 1 : 0;
  }
  if (first.empty()) first = "the driver gives no reason";

  std::string where = "shaders/" + shader.files.front();
  std::string_view message = first;
  const std::size_t line = take_place(message);
  if (line >= 1 && line <= shader.origins.size()) {
    const ShaderText::Origin& origin = shader.origins[line - 1];
    where = fmt::format("shaders/{}:{}", shader.files[origin.file], origin.line);
    first = message;
  }
  return fmt::format("{}: {}{}", where, first, errors > 1 ? fmt::format(" (and {} more)", errors - 1) : "");
}

}  // namespace moldlight::gl
