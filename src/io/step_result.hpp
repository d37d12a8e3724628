// What the program moldlight-step hands back to moldlight: a tessellated STEP file as bytes. OpenCASCADE runs
// in that program of its own, so that a file which breaks it does not break moldlight.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/byte_stream.hpp"

namespace moldlight {

/// File descriptor that moldlight-step writes its result to.
inline constexpr int k_step_result_descriptor = 3;

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
  std::vector<std::uint32_t> faces;  // CAD face of each facet, from 0

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
    return result;
  }
};

}  // namespace moldlight
