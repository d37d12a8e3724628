// Eigenvectors of a symmetric 3 x 3 matrix, by Jacobi rotations.
#pragma once

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace moldlight {

struct SymmetricEigen {
  std::array<double, 3> values{};       // rising
  std::array<glm::dvec3, 3> vectors{};  // unit, orthogonal; the sign is arbitrary but reproducible
};

/// Only the symmetric part of `matrix` counts; its entries are finite.
[[nodiscard]] SymmetricEigen symmetric_eigen(const glm::dmat3& matrix);

}  // namespace moldlight
