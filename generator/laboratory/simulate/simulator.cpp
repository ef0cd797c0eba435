// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/simulate/simulator.hpp"

#include <fmt/format.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>

namespace flatdyn {
namespace {

namespace odeint = boost::numeric::odeint;

// The number of places within a step at which an event is looked for, since it may come and go.
constexpr int kProbes = 4;
// The largest number of events at one instant.
constexpr int kMostEventsAtOnce = 1000;
// The speed, rad/s or m/s, at which a simulation fails: no arm is so fast, and a control law must have made it
// unstable.
constexpr double kFastest = 1e5;

class Simulator {
 public:
  Simulator(const Simulation& simulation, JointDynamics& dynamics, const std::function<bool(double)>& interrupted)
      : simulation_(simulation),
        equation_(simulation, dynamics),
        interrupted_(interrupted),
        x_(equation_.initial_state()) {}

  SimulatedMotion run() {
    equation_.start_law(x_, 0);
    equation_.decide(x_, 0, motion_.events);
    motion_.events.clear();  // joints at rest at the start have not come to rest
    add_rows_until(0, [this](double) -> const MotionState& { return x_; });
    if (simulation_.method == IntegrationMethod::rk4) {
      in_even_steps();
    } else {
      in_free_steps();
    }
    if (motion_.rows.back().time < t_ * (1 - 1e-12)) motion_.rows.push_back(row(x_, t_));
    motion_.end = t_;
    motion_.evaluations = equation_.evaluations();
    return std::move(motion_);
  }

 private:
  bool is_over() const { return t_ >= simulation_.duration || motion_.at_limit || motion_.interrupted; }

  void in_free_steps() {
    double step = 1e-3;
    while (!is_over()) {
      const double end = std::min(simulation_.duration, equation_.next_knot(t_));
      step = until_event_or(end, step);
      if (t_ < end || is_over()) continue;
      equation_.start_law(x_, t_);
      if (equation_.margin(x_, t_) < 0) meet_event();
    }
  }

  // Integrates until an event or `end`. Returns the length of the next step.
  double until_event_or(double end, double step) {
    auto stepper = odeint::make_dense_output(simulation_.tolerance, simulation_.tolerance,
                                             odeint::runge_kutta_dopri5<MotionState>());
    stepper.initialize(x_, t_, std::min(step, end - t_));
    while (t_ < end) {
      const auto [from, to] = one_step(stepper);
      ++motion_.steps;
      const auto state_at = [&stepper, this](double t) -> const MotionState& {
        stepper.calc_state(t, between_);
        return between_;
      };
      const double event = first_event(from, to, state_at);
      add_rows_until(std::min(event, to), state_at);
      if (event <= to) {
        x_ = state_at(event);
        t_ = event;
        meet_event();
        return stepper.current_time_step();
      }
      x_ = stepper.current_state();
      t_ = to;
      require_finite();
      motion_.interrupted = interrupted_(t_);
      if (motion_.interrupted) return 0;
      // The step ends at a knot, where a torque may bend; a remainder within rounding is no step.
      if (end - t_ <= 1e-13 * end) t_ = end;
      const double next = stepper.current_time_step();
      const bool is_rescaled = equation_.rescale_orientations(x_), is_last = t_ + next > end;
      if (t_ < end && (is_rescaled || is_last)) stepper.initialize(x_, t_, is_last ? end - t_ : next);
      if (t_ >= end) return next;
    }
    return step;
  }

  template <class Stepper>
  std::pair<double, double> one_step(Stepper& stepper) {
    try {
      return stepper.do_step(std::ref(equation_));
    } catch (const odeint::odeint_error&) {
      refuse("no step is short enough for the tolerance");
    }
  }

  // The time just after the first event in the interval, so that it has happened; infinity if there is none.
  template <class StateAt>
  double first_event(double from, double to, const StateAt& state_at) {
    if (!has_events_) return std::numeric_limits<double>::infinity();
    const auto margin = [&](double t) { return equation_.margin(state_at(t), t); };
    double before = from;
    for (int k = 1; k <= kProbes; ++k) {
      const double probe = k == kProbes ? to : from + (to - from) * k / kProbes;
      if (!(margin(probe) < 0)) {
        before = probe;
        continue;
      }
      if (!(margin(before) > 0)) return before;
      std::uintmax_t most = 100;
      return boost::math::tools::toms748_solve(margin, before, probe, boost::math::tools::eps_tolerance<double>(50),
                                               most)
          .second;
    }
    return std::numeric_limits<double>::infinity();
  }

  void meet_event() {
    events_at_once_ = t_ > last_event_ ? 1 : events_at_once_ + 1;
    last_event_ = t_;
    if (events_at_once_ > kMostEventsAtOnce) refuse("joints come to rest and break away without end");
    motion_.at_limit = equation_.meet_event(x_, t_, motion_.events);
  }

  // Constant steps: an event is handled at the end of its step.
  void in_even_steps() {
    const double row = 1 / simulation_.rate;
    const auto per_row = static_cast<long>(std::ceil(row / simulation_.step * (1 - 1e-12)));
    const double step = row / static_cast<double>(per_row);
    odeint::runge_kutta4<MotionState> stepper;
    double knot = equation_.next_knot(0);
    for (long k = 1; !is_over(); ++k) {
      stepper.do_step(std::ref(equation_), x_, t_, step);
      equation_.rescale_orientations(x_);
      t_ = static_cast<double>(k) * step;
      ++motion_.steps;
      require_finite();
      // A knot is met to within half a step.
      if (t_ + step / 2 >= knot) {
        equation_.start_law(x_, t_);
        knot = equation_.next_knot(t_ + step / 2);
      }
      if (equation_.margin(x_, t_) < 0) meet_event();
      add_rows_until(t_ + step / 2, [this](double) -> const MotionState& { return x_; });
      motion_.interrupted = interrupted_(t_);
    }
  }

  void require_finite() const {
    for (const double x : x_) {
      if (!std::isfinite(x)) refuse("positions or speeds are no numbers any more");
    }
    const std::size_t n = equation_.contacts().size();
    for (std::size_t i = 0; i < n; ++i) {
      if (std::abs(x_[n + i]) > kFastest) refuse(fmt::format("a joint is faster than {:g} rad/s or m/s", kFastest));
    }
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw Failure(FailureKind::input, fmt::format("the motion cannot be followed beyond t = {} s: {}", t_, what),
                  "look at torques and gains, and at joints whose inertia is nearly zero");
  }

  template <class StateAt>
  void add_rows_until(double t, const StateAt& state_at) {
    for (;;) {
      const double time = static_cast<double>(motion_.rows.size()) / simulation_.rate;
      if (time > std::min(t, simulation_.duration * (1 + 1e-12))) return;
      motion_.rows.push_back(row(state_at(time), time));
    }
  }

  SimulationRow row(const MotionState& x, double t) {
    const ContactMotion now = equation_.motion(x, t);
    const Eigen::Index n = now.qdd.size();
    const Eigen::Map<const Eigen::VectorXd> qd(x.data() + n, n);
    const auto energies = static_cast<std::size_t>(2 * n);
    SimulationRow result{t,
                         equation_.positions(x),
                         qd,
                         now.qdd,
                         equation_.tau(),
                         now.lambda - equation_.smooth_friction(qd),
                         equation_.kinetic_energy(x),
                         equation_.potential_energy(x),
                         x[energies],
                         x[energies + 1]};
    if (equation_.has_base()) {
      result.base = {equation_.pose(x), equation_.momentum(x), equation_.impulse(x), equation_.base_gravity(x)};
    }
    return result;
  }

  const Simulation& simulation_;
  MotionEquation equation_;
  const std::function<bool(double)>& interrupted_;
  bool has_events_ = equation_.has_events();
  MotionState x_, between_ = x_;
  double t_ = 0, last_event_ = -1;
  int events_at_once_ = 0;
  SimulatedMotion motion_;
};

}  // namespace

Momentum momentum_error(const SimulatedMotion& motion) {
  const auto left = [](const SimulationRow& row) {
    const BaseRow& base = *row.base;
    return Momentum{base.momentum.linear - base.impulse.linear, base.momentum.angular - base.impulse.angular};
  };
  Momentum largest;
  for (const SimulationRow& row : motion.rows) {
    const Momentum here = left(row), first = left(motion.rows.front());
    largest.linear = largest.linear.cwiseMax((here.linear - first.linear).cwiseAbs());
    largest.angular = largest.angular.cwiseMax((here.angular - first.angular).cwiseAbs());
  }
  return largest;
}

double energy_error(const SimulatedMotion& motion) {
  const auto sum = [](const SimulationRow& row) { return row.kinetic + row.potential - row.work + row.dissipated; };
  double largest = 0;
  for (const SimulationRow& row : motion.rows) {
    largest = std::max(largest, std::abs(sum(row) - sum(motion.rows.front())));
  }
  return largest;
}

SimulatedMotion simulate(const Simulation& simulation, JointDynamics& dynamics,
                         const std::function<bool(double)>& interrupted) {
  return Simulator(simulation, dynamics, interrupted).run();
}

}  // namespace flatdyn
