#include "report/packed_bytes.hpp"

#include <zlib.h>

#include "base/check.hpp"
#include "page/page.hpp"

namespace moldlight::report {

std::string PackedBytes::deflated_base64() const {
  uLongf size = compressBound(static_cast<uLong>(bytes_.size()));
  std::string out(size, '\0');
  CHECK(compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes_.data()),
                  static_cast<uLong>(bytes_.size()), Z_BEST_COMPRESSION) == Z_OK);
  out.resize(size);
  return page::base64(out);
}

std::vector<VertexIndex> pack_corners(const TriangleMesh& mesh, PackedBytes& bytes) {
  constexpr std::uint32_t k_unused = ~0U;
  std::vector<std::uint32_t> number(mesh.vertices.size(), k_unused);
  std::vector<VertexIndex> order;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex corner : facet) {
      const auto next = static_cast<std::uint32_t>(order.size());
      if (number[corner] == k_unused) {
        number[corner] = next;
        order.push_back(corner);
      }
      bytes.add(next - number[corner]);
    }
  }
  return order;
}

}  // namespace moldlight::report
