// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn report`: the page in a browser. It computes what `flatdyn eval` computes, fetches nothing, and is legible on
// a phone and with a screen reader.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "cli/report_fixture.hpp"
#include "support/floating_robots.hpp"

namespace flatdyn::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using ByRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class MovedReport : public Report, public ::testing::WithParamInterface<const char*> {};

TEST_P(MovedReport, ShowsWhatEvalComputes) {
  const std::string robot = GetParam();
  const json shown = told_by(page(robot), std::string(kMove) + kRead + kCheck);
  EXPECT_EQ(shown.at("troubles"), json::array());
  EXPECT_GT(shown.at("drawn").get<int>(), 4);
  const std::string csv = shown.at("csv");
  const std::vector<double> g = evaluated(robot, "gravity", csv);
  expect_near(shown.at("tau"), evaluated(robot, "inverse_dynamics", csv), "torque");
  expect_near(shown.at("g"), g, "gravity");
  const std::vector<double> entries = evaluated(robot, "inertia_matrix", csv);
  if (g.size() <= 10) expect_near(shown.at("B"), entries, "B");

  // (7.148), with torques scaled by the limits if every joint has one.
  const auto n = static_cast<Eigen::Index>(g.size());
  const Eigen::MatrixXd B = Eigen::Map<const ByRows>(entries.data(), n, n);
  const std::vector<double> rows = evaluated(robot, "jacobian", csv);
  const Eigen::MatrixXd J = Eigen::Map<const ByRows>(rows.data(), 6, n).topRows(3);
  const Eigen::VectorXd gravity = Eigen::Map<const Eigen::VectorXd>(g.data(), n);
  const Eigen::VectorXd falling = B.llt().solve(gravity), shift = -J * falling;
  const json model = json::parse(run_flatdyn(fmt::format("inspect {} -q --json", robot)).out);
  bool has_limits = true;
  for (const json& joint : model.at("joints")) has_limits = has_limits && joint.contains("effort");
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(J);
  Eigen::MatrixXd core = B * decomposition.pseudoInverse();
  for (Eigen::Index k = 0; k < n && has_limits; ++k) {
    core.row(k) /= model.at("joints").at(static_cast<std::size_t>(k)).at("effort").get<double>();
  }
  const Eigen::VectorXd sizes = core.jacobiSvd().singularValues();
  Eigen::VectorXd axes = Eigen::VectorXd::Zero(3);
  const Eigen::Index rank = decomposition.rank();
  axes.head(rank) = sizes.head(rank).cwiseInverse().reverse();
  const std::vector<double> shown_axes = shown.at("axes");
  for (Eigen::Index k = 0; k < axes.size(); ++k) {
    EXPECT_NEAR(shown_axes[static_cast<std::size_t>(k)], axes[k], 1e-6 * axes[0]) << "semi-axis " << k;
  }
  expect_near(shown.at("centre"), {shift.data(), shift.data() + 3}, "shift");
}

INSTANTIATE_TEST_SUITE_P(Robots, MovedReport,
                         ::testing::Values("robots/panda.urdf", "robots/planar_2r.toml", "robots/cartesian_2.toml",
                                           "robots/pendulum_motor.toml", "robots/prismatic_revolute.toml",
                                           "robots/puma560.toml", "robots/quadruped12.urdf",
                                           "docs/examples/ball_wrist.toml"),
                         [](const auto& test) { return std::filesystem::path(test.param).stem().string(); });

TEST_F(Report, StandsAloneAndIsNamedThroughout) {
  const std::string text = page("robots/scara.toml");
  for (const char* what : {"http:", "https:", "@import", "url(", "src="}) EXPECT_THAT(text, Not(HasSubstr(what)));
  for (std::size_t at = 0; (at = text.find("href=\"", at)) != std::string::npos; ++at) {
    EXPECT_TRUE(text.compare(at + 6, 1, "#") == 0 || text.compare(at + 6, 5, "data:") == 0) << text.substr(at, 40);
  }
  const json seen = told_by(text, kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  EXPECT_EQ(seen.at("fetched"), json::array());
  for (const char* count : {"unnamed", "pictures", "ids", "heads", "images"}) EXPECT_EQ(seen.at(count), 0) << count;
  EXPECT_EQ(seen.at("landmarks"), json({1, 1, 1, 1}));
  EXPECT_EQ(seen.at("title"), "scara: dynamics");
}

TEST_F(Report, AnswersEveryControlAndPlays) {
  const json seen = told_by(page("robots/panda.urdf"), std::string(kUse) + kRead + kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  for (const char* control :
       {"left", "up", "larger", "reset", "middle", "random", "start", "unit", "hides", "theme", "typed", "nonsense"}) {
    EXPECT_EQ(seen.at(control), true) << control;
  }
  const std::string csv = seen.at("csv");
  const std::vector<double> gravity = evaluated("robots/panda.urdf", "gravity", csv);
  expect_near(seen.at("tau"), evaluated("robots/panda.urdf", "inverse_dynamics", csv), "torque");
  EXPECT_NE(seen.at("tau"), json(gravity)) << "it does not move";
}

// These parameters belong to no real body: the page says so, still draws, and recovers.
TEST_F(Report, SaysWhereBIsNotPositiveDefinite) {
  const std::string all_zero = R"js(<script>
const set = (value) => document.querySelectorAll('#symbols input').forEach((field) => {
  field.value = value;
  field.dispatchEvent(new Event('input'));
});
set(0);
</script>)js";
  const std::string text = page("robots/planar_2r.toml");
  const json zero = told_by(text, all_zero + kRead + kCheck);
  EXPECT_THAT(zero.at("trouble").get<std::string>(), HasSubstr("not positive definite"));
  EXPECT_EQ(zero.at("troubles"), json::array());
  const json again = told_by(text, all_zero + "<script>set(1);</script>" + kCheck);
  EXPECT_EQ(again.at("trouble"), "");
  EXPECT_EQ(again.at("troubles"), json::array());
}

// Nothing is wider than a frame of 360 pixels.
TEST_F(Report, FitsOnAPhone) {
  const std::string text = page("robots/panda.urdf");
  const json seen =
      told_by(text, kCheck, R"html(<iframe src="watched.html" style="width:360px;height:700px;border:0"></iframe>
<script>addEventListener('message', (event) => {
  document.body.insertAdjacentHTML('beforeend', '<pre id="told"></pre>');
  document.getElementById('told').textContent = event.data;
});</script>)html");
  EXPECT_EQ(seen.at("wide"), 0);
  EXPECT_EQ(seen.at("troubles"), json::array());
}

TEST_F(Report, EscapesNames) {
  const std::string name = "</script><img src=x onerror=\"document.title='no'\">'&lt;{{robot}}<!--\\";
  folder_.write("arm.toml", fmt::format(R"toml(name = {0}
dh = "standard"
[[link]]
joint = {0}
a = 1
mass = 1
)toml",
                                        json(name).dump()));
  const Outcome made =
      run_flatdyn(fmt::format("report '{}' -q -o '{}'", folder_.path("arm.toml"), folder_.path("page.html")));
  ASSERT_EQ(made.code, 0) << made.err;
  const json seen = told_by(folder_.read("page.html"), kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  EXPECT_EQ(seen.at("images"), 0);
  EXPECT_EQ(seen.at("heading"), name);
  EXPECT_EQ(seen.at("title"), name + ": dynamics");
  EXPECT_EQ(seen.at("names"), json({name}));
}

TEST(ReportFile, IsTheSameFromAnyFolder) {
  const Scratch folder;
  folder.write("arm.toml", "[[link]]\na = 1\nmass = 1\n");
  std::string pages[2];
  const char* const robots[] = {"robots/prismatic_revolute.toml", "$PWD/robots/prismatic_revolute.toml"};
  for (int k = 0; k < 2; ++k) {
    const std::string file = folder.path(fmt::format("{}/page.html", k));
    const Outcome outcome = run_flatdyn(fmt::format("report \"{}\" -q -o '{}' --tip link2", robots[k], file));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    pages[k] = folder.read(fmt::format("{}/page.html", k));
  }
  EXPECT_EQ(pages[0], pages[1]);
  EXPECT_THAT(pages[0], HasSubstr("--tip link2"));
}

// The page shows the bounds of `flatdyn certify`; without limits there are none.
TEST(ReportFile, HasACertificateOnRequest) {
  const Scratch folder;
  folder.write("arm.toml", R"toml(dh = "standard"
[[link]]
a = 1
mass = 2
com = [-0.5, 0, 0]
limits = { lower = -1, upper = 1, velocity = 2, acceleration = 10, effort = 100 }
[[link]]
a = 1
mass = 1
com = [-0.3, 0.1, 0]
limits = { velocity = 2, acceleration = 10 }
)toml");
  const std::string arm = folder.path("arm.toml"), page = folder.path("page.html");
  const Outcome made = run_flatdyn(fmt::format("report '{}' -q --with certificate -o '{}'", arm, page));
  ASSERT_EQ(made.code, 0) << made.err;
  const json certificate = json::parse(
      run_flatdyn(fmt::format("certify '{}' -q --json --functions inverse_dynamics --time-limit 0 --states 1000", arm))
          .out);
  const std::string text = folder.read("page.html");
  for (const json& output : certificate.at("functions").at(0).at("outputs")) {
    EXPECT_THAT(text, HasSubstr(fmt::format("<code>{}</code></th><td class=\"n\">{:.3e}</td>",
                                            output.at("output").get<std::string>(), output.at("bound").get<double>())));
  }
  const std::string none = folder.path("none.html");
  EXPECT_EQ(run_flatdyn(fmt::format("report robots/planar_2r.toml -q --with certificate -o '{}'", none)).code, 4);
  EXPECT_FALSE(std::filesystem::exists(none));
}

// The picture has as many squares as the header has entries that are not always zero.
TEST(ReportFile, MapsTheRegressorAsTheHeaderHasIt) {
  const Scratch folder;
  folder.write("satellite.toml", kSatellite);
  const auto expect_mapped = [&folder](const std::string& robot, const std::string& name, int entries) {
    ASSERT_EQ(run_flatdyn(fmt::format("report '{}' -q -o '{}'", robot, folder.path("page.html"))).code, 0);
    ASSERT_EQ(run_flatdyn(fmt::format("generate '{}' -q --functions regressor -o '{}'", robot, folder.path())).code, 0);
    const std::string header = folder.read(name + ".hpp"), page = folder.read("page.html");
    const std::size_t begin = header.find("{", header.find("regressor_nonzero[")), end = header.find("}", begin);
    const auto filled = std::count(header.begin() + static_cast<std::ptrdiff_t>(begin),
                                   header.begin() + static_cast<std::ptrdiff_t>(end), '1');
    EXPECT_GT(filled, 20);
    EXPECT_LT(filled, entries);
    EXPECT_THAT(page, HasSubstr(fmt::format("{} of {} entries", filled, entries)));
    const std::size_t map = page.find("aria-label=\"regressor:"), path = page.find("<path", map);
    ASSERT_NE(map, std::string::npos);
    EXPECT_EQ(std::count(page.begin() + static_cast<std::ptrdiff_t>(path),
                         page.begin() + static_cast<std::ptrdiff_t>(page.find("/>", path)), 'M'),
              filled);
  };
  expect_mapped("robots/scara.toml", "scara", 4 * 52);
  expect_mapped("docs/examples/ball_wrist.toml", "ball_wrist", 7 * 5 * 13);
  expect_mapped(folder.path("satellite.toml"), "satellite", 9 * (10 + 3 * 13));
}

// The page shows the file that flatdyn stress has saved, and accepts no other.
TEST_F(Report, ShowsTheWorstStates) {
  const std::string robot = "robots/planar_2r_example_7_2.toml", out = folder_.path("found");
  ASSERT_EQ(run_flatdyn(fmt::format("stress {} -q --functions gravity,inverse_dynamics --states 100 --edges 20 "
                                    "--evaluations 100 --variants double,float -o '{}'",
                                    robot, out))
                .code,
            0);
  const json found = json::parse(folder_.read("found/stress.json"));
  const std::string page = folder_.path("page.html"),
                    report = fmt::format("report {} -q -o '{}' --stress ", robot, page);
  ASSERT_EQ(run_flatdyn(report + "'" + out + "/stress.json'").code, 0);
  const std::string text = folder_.read("page.html");
  ASSERT_GE(found.at("rows").size(), 2u);
  for (const json& row : found.at("rows")) {
    EXPECT_THAT(text, HasSubstr(fmt::format("<code>{}</code></th><td>{}</td><td class=\"n\">{:.2g}</td>",
                                            row.at("function").get<std::string>(), row.at("scalar").get<std::string>(),
                                            row.at("worst").at("scaled_error").get<double>())));
    EXPECT_THAT(text, HasSubstr(row.at("worst").at("state").get<std::string>()));
  }
  const json seen = told_by(text, kCheck);
  EXPECT_EQ(seen.at("troubles"), json::array());
  EXPECT_EQ(seen.at("unnamed"), 0);

  folder_.write("broken.json", "{\n\"robot\": \"planar_2r_example_7_2\",\n");
  folder_.write("other.json", found.dump());
  folder_.write("half.json",
                R"({"robot": "planar_2r_example_7_2", "bound": 64, "ratio": 4, "rows": [{"function": "gravity"}]})");
  const auto refused = [&](const std::string& command) {
    const Outcome outcome = run_flatdyn(command);
    EXPECT_EQ(outcome.code, 3) << command;
    return outcome.err;
  };
  EXPECT_THAT(refused(report + "'" + folder_.path("broken.json") + "'"),
              HasSubstr("broken.json:3: error: this is no JSON"));
  EXPECT_THAT(refused(report + "'" + folder_.path("half.json") + "'"), HasSubstr("no result of flatdyn stress"));
  EXPECT_THAT(
      refused(fmt::format("report robots/scara.toml -q -o '{}' --stress '{}'", page, folder_.path("other.json"))),
      HasSubstr("and the page of \"scara\""));
  EXPECT_EQ(run_flatdyn(report + "'" + folder_.path("none.json") + "'").code, 6);
  EXPECT_EQ(run_flatdyn(fmt::format("report {0} -q -o '{1}' --stress '{1}'", robot, folder_.path("other.json"))).code,
            2);
}

TEST(ReportFile, IsRefusedWhereThereIsNothingToShow) {
  const Scratch folder;
  const std::string page = folder.path("page.html");
  EXPECT_EQ(run_flatdyn(fmt::format("report robots/pendulum_motor.toml --fix theta -q -o '{}'", page)).code, 3);
  EXPECT_EQ(run_flatdyn(fmt::format("report robots/none.toml -q -o '{}'", page)).code, 6);
  EXPECT_EQ(run_flatdyn("report robots/pendulum_motor.toml -q -o robots/pendulum_motor.toml").code, 2);
  EXPECT_EQ(run_flatdyn("report robots/pendulum_motor.toml -q").code, 2);
  EXPECT_TRUE(folder.is_empty());
}

}  // namespace
}  // namespace flatdyn::testing
