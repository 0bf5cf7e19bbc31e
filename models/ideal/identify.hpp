// SPDX-License-Identifier: Apache-2.0
//
// Identification of a linear model from a run, by least squares:
//   y[k] = a1 y[k-1] + ... + an y[k-n] + b1 u[k-1] + ... + bn u[k-n]
// in observer form, whose first state is the output.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "models/ideal/kalman.hpp"

namespace trammel::ideal {

// Input u[k] holds from sample k to k + 1; both are as long.
template <int Order>
LinearModel<Order> identify(const std::vector<double>& u, const std::vector<double>& y) {
  constexpr int kUnknown = 2 * Order;
  using Unknown = Eigen::Matrix<double, kUnknown, 1>;
  Eigen::Matrix<double, kUnknown, kUnknown> normal =
      Eigen::Matrix<double, kUnknown, kUnknown>::Zero();
  Unknown right = Unknown::Zero();
  for (std::size_t k = Order; k < y.size(); ++k) {
    Unknown row;
    for (int n = 0; n < Order; ++n) {
      row(n) = y[k - 1 - static_cast<std::size_t>(n)];
      row(Order + n) = u[k - 1 - static_cast<std::size_t>(n)];
    }
    normal += row * row.transpose();
    right += row * y[k];
  }
  const Unknown found = normal.ldlt().solve(right);
  LinearModel<Order> m;
  for (int n = 0; n < Order; ++n) {
    m.phi(n, 0) = found(n);
    if (n + 1 < Order) m.phi(n, n + 1) = 1;
    m.psi(n) = found(Order + n);
  }
  m.c(0) = 1;
  return m;
}

// How much of the output's variation a simulation of the model explains, from rest [%]:
// 100 (1 - |y - ym| / |y - mean y|).
template <int Order>
double fit_percent(const LinearModel<Order>& m, const std::vector<double>& u,
                   const std::vector<double>& y) {
  double mean = 0;
  for (const double v : y) mean += v / static_cast<double>(y.size());
  typename LinearModel<Order>::Column x = LinearModel<Order>::Column::Zero();
  double off = 0, all = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    off += std::pow(y[k] - m.output(x), 2);
    all += std::pow(y[k] - mean, 2);
    x = m.next(x, u[k]);
  }
  return 100 * (1 - std::sqrt(off / all));
}

}  // namespace trammel::ideal
