// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/log_hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "laboratory/identify/gravity_search.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Instant = RowSample::Instant;

constexpr double kDegree = std::numbers::pi / 180;

std::vector<VectorXd> starts_at(const std::vector<double>& values) {
  std::vector<VectorXd> starts;
  for (const double value : values) starts.push_back(VectorXd::Constant(1, value));
  return starts;
}

// Puts further columns behind those that there are.
void add_columns(Instant& t, const MatrixXd& columns) {
  t.Y.conservativeResize(Eigen::NoChange, t.Y.cols() + columns.cols());
  t.Y.rightCols(columns.cols()) = columns;
}

// The sign of a joint's speed as the filter smears it, from the speed at the middle of its window and the acceleration.
double smeared_sign(const Instant& t, int joint) {
  constexpr double kHalfWidth = 0.025;  // s, at a band of 10 Hz
  return std::tanh(t.qd[joint] / std::max(std::abs(t.qdd[joint]) * kHalfWidth, 1e-9));
}

class HypothesisTable {
 public:
  HypothesisTable(const LoadedRobot& robot, const RowSample& sample, FrictionLaw law)
      : robot_(robot), sample_(sample), model_(sample.model()), law_(law) {
    for (int i = 0; i < model_.equations(); ++i) {
      names_.push_back(model_.subject_of(i));
      if (sample.has_rows(i)) with_rows_.push_back(i);
    }
  }

  std::vector<LogHypothesis> all() {
    const Mechanism& mechanism = model_.mechanism();
    const bool has_positions = !mechanism.has_loops() && !mechanism.has_spherical_joints();
    torques();
    if (sample_.has_rates()) delays();
    if (!mechanism.is_coupled() && !mechanism.has_loops()) friction();
    if (has_positions) positions();
    if (has_own_gravity(mechanism)) gravity();
    if (has_positions) offsets();
    if (model_.first_joint() > 0) sensors_of_base();
    return std::move(rows_);
  }

 private:
  using Text = std::function<std::string(const HypothesisFit& fit)>;
  void add(Hypothesis hypothesis, Text text, bool is_gain = false) {
    rows_.push_back({[hypothesis = std::move(hypothesis)] { return best_fit(hypothesis); }, std::move(text), is_gain});
  }
  void add(RowSample::Change change, const std::string& text, bool is_gain = false) {
    const auto always = [text](const HypothesisFit&) { return text; };
    add(changed(std::move(change)), always, is_gain);
  }

  // A change of each instant.
  Hypothesis changed(RowSample::Change change) const {
    return {{}, [sample = &sample_, change = std::move(change)](const VectorXd&) { return sample->rows(change); }};
  }
  // A change of each instant by an unknown between its starts, which are ascending, or little beyond them.
  Hypothesis changed_by(const std::vector<double>& starts, std::function<void(Instant&, double x)> change) const {
    const auto apply = [sample = &sample_, change = std::move(change)](const VectorXd& x) {
      return sample->rows([&](Instant& t) { change(t, x[0]); });
    };
    const double beyond = starts[1] - starts[0];
    return {{{.low = starts.front() - beyond, .high = starts.back() + beyond}}, apply, starts_at(starts)};
  }

  std::string its_readings(int i) const { return fmt::format("{}: its {}", name(i), readings(i)); }
  const char* readings(int i) const { return is_of_base(i) ? "readings" : "torques"; }
  bool is_of_base(int i) const { return i < model_.first_joint(); }
  const std::string& name(int i) const { return names_[static_cast<std::size_t>(i)]; }
  // The name of a joint that is counted from 0, without a floating base.
  const std::string& joint_name(int joint) const { return name(model_.first_joint() + joint); }

  void torques() {
    for (const int i : with_rows_) {
      add([i](Instant& t) { t.tau[i] *= -1; }, its_readings(i) + " look as if their sign were reversed", true);
    }
    for (const int i : with_rows_) {
      for (const int k : with_rows_) {
        if (k <= i || is_of_base(i) != is_of_base(k)) continue;
        add([i, k](Instant& t) { std::swap(t.tau[i], t.tau[k]); },
            fmt::format("{} and {}: their {} look exchanged", name(i), name(k), readings(i)));
      }
    }
    for (const int i : with_rows_) {
      constant(i);
      gain(i);
    }
    const int of_base = model_.first_joint();
    if (of_base == 0 || !sample_.has_rows(0)) return;
    add([of_base](Instant& t) { t.tau.head(of_base) *= -1; },
        "the force on the base, and its moment, look as if their signs were reversed: they are what something "
        "exerts on the base, the weight of a robot that hangs still upwards");
  }

  // Torques with a constant added, which is one more parameter.
  void constant(int i) {
    const auto add_one = [i](Instant& t) { add_columns(t, VectorXd::Unit(t.Y.rows(), i)); };
    const char* const hint = is_of_base(i) ? "" : " (--offsets estimates it)";
    add(changed(add_one), [its = its_readings(i), unit = model_.unit_of(i), hint](const HypothesisFit& fit) {
      const double value = fit.pi.tail<1>()[0];
      return fmt::format("{} look as if {:.3g} {} were added to all of them{}", its, value, unit, hint);
    });
  }

  // Torques that are some times the right ones, whose logarithm is unknown; noise is not part of the gain.
  void gain(int i) {
    std::vector<double> powers;  // up to 10^4
    for (int k = -13; k <= 13; ++k) powers.push_back(k * std::numbers::ln2);
    const auto multiply = [i](Instant& t, double x) { t.Y.row(i) *= std::exp(x); };
    const auto text = [its = its_readings(i)](const HypothesisFit& fit) {
      const double x = fit.x[0];
      return fmt::format("{} look {:.3g} times too {}", its, std::exp(std::abs(x)), x > 0 ? "large" : "small");
    };
    add(changed_by(powers, multiply), text, true);
  }

  void delays() {
    const auto size = [](const HypothesisFit& fit) { return fmt::format("{:.2g} ms", 1000 * std::abs(fit.x[0])); };
    const auto side = [](bool is_late) { return is_late ? "late" : "early"; };
    add(delay_hypothesis(sample_, 0, model_.equations()), [=](const HypothesisFit& fit) {
      return fmt::format("all torques look {} {} (--delay estimates it)", size(fit), side(fit.x[0] > 0));
    });
    for (const int i : with_rows_) {
      if (names_.size() == 1) break;
      const char* const motion = is_of_base(i) ? "the base's motion" : "its positions";
      add(delay_hypothesis(sample_, i, i + 1), [=, its = its_readings(i)](const HypothesisFit& fit) {
        const bool is_late = fit.x[0] > 0;
        return fmt::format("{} look {} {}, or {} {}", its, size(fit), side(is_late), motion, side(!is_late));
      });
    }
  }

  // Friction and rotors that the model lacks, or friction that is larger near rest or with a load.
  void friction() {
    std::vector<int> without, with;
    const std::vector<int>& columns = model_.base().columns;
    for (int i = model_.first_joint(); i < model_.equations(); ++i) {
      const auto has = [&](Parameter each) {
        return std::find(columns.begin(), columns.end(), index_of(i, each)) != columns.end();
      };
      (has(Parameter::Fs) && has(Parameter::Fv) ? with : without).push_back(i);
    }
    const auto lacking = [without](Instant& t) {
      for (const int i : without) {
        const Eigen::RowVector3d row(t.qd[i], smeared_sign(t, i), t.qdd[i]);
        add_columns(t, VectorXd::Unit(t.Y.rows(), i) * row);
      }
    };
    if (!without.empty()) add(lacking, "friction, perhaps rotors, look left out (--parameters full estimates them)");
    if (with.empty()) return;
    if (law_ != FrictionLaw::stribeck) friction_near_rest(with);
    if (law_ != FrictionLaw::load) friction_of_loads(with);
  }

  // Friction that is larger below a speed, a share of each joint's largest one, whose logarithm is unknown.
  void friction_near_rest(const std::vector<int>& joints) {
    VectorXd fastest = VectorXd::Constant(model_.equations(), 1e-9);
    for (const Instant& t : sample_.instants()) fastest = fastest.cwiseMax(t.qd.cwiseAbs());
    std::vector<double> shares;
    for (double share = 0.01; share < 1; share *= 2) shares.push_back(std::log(share));
    const auto near_rest = [=](Instant& t, double x) {
      for (const int i : joints) {
        const double part = t.qd[i] / (std::exp(x) * fastest[i]);
        add_columns(t, std::exp(-part * part) * smeared_sign(t, i) * VectorXd::Unit(t.Y.rows(), i));
      }
    };
    add(changed_by(shares, near_rest), [](const HypothesisFit&) {
      return "friction looks larger near rest (--friction stribeck estimates by how much)";
    });
  }

  // Friction that grows with what a drive carries: the measured torque less the friction of the fit.
  void friction_of_loads(const std::vector<int>& joints) {
    const auto with_loads = [joints, &model = model_, pi = fit_of(sample_.rows()).pi](Instant& t) {
      const std::vector<int>& columns = model.base().columns;
      VectorXd carried = t.tau;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const auto column = static_cast<Index>(k);
        const Parameter kind = parameter_of(columns[k]);
        if (kind == Parameter::Fv || kind == Parameter::Fs) carried -= pi[column] * t.Y.col(column);
      }
      for (const int i : joints) {
        add_columns(t, std::abs(carried[i]) * smeared_sign(t, i) * VectorXd::Unit(t.Y.rows(), i));
      }
    };
    const auto count = static_cast<Index>(joints.size());
    rows_.push_back({[hypothesis = changed(with_loads), count] {
                       HypothesisFit fit = best_fit(hypothesis);
                       if (fit.pi.tail(count).maxCoeff() <= 0) fit.cost = std::numeric_limits<double>::infinity();
                       return fit;
                     },
                     [](const HypothesisFit&) {
                       return "friction looks larger where drives carry more (--friction load estimates by how much)";
                     }});
  }

  // Another motion of the joints: q, q̇, q̈ and friction changed alike.
  template <class Map>
  RowSample::Change moved(Map map) const {
    return [sample = &sample_, map](Instant& t) {
      for (VectorXd* each : t.motion()) map(each->tail(sample->model().joints()));
      sample->follow_motion(t);
    };
  }

  void positions() {
    const int n = model_.joints(), first = model_.first_joint();
    using OfJoints = Eigen::Ref<VectorXd>;
    for (int i = 0; i < n; ++i) {
      add(moved([i](OfJoints q) { q[i] = -q[i]; }),
          joint_name(i) + ": its positions look as if their sign were reversed");
    }
    for (const bool are_torques_too : {false, true}) {
      for (int i = 0; i < n; ++i) {
        for (int k = i + 1; k < n; ++k) {
          const RowSample::Change exchanged = moved([i, k](OfJoints q) { std::swap(q[i], q[k]); });
          const auto with_torques = [=](Instant& t) {
            exchanged(t);
            std::swap(t.tau[first + i], t.tau[first + k]);
            std::swap(t.weights[first + i], t.weights[first + k]);
          };
          const std::string both = joint_name(i) + " and " + joint_name(k);
          if (are_torques_too) {
            add(with_torques, both + " look exchanged: the positions and the torques of both");
          } else {
            add(exchanged, both + ": their positions look exchanged");
          }
        }
      }
    }
  }

  void gravity() {
    constexpr double kLeast = kDegree;  // a smaller angle is chance, or the fault of something else
    const auto direction = [&robot = robot_, &sample = sample_] {
      const GravityFit fit = gravity_direction(robot, sample);
      const double cost = fit.angle < kLeast ? std::numeric_limits<double>::infinity() : fit.cost;
      return HypothesisFit{cost, {}, {}, Eigen::Vector4d(fit.gravity.x(), fit.gravity.y(), fit.gravity.z(), fit.angle)};
    };
    rows_.push_back({direction, [](const HypothesisFit& fit) {
                       return fmt::format(
                           "gravity looks as if it came from another direction: [{:.3g}, {:.3g}, {:.3g}] m/s^2 in the "
                           "base frame, {:.3g} degrees from the robot file's (--gravity-direction estimates it)",
                           fit.x[0], fit.x[1], fit.x[2], fit.x[3] / kDegree);
                     }});
  }

  // The zero of each hinge, anywhere around.
  void offsets() {
    std::vector<double> around;
    for (int step = -11; step <= 12; ++step) around.push_back(15 * step * kDegree);
    for (int i = 0; i < model_.joints(); ++i) {
      if (model_.mechanism().joints()[static_cast<std::size_t>(i)].prismatic) continue;
      const auto turned = [i, &sample = sample_](Instant& t, double offset) {
        t.q[i] += offset;
        sample.follow_motion(t);
      };
      add(changed_by(around, turned), [name = joint_name(i)](const HypothesisFit& fit) {
        return fmt::format("{}: its zero looks {:.3g} degrees off: as if {:.4g} rad were missing in its positions",
                           name, std::abs(fit.x[0]) / kDegree, fit.x[0]);
      });
    }
  }

  // The sensors of a floating base may have the other sign: an accelerometer that shows gravity instead of what
  // holds against it, or a gyroscope that turns the other way.
  void sensors_of_base() {
    constexpr int kTurns = 3;
    add(
        [&sample = sample_](Instant& t) {
          t.qdd.head(kTurns) *= -1;
          sample.follow_motion(t);
        },
        "the base's specific force looks as if its sign were reversed: at rest an accelerometer shows 9.81 m/s^2 "
        "upwards, and gravity in base axes points down");
    add(
        [&sample = sample_](Instant& t) {
          for (VectorXd* each : {&t.qd, &t.qdd}) each->segment(kTurns, kTurns) *= -1;
          sample.follow_motion(t);
        },
        "the base's angular velocity looks as if its sign were reversed");
  }

  const LoadedRobot& robot_;
  const RowSample& sample_;
  const TorqueModel& model_;
  FrictionLaw law_;
  std::vector<std::string> names_;  // by equation
  std::vector<int> with_rows_;      // equations
  std::vector<LogHypothesis> rows_;
};

}  // namespace

std::vector<LogHypothesis> log_hypotheses(const LoadedRobot& robot, const RowSample& sample, FrictionLaw law) {
  return HypothesisTable(robot, sample, law).all();
}

Hypothesis delay_hypothesis(const RowSample& sample, int first, int end) {
  constexpr double kLeastRows = 0.5;
  const auto apply = [&sample, first, end](const VectorXd& x) {
    double rows_left = 0;
    WeightedEquations rows = sample.rows([&](Instant& t) {
      sample.undo_delay(t, x[0], first, end);
      rows_left += static_cast<double>((t.weights.array() > 0).count());
    });
    const double share = rows_left / sample.count();
    if (share < kLeastRows) return sample.rows();
    return WeightedEquations{rows.A / std::sqrt(share), rows.b / std::sqrt(share)};
  };
  // The torques change more slowly than from one start, s, to the next.
  return {{{.step = 1e-7}}, apply, starts_at({0.003, -0.003, 0.023, -0.023, 0.053, -0.053, 0.093, -0.093})};
}

bool has_own_gravity(const Mechanism& mechanism) { return !mechanism.has_loops() && !mechanism.has_quasi_velocities(); }

}  // namespace flatdyn
