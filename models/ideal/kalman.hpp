// SPDX-License-Identifier: Apache-2.0
//
// Kalman filter of a model x' = Phi x + Psi u, z = C x with one input and one output (Brochier
// 2006, 2.2.4):
//   x- = Phi x + Psi u             P- = Phi P Phi^T + W
//   K = P- C^T / (V + C P- C^T)    P = P- - K (V + C P- C^T) K^T    x = x- + K (z - C x-)
#pragma once

#include <Eigen/Dense>

namespace trammel::ideal {

template <int Order>
struct LinearModel {
  using Matrix = Eigen::Matrix<double, Order, Order>;
  using Column = Eigen::Matrix<double, Order, 1>;
  using Row = Eigen::Matrix<double, 1, Order>;

  Matrix phi = Matrix::Zero();
  Column psi = Column::Zero();
  Row c = Row::Zero();

  double output(const Column& x) const { return (c * x)(0); }
  Column next(const Column& x, double u) const { return phi * x + psi * u; }
  bool stable() const { return phi.eigenvalues().cwiseAbs().maxCoeff() < 1; }
};

template <int Order>
class Kalman {
 public:
  using Model = LinearModel<Order>;

  // w: covariance of what the model leaves out of a step; v: variance of the measurement's noise.
  Kalman(const Model& model, const typename Model::Matrix& w, double v)
      : m_(model), w_(w), v_(v), p_(w) {}

  // The estimate of the output, of the force since the last measurement and the present one.
  double step(double u, double z) {
    const typename Model::Column ahead = m_.next(x_, u);
    const typename Model::Matrix p = m_.phi * p_ * m_.phi.transpose() + w_;
    const double s = v_ + (m_.c * p * m_.c.transpose())(0);
    const typename Model::Column gain = p * m_.c.transpose() / s;
    p_ = p - gain * s * gain.transpose();
    x_ = ahead + gain * (z - m_.output(ahead));
    return m_.output(x_);
  }

  const typename Model::Matrix& covariance() const { return p_; }

 private:
  Model m_;
  typename Model::Matrix w_;
  double v_;
  typename Model::Matrix p_;
  typename Model::Column x_ = Model::Column::Zero();
};

}  // namespace trammel::ideal
