// Bytes as a page's script unpacks them (page/files/model.js): numbers of seven bits a byte, deflated (zlib),
// in base64.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::report {

class PackedBytes {
 public:
  /// Seven bits a byte, the lowest first.
  void add(std::uint32_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += static_cast<char>(0x80 | (value & 0x7F));
    bytes_ += static_cast<char>(value);
  }
  /// Folded: 0, -1, 1, -2, …
  void add_signed(std::int32_t value) {
    add(value < 0 ? ~(static_cast<std::uint32_t>(value) << 1) : static_cast<std::uint32_t>(value) << 1);
  }
  void add_byte(unsigned char byte) { bytes_ += static_cast<char>(byte); }
  void append(const PackedBytes& others) { bytes_ += others.bytes_; }
  [[nodiscard]] std::string deflated_base64() const;

 private:
  std::string bytes_;
};

/// The vertices of the facets in the order of their first use; adds to `bytes`, for every corner, the number
/// of the next new vertex less its own.
[[nodiscard]] std::vector<VertexIndex> pack_corners(const TriangleMesh& mesh, PackedBytes& bytes);

}  // namespace moldlight::report
