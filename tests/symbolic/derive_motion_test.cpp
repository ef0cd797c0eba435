// SPDX-License-Identifier: GPL-2.0-or-later
// The text that `derive` prints for robots with a floating base or spherical joints is read back and compared
// with the definition, in exact arithmetic where no number is rounded, and with derived functions in 50 digits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "derivation/notation/derive.hpp"
#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/states.hpp"
#include "support/floating_robots.hpp"
#include "support/printed_formula.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Mechanism of_example(const std::string& file) {
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "docs" / "examples" / file, {}).mechanism;
}

Mechanism of_toml(const std::string& text) { return testing::model_of_toml(text).mechanism; }

// A rigid body with symbols, whose centre of mass is on the z axis.
constexpr const char* kSymbolicBody = R"([base]
name = "body"
motion = "floating"
mass = "m"
com = [0, 0, "l"]
inertia = { xx = "I_x", yy = "I_y", zz = "I_z" }
inertia_about = "com"
)";

// Two hinges, one on the other, with a motor, friction and a spring, and a slide beside them.
constexpr const char* kHopper = R"([base]
name = "hull"
motion = "floating"
mass = 12
com = [0.01, 0.02, -0.03]
inertia = { xx = 0.1, yy = 0.3, zz = 0.35, xy = 0.01, yz = 0.02 }
inertia_about = "com"
[[link]]
joint = "hip"
xyz = [0.1, 0.2, 0]
rpy = ["pi/2", 0, 0]
mass = 2
com = [0.1, 0.01, 0.02]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
viscous = 0.2
coulomb = 0.1
stiffness = 3
spring_reference = 0.5
motor = { mass = 0.3, inertia = 1e-3, gear_ratio = 30, carrier = "hull" }
[[link]]
joint = "knee"
xyz = [0.3, 0, 0.1]
mass = 1
com = [0.1, 0, 0.01]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02, xz = 0.003 }
inertia_about = "com"
[[link]]
joint = "rail"
type = "prismatic"
parent = "hull"
xyz = [0, 0, 0.2]
axis = [1, 0, 0]
mass = 0.5
com = [0.02, 0, 0.03]
inertia = { xx = 0.001, yy = 0.002, zz = 0.001 }
inertia_about = "com"
)";

// A ball on a hinge, a hinge on the ball, and symbols whose names are those of a quaternion and of a rate.
constexpr const char* kBallArm = R"(gravity = [0, 0, -10]
[[link]]
joint = "turn"
rpy = ["pi/2", 0, 0]
mass = 2
com = [0.2, 0, 0]
inertia = { xx = 0.01, yy = 0.02, zz = 0.03 }
inertia_about = "com"
[[link]]
name = "hand"
joint = "ball"
type = "spherical"
xyz = ["x_2", 0, 0.1]
mass = "domega_2y"
com = [0, 0, 0.2]
inertia = { xx = 0.01, yy = 0.02, zz = 0.025 }
inertia_about = "com"
viscous = 0.01
[[link]]
joint = "finger"
xyz = [0.1, 0, 0]
mass = 0.25
com = [0.1, 0, 0]
inertia = { xx = 0.001, yy = 0.002, zz = 0.002 }
inertia_about = "com"
)";

constexpr int kAllTerms = 6000;

struct MotionSubject {
  const char* name;
  Mechanism (*mechanism)();
  bool is_exact;  // whether no number is rounded
  int max_terms = kAllTerms;
};

// The printed model of one robot, and the functions that it must agree with. Formulas that are left out are compared
// with nothing.
class PrintedMotion {
 public:
  explicit PrintedMotion(const MotionSubject& subject) : subject_(subject), mechanism_(subject.mechanism()) {}

  void expect_inverse_dynamics() const { expect_same("inverse_dynamics", texts_of(model_.equations)); }
  void expect_gravity() const { expect_same("gravity", texts_of(model_.gravity)); }
  void expect_inertia_matrix() const;
  void expect_velocity_terms() const;

 private:
  int n() const { return mechanism_.size(); }
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  // "w_2, x_2": the names in a line of the joints' table.
  static std::vector<std::string> names_in(const std::string& list) {
    std::vector<std::string> names;
    std::size_t begin = 0;
    for (std::size_t end = list.find_first_of(",="); end != std::string::npos; end = list.find_first_of(",=", begin)) {
      names.push_back(list.substr(begin, list.find_last_not_of(' ', end - 1) + 1 - begin));
      begin = end + 2;
    }
    names.push_back(list.substr(begin));
    return names;
  }

  // The inputs by their names: those of the head of the output, and the free symbols.
  std::map<std::string, Input> inputs_by_name() const {
    std::map<std::string, Input> inputs;
    for (int k = 0; k < n(); ++k) {
      inputs[model_.entries[at(k)].velocity] = {InputKind::v, k};
      inputs[model_.entries[at(k)].acceleration] = {InputKind::a, k};
    }
    int position = 0;
    for (const DerivedLine& joint : model_.joints) {
      const std::vector<std::string> names = names_in(joint.name);
      const bool is_quaternion = names.size() == 4;
      for (const std::string& name : names) {
        inputs[name] = {InputKind::q, position};
        if (is_quaternion) ++position;
      }
      if (!is_quaternion) ++position;
    }
    for (int k = 0; k < 3; ++k) inputs[std::string("g_") + "xyz"[k]] = {InputKind::g_b, k};
    for (std::size_t k = 0; k < mechanism_.symbols.size(); ++k) {
      inputs[mechanism_.symbols[k].name] = {InputKind::parameter, static_cast<int>(k)};
    }
    return inputs;
  }

  // The node of a name: an input, or c_12 = cos(q_1 + q_2), s_12.
  static NodeId node_of(const std::string& name, const std::map<std::string, Input>& inputs, Graph& graph) {
    if (const auto known = inputs.find(name); known != inputs.end()) return graph.input(known->second);
    if (name.rfind("c_", 0) != 0 && name.rfind("s_", 0) != 0) throw std::runtime_error("unknown name " + name);
    std::vector<Term> angle;
    for (const char joint : name.substr(2)) {
      angle.push_back({1, graph.input(inputs.at(std::string("q_") + joint))});
    }
    return name.front() == 'c' ? graph.cos(graph.sum(angle)) : graph.sin(graph.sum(angle));
  }

  // The function of this name with printed formulas as the entries of its first output.
  Function printed(const std::string& name, const std::vector<std::string>& texts) const {
    Function function = derive_function(mechanism_, name);
    const std::map<std::string, Input> inputs = inputs_by_name();
    Graph graph;
    testing::PrintedFormula formula(graph, [&](const std::string& each) { return node_of(each, inputs, graph); });
    std::vector<NodeId> entries;
    for (const std::string& text : texts) entries.push_back(formula.read(text.empty() ? "0" : text));
    EXPECT_FALSE(formula.has_rounded_numbers() && subject_.is_exact);
    function.outputs.at(0).entries = std::move(entries);
    function.graph = std::move(graph);
    return function;
  }

  std::vector<State> states() const {
    std::vector<State> states;
    for (const State& state : random_states(mechanism_, 2, 5)) {
      states.push_back(with_unit_quaternions(mechanism_, state));
      for (std::size_t k = 0; k < mechanism_.symbols.size(); ++k) {
        states.back().parameters.push_back(0.5 + 0.25 * static_cast<double>(k));
      }
    }
    return states;
  }

  // Proven exactly if all numbers are exact, and compared with the derived function in any case. An empty text is left
  // out.
  void expect_same(const std::string& name, const std::vector<std::string>& texts) const {
    const Function function = printed(name, texts), derived = derive_function(mechanism_, name);
    ASSERT_EQ(function.outputs.at(0).entries.size(), derived.outputs.at(0).entries.size());
    if (subject_.is_exact) {
      const ExactResult result = prove_exactly(mechanism_, function);
      EXPECT_TRUE(result.equal) << name << ": " << result.summary();
    }
    GraphEvaluator<Real50> from_text(function), expected(derived);
    for (const State& state : states()) {
      const StateOf<Real50> here = with_unit_quaternions(mechanism_, widened<Real50>(state));
      const std::vector<Real50> found = *from_text(here), right = *expected(here);
      for (std::size_t k = 0; k < right.size(); ++k) {
        if (!texts[k].empty()) expect_near(found[k], right[k], name + " " + std::to_string(k));
      }
    }
  }

  static void expect_near(const Real50& found, const Real50& right, const std::string& what) {
    const Real50 scale = std::max(Real50(1), Real50(abs(right)));
    EXPECT_LE(Real50(abs(found - right) / scale).convert_to<double>(), 1e-12) << what << ": " << found << " " << right;
  }

  std::vector<std::string> texts_of(const std::vector<DerivedLine>& lines) const {
    std::vector<std::string> texts;
    for (const DerivedLine& line : lines) {
      EXPECT_FALSE(line.left_out && subject_.max_terms == kAllTerms) << line.name;
      texts.push_back(line.left_out ? "" : line.text);
    }
    return texts;
  }

  const MotionSubject& subject_;
  const Mechanism mechanism_;
  const DerivedModel model_ = derive_model(mechanism_, {subject_.max_terms, kExactDigits}, Notation::text);
};

void PrintedMotion::expect_inertia_matrix() const {
  const std::vector<std::string> upper = texts_of(model_.inertia);
  std::vector<std::string> texts(at(n() * n()));
  std::size_t next = 0;
  for (int i = 0; i < n(); ++i) {
    for (int j = i; j < n(); ++j) texts[at(i * n() + j)] = texts[at(j * n() + i)] = upper.at(next++);
  }
  expect_same("inertia_matrix", texts);
}

// h_kij by the bias at v = e_i + e_j, e_i, e_j and 0; coefficients that have no line are zero.
void PrintedMotion::expect_velocity_terms() const {
  Mechanism passive = mechanism_;
  for (Body& body : passive.bodies) body.viscous = body.coulomb = body.stiffness = 0;
  const Function bias = derive_function(passive, "bias");
  std::map<std::string, std::string> by_name;
  for (const DerivedLine& line : model_.velocity_terms) by_name[line.name] = line.left_out ? "" : line.text;
  // A text may be another coefficient's name, perhaps with a sign.
  const auto resolved = [&](const std::string& text) {
    const auto same = by_name.find(text.substr(text.rfind('-', 0) == 0 ? 1 : 0));
    if (same == by_name.end()) return text;
    return text.front() == '-' ? "-(" + same->second + ")" : same->second;
  };
  const std::map<std::string, Input> inputs = inputs_by_name();
  const std::string separator = n() < 10 ? "" : "_";
  GraphEvaluator<Real50> torques(bias);
  StateOf<Real50> state = with_unit_quaternions(mechanism_, widened<Real50>(states().front()));
  const auto at_unit_rates = [&](const std::vector<int>& entries) {
    state.qd.assign(at(n()), Real50(0));
    for (const int entry : entries) state.qd[at(entry)] += 1;
    return *torques(state);
  };
  const std::vector<Real50> at_rest = at_unit_rates({});
  int present = 0;
  for (int i = 0; i < n(); ++i) {
    const std::vector<Real50> first = at_unit_rates({i});
    for (int j = i; j < n(); ++j) {
      const std::vector<Real50> second = at_unit_rates({j}), both = at_unit_rates({i, j});
      for (int k = 0; k < n(); ++k) {
        const Real50 right = i == j ? Real50(first[at(k)] - at_rest[at(k)])
                                    : Real50(both[at(k)] - first[at(k)] - second[at(k)] + at_rest[at(k)]);
        const std::string name =
            "h_" + std::to_string(k + 1) + separator + std::to_string(i + 1) + separator + std::to_string(j + 1);
        const auto line = by_name.find(name);
        if (line == by_name.end()) {
          EXPECT_LE(abs(right).convert_to<double>(), 1e-25) << name;
          continue;
        }
        ++present;
        if (line->second.empty()) continue;
        Function function = bias;
        Graph graph;
        testing::PrintedFormula formula(graph, [&](const std::string& each) { return node_of(each, inputs, graph); });
        function.outputs.at(0).entries = {formula.read(resolved(line->second))};
        function.graph = std::move(graph);
        expect_near(GraphEvaluator<Real50>(function)(state)->front(), right, name);
      }
    }
  }
  EXPECT_EQ(present, static_cast<int>(by_name.size()));
}

class DerivedMotion : public ::testing::TestWithParam<MotionSubject> {
 protected:
  const PrintedMotion printed_{GetParam()};
};

TEST_P(DerivedMotion, EquationsAreInverseDynamics) { printed_.expect_inverse_dynamics(); }
TEST_P(DerivedMotion, GravityIsGravity) { printed_.expect_gravity(); }
TEST_P(DerivedMotion, InertiaMatrixIsInertiaMatrix) { printed_.expect_inertia_matrix(); }
TEST_P(DerivedMotion, VelocityTermsAreThoseOfTheBias) { printed_.expect_velocity_terms(); }

INSTANTIATE_TEST_SUITE_P(
    Robots, DerivedMotion,
    ::testing::Values(MotionSubject{"floating_body", [] { return of_example("floating_body.toml"); }, true},
                      MotionSubject{"symbolic_body", [] { return of_toml(kSymbolicBody); }, true},
                      MotionSubject{"hopper", [] { return of_toml(kHopper); }, true},
                      MotionSubject{"satellite", [] { return of_toml(testing::kSatellite); }, false},
                      MotionSubject{"heavy_satellite", [] { return of_toml(testing::heavy_satellite()); }, false},
                      MotionSubject{"lander", [] { return of_toml(testing::kLander); }, false},
                      MotionSubject{"pendulum", [] { return of_example("spherical_pendulum.toml"); }, true},
                      MotionSubject{"ball_arm", [] { return of_toml(kBallArm); }, true}),
    [](const auto& each) { return std::string(each.param.name); });

// Formulas of up to 60 terms; the longest of B has 1100.
TEST(DerivedFreeArm, IsItsFunctions) {
  const MotionSubject subject{"free_arm", [] { return of_example("free_arm.toml"); }, false, 60};
  const PrintedMotion arm(subject);
  arm.expect_gravity();
  arm.expect_inertia_matrix();
  arm.expect_velocity_terms();
}

// Newton's and Euler's equations, with a centre of mass that is not the origin of the base frame.
TEST(DerivedBody, IsNewtonsAndEulersEquations) {
  const std::string text = derive_text(of_toml(kSymbolicBody));
  EXPECT_THAT(text, HasSubstr("\nb_44 = m l^2 + I_x\n"));
  EXPECT_THAT(text, HasSubstr("\nh_645 = I_y - I_x\n"));
  EXPECT_THAT(text, HasSubstr("\nm dv_x + m l domega_y - m v_y omega_z + m v_z omega_y + m l omega_x omega_z - m g_x = "
                              "f_x\n"));
  EXPECT_THAT(text, HasSubstr("\nI_z domega_z + (I_y - I_x) omega_x omega_y = n_z\n"));
  for (const char* const line : {"v_x, v_y, v_z: velocity of the base frame's origin, in base axes, m/s\n",
                                 "n_x, n_y, n_z: moment on the base about its frame's origin, in base axes, N m\n",
                                 "velocities v by index: 1 v_x, 2 v_y, 3 v_z, 4 omega_x, 5 omega_y, 6 omega_z\n",
                                 "there are no Christoffel symbols"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  EXPECT_THAT(text, Not(HasSubstr("c_ijk")));
}

TEST(DerivedBody, IsWrittenInLatex) {
  const std::string text = derive_latex(of_toml(kSymbolicBody));
  EXPECT_THAT(text, HasSubstr("  n_{z} &= I_{z} \\dot{\\omega}_{z} + (I_{y} - I_{x}) \\omega_{x} \\omega_{y}\n"));
  EXPECT_THAT(text, HasSubstr("- m v_{y} \\omega_{z} + m v_{z} \\omega_{y}"));
}

TEST(DerivedPendulum, HasAQuaternion) {
  const std::string text = derive_text(of_example("spherical_pendulum.toml"));
  EXPECT_THAT(text, HasSubstr("\nw_1, x_1, y_1, z_1: ball (spherical)\n"));
  EXPECT_THAT(text, HasSubstr("\n0.26 domega_1x - 0.26 omega_1y omega_1z + 0.01 omega_1x + 11.772 w_1 x_1 + 11.772 y_1 "
                              "z_1 = tau_1x\n"));
  EXPECT_THAT(derive_latex(of_example("spherical_pendulum.toml")),
              HasSubstr("  \\tau_{1,z} &= 0.01 \\dot{\\omega}_{1,z} + 0.01 \\omega_{1,x} \\omega_{1,y}"));
}

// A letter is doubled where a free symbol has the name.
TEST(DerivedNames, AreNotThoseOfTheRobotsSymbols) {
  const DerivedModel model = derive_model(of_toml(kBallArm), {}, Notation::text);
  EXPECT_EQ(model.joints.at(1).name, "w_2, xx_2, y_2, z_2");
  EXPECT_EQ(model.entries.at(1).velocity, "omegaa_2x");
  EXPECT_EQ(model.entries.at(1).acceleration, "domegaa_2x");
  EXPECT_EQ(model.entries.at(1).torque, "tau_2x");
}

TEST(DerivedQuadruped, IsShort) {
  const Mechanism mechanism = with_floating_base(testing::model_of("quadruped12.urdf").mechanism);
  const DerivedModel model = derive_model(mechanism, {}, Notation::text);
  EXPECT_EQ(model.inertia.size(), 171u);
  EXPECT_EQ(model.equations.size(), 18u);
}

TEST(DerivedMotionInAll, IsRefusedWhereItWouldTakeMinutes) {
  const Mechanism hopper = of_toml(kHopper);
  EXPECT_THROW(closed_form(hopper, 100), Failure);
  EXPECT_NO_THROW(closed_form(hopper, 1000));
  const Mechanism humanoid = with_floating_base(testing::model_of("humanoid32.urdf").mechanism);
  EXPECT_THROW(derive_model(humanoid, {}, Notation::text), Failure);
}

}  // namespace
}  // namespace flatdyn
