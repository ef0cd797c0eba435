// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/payload_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostics/table.hpp"
#include "base/diagnostics/version.hpp"
#include "report/base_warnings.hpp"
#include "report/numbers.hpp"
#include "report/toml_string.hpp"
#include "robot/input/csv/names.hpp"

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

// The equations of one set of logs.
std::size_t equations_of(const Mechanism& mechanism) { return static_cast<std::size_t>(mechanism.size()); }

// The name of an equation: the joint's, or "base_fx", and whether it is that of the log without payload.
std::string equation_name(const Mechanism& mechanism, std::size_t equation) {
  const auto k = static_cast<int>(equation % equations_of(mechanism));
  const std::string of_base = base_name_of(CsvQuantity::tau, k, mechanism);
  const std::string name = of_base.empty() ? mechanism.joint(k).joint : of_base;
  return equation < equations_of(mechanism) ? name : name + ", without payload";
}

// Whether it is an equation of the base's force that the log lacks.
bool is_of_missing_force(const Mechanism& mechanism, const FittedPayload& found, std::size_t equation) {
  const auto k = static_cast<int>(equation % equations_of(mechanism));
  return mechanism.is_of_base(k) && found.observations.joints[equation].rows == 0;
}

// Which logs lack the force on a floating base: "" for none, "no log", or those with the payload or without it.
std::string logs_without_base_force(const Mechanism& mechanism, const FittedPayload& found) {
  if (!mechanism.floating_base || found.is_of_wrist()) return "";
  const bool are_two = found.fits.size() > equations_of(mechanism);
  const bool with_lacks = is_of_missing_force(mechanism, found, 0),
             without_lacks = are_two && is_of_missing_force(mechanism, found, equations_of(mechanism));
  if (with_lacks && (without_lacks || !are_two)) return "no log";
  return with_lacks ? "no log with the payload" : without_lacks ? "no log without the payload" : "";
}

std::string fit_table(const Mechanism& mechanism, const FittedPayload& found) {
  if (found.is_of_wrist()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"joint", "torque (rms)", "residual (rms)", "noise ratio", "correlation", "rows"}};
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    if (is_of_missing_force(mechanism, found, i)) continue;
    const JointObservations& joint = found.observations.joints[i];
    rows.push_back({equation_name(mechanism, i), fmt::format("{:.4g}", joint.rms_torque()),
                    fmt::format("{:.3g}", joint.rms_residual(found.payload.unknowns)),
                    fmt::format("{:.3g}", found.fits[i].ratio), fmt::format("{:.2f}", found.fits[i].correlation),
                    std::to_string(joint.rows)});
  }
  return "\n" + aligned_table(rows);
}

// A sum of multiples of the ten parameters: "m - 0.2 mlx + 0.04 Izz".
std::string sum_text(const Eigen::VectorXd& factors) {
  constexpr double kNothing = 1e-6;
  std::string text;
  for (Eigen::Index k = 0; k < factors.size(); ++k) {
    const double size = std::abs(factors(k));
    if (size < kNothing) continue;
    const bool is_first = text.empty(), is_one = std::abs(size - 1) < kNothing;
    text += factors(k) < 0 ? (is_first ? "-" : " - ") : (is_first ? "" : " + ");
    text += is_one ? kNames[k] : fmt::format("{:.4g} ({})", size, kNames[k]);
  }
  return text;
}

// The sums of parameters of which the logs show nothing.
std::string untold_sums_text(const Mechanism& mechanism, const FittedPayload& found) {
  const Eigen::MatrixXd& untold = found.payload.untold;
  const std::string lacking = logs_without_base_force(mechanism, found);
  std::string text;
  if (!lacking.empty()) {
    text += fmt::format(
        "\n{} has the force on the base, base_fx to base_nz, which tells more of the payload\n"
        "(zeros, if nothing touches the robot)\n",
        lacking);
  }
  if (untold.cols() == 0) return text;
  text += fmt::format(
      "\nthe logs do not tell {} of ten directions: a change of the payload along any of these changes nothing\n"
      "that was measured. The nearest body is one that agrees with what they tell.\n",
      untold.cols());
  for (const auto& direction : untold.colwise()) text += "  " + sum_text(direction) + "\n";
  return text;
}

// Reports logs in which a floating base moves, or is carried, as it can hardly be.
void doubt_base(const Mechanism& mechanism, const FittedPayload& found, std::vector<std::string>& warning_texts) {
  for (const Measurement& each : found.measurements) {
    for (const std::string& text : base_warnings(mechanism, each.observations, !found.is_of_wrist())) {
      warning_texts.push_back((&each == found.measurements.data() ? "" : "without payload: ") + text);
    }
  }
}

// Reports residuals that are no noise.
void doubt_fit(const Mechanism& mechanism, const FittedPayload& found, std::vector<std::string>& warning_texts) {
  std::vector<std::string> bad;
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    if (found.fits[i].is_sound()) continue;
    bad.push_back(fmt::format("{} {:.3g}", equation_name(mechanism, i), found.fits[i].ratio));
  }
  if (bad.empty()) return;
  std::string question;
  for (const Measurement& each : found.measurements) {
    if (question.empty()) question = imu_question(each.logs);
  }
  warning_texts.push_back(fmt::format(
      "the model does not fit: residuals to the noise of the log: {}; friction or rotors that the robot file lacks "
      "(--parameters full), {}or a log that is not what it says (flatdyn identify names reasons){}",
      fmt::join(bad, ", "), found.is_by_file ? "masses of the file that are not right (--without), " : "", question));
  if (!found.is_by_file) return;
  warning_texts.emplace_back(
      "no standard deviations are given: the robot file's numbers count as exact, but do not fit the log. Those of a "
      "maker are seldom identified ones: compare with --without, a log of the same arm without the payload");
}

// The sentence on the file's numbers, which the logs do not tell.
std::string file_text(const FittedPayload& found) {
  if (!found.is_by_file) return "";
  return "\nThe robot file's numbers count as exact; a log of the same arm without payload takes their place "
         "(--without).\n";
}

// The reason why the logs do not determine something of the payload, and what would.
std::string reason_of_untold(const Mechanism& mechanism, const FittedPayload& found) {
  if (found.is_of_wrist()) return "the sensor's forces hardly change; move the tip faster, or turn it against gravity";
  const std::string lacking = logs_without_base_force(mechanism, found);
  if (lacking.empty()) return "nothing that was measured depends on it, or the motion does not show it";
  return lacking +
         " has the force on the base, base_fx to base_nz, which tells it: zeros, if nothing touches the robot";
}

// Reports a mass that the logs do not determine: a robot file has to have one.
void doubt_mass(const Mechanism& mechanism, const FittedPayload& found, std::vector<std::string>& warning_texts) {
  if (std::isfinite(found.payload.standard_deviations(0))) return;
  warning_texts.push_back(fmt::format(
      "the logs do not tell the payload's mass: {}; the nearest body has one that agrees with what they tell",
      reason_of_untold(mechanism, found)));
}

}  // namespace

void require_told(const LoadedRobot& robot, const FittedPayload& found) {
  if (found.payload.untold.cols() < kInertialPerBody) return;
  throw Failure(
      FailureKind::input, fmt::format("the logs tell nothing of what link \"{}\" carries", robot.mechanism.tip.link),
      fmt::format("--tip names the link that carries the payload; {}", reason_of_untold(robot.mechanism, found)));
}

std::vector<std::string> plausibility_warnings(const LoadedRobot& robot, const FittedPayload& found,
                                               const std::string& hint) {
  constexpr double kMuch = 5, kClearly = 3;  // standard deviations
  const PayloadEstimate& payload = found.payload;
  std::vector<std::string> warning_texts;
  doubt_base(robot.mechanism, found, warning_texts);
  doubt_fit(robot.mechanism, found, warning_texts);
  if (payload.largest_misfit > kMuch) {
    warning_texts.push_back(fmt::format(
        "the nearest body is {:.2g} standard deviations from the estimate, more than noise explains: motion, torques "
        "or forces, units or geometry cannot be right",
        payload.largest_misfit));
  }
  if (payload.values(0) < -kClearly * payload.standard_deviations(0)) {
    warning_texts.push_back("the mass is negative: " + hint);
  }
  doubt_mass(robot.mechanism, found, warning_texts);
  return warning_texts;
}

std::string describe_payload(const LoadedRobot& robot, const FittedPayload& found) {
  const PayloadEstimate& payload = found.payload;
  std::vector<std::vector<std::string>> rows = {{"payload", "value", "std dev", "nearest body", "unit"}};
  for (Eigen::Index k = 0; k < payload.values.size(); ++k) {
    const bool is_told = std::isfinite(payload.standard_deviations(k));
    rows.push_back({kNames[k], is_told ? fmt::format("{:.6g}", payload.values(k)) : "",
                    !is_told || found.has_deviations() ? deviation_text(payload.standard_deviations(k)) : "?",
                    fmt::format("{:.6g}", payload.body(k)), kUnits[k]});
  }
  return fmt::format(
      "on link {}, in its frame, about its origin\n\n{}\nthe nearest that a body can have is {:.2g} standard "
      "deviations from the estimate at most\n{}{}{}",
      robot.mechanism.tip.link, aligned_table(rows), payload.largest_misfit, file_text(found),
      untold_sums_text(robot.mechanism, found), fit_table(robot.mechanism, found));
}

nlohmann::ordered_json payload_json(const LoadedRobot& robot, const FittedPayload& found) {
  const PayloadEstimate& payload = found.payload;
  nlohmann::ordered_json json = {{"link", robot.mechanism.tip.link}};
  for (Eigen::Index k = 0; k < payload.values.size(); ++k) {
    json["parameters"].push_back(
        {{"name", kNames[k]},
         {"unit", kUnits[k]},
         {"value", payload.values(k)},
         {"standard_deviation", found.has_deviations() ? payload.standard_deviations(k) : std::nan("")},
         {"nearest_body", payload.body(k)}});
  }
  json["largest_misfit"] = payload.largest_misfit;
  json["untold"] = nlohmann::ordered_json::array();
  for (const auto& direction : payload.untold.colwise()) json["untold"].push_back(list(direction));
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    json["equations"].push_back({{"name", equation_name(robot.mechanism, i)},
                                 {"rms_torque", found.observations.joints[i].rms_torque()},
                                 {"rms_residual", found.observations.joints[i].rms_residual(payload.unknowns)},
                                 {"rows", found.observations.joints[i].rows},
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
