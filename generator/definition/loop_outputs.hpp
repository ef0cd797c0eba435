// SPDX-License-Identifier: GPL-2.0-or-later
// The values of the functions of closed loops by their definition, at one point of a field.
#pragma once

#include <string>
#include <vector>

#include "model/field_loops.hpp"

namespace flatdyn {

template <class F>
class LoopOutputs {
 public:
  using Values = std::vector<F>;

  // Both must outlive this object. `q`: the position of every body's joint.
  LoopOutputs(const MechanismOver<F>& mechanism, const std::vector<JointPoint<F>>& q)
      : mechanism_(mechanism), q_(q), geometry_(mechanism, q) {}

  Values entries(const std::string& output, const Values& qd, const Values& qdd) const {
    if (output == "phi") return closure();
    if (output == "phi_q") return jacobian();
    if (output == "dq") return step();
    const Matrix<F> G = loop_motion(mechanism_, q_);
    if (output == "rates") return times(G, qd);
    return accelerations(G, qd, qdd);
  }

 private:
  Values gap(const FieldLoop<F>& loop) const {
    const Values all = geometry_.gap(loop);
    Values rows;
    for (const std::size_t row : loop.rows) rows.push_back(all[row]);
    return rows;
  }

  Values closure() const {
    Values all;
    for (const FieldLoop<F>& loop : mechanism_.loops) {
      const Values rows = gap(loop);
      all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
  }

  Values jacobian() const {
    Values all;
    for (const FieldLoop<F>& loop : mechanism_.loops) {
      const Matrix<F> J = geometry_.rows(loop);
      all.insert(all.end(), J.entries().begin(), J.entries().end());
    }
    return all;
  }

  // The step dq of each loop, from Φ_q dq + Φ = 0.
  Values step() const {
    Values dq(static_cast<std::size_t>(mechanism_.position_count()), F(0));
    for (const FieldLoop<F>& loop : mechanism_.loops) {
      const Matrix<F> J = geometry_.rows(loop), own = columns_of(J, loop.dependent);
      const Values moved = times(J, dq), open = gap(loop);
      Values wanted;
      for (std::size_t row = 0; row < open.size(); ++row) wanted.push_back(-(moved[row] + open[row]));
      const Values found = solved(own, wanted);
      for (std::size_t d = 0; d < found.size(); ++d) dq[static_cast<std::size_t>(loop.dependent[d])] = found[d];
    }
    return dq;
  }

  // d/dt (G q̇).
  Values accelerations(const Matrix<F>& G, const Values& qd, const Values& qdd) const {
    const Matrix<Dual<F>> moved = loop_motion(mechanism_, moving(q_, joint_values(mechanism_, qd)));
    Values result = times(G, qdd);
    for (int k = 0; k < moved.rows(); ++k) {
      for (int a = 0; a < moved.cols(); ++a) {
        result[static_cast<std::size_t>(k)] += moved(k, a).derivative * qd[static_cast<std::size_t>(a)];
      }
    }
    return result;
  }

  const MechanismOver<F>& mechanism_;
  const std::vector<JointPoint<F>>& q_;
  LoopGeometry<F, F> geometry_;
};

}  // namespace flatdyn
