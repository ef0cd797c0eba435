// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/payload_report.hpp"

#include <fmt/format.h>

#include "diagnostics/table.hpp"
#include "diagnostics/version.hpp"
#include "report/numbers.hpp"
#include "report/toml_string.hpp"

namespace flatdyn {
namespace {

constexpr const char* kNames[] = {"m", "m lx", "m ly", "m lz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};
constexpr const char* kUnits[] = {"kg",     "kg m",   "kg m",   "kg m",   "kg m^2",
                                  "kg m^2", "kg m^2", "kg m^2", "kg m^2", "kg m^2"};

// A body given by its ten parameters, about its centre of mass.
struct Centred {
  double mass;
  Eigen::Vector3d com;
  Eigen::Matrix3d inertia;  // about the centre of mass
};

Centred centred(const Eigen::VectorXd& ten) {
  const Eigen::Vector3d com = ten.segment<3>(1) / ten(0);
  Eigen::Matrix3d I;
  I << ten(4), ten(5), ten(6), ten(5), ten(7), ten(8), ten(6), ten(8), ten(9);
  I -= ten(0) * (com.squaredNorm() * Eigen::Matrix3d::Identity() - com * com.transpose());
  return {ten(0), com, I};
}

// The name of an equation: the joint's, and whether it is that of the log without payload.
std::string equation_name(const LoadedRobot& robot, std::size_t equation) {
  const auto& joints = robot.mechanism.joints();
  const std::string name = joints[equation % joints.size()].joint;
  return equation < joints.size() ? name : name + ", without payload";
}

std::string fit_table(const LoadedRobot& robot, const FittedPayload& found) {
  if (found.fits.empty()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"joint", "torque (rms)", "residual (rms)", "noise ratio", "correlation", "rows"}};
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    const JointObservations& joint = found.observations.joints[i];
    rows.push_back({equation_name(robot, i), fmt::format("{:.4g}", joint.rms_torque()),
                    fmt::format("{:.3g}", joint.rms_residual(found.payload.unknowns)),
                    fmt::format("{:.3g}", found.fits[i].ratio), fmt::format("{:.2f}", found.fits[i].correlation),
                    std::to_string(joint.rows)});
  }
  return "\n" + aligned_table(rows);
}

}  // namespace

std::vector<std::string> plausibility_warnings(const LoadedRobot& robot, const FittedPayload& found,
                                               const std::string& hint) {
  constexpr double kMuch = 5, kClearly = 3;  // standard deviations
  const PayloadEstimate& payload = found.payload;
  std::vector<std::string> warning_texts, bad;
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    if (found.fits[i].is_sound()) continue;
    bad.push_back(fmt::format("{} {:.3g}", equation_name(robot, i), found.fits[i].ratio));
  }
  if (!bad.empty()) {
    warning_texts.push_back(fmt::format(
        "the model does not fit: residuals to the noise of the log: {}; friction or rotors that the robot file lacks "
        "(--parameters full), masses of the file that are not right (--without), or a log that is not what it says "
        "(flatdyn identify names reasons)",
        fmt::join(bad, ", ")));
  }
  if (payload.largest_misfit > kMuch) {
    warning_texts.push_back(fmt::format(
        "the nearest body is {:.2g} standard deviations from the estimate, more than noise explains: motion, torques "
        "or forces, units or geometry cannot be right",
        payload.largest_misfit));
  }
  if (payload.values(0) < -kClearly * payload.standard_deviations(0)) {
    warning_texts.push_back("the mass is negative: " + hint);
  }
  return warning_texts;
}

std::string describe_payload(const LoadedRobot& robot, const FittedPayload& found) {
  const PayloadEstimate& payload = found.payload;
  std::vector<std::vector<std::string>> rows = {{"payload", "value", "std dev", "nearest body", "unit"}};
  for (Eigen::Index k = 0; k < payload.values.size(); ++k) {
    rows.push_back({kNames[k], fmt::format("{:.6g}", payload.values(k)), deviation_text(payload.standard_deviations(k)),
                    fmt::format("{:.6g}", payload.body(k)), kUnits[k]});
  }
  return fmt::format(
      "on link {}, in its frame, about its origin\n\n{}\nthe nearest that a body can have is {:.2g} standard "
      "deviations from the estimate at most\n{}",
      robot.mechanism.tip.link, aligned_table(rows), payload.largest_misfit, fit_table(robot, found));
}

nlohmann::ordered_json payload_json(const LoadedRobot& robot, const FittedPayload& found) {
  const PayloadEstimate& payload = found.payload;
  nlohmann::ordered_json json = {{"link", robot.mechanism.tip.link}};
  for (Eigen::Index k = 0; k < payload.values.size(); ++k) {
    json["parameters"].push_back({{"name", kNames[k]},
                                  {"unit", kUnits[k]},
                                  {"value", payload.values(k)},
                                  {"standard_deviation", payload.standard_deviations(k)},
                                  {"nearest_body", payload.body(k)}});
  }
  json["largest_misfit"] = payload.largest_misfit;
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    json["equations"].push_back({{"name", equation_name(robot, i)},
                                 {"rms_torque", found.observations.joints[i].rms_torque()},
                                 {"rms_residual", found.observations.joints[i].rms_residual(payload.unknowns)},
                                 {"noise_ratio", found.fits[i].ratio},
                                 {"residual_correlation", found.fits[i].correlation}});
  }
  return json;
}

std::string payload_robot_text(const LoadedRobot& robot, const PayloadEstimate& payload,
                               const std::filesystem::path& file, const std::vector<std::string>& settings,
                               const std::vector<std::string>& warning_texts) {
  const Centred body = centred(payload.body);
  const auto& I = body.inertia;
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  std::string comments;
  for (const std::string& warning_text : warning_texts) comments += "# " + warning_text + "\n";
  return fmt::format(
      "# The payload was identified by flatdyn {} from measured motion.\n{}\n"
      "robot = {}\n{}{}\n[payload]\nlink = {}\nmass = {}\ncom = [{}, {}, {}]\n"
      "inertia = {{ xx = {}, yy = {}, zz = {}, xy = {}, xz = {}, yz = {} }}\ninertia_about = \"com\"\n",
      kProgramVersion, comments, toml_string(std::filesystem::relative(robot.robot.file, folder).generic_string()),
      fmt::join(settings, "\n"), settings.empty() ? "" : "\n", toml_string(robot.mechanism.tip.link), body.mass,
      body.com.x(), body.com.y(), body.com.z(), I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
}

}  // namespace flatdyn
