// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/loops/loops.hpp"

#include "derivation/loops/loop_determinant.hpp"

namespace flatdyn {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Rows columns_of(const Rows& A, const std::vector<int>& columns) {
  Rows result;
  for (const std::vector<Number>& row : A) {
    result.emplace_back();
    for (const int k : columns) result.back().push_back(row[at(k)]);
  }
  return result;
}

std::vector<Number> those_of(const std::vector<std::size_t>& rows, const std::vector<Number>& components) {
  std::vector<Number> result;
  for (const std::size_t row : rows) result.push_back(components[row]);
  return result;
}

std::vector<Number> list_of(const Vec3& v) { return {v.begin(), v.end()}; }

// ℓ^2r, where r is the number of rows of axes; 1 without rows of points.
Number axes_factor(const LoopClosure& closure, const Number& scale) {
  Number factor = 1;
  if (closure.rows.front() >= LoopClosure::kOfPoints) return factor;
  for (const std::size_t row : closure.rows) {
    if (row >= LoopClosure::kOfPoints) factor *= scale;
  }
  return factor;
}

std::string entry_name(const std::string& name, std::size_t k) { return name + "_" + label(static_cast<int>(k)); }

}  // namespace

ClosedLoops::ClosedLoops(const Mechanism& mechanism, Derivation& derivation)
    : mechanism_(mechanism), d_(derivation), frames_(mechanism, derivation) {
  for (std::size_t l = 0; l < mechanism.loops.size(); ++l) loops_.push_back(geometry(mechanism.loops[l], l));
}

Number ClosedLoops::factor(int body, std::size_t position) const { return mechanism_.coupling[at(body)][position]; }

// From the carrier outwards, as the Jacobian of a frame.
ClosedLoops::Path ClosedLoops::path_to(const LoopClosure& closure, std::size_t end, const std::string& name) {
  const std::vector<int> bodies = flatdyn::path_to(mechanism_, closure.ends[end].body, closure.carrier);
  std::vector<Joint> path;
  std::vector<Vec3> origins;
  Mat3 R = transpose(closure.axes);
  Vec3 origin = zero_vector();
  for (const int i : bodies) {
    const std::string n = name + frames_.label(i);
    const Vec3 z = d_.named(R * frames_.axis_in_parent(i), "z_" + n);
    origin = d_.named(origin + R * frames_.p(i) + frames_.slide(i) * z, "p_" + n);
    origins.push_back(origin);
    path.push_back({i, frames_.body(i).prismatic, z, zero_vector(), zero_vector()});
    for (std::size_t k = 0; k < 3; ++k) R[k] = frames_.to_child(i, R[k], "R_" + n + std::to_string(k));
  }
  const Vec3 point = d_.named(origin + R * closure.ends[end].p, "p_" + name + "e");
  for (std::size_t k = 0; k < path.size(); ++k) {
    const std::string n = name + frames_.label(path[k].body);
    const Vec3& next = k + 1 < path.size() ? origins[k + 1] : point;
    path[k].link = d_.named(next - origins[k], "r_" + n);
    path[k].column = path[k].slides ? path[k].axis : d_.named(cross(path[k].axis, point - origins[k]), "J_" + n);
  }
  return {std::move(path), point, R};
}

void ClosedLoops::find_axes(const LoopClosure& closure, const Path& first, const Path& second, const std::string& name,
                            Loop& loop) {
  loop.axis = d_.named(second.R * closure.axis, "a_" + name);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string n = name + "_" + std::to_string(k + 1);
    loop.across[k] = d_.named(first.R * closure.across[k], "e_" + n);
    loop.normals[k] = d_.named(cross(loop.axis, loop.across[k]), "n_" + n);
    loop.gap.push_back(d_.named(dot(loop.across[k], loop.axis), "phi_" + n));
  }
}

ClosedLoops::Loop ClosedLoops::geometry(const LoopClosure& closure, std::size_t l) {
  Loop loop;
  const std::string name = "l" + label(static_cast<int>(l));
  const Path paths[] = {path_to(closure, 0, name + "a"), path_to(closure, 1, name + "b")};
  for (std::size_t e = 0; e < 2; ++e) loop.paths[e] = paths[e].joints;
  loop.gap = list_of(d_.named(paths[1].end - paths[0].end, "phi_" + name));
  if (closure.aligns_axes()) find_axes(closure, paths[0], paths[1], name, loop);
  const auto column_of = [&loop](const Joint& joint, std::size_t row) -> Number {
    if (row < LoopClosure::kOfPoints) return joint.column[row];
    return joint.slides ? Number(0) : dot(joint.axis, loop.normals[row - LoopClosure::kOfPoints]);
  };
  const auto m = at(mechanism_.position_count());
  for (const std::size_t row : closure.rows) {
    loop.J.emplace_back(m, 0);
    for (std::size_t e = 0; e < 2; ++e) {
      for (const Joint& joint : loop.paths[e]) {
        const Number column = column_of(joint, row), part = e == 0 ? Number(-column) : column;
        for (std::size_t k = 0; k < m; ++k) loop.J.back()[k] += factor(joint.body, k) * part;
      }
    }
    for (std::size_t k = 0; k < m; ++k) {
      loop.J.back()[k] = d_.named(loop.J.back()[k], entry_name("Phi_" + name + std::to_string(row + 1), k));
    }
  }
  loop.determinant = d_.named(determinant(columns_of(loop.J, closure.dependent), d_, "M_" + name + "_"), "det_" + name);
  loop.reciprocal = d_.quotient(1, loop.determinant, "inv_" + name);
  return loop;
}

std::vector<Number> ClosedLoops::completed(std::vector<Number> values, const Extra& extra,
                                           const std::string& name) const {
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    const Loop& loop = loops_[l];
    const std::vector<int>& dependent = mechanism_.loops[l].dependent;
    std::vector<Number> rest = extra(loop, l);
    for (std::size_t r = 0; r < rest.size(); ++r) {
      for (std::size_t k = 0; k < values.size(); ++k) rest[r] += loop.J[r][k] * values[k];  // dependent: still 0
      rest[r] = d_.named(rest[r], entry_name(name + "r" + label(static_cast<int>(l)), r));
    }
    const Rows own = columns_of(loop.J, dependent);
    std::vector<Number> found;
    for (std::size_t c = 0; c < dependent.size(); ++c) {
      const std::string n = entry_name(name, at(dependent[c]));
      const Number numerator = d_.named(determinant_with(own, c, rest, d_, name + "m"), n + "n");
      found.push_back(d_.named(numerator * loop.reciprocal, n));
    }
    for (std::size_t c = 0; c < dependent.size(); ++c) values[at(dependent[c])] = found[c];
  }
  return values;
}

std::vector<Number> ClosedLoops::closure() const {
  std::vector<Number> result;
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    for (const Number& entry : those_of(mechanism_.loops[l].rows, loops_[l].gap)) result.push_back(entry);
  }
  return result;
}

Rows ClosedLoops::jacobian() const {
  Rows result;
  for (const Loop& loop : loops_) result.insert(result.end(), loop.J.begin(), loop.J.end());
  return result;
}

Rows ClosedLoops::motion() const {
  const auto m = at(mechanism_.position_count());
  Rows G(m);
  for (std::size_t a = 0; a < mechanism_.independent.size(); ++a) {
    std::vector<Number> unit(m, 0);
    unit[at(mechanism_.independent[a])] = 1;
    const auto nothing = [](const Loop& loop, std::size_t) { return std::vector<Number>(loop.J.size(), 0); };
    const std::vector<Number> column = completed(std::move(unit), nothing, entry_name("G", a));
    for (std::size_t k = 0; k < m; ++k) G[k].push_back(column[k]);
  }
  return G;
}

// Accelerations are symmetric in the two motions, which may be the same one. A link that turns swings what it carries,
// and takes the axes beyond it along.
ClosedLoops::Motion ClosedLoops::motion_of(const std::vector<Joint>& path, const std::vector<Number>& u,
                                           const std::vector<Number>& v) const {
  const Number half = Number(1) / 2;
  Motion motion;
  auto& [omega_u, omega_v, domega, sum] = motion;
  for (const Joint& joint : path) {
    const std::string n = frames_.label(joint.body);
    const Vec3 spin_u = u[at(joint.body)] * joint.axis, spin_v = v[at(joint.body)] * joint.axis;
    const Vec3 carried = half * (cross(omega_u, spin_v) + cross(omega_v, spin_u));
    if (joint.slides) {
      sum = sum + Number(2) * carried;
    } else {
      domega = d_.named(domega + carried, "domega_l" + n);
      omega_u = d_.named(omega_u + spin_u, "omega_l" + n);
      omega_v = d_.named(omega_v + spin_v, "omega_l" + n);
    }
    const Vec3 swing = cross(omega_u, cross(omega_v, joint.link)) + cross(omega_v, cross(omega_u, joint.link));
    sum = d_.named(sum + cross(domega, joint.link) + half * swing, "a_l" + n);
  }
  return motion;
}

// The second derivative of e·a while q̈ = 0. The first one is n·ω with n = a × e and ω the angular velocity of the
// second end relative to the first. So the second one is n·ω̇ + ω·ṅ, where with w of the first end, s of the second and
// ω = s - w
//   ω·ṅ = (e·s)(a·ω) - (a·w)(e·ω) - (e·a)(ω·ω)
// for a motion, and half of it with two motions crossed both ways. Not only where the loop is closed.
std::vector<Number> ClosedLoops::axis_drift(const Loop& loop, const Motion& first, const Motion& second) const {
  const Number half = Number(1) / 2;
  const Vec3 &w_u = first.omega_u, &w_v = first.omega_v, &s_u = second.omega_u, &s_v = second.omega_v;
  const auto along = [this](const Vec3& v, const Vec3& omega, const std::string& name) {
    return d_.named(dot(v, omega), name);
  };
  const Number a_w_u = along(loop.axis, w_u, "along_a"), a_w_v = along(loop.axis, w_v, "along_a");
  const Number a_u = along(loop.axis, s_u, "along_a") - a_w_u, a_v = along(loop.axis, s_v, "along_a") - a_w_v;
  const Number square = d_.named(dot(s_u - w_u, s_v - w_v), "omega2_l");
  std::vector<Number> result;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3& e = loop.across[k];
    const Number e_s_u = along(e, s_u, "along_e"), e_s_v = along(e, s_v, "along_e");
    const Number e_u = e_s_u - along(e, w_u, "along_e"), e_v = e_s_v - along(e, w_v, "along_e");
    result.push_back(dot(loop.normals[k], second.domega - first.domega) -
                     loop.gap[LoopClosure::kOfPoints + k] * square +
                     half * (e_s_u * a_v + e_s_v * a_u - a_w_u * e_v - a_w_v * e_u));
  }
  return result;
}

std::vector<Number> ClosedLoops::drift_of(const Loop& loop, std::size_t l, const std::vector<Number>& rates,
                                          const std::vector<Number>& rates_r) const {
  const Motion first = motion_of(loop.paths[0], rates, rates_r), second = motion_of(loop.paths[1], rates, rates_r);
  std::vector<Number> all = list_of(second.a - first.a);
  if (mechanism_.loops[l].aligns_axes()) {
    for (const Number& each : axis_drift(loop, first, second)) all.push_back(each);
  }
  return those_of(mechanism_.loops[l].rows, all);
}

std::vector<Number> ClosedLoops::drift(const std::vector<Number>& rates, const std::vector<Number>& rates_r,
                                       const std::string& name) const {
  const auto extra = [&](const Loop& loop, std::size_t l) { return drift_of(loop, l, rates, rates_r); };
  return completed(std::vector<Number>(at(mechanism_.position_count()), 0), extra, name);
}

std::vector<Number> ClosedLoops::step() const {
  const auto extra = [&](const Loop& loop, std::size_t l) { return those_of(mechanism_.loops[l].rows, loop.gap); };
  return completed(std::vector<Number>(at(mechanism_.position_count()), 0), extra, "step");
}

// The lengths of the links beyond joint j of a path, and of the strokes of prismatic joints beyond it.
ClosedLoops::Lengths ClosedLoops::lengths_beyond(const std::vector<Joint>& path, std::size_t j,
                                                 const LoopClosure::End& end) const {
  if (path[j].slides) return {1, 1};  // its column is a unit vector
  Lengths lengths{0, 0};
  const auto add = [&lengths](const Number& square) {
    lengths.squares += square;
    ++lengths.count;
  };
  for (std::size_t i = j; i + 1 < path.size(); ++i) {
    const int next = path[i + 1].body;
    add(dot(frames_.p(next), frames_.p(next)));
    if (path[i + 1].slides) add(frames_.slide(next) * frames_.slide(next));
  }
  add(dot(end.p, end.p));
  return lengths;
}

// The end moves by at most the lengths of the links beyond the joints, one after another, and the square of a sum of k
// lengths is at most k times the sum of their squares.
ClosedLoops::Reach ClosedLoops::reach_of(std::size_t l, int position) const {
  Lengths column{0, 0}, turns{0, 0};
  for (std::size_t e = 0; e < 2; ++e) {
    const std::vector<Joint>& path = loops_[l].paths[e];
    for (std::size_t j = 0; j < path.size(); ++j) {
      const Number times = factor(path[j].body, at(position));
      if (vanishes(times)) continue;
      const Lengths beyond = lengths_beyond(path, j, mechanism_.loops[l].ends[e]);
      column.squares += times * times * beyond.squares;
      column.count += beyond.count;
      if (path[j].slides) continue;
      turns.squares += times * times;
      ++turns.count;
    }
  }
  const std::string name = "reach_l" + label(static_cast<int>(l));
  return {d_.named(column.count * column.squares, entry_name(name, at(position))), turns.count * turns.squares};
}

// ℓ², of a length like those by which joints that turn move the ends: it makes rows of points and rows of axes
// comparable in a loop whose axes meet. It is 0 for a spherical linkage, which does not need it.
Number ClosedLoops::length_scale(std::size_t l) const {
  if (mechanism_.loops[l].rows.front() >= LoopClosure::kOfPoints) return 0;
  Number sum = 0;
  int count = 0;
  for (const int k : mechanism_.loops[l].dependent) {
    const Reach reach = reach_of(l, k);
    if (vanishes(reach.turns)) continue;
    sum += reach.moves;
    ++count;
  }
  return d_.named(sum / count, "scale2_l" + label(static_cast<int>(l)));
}

// Squared, by Hadamard: a determinant is at most the product of its columns' lengths. Where axes meet, rows of points
// are divided by ℓ, and what slides is multiplied by it, so that all have no unit: |Φ_d|² ℓ^2r is at most this, with r
// rows of axes.
Number ClosedLoops::largest_determinant(std::size_t l, const Number& scale) const {
  Number product = 1;
  for (const int k : mechanism_.loops[l].dependent) product *= largest_column(l, k, scale);
  return product;
}

Number ClosedLoops::largest_column(std::size_t l, int position, const Number& scale) const {
  const LoopClosure& closure = mechanism_.loops[l];
  const Reach reach = reach_of(l, position);
  if (!closure.aligns_axes()) return reach.moves;
  if (closure.rows.front() >= LoopClosure::kOfPoints) return reach.turns;
  return d_.named(reach.moves + scale * reach.turns, entry_name("reach_l" + label(static_cast<int>(l)), at(position)));
}

// By Cramer's rule, an entry of G is a quotient of determinants, and the numerator is at most the product of its
// columns' lengths (Hadamard): those of the other dependent joints, and the loop's motion by the independent ones.
std::vector<Number> ClosedLoops::sizes_of_inertia(const std::vector<Number>& of_tree) const {
  const std::vector<int>& independent = mechanism_.independent;
  Rows squares(of_tree.size(), std::vector<Number>(independent.size(), 0));  // of entries of G, at most
  for (std::size_t a = 0; a < independent.size(); ++a) squares[at(independent[a])][a] = 1;
  for (std::size_t l = 0; l < loops_.size(); ++l) add_dependent(l, squares);
  std::vector<Number> result(independent.size(), 0);
  for (std::size_t a = 0; a < result.size(); ++a) {
    for (std::size_t k = 0; k < of_tree.size(); ++k) result[a] += of_tree[k] * squares[k][a];
  }
  return result;
}

void ClosedLoops::add_dependent(std::size_t l, Rows& squares) const {
  const LoopClosure& closure = mechanism_.loops[l];
  const Number scale = closure.aligns_axes() ? length_scale(l) : Number(0), largest = largest_determinant(l, scale);
  const std::string name = "l" + label(static_cast<int>(l));
  const Number& reciprocal = loops_[l].reciprocal;
  const Number inverse = d_.named(reciprocal * reciprocal, "inv2_" + name) / axes_factor(closure, scale);
  for (std::size_t a = 0; a < squares.front().size(); ++a) {
    Number moved = 0;
    for (std::size_t k = 0; k < squares.size(); ++k) {
      if (!vanishes(squares[k][a])) moved += largest_column(l, static_cast<int>(k), scale) * squares[k][a];
    }
    for (const int j : closure.dependent) {
      const Number square = largest / largest_column(l, j, scale) * moved * inverse;
      squares[at(j)][a] = d_.named(square, entry_name("G2_" + name + label(static_cast<int>(a)), at(j)));
    }
  }
}

std::vector<ClosedLoops::Condition> ClosedLoops::conditions() const {
  const Number trifle = Number(1) / 1000000, share_of_scale = Number(1) / 1024;
  std::vector<Condition> result;
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    const std::string name = "l" + label(static_cast<int>(l));
    const Number& det = loops_[l].determinant;
    const Number scale = mechanism_.loops[l].aligns_axes() ? length_scale(l) : Number(0);
    const Number largest = largest_determinant(l, scale);
    const Number least = d_.named(trifle * trifle * largest, "least_" + name);
    const Number square = d_.named(det * det, "det2_" + name) * axes_factor(mechanism_.loops[l], scale);
    const Number measure = d_.named(square - least, "regular_" + name);
    NodeId reciprocal = d_.node(loops_[l].reciprocal);
    if (d_.graph().is_scaled(reciprocal)) reciprocal = d_.graph()[reciprocal].terms.front().node;  // what sums refer to
    result.push_back({reciprocal, d_.node(measure), d_.node(d_.named(share_of_scale * largest, "scale_" + name))});
  }
  return result;
}

}  // namespace flatdyn
