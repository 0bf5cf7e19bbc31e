// SPDX-License-Identifier: Apache-2.0
//
// Identification of a linear model from a run, by least squares:
//   y[k] = a1 y[k-1] + ... + an y[k-n] + b1 u[k-1] + ... + bn u[k-n]
// in observer form, whose first state is the output.
#pragma once

#include <algorithm>
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

// What a run's impulse response is seen to be, by least squares: y[k] = h0 u[k] + ... + hm u[k-m],
// m = lags - 1; h0 is 0 where y[k] is taken as u[k] begins.
struct ImpulseResponse {
  std::vector<double> h, deviation;  // [output an input], their standard deviations

  // From an input to the first output that three standard deviations do not explain; below 0: none.
  int dead_samples() const {
    for (std::size_t k = 0; k < h.size(); ++k) {
      if (std::fabs(h[k]) > 3 * deviation[k]) return static_cast<int>(k);
    }
    return -1;
  }
};

inline ImpulseResponse impulse_response(const std::vector<double>& u, const std::vector<double>& y,
                                        int lags) {
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(lags, lags);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(lags), row(lags);
  const std::size_t end = std::min(u.size(), y.size());  // the last output may have no input yet
  const auto each = [&](auto&& use) {
    for (std::size_t k = static_cast<std::size_t>(lags) - 1; k < end; ++k) {
      for (int n = 0; n < lags; ++n) row(n) = u[k - static_cast<std::size_t>(n)];
      use(y[k]);
    }
  };
  each([&](double out) {
    normal += row * row.transpose();
    right += row * out;
  });
  const Eigen::MatrixXd inverse = normal.inverse();
  const Eigen::VectorXd h = inverse * right;
  double square = 0;
  int count = -lags;
  each([&](double out) {
    square += std::pow(out - row.dot(h), 2);
    ++count;
  });
  ImpulseResponse found;
  for (int n = 0; n < lags; ++n) {
    found.h.push_back(h(n));
    found.deviation.push_back(std::sqrt(square / count * inverse(n, n)));
  }
  return found;
}

// Mean square of what the model, given the outputs before, leaves of each output.
template <int Order>
double prediction_loss(const LinearModel<Order>& m, const std::vector<double>& u,
                       const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t k = Order; k < y.size(); ++k) {
    double ahead = 0;
    for (int n = 0; n < Order; ++n) {
      const std::size_t before = k - 1 - static_cast<std::size_t>(n);
      ahead += m.phi(n, 0) * y[before] + m.psi(n) * u[before];
    }
    sum += std::pow(y[k] - ahead, 2);
  }
  return sum / static_cast<double>(y.size() - Order);
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
