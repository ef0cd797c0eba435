// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/identified_robot.hpp"

#include <fmt/format.h>

#include "report/toml_string.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

Number exact(double value) { return exact_decimal(fmt::format("{}", value)); }

// The shortest text of the nearest double; 0 for less than this many kg, kg m or kg m², which is rounding.
std::string number(const Number& value) {
  constexpr double kSmallest = 1e-15;
  const double nearest = nearest_double(value);
  return std::abs(nearest) < kSmallest ? "0" : fmt::format("{}", nearest);
}

class RobotText {
 public:
  RobotText(const LoadedRobot& model, ParameterSet set, const PhysicalParameters& parameters)
      : model_(model), present_(parameters_in(model.mechanism, set)), pi_(parameters.pi) {}

  std::string text(const IdentifiedRobot& about) {
    for (const std::string& comment : about.comments) line(comment.empty() ? "#" : "# " + comment);
    const std::filesystem::path folder = std::filesystem::absolute(about.file).parent_path();
    line("");
    line("robot = " + toml_string(std::filesystem::relative(model_.robot.file, folder).generic_string()));
    for (const std::string& setting : about.settings) line(setting);
    if (model_.robot.has_payload) line("payload = { mass = 0 }  # in its link, below");
    const int base = model_.mechanism.base_bodies();
    for (int i = std::max(0, base - 1); i < model_.mechanism.body_count(); ++i) {
      if (!has_no_link(model_.mechanism.bodies[static_cast<std::size_t>(i)])) add_link(i);
    }
    for (const LinkFrame& link : model_.mechanism.links) add_merged(link);
    for (int i = base; i < model_.mechanism.body_count(); ++i) {
      const int spherical = model_.mechanism.bodies[static_cast<std::size_t>(i)].spherical;
      if (spherical == 0) add_joint(i, about);
      if (spherical == 1) add_spherical_joint(i);
    }
    return text_;
  }

 private:
  void line(const std::string& text) { text_ += text + "\n"; }

  double parameter(int i, Parameter which) const { return pi_[static_cast<std::size_t>(index_of(i, which))]; }
  bool has(int i, Parameter which) const { return present_[static_cast<std::size_t>(index_of(i, which))]; }

  // The inertia of body i in its canonical frame without the rotors that it carries, which have entries of their own in
  // the file.
  InertialParameters body_without_rotors(int i) const {
    InertialParameters body;
    for (int k = 0; k < kInertialPerBody; ++k) {
      const auto which = static_cast<Parameter>(k);
      body = body + single_parameter(which, exact(parameter(i, which)));
    }
    for (int j = 0; j < model_.mechanism.body_count(); ++j) {
      const std::optional<Rotor>& rotor = model_.mechanism.bodies[static_cast<std::size_t>(j)].rotor;
      if (!rotor || rotor->carrier != i) continue;
      const Number I_m = rotor_inertia(j);
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) body.inertia[r][c] -= I_m * rotor->axis[r] * rotor->axis[c];
      }
    }
    return body;
  }

  Number rotor_inertia(int j) const { return has(j, Parameter::Im) ? exact(parameter(j, Parameter::Im)) : Number(0); }

  static Mat3 scaled(const Number& factor, const Mat3& m) {
    Mat3 result = m;
    for (Vec3& row : result) row = factor * row;
    return result;
  }

  void add_link(int i) {
    const Body& body = model_.mechanism.bodies[static_cast<std::size_t>(i)];
    const auto frame = std::find_if(model_.mechanism.links.begin(), model_.mechanism.links.end(),
                                    [&](const LinkFrame& link) { return link.link == body.link; });
    const Mat3 back = transpose(frame->R);
    const InertialParameters link = transformed(body_without_rotors(i), back, expanded(Number(-1) * (back * frame->p)));
    const Vec3 com = (1 / link.mass) * link.first_moment;
    const Mat3 about_com = link.inertia + scaled(-1, steiner(link.mass, com));
    line("\n[[link]]\nname = " + toml_string(body.link));
    line("mass = " + number(link.mass));
    line(fmt::format("com = [{}, {}, {}]", number(com[0]), number(com[1]), number(com[2])));
    line(fmt::format("inertia = {{ xx = {}, yy = {}, zz = {}, xy = {}, xz = {}, yz = {} }}", number(about_com[0][0]),
                     number(about_com[1][1]), number(about_com[2][2]), number(about_com[0][1]), number(about_com[0][2]),
                     number(about_com[1][2])));
    line("inertia_about = \"com\"");
  }

  void add_merged(const LinkFrame& link) {
    if (link.body < 0 || model_.mechanism.bodies[static_cast<std::size_t>(link.body)].link == link.link) return;
    const auto written = std::find_if(model_.robot.links.begin(), model_.robot.links.end(),
                                      [&](const Link& each) { return each.name == link.link; });
    if (written->inertials.empty()) return;
    line("\n[[link]]\nname = " + toml_string(link.link) + "\nmass = 0  # moves with " +
         toml_string(model_.mechanism.bodies[static_cast<std::size_t>(link.body)].link) + ", and is part of it");
  }

  // A negative stiffness is no spring's: the file then has none.
  static std::string spring_text(const IdentifiedSpring& spring) {
    if (spring.stiffness <= 0) return fmt::format("stiffness = 0  # the estimate is {:.6g}\n", spring.stiffness);
    return fmt::format("stiffness = {}\nspring_reference = {}\n", spring.stiffness,
                       spring.relaxed_torque / spring.stiffness);
  }

  void add_joint(int i, const IdentifiedRobot& about) {
    const Body& body = model_.mechanism.bodies[static_cast<std::size_t>(i)];
    std::string values;
    // Subtracts an entry of the file that the estimate was made without.
    const auto add = [&](Parameter which, const char* key, const Number& in_file) {
      if (has(i, which)) values += fmt::format("{} = {}\n", key, number(exact(parameter(i, which))));
      if (!has(i, which) && !vanishes(in_file)) values += fmt::format("{} = 0\n", key);
    };
    add(Parameter::Fv, "viscous", body.viscous);
    add(Parameter::Fs, "coulomb", body.coulomb);
    if (body.rotor) {
      if (!vanishes(body.armature)) values += "armature = 0\n";
      values += fmt::format("motor = {{ mass = 0, inertia = {}, inertia_transverse = 0 }}\n", number(rotor_inertia(i)));
    } else {
      add(Parameter::Im, "armature", body.armature);
    }
    if (body.current_to_torque) values += fmt::format("current_to_torque = {}\n", number(*body.current_to_torque));
    if (!about.springs.empty())
      values += spring_text(about.springs[static_cast<std::size_t>(i - model_.mechanism.base_bodies())]);
    if (!values.empty()) text_ += "\n[[joint]]\nname = " + toml_string(body.joint) + "\n" + values;
  }

  // The file has one coefficient for all axes: the mean of those about x, y and z.
  void add_spherical_joint(int first) {
    const Body& body = model_.mechanism.bodies[static_cast<std::size_t>(first)];
    double viscous[kSphericalBodies] = {};
    for (int k = 0; k < kSphericalBodies; ++k) {
      if (has(first + k, Parameter::Fv)) viscous[k] = parameter(first + k, Parameter::Fv);
    }
    const double mean = (viscous[0] + viscous[1] + viscous[2]) / kSphericalBodies;
    if (mean == 0 && vanishes(body.viscous)) return;
    text_ += fmt::format("\n[[joint]]\nname = {}\nviscous = {}  # about x, y and z: {:.6g}, {:.6g}, {:.6g}\n",
                         toml_string(spherical_joint_name(body.joint)), number(exact(mean)), viscous[0], viscous[1],
                         viscous[2]);
  }

  const LoadedRobot& model_;
  std::vector<bool> present_;
  const std::vector<double>& pi_;
  std::string text_;
};

}  // namespace

std::string identified_robot_text(const LoadedRobot& model, ParameterSet set, const PhysicalParameters& parameters,
                                  const IdentifiedRobot& about) {
  return RobotText(model, set, parameters).text(about);
}

}  // namespace flatdyn
