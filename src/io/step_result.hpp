// The bytes that moldlight-step hands back to moldlight: a tessellated STEP file. OpenCASCADE runs
// in that program of its own, so that a file which breaks it does not break moldlight.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace moldlight {

/// Numbers, strings and arrays in a row of bytes, for two programs of ours on one machine.
class ByteWriter {
 public:
  template <typename T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(std::string_view value) {
    number<std::uint64_t>(value.size());
    bytes_ += value;
  }
  template <typename T>
  void array(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    number<std::uint64_t>(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Trusts nothing: every call throws std::out_of_range where the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  [[nodiscard]] T number() {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  [[nodiscard]] std::string text() { return std::string(take(number<std::uint64_t>())); }
  template <typename T>
  [[nodiscard]] std::vector<T> array() {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto count = number<std::uint64_t>();
    if (count > bytes_.size() / sizeof(T)) throw std::out_of_range("an array ends too early");
    std::vector<T> values(count);
    const std::string_view raw = take(count * sizeof(T));
    if (count > 0) std::memcpy(values.data(), raw.data(), raw.size());
    return values;
  }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) throw std::out_of_range("a value ends too early");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
};

/// File descriptor that moldlight-step writes its result to.
inline constexpr int k_step_result_descriptor = 3;
/// And that it finds the file open at.
inline constexpr int k_step_file_descriptor = 4;

struct StepBody {
  std::string name;
  std::uint64_t facets = 0;
};

struct StepResult {
  std::string error;  // one sentence; the rest is empty then
  std::string unit;   // "mm", "in", …
  std::vector<std::string> warnings;
  std::vector<StepBody> bodies;                 // runs of facets, in order
  std::vector<std::array<double, 3>> vertices;  // in the unit
  std::vector<std::array<std::uint32_t, 3>> facets;
  std::vector<std::uint32_t> faces;         // CAD face of each facet, from 0
  std::vector<std::uint32_t> face_colours;  // as of Part

  [[nodiscard]] std::string to_bytes() const {
    ByteWriter out;
    out.text(error);
    out.text(unit);
    out.number<std::uint64_t>(warnings.size());
    for (const std::string& warning : warnings) out.text(warning);
    out.number<std::uint64_t>(bodies.size());
    for (const StepBody& body : bodies) {
      out.text(body.name);
      out.number(body.facets);
    }
    out.array(vertices);
    out.array(facets);
    out.array(faces);
    out.array(face_colours);
    return out.bytes();
  }

  /// Throws std::out_of_range for bytes cut short.
  [[nodiscard]] static StepResult from_bytes(std::string_view bytes) {
    ByteReader in(bytes);
    StepResult result;
    result.error = in.text();
    result.unit = in.text();
    for (auto count = in.number<std::uint64_t>(); count > 0; --count) result.warnings.push_back(in.text());
    for (auto count = in.number<std::uint64_t>(); count > 0; --count) {
      StepBody body;
      body.name = in.text();
      body.facets = in.number<std::uint64_t>();
      result.bodies.push_back(std::move(body));
    }
    result.vertices = in.array<std::array<double, 3>>();
    result.facets = in.array<std::array<std::uint32_t, 3>>();
    result.faces = in.array<std::uint32_t>();
    result.face_colours = in.array<std::uint32_t>();
    return result;
  }
};

}  // namespace moldlight
