// SPDX-License-Identifier: BSD-3-Clause
// Holds both links level: the shoulder carries 2 kg at 1 m and 1 kg at 2 m, the elbow 1 kg at 1 m.
#include <cmath>
#include <cstdio>

#include "flatdyn/cuda_batch.cuh"
#include "flatdyn/eigen.hpp"
#include "my_arm.hpp"
#include "my_arm_as_pair.hpp"
#include "my_arm_in_c.h"
#include "my_arm_in_cuda.cuh"

namespace {

constexpr double kGravity = 9.81;

bool close(double a, double b) { return std::abs(a - b) <= 1e-12; }

}  // namespace

int main() {
  const double q[my_arm::joint_count] = {}, zero[my_arm::joint_count] = {};
  double g[my_arm::joint_count], tau[my_arm::joint_count], in_c[my_arm::joint_count], as_pair[my_arm::joint_count];
  my_arm::gravity(q, g);
  my_arm::inverse_dynamics(q, zero, zero, tau);
  my_arm_in_c_inverse_dynamics(q, zero, zero, in_c);
  my_arm_as_pair::inverse_dynamics(q, zero, zero, as_pair);
  double in_cuda[my_arm::joint_count];  // on the host, without a compiler of CUDA
  using Rows = flatdyn::cuda::Rows;
  flatdyn::cuda::for_each_state_on_host<my_arm_in_cuda::functions::gravity, double, Rows>(1, q, in_cuda);
  const Eigen::Vector2d of_eigen = flatdyn::eigen<my_arm::functions::gravity>(Eigen::Vector2d(0, 0));
  std::printf("gravity: %g %g N m\n", g[0], g[1]);
  const bool right = close(g[0], 4 * kGravity) && close(g[1], kGravity);
  const bool alike = close(tau[0], g[0]) && close(tau[1], g[1]);
  const bool same = in_c[0] == tau[0] && in_c[1] == tau[1] && as_pair[0] == tau[0] && as_pair[1] == tau[1] &&
                    of_eigen[0] == g[0] && of_eigen[1] == g[1] && in_cuda[0] == g[0] &&
                    in_cuda[1] == g[1];  // bit for bit
  const bool rounded = my_arm::rounding_is_as_written() && my_arm_as_pair::rounding_is_as_written<float>();
  return right && alike && same && rounded ? 0 : 1;
}
