#include "sweep/candidates/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace moldlight {

SymmetricEigen symmetric_eigen(const glm::dmat3& matrix) {
  glm::dmat3 a = 0.5 * (matrix + glm::transpose(matrix));
  glm::dmat3 vectors(1.0);
  constexpr std::pair<int, int> k_pairs[] = {{0, 1}, {0, 2}, {1, 2}};
  // Converges quadratically: six sweeps are plenty, the rest would be rotations by nothing.
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (const auto& [p, q] : k_pairs) {
      if (a[p][q] == 0.0) continue;
      const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
      const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
      const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
      glm::dmat3 rotation(1.0);
      rotation[p][p] = rotation[q][q] = c;
      rotation[q][p] = s;
      rotation[p][q] = -s;
      a = glm::transpose(rotation) * a * rotation;
      a[p][q] = a[q][p] = 0.0;
      vectors = vectors * rotation;
    }
  }
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return a[i][i] < a[j][j]; });
  SymmetricEigen result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.values[i] = a[order[i]][order[i]];
    result.vectors[i] = glm::normalize(vectors[order[i]]);
  }
  return result;
}

}  // namespace moldlight
