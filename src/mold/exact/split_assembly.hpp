// Puts the cells of all facets together to one conforming mesh.
#pragma once

#include <cstdint>
#include <vector>

#include <tbb/enumerable_thread_specific.h>

#include "base/progress.hpp"
#include "mold/exact/exact_part.hpp"
#include "mold/exact/facet_cells.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// On every edge of the part the cut points of all its facets are joined in order and put into the cells of
/// each of them, so that neighbours share whole edges.
class SplitAssembly {
 public:
  explicit SplitAssembly(const ExactPart& part);

  /// Takes the kept cells of a facet; from any thread, once a facet.
  void add(FacetIndex facet, const FacetCells& cells);

  /// The mesh, once every facet has been added. Uses all cores; the result does not depend on them.
  [[nodiscard]] SplitMesh finish(const Progress& progress);

 private:
  static constexpr std::uint32_t k_none = ~0U;
  static constexpr std::uint32_t k_inside = 3;
  /// A corner of a cell that is not one of the facet's. There are twenty a facet where shadows are dense.
  struct Point {
    std::array<double, 2> at{};         // weights of the facet's corners 1 and 2; on a side: the share of the
                                        // part's edge, from its lower vertex
    std::uint32_t vertex = k_none;      // of the split mesh
    std::uint32_t side : 2 = k_inside;  // of the facet
    std::uint32_t place : 30 = 0;       // among the vertices of the part's edge
  };
  struct SplitFacet {
    FacetIndex facet = 0;
    std::vector<Point> points;  // 0, 1, 2: the facet's corners
    std::vector<FacetCells::Cell> cells;
    std::vector<std::uint32_t> outlines;
  };

  void join_side_points();
  void number_inner_points();
  void adopt_regions_without_area();
  void append_outline(FacetIndex facet, std::span<const std::uint32_t> outline, const SplitFacet* split,
                      std::vector<VertexIndex>& polygon) const;
  void append_pieces(FacetIndex facet, std::vector<SplitPiece>& pieces,
                     std::vector<VertexIndex>& polygon) const;
  void triangulate(std::vector<VertexIndex>& polygon, const SplitPiece& like,
                   std::vector<SplitPiece>& pieces) const;
  void leave_out_unused_vertices();
  [[nodiscard]] bool is_corner(const std::vector<VertexIndex>& polygon, std::size_t k) const;
  [[nodiscard]] std::size_t vertices_on(std::uint32_t edge) const;

  const ExactPart& part_;
  std::vector<Region> regions_;  // of facets in one cell
  tbb::enumerable_thread_specific<std::vector<SplitFacet>> added_;
  std::vector<SplitFacet> split_;              // in the order of the facets
  std::vector<std::uint32_t> split_of_facet_;  // k_none: in one cell
  std::vector<std::uint32_t> first_on_edge_;   // edges + 1 entries, of edge_vertices_
  std::vector<VertexIndex> edge_vertices_;
  SplitMesh mesh_;
};

}  // namespace moldlight
