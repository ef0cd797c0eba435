// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/loops/loops.hpp"

namespace flatdyn {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// By its first row.
Number determinant(const Rows& A) {
  if (A.size() == 1) return A[0][0];
  Number sum = 0;
  for (std::size_t k = 0; k < A.size(); ++k) {
    Rows minor;
    for (std::size_t i = 1; i < A.size(); ++i) {
      minor.push_back(A[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(k));
    }
    sum += (k % 2 == 0 ? A[0][k] : Number(-A[0][k])) * determinant(minor);
  }
  return sum;
}

Rows columns_of(const Rows& A, const std::vector<int>& columns) {
  Rows result;
  for (const std::vector<Number>& row : A) {
    result.emplace_back();
    for (const int k : columns) result.back().push_back(row[at(k)]);
  }
  return result;
}

std::vector<Number> components(const Vec3& v, const std::vector<std::size_t>& rows) {
  std::vector<Number> result;
  for (const std::size_t row : rows) result.push_back(v[row]);
  return result;
}

std::string entry_name(const std::string& name, std::size_t k) { return name + "_" + label(static_cast<int>(k)); }

}  // namespace

ClosedLoops::ClosedLoops(const Mechanism& mechanism, Derivation& derivation)
    : mechanism_(mechanism), d_(derivation), frames_(mechanism, derivation) {
  for (std::size_t l = 0; l < mechanism.loops.size(); ++l) loops_.push_back(geometry(mechanism.loops[l], l));
}

Number ClosedLoops::factor(int body, std::size_t position) const { return mechanism_.coupling[at(body)][position]; }

// From the carrier outwards, as the Jacobian of a frame; `point`: where the end is.
std::vector<ClosedLoops::Joint> ClosedLoops::way_to(const LoopClosure& closure, std::size_t end, Vec3& point,
                                                    const std::string& name) {
  const std::vector<int> bodies = flatdyn::way_to(mechanism_, closure.ends[end].body, closure.carrier);
  std::vector<Joint> way;
  std::vector<Vec3> origins;
  Mat3 R = transpose(closure.axes);
  Vec3 origin = zero_vector();
  for (const int i : bodies) {
    const std::string n = name + label(i);
    const Vec3 z = d_.named(R * frames_.axis_in_parent(i), "z_" + n);
    origin = d_.named(origin + R * frames_.p(i) + frames_.slide(i) * z, "p_" + n);
    origins.push_back(origin);
    way.push_back({i, frames_.body(i).prismatic, z, zero_vector(), zero_vector()});
    for (std::size_t k = 0; k < 3; ++k) R[k] = frames_.to_child(i, R[k], "R_" + n + std::to_string(k));
  }
  point = d_.named(origin + R * closure.ends[end].p, "p_" + name + "e");
  for (std::size_t k = 0; k < way.size(); ++k) {
    const std::string n = name + label(way[k].body);
    const Vec3& next = k + 1 < way.size() ? origins[k + 1] : point;
    way[k].link = d_.named(next - origins[k], "r_" + n);
    way[k].column = way[k].slides ? way[k].axis : d_.named(cross(way[k].axis, point - origins[k]), "J_" + n);
  }
  return way;
}

ClosedLoops::Loop ClosedLoops::geometry(const LoopClosure& closure, std::size_t l) {
  Loop loop;
  const std::string name = "l" + label(static_cast<int>(l));
  Vec3 ends[2];
  for (std::size_t e = 0; e < 2; ++e) loop.ways[e] = way_to(closure, e, ends[e], name + (e == 0 ? "a" : "b"));
  loop.gap = d_.named(ends[1] - ends[0], "phi_" + name);
  const auto m = at(mechanism_.position_count());
  for (const std::size_t row : closure.rows) {
    loop.J.emplace_back(m, 0);
    for (std::size_t e = 0; e < 2; ++e) {
      for (const Joint& joint : loop.ways[e]) {
        const Number part = e == 0 ? Number(-joint.column[row]) : joint.column[row];
        for (std::size_t k = 0; k < m; ++k) loop.J.back()[k] += factor(joint.body, k) * part;
      }
    }
    for (std::size_t k = 0; k < m; ++k) {
      loop.J.back()[k] = d_.named(loop.J.back()[k], entry_name("Phi_" + name + std::to_string(row + 1), k));
    }
  }
  loop.determinant = d_.named(determinant(columns_of(loop.J, closure.dependent)), "det_" + name);
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
    std::vector<Number> found;
    for (std::size_t c = 0; c < dependent.size(); ++c) {
      Rows replaced = columns_of(loop.J, dependent);
      for (std::size_t r = 0; r < rest.size(); ++r) replaced[r][c] = -rest[r];
      const std::string n = entry_name(name, at(dependent[c]));
      found.push_back(d_.named(d_.named(determinant(replaced), n + "n") * loop.reciprocal, n));
    }
    for (std::size_t c = 0; c < dependent.size(); ++c) values[at(dependent[c])] = found[c];
  }
  return values;
}

std::vector<Number> ClosedLoops::closure() const {
  std::vector<Number> result;
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    for (const Number& entry : components(loops_[l].gap, mechanism_.loops[l].rows)) result.push_back(entry);
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
  for (int a = 0; a < mechanism_.size(); ++a) {
    std::vector<Number> unit(m, 0);
    unit[at(mechanism_.position_of(a))] = 1;
    const auto nothing = [](const Loop& loop, std::size_t) { return std::vector<Number>(loop.J.size(), 0); };
    const std::vector<Number> column = completed(std::move(unit), nothing, "G_" + label(a));
    for (std::size_t k = 0; k < m; ++k) G[k].push_back(column[k]);
  }
  return G;
}

// What an end accelerates by when no joint does: symmetric in the two motions, which may be the same one. A link that
// turns swings what it carries, and takes the axes beyond it along.
Vec3 ClosedLoops::acceleration(const std::vector<Joint>& way, const std::vector<Number>& u,
                               const std::vector<Number>& v) const {
  const Number half = Number(1) / 2;
  Vec3 omega_u = zero_vector(), omega_v = zero_vector(), domega = zero_vector(), sum = zero_vector();
  for (const Joint& joint : way) {
    const std::string n = label(joint.body);
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
  return sum;
}

std::vector<Number> ClosedLoops::drift(const std::vector<Number>& rates, const std::vector<Number>& rates_r,
                                       const std::string& name) const {
  const auto extra = [&](const Loop& loop, std::size_t l) {
    const Vec3 gap = acceleration(loop.ways[1], rates, rates_r) - acceleration(loop.ways[0], rates, rates_r);
    return components(gap, mechanism_.loops[l].rows);
  };
  return completed(std::vector<Number>(at(mechanism_.position_count()), 0), extra, name);
}

std::vector<Number> ClosedLoops::step() const {
  const auto extra = [&](const Loop& loop, std::size_t l) { return components(loop.gap, mechanism_.loops[l].rows); };
  return completed(std::vector<Number>(at(mechanism_.position_count()), 0), extra, "step");
}

// Of the links beyond joint j of a way, and of how far it and joints after it slide.
ClosedLoops::Lengths ClosedLoops::lengths_beyond(const std::vector<Joint>& way, std::size_t j,
                                                 const LoopClosure::End& end) const {
  if (way[j].slides) return {1, 1};  // its column is a unit vector
  Lengths lengths{0, 0};
  const auto add = [&lengths](const Number& square) {
    lengths.squares += square;
    ++lengths.count;
  };
  for (std::size_t i = j; i + 1 < way.size(); ++i) {
    const int next = way[i + 1].body;
    add(dot(frames_.p(next), frames_.p(next)));
    if (way[i + 1].slides) add(frames_.slide(next) * frames_.slide(next));
  }
  add(dot(end.p, end.p));
  return lengths;
}

// Squared, by Hadamard: the lengths of its columns are at most those of the links beyond the joints, one after another,
// and the square of a sum of k lengths at most k times the sum of their squares.
Number ClosedLoops::largest_determinant(std::size_t l) const {
  Number product = 1;
  for (const int k : mechanism_.loops[l].dependent) {
    Lengths column{0, 0};
    for (std::size_t e = 0; e < 2; ++e) {
      const std::vector<Joint>& way = loops_[l].ways[e];
      for (std::size_t j = 0; j < way.size(); ++j) {
        const Number times = factor(way[j].body, at(k));
        if (vanishes(times)) continue;
        const Lengths beyond = lengths_beyond(way, j, mechanism_.loops[l].ends[e]);
        column.squares += times * times * beyond.squares;
        column.count += beyond.count;
      }
    }
    product *= d_.named(column.count * column.squares, entry_name("reach_l" + label(static_cast<int>(l)), at(k)));
  }
  return product;
}

std::vector<ClosedLoops::Condition> ClosedLoops::conditions() const {
  const Number trifle = Number(1) / 1000000;
  std::vector<Condition> result;
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    const std::string name = "l" + label(static_cast<int>(l));
    const Number& det = loops_[l].determinant;
    const Number least = d_.named(trifle * trifle * largest_determinant(l), "least_" + name);
    const Number measure = d_.named(d_.named(det * det, "det2_" + name) - least, "regular_" + name);
    NodeId reciprocal = d_.node(loops_[l].reciprocal);
    if (d_.graph().is_scaled(reciprocal)) reciprocal = d_.graph()[reciprocal].terms.front().node;  // what sums refer to
    result.push_back({reciprocal, d_.node(measure)});
  }
  return result;
}

}  // namespace flatdyn
