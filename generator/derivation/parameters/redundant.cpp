// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/redundant.hpp"

#include <algorithm>
#include <random>

#include "derivation/kernel/elimination.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

constexpr int kSamples = kEnergyParameters + 5;  // more motions than unknowns, so that they are in general position

// Sources of random motions: over a prime field for the dimension of M_j, in rationals for its vectors.
struct PrimeField {
  using F = ModP<kMersenne61>;
  explicit PrimeField(const Mechanism& mechanism) : number(mechanism.symbols, arithmetic) {}
  F operator()(const Number& a) const { return number(a); }
  F draw() { return F(engine()); }

  std::mt19937_64 engine{1};
  ModPArithmetic<> arithmetic{1};
  NumberMap<ModPArithmetic<>> number;
};

struct Rationals {
  using F = Number;
  explicit Rationals(const Mechanism&) {}
  F operator()(const Number& a) const { return a; }
  F draw() { return GiNaC::numeric(static_cast<long>(engine() % 199) - 99, static_cast<long>(engine() % 9) + 1); }

  std::mt19937_64 engine{1};
};

// The position and rate of a joint.
template <class F>
struct JointState {
  F c = F(1), s = F(0), d = F(0), rate = F(0);
};

// The state that a body's energy depends on, in its own frame.
template <class F>
struct BodyState {
  Vector3<F> omega{F(0), F(0), F(0)}, v{F(0), F(0), F(0)}, g{F(0), F(0), F(0)};  // rad/s, m/s, m/s^2
  F height = F(0);                                                               // g_0 · p_i, m^2/s^2
};

template <class Source>
class FieldEnergies {
 public:
  using F = typename Source::F;
  using Row = std::vector<F>;

  FieldEnergies(const Mechanism& mechanism, Source& source) : mechanism_(mechanism), source_(source) {
    for (const Body& body : mechanism.bodies) {
      rotation_.push_back(transposed(mapped(constant_rotation(body))));
      p_.push_back(mapped(body.p));
    }
  }

  // The energies at one random motion of the whole tree: for every joint those of its parameters, less those at q_j =
  // q̇_j = 0.
  std::vector<Row> sample() {
    std::vector<BodyState<F>> states;
    std::vector<Row> rows;
    BodyState<F> base;
    base.g = mapped(mechanism_.gravity);
    for (int j = 0; j < mechanism_.body_count(); ++j) {
      const int parent = parent_of_joint(mechanism_, j);
      const BodyState<F> before = parent < 0 ? base : states[static_cast<std::size_t>(parent)];
      if (mechanism_.is_of_spherical(j)) {
        add_spherical(j, before, states, rows);
        continue;
      }
      const JointState<F> joint = drawn();
      states.push_back(moved(j, before, joint));
      Row row = energies(states.back());
      const Row held = energies(moved(j, before, {}));
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = row[k] - held[k];
      row.push_back(rotor_energy(j, states, joint.rate));
      rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  Vector3<F> mapped(const Vec3& v) const { return {source_(v[0]), source_(v[1]), source_(v[2])}; }
  Matrix3<F> mapped(const Mat3& m) const { return {mapped(m[0]), mapped(m[1]), mapped(m[2])}; }

  JointState<F> drawn() {
    const F t = source_.draw(), n = F(1) + t * t;
    return {(F(1) - t * t) / n, (t + t) / n, source_.draw(), source_.draw()};
  }

  // A body of a spherical joint: the first two have no parameters, and the last one's state follows from the parent's.
  void add_spherical(int j, const BodyState<F>& parent, std::vector<BodyState<F>>& states, std::vector<Row>& rows) {
    const auto last = static_cast<std::size_t>(j);
    const auto first = static_cast<std::size_t>(first_body_of_joint(mechanism_, j));
    Matrix3<F> before = rotation_[first];
    for (std::size_t i = first + 1; i <= last; ++i) before = times(rotation_[i], before);
    const Vector3<F> rates = {source_.draw(), source_.draw(), source_.draw()};
    const BodyState<F> held = turned(parent, p_[first], before);
    BodyState<F> body = turned(parent, p_[first], times(transposed(drawn_rotation()), before));
    body.omega = plus(body.omega, rates);
    Row row = energies(body);
    const Row at_rest = energies(held);
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = row[k] - at_rest[k];
    row.push_back(F(0));
    states.push_back(body);
    rows.push_back(is_inside_joint(mechanism_.bodies[last]) ? Row(row.size(), F(0)) : row);
  }

  Matrix3<F> drawn_rotation() {
    const Vector3<F> t = {source_.draw(), source_.draw(), source_.draw()};
    const F square = dot(t, t), per = F(1) / (F(1) + square), two = F(1) + F(1);
    return rotation_of_quaternion<F>({(F(1) - square) * per, two * t[0] * per, two * t[1] * per, two * t[2] * per});
  }

  // The state of a body that does not move relative to its parent. `to_body`: the parent's axes → its own.
  static BodyState<F> turned(const BodyState<F>& parent, const Vector3<F>& p, const Matrix3<F>& to_body) {
    BodyState<F> body;
    body.omega = times(to_body, parent.omega);
    body.v = times(to_body, plus(parent.v, cross(parent.omega, p)));
    body.g = times(to_body, parent.g);
    body.height = parent.height + dot(parent.g, p);
    return body;
  }

  BodyState<F> moved(int j, const BodyState<F>& parent, const JointState<F>& joint) const {
    const auto k = static_cast<std::size_t>(j);
    BodyState<F> body = turned(parent, p_[k], rotation_[k]);
    if (mechanism_.bodies[k].prismatic) {
      body.height = body.height + joint.d * body.g[2];
      const Vector3<F> slide = {joint.d * body.omega[1], -(joint.d * body.omega[0]), joint.rate};
      body.v = plus(body.v, slide);
      return body;
    }
    for (Vector3<F>* vector : {&body.omega, &body.v, &body.g}) {
      Vector3<F>& a = *vector;
      a = {joint.c * a[0] + joint.s * a[1], joint.c * a[1] - joint.s * a[0], a[2]};
    }
    body.omega[2] = body.omega[2] + joint.rate;
    return body;
  }

  // Twice the kinetic and potential energy of unit parameters, (7.70), (7.75).
  static Row energies(const BodyState<F>& body) {
    const F two = F(1) + F(1);
    const Vector3<F>& w = body.omega;
    const Vector3<F> h = scaled(two, minus(cross(body.v, w), body.g));
    return {dot(body.v, body.v) - two * body.height,
            h[0],
            h[1],
            h[2],
            w[0] * w[0],
            two * w[0] * w[1],
            two * w[0] * w[2],
            w[1] * w[1],
            two * w[1] * w[2],
            w[2] * w[2]};
  }

  // Twice the last two terms of (7.70); zero when the joint does not move.
  F rotor_energy(int j, const std::vector<BodyState<F>>& states, const F& rate) const {
    const auto& rotor = mechanism_.bodies[static_cast<std::size_t>(j)].rotor;
    if (!rotor) return rate * rate;
    const F spin = source_(rotor->gear_ratio) * rate;
    if (rotor->carrier < 0) return spin * spin;
    const F carried = dot(mapped(rotor->axis), states[static_cast<std::size_t>(rotor->carrier)].omega);
    return spin * (spin + carried + carried);
  }

  const Mechanism& mechanism_;
  Source& source_;
  std::vector<Matrix3<F>> rotation_;  // parent's axes → own, at q = 0
  std::vector<Vector3<F>> p_;
};

std::vector<Parameter> energy_preference() {
  std::vector<Parameter> order(std::begin(kPreference), std::end(kPreference));
  std::erase_if(order, [](Parameter p) { return static_cast<int>(p) >= kEnergyParameters; });
  return order;
}

// The rows of joint j, samples[s][j], with columns in the order of preference.
template <class F>
std::vector<std::vector<F>> rows_of(const std::vector<std::vector<std::vector<F>>>& samples, int j) {
  std::vector<std::vector<F>> rows;
  for (const auto& sample : samples) {
    std::vector<F> row;
    for (const Parameter p : energy_preference()) {
      row.push_back(sample[static_cast<std::size_t>(j)][static_cast<std::size_t>(p)]);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Parameter> leads_in_general(const Body& body) {
  using enum Parameter;
  if (body.prismatic) return {Izz, Ixx, Ixy, Ixz, Iyz, Iyy};
  if (body.spherical > 0) return {m};
  return {m, mlz, Iyy};
}

std::vector<RedundantPart> parts_in_general(const Body& body) {
  std::vector<RedundantPart> parts;
  for (const Parameter lead : leads_in_general(body)) {
    RedundantPart part{lead, std::vector<Number>(kEnergyParameters, 0)};
    part.entries[static_cast<std::size_t>(lead)] = 1;
    if (!body.prismatic && lead == Parameter::Iyy) part.entries[static_cast<std::size_t>(Parameter::Ixx)] = 1;
    parts.push_back(part);
  }
  return parts;
}

template <class F>
std::vector<Parameter> free_columns(const Echelon<F>& echelon) {
  std::vector<Parameter> free;
  const std::vector<Parameter> order = energy_preference();
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& pivots = echelon.pivots;
    if (std::find(pivots.begin(), pivots.end(), k) == pivots.end()) free.push_back(order[k]);
  }
  return free;
}

// The null space of an echelon form: one vector per column without a pivot.
std::vector<RedundantPart> null_space(const Echelon<Number>& echelon) {
  const std::vector<Parameter> order = energy_preference();
  std::vector<RedundantPart> parts;
  for (const Parameter lead : free_columns(echelon)) {
    const auto column = static_cast<std::size_t>(std::find(order.begin(), order.end(), lead) - order.begin());
    RedundantPart part{lead, std::vector<Number>(kEnergyParameters, 0)};
    part.entries[static_cast<std::size_t>(lead)] = 1;
    for (std::size_t r = 0; r < echelon.pivots.size(); ++r) {
      part.entries[static_cast<std::size_t>(order[echelon.pivots[r]])] = -echelon.rows[r][column];
    }
    parts.push_back(part);
  }
  return parts;
}

template <class Source>
std::vector<std::vector<std::vector<typename Source::F>>> samples_of(const Mechanism& mechanism, Source& source) {
  FieldEnergies<Source> energies(mechanism, source);
  std::vector<std::vector<std::vector<typename Source::F>>> samples;
  for (int k = 0; k < kSamples; ++k) samples.push_back(energies.sample());
  return samples;
}

// The mechanism with the bodies up to j only, as exact numbers grow with the distance from the base.
Mechanism up_to(const Mechanism& mechanism, int j) {
  Mechanism part = mechanism;
  part.bodies.resize(static_cast<std::size_t>(j) + 1);
  return part;
}

}  // namespace

std::vector<std::vector<RedundantPart>> redundant_parts(const Mechanism& mechanism) {
  PrimeField field(mechanism);
  const auto samples = samples_of(mechanism, field);
  std::vector<std::vector<RedundantPart>> parts;
  std::vector<int> special;
  for (int j = 0; j < mechanism.body_count(); ++j) {
    const Body& body = mechanism.bodies[static_cast<std::size_t>(j)];
    const auto echelon = reduced_echelon(rows_of(samples, j), [](const auto& x) { return x == PrimeField::F(0); });
    std::vector<Parameter> found = free_columns(echelon), general = leads_in_general(body);
    std::sort(found.begin(), found.end());
    std::sort(general.begin(), general.end());
    const bool has_none = mechanism.is_of_base(j) || has_no_link(body);
    if (found != general && !has_none) special.push_back(j);
    parts.push_back(has_none ? std::vector<RedundantPart>{} : parts_in_general(body));
  }
  if (special.empty()) return parts;
  Rationals rationals(mechanism);
  const Mechanism near_base = up_to(mechanism, special.back());
  const auto exact = samples_of(near_base, rationals);
  const auto is_zero = [&field](const Number& x) { return field(x) == PrimeField::F(0); };
  for (const int j : special) {
    parts[static_cast<std::size_t>(j)] = null_space(reduced_echelon(rows_of(exact, j), is_zero));
  }
  return parts;
}

}  // namespace flatdyn
