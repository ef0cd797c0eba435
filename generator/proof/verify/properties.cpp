// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "graph/arithmetic.hpp"
#include "robot/model/rounded_up.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using Vector50 = reference::VectorX<Real50>;
using Matrix50 = reference::MatrixX<Real50>;

// The step h of derivatives by central differences: error h² from the formula, 1e-60 / h from rounding.
const Real50 kStep("1e-20");
constexpr double kTolerance = 1e-30;

struct ExactState {
  Vector50 q, qd, qdd, tau;
  std::vector<double> parameters;
  Vector50 g_b{};
  Vector50 rates{};  // rates of all entries of q; of another length: not known
};

Vector50 exact_vector(const std::vector<double>& values) {
  Vector50 v(static_cast<Eigen::Index>(values.size()));
  for (std::size_t k = 0; k < values.size(); ++k) v[static_cast<Eigen::Index>(k)] = Real50(values[k]);
  return v;
}

class Functions {
 public:
  explicit Functions(const std::vector<Function>& functions) {
    for (const Function& function : functions) {
      is_at_rest_ = is_at_rest_ || function.at_rest;
      if (is_whole(function)) by_name_[function.name] = &function;
    }
  }

  bool has(std::initializer_list<const char*> names) const {
    return std::all_of(names.begin(), names.end(), [this](const char* name) { return by_name_.contains(name); });
  }

  // Whether the functions hold at rest only: identities in velocities do not apply to them.
  bool are_at_rest() const { return is_at_rest_; }

  // The entries of the function's (only) output.
  Vector50 operator()(const std::string& name, const ExactState& state) const {
    RealArithmetic<Real50> arithmetic([&state](const Input& input) -> Real50 {
      switch (argument_row(input.kind).in_state) {
        case InputKind::q:
          return state.q[input.index];
        case InputKind::qd:
          return state.qd[input.index];
        case InputKind::qdd:
          return state.qdd[input.index];
        case InputKind::tau:
          return state.tau[input.index];
        case InputKind::g_b:
          return state.g_b[input.index];
        case InputKind::parameter:
          return Real50(state.parameters[static_cast<std::size_t>(input.index)]);
        default:  // the functions with identities here do not read other kinds
          break;
      }
      return Real50(0);
    });
    const Function& function = *by_name_.at(name);
    const std::vector<Real50> all = evaluate(function, arithmetic);
    const std::vector<NodeId>& entries = function.outputs[0].entries;
    Vector50 values(static_cast<Eigen::Index>(entries.size()));
    for (std::size_t k = 0; k < entries.size(); ++k)
      values[static_cast<Eigen::Index>(k)] = all[static_cast<std::size_t>(entries[k])];
    return values;
  }

  Matrix50 matrix(const std::string& name, const ExactState& state) const {
    const Vector50 entries = (*this)(name, state);
    const Eigen::Index n = state.qd.size();
    return Eigen::Map<const Eigen::Matrix<Real50, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(entries.data(), n,
                                                                                                    n);
  }

 private:
  std::map<std::string, const Function*> by_name_;  // functions without left-out entries
  bool is_at_rest_ = false;
};

ExactState after(const ExactState& state, const Real50& time) {
  ExactState later = state;
  later.q += time * state.rates;
  later.qd += time * state.qdd;
  return later;
}

double to_double(const Real50& x) { return Real50(abs(x)).convert_to<double>(); }

// The size of a sum that should vanish relative to the size of its terms.
double relative(const Real50& sum, const Real50& size) {
  return size == 0 ? to_double(sum) : to_double(Real50(sum / size));
}

double asymmetry(const Functions& f, const ExactState& state) {
  const Matrix50 B = f.matrix("inertia_matrix", state);
  return relative((B - B.transpose()).norm(), B.norm());
}

// The smallest pivot of B, up to rounding; 0 for a singular matrix.
double smallest_pivot(const Functions& f, const ExactState& state) {
  const Matrix50 B = f.matrix("inertia_matrix", state);
  const Real50 pivot = B.ldlt().vectorD().minCoeff();
  return abs(pivot) <= kTolerance * B.norm() ? 0 : pivot.convert_to<double>();
}

// A joint that moves no inertia (the reader warns of it) makes B singular, which is right for that robot. Masses that
// differ by more than the digits of the computation make B singular up to rounding.
Property definiteness(double smallest_pivot, std::size_t positions, const ProvenPivots& proven) {
  const std::string sampled = fmt::format("smallest pivot {:.2g} at {} sampled position{}", smallest_pivot, positions,
                                          positions == 1 ? "" : "s");
  if (proven.share > 0) {
    return {"B is positive definite",
            fmt::format("proven {}: pivots are at least {:.2g} of their scales; {}", proven.positions,
                        rounded_down(proven.share, 2), sampled),
            smallest_pivot > 0};
  }
  if (smallest_pivot == 0)
    return {"B is positive semidefinite", "singular, rounding apart, at a sampled position", true};
  return {"B is positive definite", sampled, smallest_pivot > 0};
}

double skewness(const Functions& f, const ExactState& state) {
  ExactState rest = state;
  rest.qdd.setZero();
  const Matrix50 Bdot =
      (f.matrix("inertia_matrix", after(rest, kStep)) - f.matrix("inertia_matrix", after(rest, -kStep))) / (2 * kStep);
  const Matrix50 C = f.matrix("coriolis_matrix", state);
  const Vector50& w = state.tau;  // any vector
  return relative(w.dot((Bdot - 2 * C) * w), w.squaredNorm() * (Bdot.norm() + C.norm()));
}

double energy_imbalance(const Functions& f, const ExactState& state) {
  const Real50 rate =
      (f("kinetic_energy", after(state, kStep))[0] - f("kinetic_energy", after(state, -kStep))[0]) / (2 * kStep);
  const Vector50 tau = f("inverse_dynamics", state), bias = f("bias", state);
  const Matrix50 C = f.matrix("coriolis_matrix", state);
  const Real50 power = state.qd.dot(tau - bias + C * state.qd);
  return relative(rate - power, state.qd.norm() * (tau.norm() + bias.norm()));
}

double round_trip(const Functions& f, ExactState state) {
  state.tau = f("inverse_dynamics", state);
  const Vector50 qdd = f("forward_dynamics", state);
  return relative((qdd - state.qdd).norm(), qdd.norm());
}

// With closed loops, only one function gives the rates of all entries of q: empty without it. With a floating base, q̇
// begins with the base's velocities.
Vector50 rates_of(const Functions& f, const ExactState& state, const Mechanism* mechanism) {
  const bool has_loops = mechanism != nullptr && mechanism->has_loops();
  if (!has_loops) return state.qd.tail(state.q.size());
  return f.has({"loop_motion"}) ? f("loop_motion", state).head(state.q.size()) : Vector50();
}

// With spherical joints, q has quaternions, which become exactly unit ones; their rates are ½ q (0, ω).
Vector50 rates_of(const Mechanism& mechanism, ExactState& state) {
  for (const int first : mechanism.quaternions()) state.q.segment<4>(first).normalize();
  Vector50 rates(state.q.size());
  for (int k = mechanism.base_bodies(); k < mechanism.size(); ++k) {
    if (!mechanism.is_of_spherical(k)) rates[mechanism.position_of(k)] = state.qd[k];
  }
  for (const int first : mechanism.spherical) {
    const int p = mechanism.quaternion_of(first);
    const Real50 w = state.q[p];
    const Eigen::Matrix<Real50, 3, 1> r = state.q.segment<3>(p + 1), omega = state.qd.segment<3>(first);
    rates[p] = -r.dot(omega) / 2;
    rates.segment<3>(p + 1) = (w * omega + r.cross(omega)) / 2;
  }
  return rates;
}

}  // namespace

std::vector<Property> check_properties(const std::vector<Function>& functions, const std::vector<State>& states,
                                       double largest_angle_factor, const ProvenPivots& proven,
                                       const Mechanism* mechanism) {
  const double tolerance = kTolerance * largest_angle_factor * largest_angle_factor;
  constexpr std::size_t kStates = 5;
  const Functions f(functions);
  std::vector<ExactState> exact;
  for (std::size_t k = 0; k < std::min(kStates, states.size()); ++k) {
    const State& s = states[k];
    exact.push_back({exact_vector(s.q), exact_vector(s.qd), exact_vector(s.qdd), exact_vector(s.tau), s.parameters,
                     exact_vector(s.g_b)});
    const bool has_quaternions = mechanism != nullptr && mechanism->has_spherical_joints();
    exact.back().rates = has_quaternions ? rates_of(*mechanism, exact.back()) : rates_of(f, exact.back(), mechanism);
  }
  std::vector<Property> properties;
  const auto vanishing = [&](const std::string& name, double (*measure)(const Functions&, const ExactState&)) {
    double largest = 0;
    for (const ExactState& state : exact) largest = std::max(largest, measure(f, state));
    properties.push_back({name, fmt::format("{:.1g}, relative", largest), largest < tolerance});
  };
  if (f.has({"inertia_matrix"})) {
    vanishing("B is symmetric", asymmetry);
    double pivot = std::numeric_limits<double>::infinity();
    for (const ExactState& state : exact) pivot = std::min(pivot, smallest_pivot(f, state));
    properties.push_back(definiteness(pivot, exact.size(), proven));
  }
  const bool moves = !f.are_at_rest() && !exact.empty() && exact.front().rates.size() == exact.front().q.size();
  if (moves && f.has({"inertia_matrix", "coriolis_matrix"})) vanishing("w'(dB/dt - 2C)w = 0, (7.48)", skewness);
  if (moves && f.has({"inverse_dynamics", "bias", "coriolis_matrix", "kinetic_energy"})) {
    vanishing("energy balance, (7.50)", energy_imbalance);
  }
  if (f.has({"inverse_dynamics", "forward_dynamics"})) {
    vanishing("forward dynamics undoes inverse dynamics",
              [](const Functions& g, const ExactState& s) { return round_trip(g, s); });
  }
  return properties;
}

}  // namespace flatdyn
