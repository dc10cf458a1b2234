// SPDX-License-Identifier: MIT
#include "solver/engine/implicit_heat.h"

#include <algorithm>
#include <limits>
#include <string>

#include "solver/core/errors.h"
#include "solver/core/parallel.h"
#include "solver/engine/conduction.h"

namespace bake {

namespace {

/// Dot product over the nodes of a block.
template <class Real>
double block_dot(const Real* a, const Real* b) {
  constexpr int k_parts = 8;  // sums side by side
  double part[k_parts] = {};
  for (int i = 0; i < k_block_nodes; i += k_parts)
    for (int l = 0; l < k_parts; ++l) part[l] += static_cast<double>(a[i + l]) * static_cast<double>(b[i + l]);
  double sum = 0;
  for (const double p : part) sum += p;
  return sum;
}

}  // namespace

template <class Real>
template <class Visit>
double ImplicitHeat<Real>::sum_over_blocks(Visit visit) {
  parts_.resize(theta_.size() / k_block_nodes);
  for_each_parallel(parts_.size(), 16, [&](std::size_t s) { parts_[s] = visit(s * k_block_nodes); });
  double sum = 0;
  for (const double part : parts_) sum += part;
  return sum;
}

template <class Real>
void ImplicitHeat<Real>::conduct(const BlockWork<Real>& work, const std::vector<BlockColumns>& colours, const std::vector<Real>& theta) {
  const auto one = order_ == KernelOrder::quadratic ? bake::conduct<Real, KernelOrder::quadratic> : bake::conduct<Real, KernelOrder::cubic>;
  K_.assign(theta.size(), Real(0));
  for (const BlockColumns& columns : colours)
    for_each_parallel(columns.size(), 1, [&](std::size_t c) {
      for (std::int32_t b = columns[c].first; b < columns[c].second; ++b)
        one(*work.store, *work.physics, work.step.dx, b, theta.data(), K_.data());
    });
}

template <class Real>
double ImplicitHeat<Real>::solve(const BlockWork<Real>& work, const std::vector<BlockColumns>& colours, const std::vector<Real>& weight,
                                 const std::vector<Real>& heat_transfer, double dt, std::size_t row, Real* grid) {
  const std::size_t n = weight.size();
  const auto step = static_cast<Real>(dt);
  Real* rows = grid + work.physics->temperature_channel;
  for (std::vector<Real>* v : {&theta_, &r_, &z_, &p_, &d_}) v->resize(n);

  // r = -dt K theta - (H + dt K) d in all nodes, of which held ones and empty ones have no weight and keep d = 0
  const auto precondition = [&](std::size_t first) {
    for (std::size_t i = first; i < first + k_block_nodes; ++i) z_[i] = weight[i] > 0 ? r_[i] / weight[i] : Real(0);
    return block_dot(&r_[first], &z_[first]);
  };
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) theta_[i] = rows[i * row];
  conduct(work, colours, theta_);
  double rz = sum_over_blocks([&](std::size_t first) {
    for (std::size_t i = first; i < first + k_block_nodes; ++i) r_[i] = -step * K_[i], d_[i] = 0;
    return precondition(first);
  });
  p_ = z_;
  const double tolerance = std::max(work.physics->heat_tolerance, 8. * std::numeric_limits<Real>::epsilon()),
               small = tolerance * tolerance * rz;
  constexpr int k_most = 1000;
  for (int iteration = 0; rz > small; ++iteration) {
    if (iteration == k_most)
      throw RunError("backward Euler's conjugate gradients did not reach heat.tolerance in " + std::to_string(k_most) + " iterations");
    conduct(work, colours, p_);
    const double curvature = sum_over_blocks([&](std::size_t first) {
      for (std::size_t i = first; i < first + k_block_nodes; ++i) K_[i] = step * K_[i] + weight[i] * p_[i];
      return block_dot(&p_[first], &K_[first]);
    });
    const auto alpha = static_cast<Real>(rz / curvature);
    const double next = sum_over_blocks([&](std::size_t first) {
      for (std::size_t i = first; i < first + k_block_nodes; ++i) d_[i] += alpha * p_[i], r_[i] -= alpha * K_[i];
      return precondition(first);
    });
    const auto beta = static_cast<Real>(next / rz);
    rz = next;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) p_[i] = z_[i] + beta * p_[i];
  }

  // d + r / H instead of d: the heat H (d + r / H) = -dt K (theta + d) is what was conducted, to the last digit. What flows into held
  // nodes comes from the grip.
  return sum_over_blocks([&](std::size_t first) {
    double booked = 0;
    for (std::size_t i = first; i < first + k_block_nodes; ++i) {
      if (weight[i] > 0) {
        const Real correction = d_[i] + z_[i];
        rows[i * row] += correction;
        *(rows + i * row - 1) += correction;
        booked -= dt * static_cast<double>(heat_transfer[i]) * static_cast<double>(correction);
      } else {
        booked -= static_cast<double>(r_[i]);
      }
    }
    return booked;
  });
}

template class ImplicitHeat<float>;
template class ImplicitHeat<double>;

}  // namespace bake
