// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/identification_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace flatdyn {
namespace {

// The first six entries of q̇ and q̈ of a floating base (base_motion.hpp).
constexpr const char* kBaseRates[] = {"zero_x", "zero_y", "zero_z", "base_wx", "base_wy", "base_wz"};
constexpr const char* kBaseAccelerations[] = {"imu_ax", "imu_ay", "imu_az", "base_dwx", "base_dwy", "base_dwz"};

std::string base_or_number(const Mechanism& mechanism, const char* const (&of_base)[6], const char* stem, int entry) {
  return entry < mechanism.base_bodies() ? of_base[entry] : fmt::format("{}{}", stem, entry + 1);
}

}  // namespace

std::string covariance_csv(const TorqueEquations& equations, const Estimate& estimate) {
  std::string text = "parameter";
  auto out = std::back_inserter(text);
  const auto b = static_cast<int>(estimate.values.size());
  for (int k = 0; k < b; ++k) fmt::format_to(out, ",{}", equations.names()[static_cast<std::size_t>(k)]);
  const auto is_told = [&](int k) { return std::isfinite(estimate.standard_deviations(k)); };
  for (int i = 0; i < b; ++i) {
    fmt::format_to(out, "\n{}", equations.names()[static_cast<std::size_t>(i)]);
    for (int k = 0; k < b; ++k) {
      text += ',';
      if (is_told(i) && is_told(k)) fmt::format_to(out, "{}", estimate.covariance(i, k));
    }
  }
  return text + "\n";
}

SignalTable::SignalTable(const TorqueEquations& equations, Eigen::VectorXd values)
    : equations_(equations), values_(std::move(values)), text_("log,t") {
  const Mechanism& mechanism = equations.model().mechanism();
  auto out = std::back_inserter(text_);
  for (int i = 1; i <= mechanism.position_count(); ++i) fmt::format_to(out, ",q{}", i);
  const int rates = mechanism.size();
  for (int i = 0; i < rates; ++i) text_ += "," + base_or_number(mechanism, kBaseRates, "qd", i);
  for (int i = 0; i < rates; ++i) text_ += "," + base_or_number(mechanism, kBaseAccelerations, "qdd", i);
  for (const char* name : {"tau", "model", "used"}) {
    for (int i = 1; i <= rates; ++i) fmt::format_to(out, ",{}{}", name, i);
  }
  text_ += '\n';
}

void SignalTable::add(const FilteredEquations& filtered, int log) {
  auto out = std::back_inserter(text_);
  const auto put = [&](const double* from, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) fmt::format_to(out, ",{:.10g}", from[k]);
  };
  fmt::format_to(out, "{},{:.10g}", log + 1, filtered.motion.time);
  put(filtered.motion.q, filtered.positions);
  put(filtered.motion.qd, filtered.rates);
  put(filtered.motion.qdd, filtered.rates);
  put(filtered.right, filtered.rates);
  const double* entries = filtered.entries;
  for (const std::vector<int>& columns : equations_.columns()) {
    double torque = 0;
    for (const int column : columns) torque += *entries++ * values_[column];
    put(&torque, 1);
  }
  for (std::size_t i = 0; i < filtered.rates; ++i) fmt::format_to(out, ",{}", filtered.used[i] != 0 ? 1 : 0);
  text_ += '\n';
}

}  // namespace flatdyn
