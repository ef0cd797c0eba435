// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/composite.hpp"

#include "derivation/dynamics/twists.hpp"

namespace flatdyn {
namespace {

int parent_of(Frames& frames, int i) { return frames.body(i).parent; }

// 2 (p·h) 1 - p hᵀ - h pᵀ + m (p·p 1 - p pᵀ): the change of an inertia when the reference point moves from the origin
// of frame i to that of its parent; h is the first moment about the old point.
Mat3 inertia_shift(const Number& m, const Vec3& h, const Vec3& p) { return inertia_between(p, h + (m / 2) * p); }

// The zz entry of that change, if the axes of body i and its parent are parallel; h and p are in axes of frame i.
Number moved_axis(const Body& body, const Number& m, const Vec3& h, const Vec3& p) {
  return 2 * (p[0] * h[0] + p[1] * h[1]) + m * (body.p[0] * body.p[0] + body.p[1] * body.p[1]);
}

InertialParameters composite_in_parent(Frames& frames, int i, const InertialParameters& composite) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  InertialParameters slid = composite;
  if (frames.body(i).prismatic) {
    const Vec3 slide = {0, 0, frames.slide(i)};
    slid.inertia =
        d.named_symmetric(composite.inertia + inertia_shift(composite.mass, composite.first_moment, slide), "Is_" + n);
    slid.first_moment = d.named(composite.first_moment + composite.mass * slide, "hs_" + n);
  }
  const Vec3 h = frames.to_parent(i, slid.first_moment, "hu_" + n);
  const Mat3 I = frames.to_parent(i, slid.inertia, "Iu_" + n);
  const Vec3& p = frames.p(i);
  Mat3 moved = inertia_shift(composite.mass, h, p);
  if (const auto& own = frames.p_in_own_axes(i))
    moved[2][2] = moved_axis(frames.body(i), composite.mass, slid.first_moment, *own);
  return {composite.mass, h + composite.mass * p, I + moved};
}

// Calls visit(k, wrench) for i and every body k between it and the base, with the unit wrench of i in frame k.
template <class Visit>
void visit_ancestors(Frames& frames, int i, Wrench wrench, Visit visit) {
  Derivation& d = frames.derivation();
  const auto& rotor = frames.body(i).rotor;
  for (int k = i;; k = parent_of(frames, k)) {
    const std::string n = frames.label(i) + "_" + frames.label(k);
    if (rotor && k != i && rotor->carrier == k) {
      wrench.mu = wrench.mu + rotor_momentum(frames, i);
    }
    wrench = {d.named(wrench.f, "f_" + n), d.named(wrench.mu, "mu_" + n)};
    visit(k, wrench);
    if (parent_of(frames, k) < 0) return;
    wrench = to_parent(frames, k, wrench, n);
  }
}

}  // namespace

Wrench unit_wrench(Frames& frames, int i, const InertialParameters& composite) {
  const Vec3& h = composite.first_moment;
  if (frames.body(i).prismatic) return {{0, 0, composite.mass}, {h[1], -h[0], 0}};
  return {{-h[1], h[0], 0}, {composite.inertia[0][2], composite.inertia[1][2], composite.inertia[2][2]}};
}

Wrench derivative_by_joint(const Body& body, const Wrench& wrench) {
  const Vec3 &f = wrench.f, &mu = wrench.mu;
  if (body.prismatic) return {zero_vector(), {-f[1], f[0], 0}};
  return {{-f[1], f[0], 0}, {-mu[1], mu[0], 0}};
}

std::vector<InertialParameters> composites(Frames& frames) {
  Derivation& d = frames.derivation();
  std::vector<InertialParameters> result;
  for (int i = 0; i < frames.mechanism().body_count(); ++i) result.push_back(frames.inertia(i));
  for (int i = frames.mechanism().body_count() - 1; i >= 0; --i) {
    InertialParameters& composite = result[static_cast<std::size_t>(i)];
    const std::string n = frames.label(i);
    composite = {d.named(composite.mass, "mc_" + n), d.named(composite.first_moment, "hc_" + n),
                 d.named_symmetric(composite.inertia, "Ic_" + n)};
    if (parent_of(frames, i) < 0) continue;
    InertialParameters& parent = result[static_cast<std::size_t>(parent_of(frames, i))];
    const InertialParameters carried = composite_in_parent(frames, i, composite);
    parent = {parent.mass + carried.mass, parent.first_moment + carried.first_moment, parent.inertia + carried.inertia};
  }
  return result;
}

Rows inertia_matrix(Frames& frames) {
  Derivation& d = frames.derivation();
  const auto n = static_cast<std::size_t>(frames.mechanism().body_count());
  const std::vector<InertialParameters> bodies = composites(frames);
  Rows B(n, std::vector<Number>(n, 0));
  for (std::size_t j = 0; j < n; ++j) {
    const int jj = static_cast<int>(j);
    visit_ancestors(frames, jj, unit_wrench(frames, jj, bodies[j]), [&](int i, const Wrench& wrench) {
      const auto ii = static_cast<std::size_t>(i);
      Number b = joint_component(frames, i, wrench);
      if (i == jj) b += d.named(reflected_inertia(frames.body(i)), "I_r" + frames.label(i));
      B[ii][j] = B[j][ii] = d.named(b, "b_" + frames.label(i) + "_" + frames.label(jj));
    });
  }
  return B;
}

namespace {

// dI/dq_k of composite body k, which turns or slides with joint k, for a fixed observer.
InertialParameters rate_of(Derivation& d, const Body& body, const InertialParameters& composite, const std::string& n) {
  const Vec3& h = composite.first_moment;
  const Mat3& I = composite.inertia;
  InertialParameters rate;
  if (body.prismatic) {
    // The reference point is fixed while the body moves along z: h' = m z, I' = 2 (z·h) 1 - z hᵀ - h zᵀ.
    rate.first_moment = {0, 0, composite.mass};
    rate.inertia = {Vec3{2 * h[2], 0, -h[0]}, Vec3{0, 2 * h[2], -h[1]}, Vec3{-h[0], -h[1], 0}};
  } else {
    // I' = S(z) I - I S(z), h' = z × h.
    rate.first_moment = {-h[1], h[0], 0};
    rate.inertia = {Vec3{-2 * I[0][1], I[0][0] - I[1][1], -I[1][2]}, Vec3{I[0][0] - I[1][1], 2 * I[0][1], I[0][2]},
                    Vec3{-I[1][2], I[0][2], 0}};
  }
  return {0, d.named(rate.first_moment, "dh_" + n), d.named_symmetric(rate.inertia, "dI_" + n)};
}

// (rate of inertia) · twist. The mass is constant, so v acts on the first moment only.
Wrench applied(const InertialParameters& rate, const Twist& twist) {
  return {cross(twist.omega, rate.first_moment), rate.inertia * twist.omega + cross(rate.first_moment, twist.v)};
}

// Halves of the derivatives of B that are not zero: swept[{i, k, j}] = ½ ∂b_ij/∂q_k for i < k <= j, turned[{i, j, k}] =
// ½ ∂b_ij/∂q_k for i <= j < k.
struct HalfDerivatives {
  std::map<std::array<int, 3>, Number> swept, turned;
};

HalfDerivatives half_derivatives(Frames& frames) {  // the frames' mechanism has halved inertias
  Derivation& d = frames.derivation();
  const std::vector<InertialParameters> bodies = composites(frames);
  const std::vector<std::map<int, Twist>> twists = unit_twists(frames);
  HalfDerivatives result;
  for (int j = 0; j < frames.mechanism().body_count(); ++j) {
    const auto jj = static_cast<std::size_t>(j);
    visit_ancestors(frames, j, unit_wrench(frames, j, bodies[jj]), [&](int k, const Wrench& wrench) {
      const std::string n = frames.label(j) + "_" + frames.label(k);
      const Wrench swept = derivative_by_joint(frames.body(k), wrench);
      for (const auto& [i, twist] : twists[static_cast<std::size_t>(k)]) {
        if (i < k) result.swept[{i, k, j}] = d.named(power(twist, swept), "db_" + frames.label(i) + n);
      }
    });
    const InertialParameters rate = rate_of(d, frames.body(j), bodies[jj], frames.label(j));
    for (const auto& [b, twist_b] : twists[jj]) {
      if (b == j) continue;
      const Wrench turned = applied(rate, twist_b);
      const std::string n = frames.label(b) + "_" + frames.label(j);
      const Wrench named = {d.named(turned.f, "df_" + n), d.named(turned.mu, "dmu_" + n)};
      for (const auto& [a, twist_a] : twists[jj]) {
        if (a <= b) result.turned[{a, b, j}] = d.named(power(twist_a, named), "db_" + frames.label(a) + n + "r");
      }
    }
  }
  return result;
}

}  // namespace

Mechanism with_half_inertia(const Mechanism& mechanism) {
  Mechanism half = mechanism;
  const Number factor = Number(1) / 2;
  for (Body& body : half.bodies) {
    body.inertia.mass *= factor;
    body.inertia.first_moment = factor * body.inertia.first_moment;
    for (Vec3& row : body.inertia.inertia) row = factor * row;
    if (body.rotor) body.rotor->inertia *= factor;
    body.armature *= factor;
  }
  return half;
}

std::map<std::array<int, 3>, Number> christoffel_symbols(Frames& frames) {
  Derivation& d = frames.derivation();
  const HalfDerivatives half = half_derivatives(frames);
  std::map<std::array<int, 3>, Number> c;
  const auto set = [&](int i, int j, int k, const Number& value) {
    c[{i, j, k}] = d.named(value, "c_" + frames.label(i) + "_" + frames.label(j) + "_" + frames.label(k));
  };
  for (const auto& [key, swept] : half.swept) {
    const auto [i, k, j] = key;
    if (k == j) set(i, j, j, 2 * swept);  // c_ijj = ∂b_ij/∂q_j
  }
  for (const auto& [key, turned] : half.turned) {
    const auto [i, j, k] = key;
    if (i == j) {  // c_iik = ½ ∂b_ii/∂q_k = -c_kii
      set(i, i, k, turned);
      set(k, i, i, -turned);
      continue;
    }
    const Number swept = half.swept.at({i, j, k});  // ½ ∂b_ik/∂q_j; ∂b_jk/∂q_i = 0 for i < j < k
    set(i, j, k, turned + swept);
    set(j, i, k, turned - swept);
    set(k, i, j, swept - turned);
  }
  return c;
}

}  // namespace flatdyn
