// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/loop_definitions.hpp"

#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {
namespace {

template <class F>
class LoopDefinition {
 public:
  using Values = std::vector<F>;

  // Both must outlive this object. `q`: the position of every body's joint.
  LoopDefinition(const MechanismOver<F>& mechanism, const std::vector<JointPoint<F>>& q)
      : mechanism_(mechanism), q_(q), geometry_(mechanism, q) {}

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

  // G q̇_a.
  Values rates(const Values& qd) const {
    return times(flatdyn::loop_motion(mechanism_, q_), without_base(mechanism_, qd));
  }

  // d/dt (G q̇_a).
  Values accelerations(const Values& qd, const Values& qdd) const {
    const Matrix<Dual<F>> moved = flatdyn::loop_motion(mechanism_, moving(q_, joint_values(mechanism_, qd)));
    const Values independent = without_base(mechanism_, qd);
    Values result = rates(qdd);
    for (int k = 0; k < moved.rows(); ++k) {
      for (int a = 0; a < moved.cols(); ++a) {
        result[static_cast<std::size_t>(k)] += moved(k, a).derivative * independent[static_cast<std::size_t>(a)];
      }
    }
    return result;
  }

 private:
  Values gap(const FieldLoop<F>& loop) const {
    const Values all = geometry_.gap(loop);
    Values rows;
    for (const std::size_t row : loop.rows) rows.push_back(all[row]);
    return rows;
  }

  const MechanismOver<F>& mechanism_;
  const std::vector<JointPoint<F>>& q_;
  LoopGeometry<F, F> geometry_;
};

template <class Point>
auto loops_at(const Point& point) {
  return LoopDefinition<typename Point::F>(point.lagrangian.mechanism(), point.q);
}

}  // namespace

constinit const Definition loop_closure = defined_as([](auto& at, const Output&) { return loops_at(at).closure(); });

constinit const Definition loop_jacobian = defined_as([](auto& at, const Output&) { return loops_at(at).jacobian(); });

constinit const Definition loop_step = defined_as([](auto& at, const Output&) { return loops_at(at).step(); });

constinit const Definition loop_motion = defined_as([](auto& at, const Output& output) {
  if (output.name == "rates") return loops_at(at).rates(at.qd());
  return loops_at(at).accelerations(at.qd(), at.qdd());
});

}  // namespace flatdyn::definitions
