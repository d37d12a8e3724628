#include "compare/lit_surface.hpp"

namespace moldlight {

namespace {

struct LitFacts {
  Colour colour;
  std::string_view name;
};

const LitFacts& facts_of(Lit what) {
  static constexpr LitFacts k_facts[] = {
      {{200, 60, 200}, "gone"}, {{245, 150, 20}, "new"}, {{240, 220, 40}, "another region"}};
  return k_facts[static_cast<std::size_t>(what)];
}

}  // namespace

Colour lit_colour(Lit what) { return facts_of(what).colour; }

std::string_view lit_name(Lit what) { return facts_of(what).name; }

std::vector<LitPolygon> lit_surface(const Comparison& comparison, bool former) {
  const SurfaceChange& surface = comparison.surface;
  const std::vector<LeftOver>& left = former ? surface.of_former.left : surface.of_fresh.left;
  const std::vector<std::uint32_t>& place_of = former ? surface.place_of_former : surface.place_of_fresh;
  std::vector<LitPolygon> lit;
  for (std::size_t k = 0; k < left.size(); ++k) {
    if (place_of[k] != k_no_change)
      lit.push_back({&left[k].polygon, left[k].piece, former ? Lit::gone : Lit::fresh, place_of[k]});
  }
  for (std::size_t k = 0; k < surface.of_former.regions.size(); ++k) {
    const OtherRegion& one = surface.of_former.regions[k];
    if (surface.change_of_region[k] != k_no_change)
      lit.push_back(
          {&one.polygon, former ? one.piece : one.other, Lit::other_region, surface.change_of_region[k]});
  }
  return lit;
}

std::shared_ptr<const SplitMesh> marked_split(const ComparedPart& part, std::span<const LitPolygon> lit) {
  auto split = std::make_shared<SplitMesh>(*part.result.split);
  for (SplitPiece& piece : split->pieces) piece.region = Region::both;
  for (const LitPolygon& one : lit) split->pieces[one.piece].region = Region::undercut;
  return split;
}

}  // namespace moldlight
