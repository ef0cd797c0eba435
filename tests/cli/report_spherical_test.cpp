// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn report` of robots with spherical joints: their sliders, quaternions and drawing in a browser, and the page's
// scripts run by Node. What their pages compute is compared with `flatdyn eval` where those of other robots are.
#include <gmock/gmock.h>

#include <cmath>

#include "cli/report_fixture.hpp"
#include "cli/report_node.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kWrist = "docs/examples/ball_wrist.toml";

// Reads what the page shows of the wrist.
constexpr const char* kReadBall = R"js(<script>
const set = (field, value) => {
  field.value = value;
  field.dispatchEvent(new Event('input'));
  return look();
};
const row = (lines, name) => { const [names, cells] = lines.split('\n').map((line) => line.split(',')); return Number(cells[names.indexOf(name)]); };
const look = () => {
  const csv = document.getElementById('csv').value, columns = (key, from, to) => Array.from({length: to - from + 1}, (_, k) => row(csv, `${key}${from + k}`));
  return {
    csv, q: columns('q', 3, 6), w: columns('qd', 3, 5), a: columns('qdd', 3, 5),
    fields: [...document.querySelectorAll('.quaternion input')].map((field) => Number(field.value)),
    turns: [2, 3, 4].map((k) => Number(document.getElementById(`number-${k}`).value)),
    labels: [...document.querySelectorAll('.slider label')].map((label) => label.textContent),
    tau: [...document.querySelectorAll('[id^="tau-"]')].map((cell) => Number(cell.dataset.value)),
    thick: [...document.querySelectorAll('.ball-axes .turning')].map((line) => line.getAttribute('class')),
  };
};
</script>)js";

class SphericalReport : public Report {
 protected:
  // How far q is from the turn by a rotation vector.
  static double off(const std::vector<double>& q, const std::vector<double>& turn) {
    const double angle = std::hypot(turn[0], turn[1], turn[2]), part = std::sin(angle / 2) / angle;
    return std::hypot(std::hypot(q[0] - std::cos(angle / 2), q[1] - part * turn[0]),
                      std::hypot(q[2] - part * turn[1], q[3] - part * turn[2]));
  }
};

TEST_F(SphericalReport, TurnsByItsSlidersAndByItsQuaternion) {
  const std::string use = R"js(<script>
const sliders = [2, 3, 4].map((k) => document.getElementById(`range-${k}`)), quaternion = [...document.querySelectorAll('.quaternion input')];
const used = {start: look()};
[1.2, -2.5, 3].forEach((x, k) => set(sliders[k], x));
sliders[1].focus();
used.turned = look();
used.typed = set(quaternion[0], -0.6);
used.half = quaternion.map((field, k) => set(field, k === 1 ? 1 : 0)).at(-1);
sliders.forEach((slider) => set(slider, 0));
used.none = set(quaternion[0], 0);
used.beyond = set(document.getElementById('number-2'), 9);
document.querySelector('[value=qd]').click();
used.rates = set(document.getElementById('number-4'), 9);
used.kept = used.rates.q;
</script>)js";
  const json seen = told_by(page(kWrist), std::string(kReadBall) + use + kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  for (const char* count : {"unnamed", "pictures", "ids", "heads"}) EXPECT_EQ(seen.at(count), 0) << count;
  EXPECT_EQ(seen.at("names"), json({"waist", "shoulder", "wrist.wx", "wrist.wy", "wrist.wz", "knuckle", "slide"}));
  EXPECT_EQ(seen.at("start").at("q"), json({1, 0, 0, 0}));  // a tree is shown at zero
  EXPECT_EQ(seen.at("start").at("labels")[2], "wrist, turn x");
  EXPECT_LT(off(seen.at("turned").at("q"), {1.2, -2.5, 3}), 1e-15);
  EXPECT_EQ(seen.at("turned").at("thick"), json({"axis-y turning"}));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(seen.at("turned").at("fields")[k].get<double>(), seen.at("turned").at("q")[k].get<double>(), 5e-5);
  }
  const std::vector<double> typed = seen.at("typed").at("q");
  EXPECT_NEAR(typed[0] * typed[0] + typed[1] * typed[1] + typed[2] * typed[2] + typed[3] * typed[3], 1, 1e-15);
  EXPECT_LT(off(seen.at("half").at("q"), {M_PI, 0, 0}), 1e-15);
  EXPECT_NEAR(seen.at("half").at("turns")[0].get<double>(), M_PI, 1e-5);
  EXPECT_EQ(seen.at("none").at("q"), json({1, 0, 0, 0}));  // one of zeros is not taken
  EXPECT_LT(off(seen.at("beyond").at("q"), {M_PI, 0, 0}), 1e-15);
  EXPECT_EQ(seen.at("rates").at("labels")[4], "wrist.wz");
  EXPECT_EQ(seen.at("rates").at("w"), json({0, 0, 9}));
  EXPECT_EQ(seen.at("kept"), seen.at("beyond").at("q"));
}

// In play q̇ = q (0, w) / 2, and the accelerations are the derivatives of w. The script draws frames by its own clock.
TEST_F(SphericalReport, PlaysWithTheVelocitiesThatBelongToIt) {
  const std::string clock = R"js(<script>
let drawFrame = null, clock = 0;
performance.now = () => clock;
window.requestAnimationFrame = (draw) => { drawFrame = draw; return 1; };
window.cancelAnimationFrame = () => {};
</script>)js",
                    use = R"js(<script>
[0.5, -0.8, 0.3].forEach((x, k) => set(document.getElementById(`range-${k + 2}`), x));
document.getElementById('play').click();
const at = (t) => { clock = t; drawFrame(t); return look(); };
const used = {begins: at(0), before: at(1299), now: at(1300), after: at(1301)};
</script>)js";
  std::string text = page(kWrist);
  text.insert(text.find("<head>") + 6, clock);
  const json seen = told_by(text, std::string(kReadBall) + use + kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  const auto of = [&seen](const char* when, const char* what) {
    return seen.at(when).at(what).get<std::vector<double>>();
  };
  EXPECT_LT(off(of("begins", "q"), {0.5, -0.8, 0.3}), 1e-14);
  const std::vector<double> q = of("now", "q"), w = of("now", "w"), a = of("now", "a");
  const double rates[] = {-q[1] * w[0] - q[2] * w[1] - q[3] * w[2], q[0] * w[0] + q[2] * w[2] - q[3] * w[1],
                          q[0] * w[1] + q[3] * w[0] - q[1] * w[2], q[0] * w[2] + q[1] * w[1] - q[2] * w[0]};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR((of("after", "q")[k] - of("before", "q")[k]) / 2e-3, rates[k] / 2, 1e-6) << k;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR((of("after", "w")[k] - of("before", "w")[k]) / 2e-3, a[k], 1e-6) << k;
    EXPECT_GT(std::abs(w[k]), 0.01);
  }
  expect_near(of("now", "tau"), evaluated(kWrist, "inverse_dynamics", seen.at("now").at("csv")), "torque");
}

// Nothing is wider than a frame of 360 pixels.
TEST_F(SphericalReport, FitsOnAPhone) {
  const json seen = told_by(page(kWrist), kCheck,
                            R"html(<iframe src="watched.html" style="width:360px;height:700px;border:0"></iframe>
<script>addEventListener('message', (event) => {
  document.body.insertAdjacentHTML('beforeend', '<pre id="told"></pre>');
  document.getElementById('told').textContent = event.data;
});</script>)html");
  EXPECT_EQ(seen.at("wide"), 0);
  EXPECT_EQ(seen.at("troubles"), json::array());
}

// A spherical joint is one row of the model's table and one group of the regressor's map, and three torques.
TEST(SphericalReportFile, HasTablesOfItsJoints) {
  const Scratch folder;
  const std::string limits = "docs/examples/ball_wrist_limits.toml", page = folder.path("page.html");
  const Outcome made =
      run_flatdyn(fmt::format("report {} -q --scene {} --with certificate -o '{}'", kWrist, limits, page));
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string text = folder.read("page.html");
  for (const char* row :
       {"<p class=\"lead\">5 joints, 1 of them spherical, 1 prismatic</p>",
        "<tr><td class=\"n\">3–6</td><th scope=\"row\">wrist</th><td>hand</td><td>shoulder</td><td>spherical</td>",
        "<tr><td class=\"n\">8</td><th scope=\"row\">slide</th><td>thumb</td><td>wrist</td><td>prismatic</td>",
        ">3–5</text>", "<code>tau[6]</code>", "at all orientations of spherical joints"}) {
    EXPECT_THAT(text, HasSubstr(row));
  }
}

class SphericalScripts : public ReportInNode {};

// Rotation vectors as long as sliders allow stand for one quaternion each, and the other way round up to half a turn;
// the drawing has the tip where forward_kinematics has it, and the child's axes as its rotation.
TEST_F(SphericalScripts, AgreeWithTheFunctions) {
  expect_passes(text_of_example("ball_wrist.toml"), R"js(
const {data, state, result, compute, setTurns, quaternionOf, turnOf} = use('data, state, result, compute, setTurns, quaternionOf, turnOf');
const rest = (x, y) => assert(Math.abs(x - y) < 1e-14, `${x}, ${y}`);
for (let trial = 0; trial < 20; ++trial) {
  state.q.forEach((_, k) => { state.q[k] = Math.PI * Math.sin(1 + 3 * k + 7 * trial); });
  compute();
  const turn = state.q.slice(2, 5), quaternion = state.positions.subarray(2, 6), back = new Float64Array(7);
  rest(Math.hypot(...quaternion), 1);
  setTurns(back, state.positions);
  if (Math.hypot(...turn) < Math.PI) rest(distance([...back], [...state.q]), 0);
  const again = quaternionOf(turnOf(quaternion)), sign = Math.sign(quaternion[0]);
  rest(distance(again.map((x) => sign * x), [...quaternion]), 0);
  const end = data.edges.findLast(([from]) => from === data.joints[5].point)[1], axis = (k) => [...result.axes.subarray(3 * k, 3 * k + 3)];
  rest(distance([...result.points.subarray(3 * end, 3 * end + 3)], [...result.tip]), 0);
  const [x, y, z] = [axis(2), axis(3), axis(4)];
  rest(distance([x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]], z), 0);
  const finger = axis(5), thumb = axis(6);  // along x of the hand both
  rest(distance(finger, x), 0);
  rest(distance(thumb, x), 0);
}
assert.deepEqual(quaternionOf([0, 0, 0]), [1, 0, 0, 0]);
assert.deepEqual(turnOf([1, 0, 0, 0]), [0, 0, 0]);
rest(turnOf(quaternionOf([1e-200, 0, 0]))[0] / 1e-200, 1);
)js");
}

// A pendulum that is the whole robot.
TEST_F(SphericalScripts, FindTheTorqueOfAPendulum) {
  expect_passes(text_of_example("spherical_pendulum.toml"), R"js(
const {state, result, compute} = use('state, result, compute');
state.q.set([0.7, 0, 0]);
compute();
assert(Math.abs(result.g[0] - 1.5 * 9.81 * 0.4 * Math.sin(0.7)) < 1e-12 && Math.abs(result.g[1]) < 1e-12, `${result.g}`);
assert(Math.abs(result.points.at(-1) + 0.4 * Math.cos(0.7)) < 1e-12, `${result.points}`);
)js");
}

}  // namespace
}  // namespace flatdyn::testing
