#include "sweep/sample_rays.hpp"

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// Rays start above their facet by the rounding of coordinates, which saves distinguishing the facet's own
/// hit from others. Surfaces that touch count as free here; classify distinguishes them.
constexpr float k_start_above = 5e-7F;

}  // namespace

void SampleRays::begin(const AccessibilityQuery& query) {
  query_ = query;
  for (Queue* queue : {&up_, &down_, &beside_}) queue->clear();
}

void SampleRays::add(std::size_t number, const glm::vec3& position, const glm::dvec3& normal,
                     FacetClass facet_class) {
  const bool beside = facet_class == FacetClass::near_vertical;
  Queue& queue = beside ? beside_ : facet_class == FacetClass::up ? up_ : down_;
  queue.numbers.push_back(number);
  queue.origins.push_back(beside ? lateral_point(position, normal, query_)
                                 : position + k_start_above * glm::vec3(normal));
  queue.facing.push_back(static_cast<float>(glm::dot(normal, query_.direction)));
}

void SampleRays::ask(const ExactRays& rays) {
  const glm::vec3 plus(query_.direction);
  rays.blocked(up_.origins, plus, up_.answers(0));
  rays.blocked(down_.origins, -plus, down_.answers(0));
  rays.blocked(beside_.origins, plus, beside_.answers(0));
  rays.blocked(beside_.origins, -plus, beside_.answers(1));
}

}  // namespace moldlight
