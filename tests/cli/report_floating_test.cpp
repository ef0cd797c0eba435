// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn report` of robots with a floating base: the page in a browser shows what `flatdyn eval` computes, its base
// can be dragged, and a robot that is let go falls. The script that moves it is run by Node as well.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <numeric>

#include "cli/report_fixture.hpp"
#include "cli/report_node.hpp"
#include "support/floating_robots.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Types into every field of the base.
constexpr const char* kPlace = R"js(<script>
const type = (id, value) => {
  const field = document.getElementById(id);
  field.value = value;
  field.dispatchEvent(new Event('input'));
};
document.querySelectorAll('#base-fields input').forEach((field, k) => type(field.id, 0.8 * Math.sin(2 + 5 * k)));
</script>)js";

// Its state, its values, and what it says of itself.
constexpr const char* kReadBase = R"js(<script>
const shown = (prefix) => [...document.querySelectorAll(`[id^="${prefix}"][data-value]`)].map((cell) => Number(cell.dataset.value));
const list = (id, key) => document.getElementById(id).dataset[key]?.split(' ').map(Number) ?? null;
const base = () => [...document.querySelectorAll('#base-fields input')].map((field) => Number(field.value));
const read = () => ({
  csv: document.getElementById('csv').value, tau: shown('tau-'), g: shown('g-'), B: shown('B-'), base: base(),
  centre: list('momenta', 'centre'), momentum: list('momenta', 'momentum'), turning: list('momenta', 'turning'),
  time: list('fall-text', 'time'), fallen: list('fall-text', 'fallen'), energy: list('fall-text', 'energy'),
  lost: [...(list('fall-text', 'momentum') ?? []), ...(list('fall-text', 'turning') ?? [])],
  labels: [...document.querySelectorAll('#forces th, .matrix tbody th')].map((cell) => cell.textContent),
  trails: document.querySelectorAll('.trail').length,
});
</script>)js";

// Frames come by the clock of the page, however busy the computer is.
constexpr const char* kFrames = R"js(<script>
window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);
window.cancelAnimationFrame = clearTimeout;
</script>)js";

constexpr const char* kLetGo = R"js(<script>
document.getElementById('fall').click();
var later = 600, stopper = 'fall';
</script>)js";

class FloatingReport : public Report {
 protected:
  // The same robot as a file: without friction, it keeps its energy.
  std::string satellite(bool friction) const {
    std::string text = kSatellite;
    for (const std::string line : {"viscous = 0.3\n", "coulomb = 0.2\n"}) {
      if (!friction) text.erase(text.find(line), line.size());
    }
    folder_.write("satellite.toml", text);
    return folder_.path("satellite.toml");
  }

  // The page's report of itself once the robot has flown for a while.
  json told_after_flight(std::string text, const std::string& before = "") const {
    text.insert(text.find("<head>") + 6, kFrames);
    return told_by(text, before + kReadBase + kLetGo + kCheck);
  }

  void expect_what_eval_computes(const std::string& robot, const json& shown) const {
    const std::string csv = shown.at("csv");
    expect_near(shown.at("tau"), evaluated(robot, "inverse_dynamics", csv), "force");
    expect_near(shown.at("g"), evaluated(robot, "gravity", csv), "gravity");
    expect_momenta(evaluated(robot, "centroidal_momentum_matrix", csv), velocities(csv), shown);
  }

  // The entries of v in a state as CSV.
  static std::vector<double> velocities(const std::string& csv) {
    std::istringstream names(csv), values(csv.substr(csv.find('\n') + 1));
    std::vector<double> v;
    bool is_of_v = false;
    for (std::string name, value; std::getline(names, name, ',') && std::getline(values, value, ',');) {
      is_of_v = (is_of_v || name == "base_vx") && name != "base_dvx";
      if (is_of_v) v.push_back(std::stod(value));
    }
    return v;
  }

  // In world axes momenta have the lengths that they have in base axes.
  static void expect_momenta(const std::vector<double>& A_G, const std::vector<double>& v, const json& shown) {
    ASSERT_EQ(A_G.size(), 6 * v.size());
    double squares[2] = {0, 0};
    for (std::size_t row = 0; row < 6; ++row) {
      double entry = 0;
      for (std::size_t k = 0; k < v.size(); ++k) entry += A_G[row * v.size() + k] * v[k];
      squares[row / 3] += entry * entry;
    }
    expect_near({length_of(shown.at("momentum")), length_of(shown.at("turning"))},
                {std::sqrt(squares[0]), std::sqrt(squares[1])}, "momentum");
  }

  static double length_of(const std::vector<double>& x) {
    return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
  }
};

TEST_F(FloatingReport, ShowsWhatEvalComputes) {
  const std::string robot = satellite(true);
  const json shown = told_by(page(robot), std::string(kMove) + kPlace + kReadBase + kCheck);
  EXPECT_EQ(shown.at("troubles"), json::array());
  for (const char* count : {"unnamed", "pictures", "ids", "heads"}) EXPECT_EQ(shown.at(count), 0) << count;
  EXPECT_EQ(shown.at("trouble"), "");
  expect_what_eval_computes(robot, shown);
  expect_near(shown.at("B"), evaluated(robot, "inertia_matrix", shown.at("csv")), "B");
  EXPECT_EQ(shown.at("labels"), json({"base fx", "base fy", "base fz", "base nx", "base ny", "base nz", "fx", "fy",
                                      "fz", "nx", "ny", "nz", "1", "2", "3"}));
}

// Gravity is given in world axes, and the base turns: g_b in the CSV is Rᵀ g_0.
TEST_F(FloatingReport, IsDraggedAndReset) {
  const std::string use = R"js(<script>
const view = document.getElementById('view');
view.setPointerCapture = () => {};  // the browser knows no such pointer
const drag = (dx, dy, how) => {
  for (const [kind, x, y] of [['pointerdown', 100, 100], ['pointermove', 100 + dx, 100 + dy], ['pointerup', 100 + dx, 100 + dy]]) {
    view.dispatchEvent(new PointerEvent(kind, {clientX: x, clientY: y, pointerId: 1, ...how}));
  }
  return base();
};
const key = (name, how) => {
  view.dispatchEvent(new KeyboardEvent('keydown', {key: name, cancelable: true, ...how}));
  return base();
};
const press = (id) => { document.getElementById(id).click(); return base(); };
const choose = (how) => document.querySelector(`input[name=drag][value=${how}]`).click();
const used = {view: drag(40, 10), moved: drag(40, 0, {shiftKey: true}), turned: drag(0, 50, {ctrlKey: true}), cleared: press('base-reset')};
choose('move');
Object.assign(used, {up: key('ArrowUp'), far: key('PageUp'), shifted: drag(10, 0)});
choose('turn');
Object.assign(used, {rolled: key('PageDown'), again: press('base-reset')});
</script>)js";
  const json seen = told_by(page(satellite(true)), std::string(kReadBase) + use + kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  const auto part = [&seen](const char* name, std::size_t begin, std::size_t end) {
    const std::vector<double> base = seen.at(name);
    return std::vector<double>(base.begin() + static_cast<std::ptrdiff_t>(begin),
                               base.begin() + static_cast<std::ptrdiff_t>(end));
  };
  const std::vector<double> upright = {1, 0, 0, 0};
  for (const char* still : {"view", "cleared", "again"}) {
    EXPECT_EQ(length_of(part(still, 0, 3)), 0) << still;
    EXPECT_EQ(part(still, 3, 7), upright) << still;
  }
  EXPECT_GT(length_of(part("moved", 0, 3)), 0.01);
  EXPECT_EQ(part("moved", 3, 7), upright);
  EXPECT_EQ(part("turned", 0, 3), part("moved", 0, 3));
  EXPECT_NEAR(part("turned", 3, 4)[0], std::cos(0.25), 1e-4);  // a hundredth of a radian per pixel
  EXPECT_GT(part("up", 2, 3)[0], 0.01);
  EXPECT_NE(part("far", 0, 3), part("up", 0, 3));
  EXPECT_NE(part("shifted", 0, 3), part("far", 0, 3));
  EXPECT_NEAR(part("rolled", 3, 4)[0], std::cos(0.05), 1e-4);
}

TEST_F(FloatingReport, FallsFromRest) {
  const std::string robot = satellite(true);
  const json seen = told_after_flight(page(robot));
  EXPECT_EQ(seen.at("troubles"), json::array());
  const double t = seen.at("time")[0];
  EXPECT_GT(t, 0);
  EXPECT_NEAR(seen.at("fallen")[0].get<double>(), 9.81 * t * t / 2, 1e-9);
  EXPECT_NEAR(seen.at("energy")[0].get<double>(), 0, 1e-9);
  EXPECT_EQ(seen.at("trails"), 1);
  for (const double lost : seen.at("lost").get<std::vector<double>>()) EXPECT_NEAR(lost, 0, 1e-9);
  for (const double force : seen.at("tau").get<std::vector<double>>()) EXPECT_NEAR(force, 0, 1e-9);
  expect_what_eval_computes(robot, seen);
}

// A drone has no joints; a robot in orbit no weight.
TEST_F(FloatingReport, ShowsASingleBodyInOrbit) {
  folder_.write("drone.toml", kDrone);
  const json seen = told_after_flight(page(folder_.path("drone.toml") + " --gravity off"), kPlace);
  EXPECT_EQ(seen.at("troubles"), json::array());
  EXPECT_GT(seen.at("time")[0].get<double>(), 0);
  EXPECT_THAT(seen.at("csv").get<std::string>(), Not(HasSubstr("base_gx")));
  EXPECT_NEAR(seen.at("energy")[0].get<double>(), 0, 1e-9);
  for (const double lost : seen.at("lost").get<std::vector<double>>()) EXPECT_NEAR(lost, 0, 1e-9);
}

// The arm's ball joint is thrown, too.
TEST_F(FloatingReport, ShowsASphericalJointAndLetsItGo) {
  const std::string robot = "docs/examples/free_arm.toml", text = page(robot);
  const json shown = told_by(text, std::string(kMove) + kPlace + kReadBase + kCheck);
  for (const char* count : {"unnamed", "pictures", "ids", "heads"}) EXPECT_EQ(shown.at(count), 0) << count;
  EXPECT_EQ(shown.at("names"), json({"hinge", "ball.wx", "ball.wy", "ball.wz", "slide", "thumb"}));
  expect_what_eval_computes(robot, shown);
  const json seen = told_after_flight(text, kMove);
  for (const json& each : {shown, seen}) EXPECT_EQ(each.at("troubles"), json::array());
  EXPECT_GT(seen.at("time")[0].get<double>(), 0);
  EXPECT_NEAR(seen.at("energy")[0].get<double>(), 0, 1e-8);
  for (const double lost : seen.at("lost").get<std::vector<double>>()) EXPECT_NEAR(lost, 0, 1e-8);
  for (const double force : seen.at("tau").get<std::vector<double>>()) EXPECT_NEAR(force, 0, 1e-8);
}

// Nothing is wider than a frame of 360 pixels.
TEST_F(FloatingReport, FitsOnAPhone) {
  const json seen = told_by(page("robots/quadruped12.urdf --base floating"), kCheck,
                            R"html(<iframe src="watched.html" style="width:360px;height:700px;border:0"></iframe>
<script>addEventListener('message', (event) => {
  document.body.insertAdjacentHTML('beforeend', '<pre id="told"></pre>');
  document.getElementById('told').textContent = event.data;
});</script>)html");
  EXPECT_EQ(seen.at("wide"), 0);
  EXPECT_EQ(seen.at("troubles"), json::array());
}

// The page's script of free flight, run by Node with the page's functions.
class Flight : public ReportInNode {
 protected:
  void expect_flies(const std::string& robot, const std::string& script) const {
    expect_passes(robot, kStart + script);
  }

  static constexpr const char* kStart = R"js(
const {state, result, compute, Flight, partsOf, frictionOf} = use('state, result, compute, Flight, partsOf, frictionOf');
const energy = () => result.kinetic + result.potential;
const throwIt = () => {
  state.p.set([0.3, -0.2, 1]);
  state.quaternion.set([0.6, 0, 0.8, 0]);
  state.q.forEach((_, k) => { state.q[k] = 0.3 - 0.2 * k; });
  state.v.forEach((_, k) => { state.v[k] = 1.5 * Math.sin(1 + 4 * k); });
  compute();
};
const fly = (h, duration) => {
  throwIt();
  const flight = new Flight(), start = {energy: energy(), turning: [...result.turning], momentum: [...result.momentum], centre: [...result.centre]};
  for (let k = 0; k < Math.round(duration / h); ++k) flight.step(h);
  flight.show();
  compute();
  const weight = [0, 0, -9.81 * result.mass * duration];
  return {flight, energy: energy() - start.energy, turning: distance([...result.turning], start.turning),
          momentum: distance([...result.momentum], start.momentum.map((x, k) => x + weight[k])),
          centre: distance([...result.centre], start.centre.map((x, k) => x + start.momentum[k] / result.mass * duration + weight[k] / result.mass * duration / 2))};
};
)js";

  // Energy, momenta and the path of the centre of mass, which is a parabola, to the order of the method: the fourth.
  void expect_keeps_energy_and_momenta(const std::string& robot) const {
    expect_flies(robot, R"js(
const [coarse, fine, finest] = [0.02, 0.01, 0.001].map((h) => fly(h, 0.4));
for (const what of ['energy', 'turning', 'momentum', 'centre']) {
  const ratio = Math.abs(coarse[what] / fine[what]);
  assert(Math.abs(coarse[what]) < 1e-3 && Math.abs(finest[what]) < 2e-9, `${what}: ${coarse[what]}, ${finest[what]}`);
  assert((ratio > 11 && ratio < 60) || Math.abs(coarse[what]) < 1e-12, `${what}: ${coarse[what]}, ${fine[what]}`);
}
const {quaternion} = partsOf(finest.flight.y);
assert(Math.abs(Math.hypot(...quaternion) - 1) < 1e-15);
assert(Math.abs(coarse.energy) > 1e-9, 'too smooth a motion to see an order');
)js");
  }
};

std::string without_friction(std::string text) {
  for (const std::string line : {"viscous = 0.3\n", "coulomb = 0.2\n"}) text.erase(text.find(line), line.size());
  return text;
}

TEST_F(Flight, KeepsEnergyAndMomenta) { expect_keeps_energy_and_momenta(without_friction(kSatellite)); }

TEST_F(Flight, KeepsEnergyAndMomentaWithASphericalJoint) {
  expect_keeps_energy_and_momenta(text_of_example("free_arm.toml"));
}

// The same as `flatdyn simulate`, another integrator over the same functions: to many digits without friction, which
// here acts at the end of a step.
TEST_F(Flight, IsWhatSimulateComputes) {
  const auto expect_as_simulated = [this](const std::string& robot, const std::string& q, int n,
                                          const char* tolerance) {
    std::string rates, speeds;
    for (int k = 0; k < n; ++k) (k < 6 ? rates : speeds) += fmt::format("{}, ", 1.5 * std::sin(1 + 4 * k));
    folder_.write("thrown.toml", fmt::format("duration = 0.4\nrate = 10\n[start]\nbase_position = [0.3, -0.2, 1]\n"
                                             "base_orientation = [0.6, 0, 0.8, 0]\nbase_velocity = [{}]\n"
                                             "q = [{}]\nqd = [{}]\n",
                                             rates, q, speeds));
    folder_.write("robot.toml", robot);
    const Outcome outcome =
        run_flatdyn(fmt::format("simulate '{}' -q --simulation '{}' -o '{}'", folder_.path("robot.toml"),
                                folder_.path("thrown.toml"), folder_.path("motion.csv")));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_flies(robot, fmt::format("const tolerance = {};\n", tolerance) + R"js(
const lines = fs.readFileSync('motion.csv', 'utf8').trim().split('\n').map((line) => line.split(','));
const column = (name) => Number(lines.at(-1)[lines[0].indexOf(name)]);
assert.equal(column('t'), 0.4);
fly(1e-3, 0.4);
const near = (x, name) => assert(Math.abs(x - column(name)) < tolerance, `${name}: ${x}, ${column(name)}`);
['x', 'y', 'z'].forEach((axis, k) => { near(state.p[k], `base_${axis}`); near(state.v[k], `base_v${axis}`); near(state.v[3 + k], `base_w${axis}`); });
['w', 'x', 'y', 'z'].forEach((axis, k) => near(state.quaternion[k], `base_q${axis}`));
(state.positions ?? state.q).forEach((x, k) => near(x, `q${k + 1}`));
state.qd.forEach((x, k) => near(x, `qd${k + 7}`));
)js");
  };
  expect_as_simulated(without_friction(kSatellite), "0.3, 0.1, -0.1", 9, "1e-7");
  expect_as_simulated(kSatellite, "0.3, 0.1, -0.1", 9, "1e-4");
  const double angle = std::sqrt(0.11), part = std::sin(angle / 2) / angle;  // of the rotation vector (0.1, -0.1, -0.3)
  expect_as_simulated(
      text_of_example("free_arm.toml"),
      fmt::format("0.3, {}, {}, {}, {}, -0.5, -0.7", std::cos(angle / 2), 0.1 * part, -0.1 * part, -0.3 * part), 12,
      "1e-7");
}

// Friction is found as the robot file has it, takes energy and no momentum, and holds what is at rest.
TEST_F(Flight, HasFrictionThatHolds) {
  expect_flies(kSatellite, R"js(
const rest = (x, y) => assert(Math.abs(x - y) < 1e-12, `${x}, ${y}`);
throwIt();
const friction = frictionOf(state.q);
rest(friction[0].viscous, 0.3);
rest(friction[1].dry, 0.2);
for (const [k, key] of [[0, 'dry'], [1, 'viscous'], [2, 'dry'], [2, 'viscous']]) assert.equal(friction[k][key], 0);
const flown = fly(1e-3, 0.4);
assert(flown.energy < -0.01 && flown.momentum < 1e-8 && flown.turning < 1e-8, JSON.stringify(flown));
const slid = (brakes) => {
  throwIt();
  state.v.fill(0);
  state.v[3] = 0.4;
  compute();
  const flight = new Flight(), q = state.q[1];
  if (!brakes) flight.brake = () => {};
  for (let k = 0; k < 300; ++k) flight.step(1e-3);
  return {speed: partsOf(flight.y).v[7], way: Math.abs(partsOf(flight.y).q[1] - q)};
};
const held = slid(true), free = slid(false);
assert(held.speed === 0 && held.way < 0.01 * free.way && free.way > 1e-3, JSON.stringify([held, free]));
)js");
}

// A stop takes energy, too, and no momentum; the joint stays there.
TEST_F(Flight, EndsAtStops) {
  std::string text = without_friction(kSatellite);
  text.replace(text.find("joint = \"shoulder\""), 18, "joint = \"shoulder\"\nlimits = { lower = -1, upper = 0.4 }");
  expect_flies(text, R"js(
throwIt();
state.v[6] = 3;
compute();
const turning = [...result.turning], before = energy(), flight = new Flight();
for (let k = 0; k < 100; ++k) flight.step(1e-3);
const {q, v} = partsOf(flight.y);
assert(Math.abs(q[0] - 0.4) < 4e-3 && v[6] === 0, `${q[0]}, ${v[6]}`);
flight.show();
compute();
assert(energy() - before < -0.1 && distance([...result.turning], turning) < 1e-8);
)js");
}

// Robots of others, straight from their MJCF; the files lie beside the checkout.
class FloatingReportOfFile : public FloatingReport, public ::testing::WithParamInterface<const char*> {};

TEST_P(FloatingReportOfFile, ShowsWhatEvalComputesAndFalls) {
  const std::filesystem::path file = std::filesystem::path(FLATDYN_SOURCE_DIR) / "../shared/robots/mjcf" / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const std::string robot = file.string(), text = page(robot);
  EXPECT_LT(text.size(), 600'000u);
  const json shown = told_by(text, std::string(kMove) + kPlace + kReadBase + kCheck);
  EXPECT_EQ(shown.at("troubles"), json::array());
  expect_what_eval_computes(robot, shown);
  const json seen = told_after_flight(text);
  const double t = seen.at("time")[0];
  EXPECT_GT(t, 0);
  if (GetParam() != std::string("gym_humanoid.xml")) {  // whose springs move it from the start
    EXPECT_NEAR(seen.at("fallen")[0].get<double>(), 9.81 * t * t / 2, 1e-9);
  }
  for (const double lost : seen.at("lost").get<std::vector<double>>()) EXPECT_NEAR(lost, 0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Files, FloatingReportOfFile, ::testing::Values("go1.xml", "g1_29dof.xml", "gym_humanoid.xml"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace flatdyn::testing
