// Eigenvectors of a small symmetric matrix, by Jacobi rotations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace moldlight {

template <int N>
struct SymmetricEigen {
  std::array<double, N> values{};                // rising
  std::array<glm::vec<N, double>, N> vectors{};  // unit, orthogonal; the sign is arbitrary but reproducible
};

/// Only the symmetric part of `matrix` counts; its entries are finite.
template <int N>
[[nodiscard]] SymmetricEigen<N> symmetric_eigen(const glm::mat<N, N, double>& matrix) {
  using Matrix = glm::mat<N, N, double>;
  Matrix a = 0.5 * (matrix + glm::transpose(matrix));
  Matrix vectors(1.0);
  // Converges quadratically: six sweeps are plenty, the rest would be rotations by nothing.
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (int p = 0; p < N; ++p) {
      for (int q = p + 1; q < N; ++q) {
        if (a[p][q] == 0.0) continue;
        const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
        Matrix rotation(1.0);
        rotation[p][p] = rotation[q][q] = c;
        rotation[q][p] = s;
        rotation[p][q] = -s;
        a = glm::transpose(rotation) * a * rotation;
        a[p][q] = a[q][p] = 0.0;
        vectors = vectors * rotation;
      }
    }
  }
  std::array<int, N> order{};
  for (int i = 0; i < N; ++i) order[static_cast<std::size_t>(i)] = i;
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return a[i][i] < a[j][j]; });
  SymmetricEigen<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result.values[i] = a[order[i]][order[i]];
    result.vectors[i] = glm::normalize(vectors[order[i]]);
  }
  return result;
}

}  // namespace moldlight
