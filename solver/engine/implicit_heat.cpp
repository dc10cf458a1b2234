// SPDX-License-Identifier: MIT
#include "solver/engine/implicit_heat.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "solver/core/errors.h"
#include "solver/core/parallel.h"

namespace bake {

namespace {

/// Dot product with sums per block added in block order: same bits for any number of threads.
template <class Real>
double dot_product(const std::vector<Real>& a, const std::vector<Real>& b) {
  const std::size_t blocks = a.size() / k_block_nodes;
  std::vector<double> part(blocks);
#pragma omp parallel for schedule(static)
  for (std::size_t s = 0; s < blocks; ++s) {
    double sum = 0;
    for (std::size_t i = s * k_block_nodes; i < (s + 1) * k_block_nodes; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    part[s] = sum;
  }
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

}  // namespace

template <class Real>
double ImplicitHeat<Real>::solve(const BlockKernel<Real>& kernel, BlockWork<Real> work, const std::vector<BlockColumns>& colours,
                                 std::vector<Scratch<Real>>& scratch, const std::vector<Real>& weight,
                                 const std::vector<Real>& heat_transfer, int temperature_channel, double dt, double tolerance,
                                 AlignedBuffer<Real>& grid) {
  const std::size_t n = weight.size(), gathered_row = static_cast<std::size_t>(kernel.gathered_row()),
                    scattered_row = static_cast<std::size_t>(kernel.scattered_row());
  in_.resize_and_forget(n * gathered_row);
  out_.resize_and_forget(n * scattered_row);
  std::memset(in_.data(), 0, in_.size() * sizeof(Real));
  work.gathered = in_.data();
  work.scattered = out_.data();
  const auto apply = [&](const std::vector<Real>& v, std::vector<Real>& Kv) {  // dt K v
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) in_.data()[i * gathered_row] = v[i];
    std::memset(out_.data(), 0, out_.size() * sizeof(Real));
    for (const BlockColumns& columns : colours)
      for_each_parallel(columns.size(), 1, [&](std::size_t c) {
        for (std::int32_t b = columns[c].first; b < columns[c].second; ++b)
          kernel.conduct(work, b, scratch[static_cast<std::size_t>(omp_get_thread_num())]);
      });
    Kv.resize(n);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) Kv[i] = static_cast<Real>(dt) * out_.data()[i * scattered_row];
  };

  x_.resize(n), r_.resize(n), p_.assign(n, 0), Kp_.resize(n);
  for (std::size_t i = 0; i < n; ++i) x_[i] = grid.data()[i * gathered_row + static_cast<std::size_t>(temperature_channel)];
  const std::vector<Real> start = x_;
  apply(x_, Kp_);
  std::vector<Real> z(n);
  for (std::size_t i = 0; i < n; ++i) {
    r_[i] = weight[i] > 0 ? -Kp_[i] : Real(0);
    z[i] = weight[i] > 0 ? r_[i] / weight[i] : Real(0);
  }
  p_ = z;
  double rz = dot_product(r_, z);
  const double first = rz;
  constexpr int k_most = 1000;
  for (int iteration = 0; rz > tolerance * tolerance * first; ++iteration) {
    if (iteration == k_most)
      throw RunError("backward Euler's conjugate gradients did not reach heat.tolerance in " + std::to_string(k_most) + " iterations");
    apply(p_, Kp_);
    for (std::size_t i = 0; i < n; ++i) Kp_[i] = weight[i] > 0 ? Kp_[i] + weight[i] * p_[i] : Real(0);
    const auto alpha = static_cast<Real>(rz / dot_product(p_, Kp_));
    for (std::size_t i = 0; i < n; ++i) {
      x_[i] += alpha * p_[i];
      r_[i] -= alpha * Kp_[i];
      z[i] = weight[i] > 0 ? r_[i] / weight[i] : Real(0);
    }
    const double next = dot_product(r_, z);
    const auto beta = static_cast<Real>(next / rz);
    rz = next;
    for (std::size_t i = 0; i < n; ++i) p_[i] = z[i] + beta * p_[i];
  }

  apply(x_, Kp_);  // what flows into held nodes comes from the grip
  double booked = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Real correction = x_[i] - start[i];
    if (weight[i] > 0) {
      Real* rows = grid.data() + i * gathered_row + temperature_channel;
      rows[0] += correction;
      rows[-1] += correction;
      booked -= dt * static_cast<double>(heat_transfer[i]) * static_cast<double>(correction);
    } else {
      booked += static_cast<double>(Kp_[i]);
    }
  }
  return booked;
}

template class ImplicitHeat<float>;
template class ImplicitHeat<double>;

}  // namespace bake
