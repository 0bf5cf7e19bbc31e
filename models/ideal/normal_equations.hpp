// SPDX-License-Identifier: Apache-2.0
//
// What the matrix R of the normal equations of least squares, the sum of phi phi', says of each
// unknown: how well the samples know it, and whether they tell it from the others.
#pragma once

#include <Eigen/Dense>

#include <array>
#include <cstddef>

namespace trammel::ideal {

template <std::size_t N>
struct Knowledge {
  std::array<double, N> variance{};  // of an estimate, where each sample has a noise of variance 1
  std::array<double, N> own_share{};  // of its regressor's square that no sum of the others makes,
                                      // 0 to 1: its variance is 1 / share that of an unknown alone
};

// R is symmetric and positive definite.
template <std::size_t N>
Knowledge<N> knowledge_of(const std::array<std::array<double, N>, N>& r) {
  constexpr int kN = static_cast<int>(N);
  Eigen::Matrix<double, kN, kN> matrix;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) matrix(static_cast<int>(i), static_cast<int>(j)) = r[i][j];
  }
  const Eigen::Matrix<double, kN, 1> inverse = matrix.inverse().diagonal();
  Knowledge<N> known;
  for (std::size_t i = 0; i < N; ++i) {
    known.variance[i] = inverse(static_cast<int>(i));
    known.own_share[i] = 1 / (r[i][i] * known.variance[i]);
  }
  return known;
}

}  // namespace trammel::ideal
