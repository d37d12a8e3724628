// Exact rays for surface samples and one parting direction, asked in packets of one kind.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/draft.hpp"
#include "mold/exact_rays.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// Keeps its room from direction to direction.
class SampleRays {
 public:
  /// Forgets all samples; those that follow are for this query's direction.
  void begin(const AccessibilityQuery& query);
  /// A sample at `position` (unit frame) on a facet of this class with this normal.
  void add(std::size_t number, const glm::vec3& position, const glm::dvec3& normal, FacetClass facet_class);
  /// Asks for all of them.
  void ask(const ExactRays& rays);

  /// Calls visit(number, accessible_plus, accessible_minus, facing) for each sample asked: those on up facets
  /// in their order, then those on down facets, then the near-vertical ones.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    const auto visit_queue = [&](const Queue& queue, bool may_plus, bool may_minus) {
      for (std::size_t i = 0; i < queue.origins.size(); ++i) {
        const bool plus = may_plus && queue.blocked[0][i] == 0;
        const bool minus = may_minus && queue.blocked[may_plus ? 1 : 0][i] == 0;
        visit(queue.numbers[i], plus, minus, queue.facing[i]);
      }
    };
    visit_queue(up_, true, false);
    visit_queue(down_, false, true);
    visit_queue(beside_, true, true);
  }

 private:
  /// Rays of one kind: where they start, how their facets face the direction, and what was in the way.
  struct Queue {
    std::vector<std::size_t> numbers;
    std::vector<glm::vec3> origins;
    std::vector<float> facing;
    std::array<std::vector<std::uint8_t>, 2> blocked;

    void clear() {
      numbers.clear();
      origins.clear();
      facing.clear();
    }
    [[nodiscard]] std::span<std::uint8_t> answers(std::size_t sense) {
      blocked[sense].resize(origins.size());
      return blocked[sense];
    }
  };

  AccessibilityQuery query_;
  Queue up_, down_, beside_;
};

}  // namespace moldlight
