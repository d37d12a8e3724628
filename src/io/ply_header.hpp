// The header of a PLY file: which elements follow, with which properties, in which encoding.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/readers.hpp"

namespace moldlight {

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value in the binary encodings.
[[nodiscard]] std::size_t ply_type_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;    // of the value, or of each value of the list
  std::optional<PlyType> count_type;  // set for a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;  // as declared
  std::vector<PlyProperty> properties;

  /// Number of the property of this name; none where there is none.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  // where the data begin
  std::size_t lines = 0;
};

/// Throws FileError for a header that breaks the format, and for counts that the file's size cannot hold.
[[nodiscard]] PlyHeader read_ply_header(const ReadContext& context);

}  // namespace moldlight
