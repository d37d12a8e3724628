// What ImGui is compiled with here: its points are made from ours, and become ours, without being asked to.
#pragma once

#include <glm/vec2.hpp>

#define IM_VEC2_CLASS_EXTRA                                \
  constexpr ImVec2(const glm::vec2& v) : x(v.x), y(v.y) {} \
  operator glm::vec2() const { return {x, y}; }
