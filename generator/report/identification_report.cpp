// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/identification_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <tuple>

#include "laboratory/identify/gravity_search.hpp"
#include "report/combination_table.hpp"
#include "report/estimate_text.hpp"
#include "report/fields.hpp"
#include "report/numbers.hpp"

namespace flatdyn {
namespace {

constexpr double kRepeated = 1.05;  // times that a motion is logged: more than once

std::string filter_text(const SampleFilter& filter) {
  if (filter.band == 0) return "no filter";
  return fmt::format("zero-phase filter, band {:.4g} Hz, every sample of {}", filter.band, filter.decimate);
}

std::string data_text(const Measurement& measurement, const NonlinearUnknowns& unknowns) {
  std::string text = fmt::format("{} samples, {} used", measurement.count.lines, measurement.count.used);
  const std::vector<SampleFilter> filters = measurement.filters();
  const bool is_one = filters.size() == 1;
  for (const SampleFilter& filter : filters) {
    if (!is_one || filter.band > 0) text += (is_one ? "; " : "; of some logs ") + filter_text(filter);
  }
  if (measurement.count.interpolated > 0) {
    text += fmt::format("; {} missing samples interpolated", measurement.count.interpolated);
  }
  if (unknowns.delay != 0) {
    text += fmt::format("; torques taken {:.2f} ms later than the positions", 1000 * unknowns.delay);
    if (!std::isnan(unknowns.delay_deviation)) {
      text += fmt::format(" (std dev {:.2g} ms)", 1000 * unknowns.delay_deviation);
    }
  }
  if (measurement.count.gaps > 0) text += fmt::format("; {} gaps in time", measurement.count.gaps);
  return text + "\n";
}

// The parameter that compensation for noise of positions changes most, and by how many standard deviations.
struct LargestCompensation {
  Eigen::Index parameter = 0;
  double deviations = 0;
};

std::optional<LargestCompensation> largest_compensation(const Estimate& estimate) {
  if (estimate.compensation.size() == 0) return std::nullopt;
  LargestCompensation result;
  for (Eigen::Index k = 0; k < estimate.compensation.size(); ++k) {
    const double own = std::abs(estimate.compensation[k]) / estimate.standard_deviations[k];
    if (own > result.deviations) result = {k, own};
  }
  return result;
}

std::string compensation_text(const TorqueEquations& equations, const Estimate& estimate) {
  const std::optional<LargestCompensation> largest = largest_compensation(estimate);
  if (!largest || largest->deviations == 0) return "";
  const std::string most = fmt::format("{:.2g} standard deviations at most ({})", largest->deviations,
                                       equations.names()[static_cast<std::size_t>(largest->parameter)]);
  if (estimate.is_compensated) {
    return fmt::format("Noise of positions is compensated; without that, parameters would differ by {}.\n", most);
  }
  const std::string reason =
      estimate.growth > 1
          ? fmt::format(", and make residuals up to {:.2g} times as large, so that it is no noise", estimate.growth)
          : "";
  return fmt::format("Noise of positions is not compensated; that would change parameters by {}{}.\n", most, reason);
}

// The sentence on motions that are logged more than once: what the model lacks repeats with them.
std::string repetition_text(const Measurement& measurement, const Estimate& estimate) {
  std::string text;
  for (const RepeatedMotion& motion : estimate.motions) {
    if (motion.count < kRepeated) continue;
    const SampleFilter& filter = measurement.logs[static_cast<std::size_t>(motion.log)].filter;
    text += fmt::format(
        "A motion of {:.3g} s is logged {:.3g} times: what repeats with it does not average out, and counts "
        "so in the standard deviations.\n",
        motion.period * filter.dt * filter.decimate, motion.count);
  }
  return text;
}

// How the parameters do in one equation of some logs.
struct EquationFit {
  std::string name;
  double torque, residual, residual_of_links;  // rms, N m or N
  JointFit fit;
  long rows;
  double share;                      // rows by all samples that are used
  double rest_speed = 0, sigma = 0;  // rad/s or m/s, N m or N: of the logs that the parameters come from

  // Null without rows.
  nlohmann::ordered_json percent_explained() const {
    const double part = torque > 0 ? residual / torque : 0;
    return rows > 0 ? nlohmann::ordered_json(100 * (1 - part * part)) : nlohmann::ordered_json();
  }
};

std::vector<EquationFit> fits_in(const Measurement& measurement, const std::vector<JointFit>& fits,
                                 const TorqueModel& model, const Identification& found) {
  const Eigen::VectorXd of_links = found.physical_values();
  std::vector<EquationFit> all;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const JointObservations& joint = measurement.observations.joints[i];
    all.push_back({model.name_of(static_cast<int>(i)), joint.rms_torque(), joint.rms_residual(found.estimate.values),
                   joint.rms_residual(of_links), fits[i], joint.rows,
                   static_cast<double>(joint.rows) / static_cast<double>(measurement.count.used)});
  }
  return all;
}

std::vector<EquationFit> fits_of_estimate(const TorqueModel& model, const Identification& found) {
  std::vector<EquationFit> all = fits_in(found.measurement, found.fits, model, found);
  const std::vector<double> rest_speeds = found.measurement.rest_speeds();
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].rest_speed = rest_speeds[i];
    all[i].sigma = found.estimate.torque_deviations(static_cast<Eigen::Index>(i));
  }
  return all;
}

// The fields of the logs that the parameters come from, or of those that they are judged by.
ReportFields<EquationFit> equation_fields(bool is_validation) {
  return {{is_validation ? "validation" : "joint", "name", &EquationFit::name},
          {"torque (rms)", "rms_torque", &EquationFit::torque, "{:.4g}"},
          {"residual (rms)", "rms_residual", &EquationFit::residual, "{:.3g}"},
          {"explained", "", &EquationFit::percent_explained, "{:.4g} %"},
          {"noise ratio", "noise_ratio", [](auto& each) { return each.fit.ratio; }, "{:.3g}"},
          {"correlation", "residual_correlation", [](auto& each) { return each.fit.correlation; }, "{:.2f}"},
          {is_validation ? "of the links" : "residual of the links", "rms_residual_of_links",
           &EquationFit::residual_of_links, "{:.3g}"},
          {is_validation ? "" : "rests below", "", &EquationFit::rest_speed, "{:.2g}"},
          {"used", "", [](auto& each) { return 100 * each.share; }, "{:.3g} %"},
          {"", "rows", &EquationFit::rows},
          {"", is_validation ? "" : "sigma", &EquationFit::sigma}};
}

// Without the equations of a floating base's force where the logs lack it.
std::string equation_table(const TorqueModel& model, const Measurement& measurement, std::vector<EquationFit> fits,
                           bool is_validation) {
  fits.erase(fits.begin(), fits.begin() + first_equation(model, measurement.observations));
  return table_of(equation_fields(is_validation), fits);
}

// Ripple that does no harm.
std::string ripple_text(const TorqueModel& model, const Identification& found) {
  if (found.fast_ripples.empty()) return "";
  std::string text = "Ripple that is faster than the band does no harm, as the filter takes it away:\n";
  for (const auto& [equation, line] : found.fast_ripples) {
    text +=
        fmt::format("  {}: a sine of {:.3g} {} that repeats {:.4g} times in a {} ({:.2g} of the squares taken away)\n",
                    model.name_of(equation), line.amplitude, model.unit_of(equation), line.rate,
                    model.mechanism().joint(equation).prismatic ? "metre" : "turn", line.share);
  }
  return text;
}

std::string fit_text(const TorqueModel& model, const Identification& found) {
  return equation_table(model, found.measurement, fits_of_estimate(model, found), false) +
         "noise ratio: residual to what the noise above the filter's band leaves; correlation: of residuals one row "
         "apart.\nSound: a ratio below 1.5, or below 4 with a correlation below 0.5. Rests below: rad/s or m/s. Used: "
         "share of rows.\n" +
         ripple_text(model, found);
}

// The meaning of a parameter behind π_b.
std::string meaning_of(const TorqueEquations& equations, const std::string& name) {
  const char* const of_law = equations.further().law == FrictionLaw::asymmetric
                                 ? "half of what Coulomb friction forwards has more than backwards"
                                 : "what friction near rest has more than F_s";
  if (name.starts_with("FvT")) return "change of F_v per kelvin";
  if (name.starts_with("FsT")) return "change of F_s per kelvin";
  if (name.front() == 'c') return "friction of a load, as a share of it";
  if (name.starts_with("kq")) return "stiffness of the joint's spring times the position where it is relaxed";
  if (name.front() == 'k') return "stiffness of the joint's spring";
  return name.front() == 'o' ? "added to all torques of the joint" : of_law;
}

// The speeds of a friction law that has them.
std::string speeds_text(const TorqueEquations& equations, const NonlinearUnknowns& unknowns) {
  if (!has_speed(equations.further().law)) return "";
  const char* const law = equations.further().law == FrictionLaw::smooth
                              ? "friction is F_v qd + F_s tanh(qd/v)"
                              : "friction is F_v qd + (F_s + F_b exp(-(qd/v)^2)) sgn qd";
  std::string text = fmt::format("{}, with v in rad/s or m/s, by joint (and its std dev):", law);
  const std::vector<double>& speeds = equations.further().speeds;
  for (auto i = static_cast<std::size_t>(equations.model().first_joint()); i < speeds.size(); ++i) {
    text += fmt::format(" {:.3g}", speeds[i]);
    if (i < unknowns.speed_deviations.size() && std::isfinite(unknowns.speed_deviations[i])) {
      text += fmt::format(" ({:.2g})", unknowns.speed_deviations[i]);
    }
  }
  return text + "\n";
}

// The drives whose load has a rotor in it that it may lack.
std::string load_text(const TorqueEquations& equations) {
  std::vector<std::string> names;
  for (const int i : equations.carried_rotors()) names.push_back(equations.name_of("c", i));
  if (names.empty()) return "";
  return fmt::format(
      "{}: the rotor counts as carried, as nothing tells it from the link; where the robot file has it (armature), it "
      "does not\n",
      fmt::join(names, ", "));
}

std::string temperature_text(const FurtherParameters& further) {
  return further.temperature ? fmt::format("F_v and F_s are those at {:.6g} degrees Celsius\n", *further.temperature)
                             : "";
}

Eigen::Vector3d deviations_of(const FoundGravity& gravity) { return gravity.covariance.diagonal().cwiseSqrt(); }

std::string gravity_text(const NonlinearUnknowns& unknowns) {
  if (!unknowns.gravity) return "";
  const Eigen::Vector3d &g = unknowns.gravity->gravity, deviation = deviations_of(*unknowns.gravity);
  const std::string exact = ", which counts as exact\n";
  return fmt::format("gravity is [{:.6g}, {:.6g}, {:.6g}] m/s^2 in the base frame", g.x(), g.y(), g.z()) +
         (deviation.hasNaN()
              ? exact
              : fmt::format(", std dev [{:.2g}, {:.2g}, {:.2g}]\n", deviation.x(), deviation.y(), deviation.z()));
}

// The place of k and k q_0 of the first spring, where they are parameters.
int first_spring(const TorqueEquations& equations) {
  return equations.parameters() - equations.corrections() - equations.static_parameters();
}

// A row of the table of parameters, before the combination.
std::vector<std::string> parameter_cells(const TorqueEquations& equations, const Identification& found, int k) {
  const int base = equations.model().parameters();
  const double value = found.estimate.values(k), deviation = found.estimate.standard_deviations(k);
  const bool has_share = k < base && value != 0 && std::isfinite(deviation);
  std::vector<std::string> cells = {equations.names()[static_cast<std::size_t>(k)], fmt::format("{:.6g}", value),
                                    deviation_text(deviation),
                                    has_share ? fmt::format("{:.2g} %", 100 * deviation / std::abs(value)) : ""};
  if (found.joint_by_joint) cells.push_back(fmt::format("{:.6g}", (*found.joint_by_joint)(k)));
  const bool is_in_file = k < base || (equations.further().springs && k >= first_spring(equations));
  cells.push_back(is_in_file ? fmt::format("{:.6g}", equations.file_values()(k)) : "");
  return cells;
}

std::string parameter_table(const TorqueEquations& equations, const Identification& found, ParameterFrames frames) {
  const TorqueModel& model = equations.model();
  std::vector<std::string> heading = {"pi_b", "value", "std dev", "relative", "file"};
  if (found.joint_by_joint) heading.insert(heading.begin() + 4, "joint by joint");
  std::vector<CombinationRow> rows;
  for (int k = 0; k < equations.parameters() - equations.corrections(); ++k) {
    rows.push_back(
        {k, parameter_cells(equations, found, k),
         k < model.parameters() ? "" : meaning_of(equations, equations.names()[static_cast<std::size_t>(k)])});
  }
  const Combinations combinations(model.mechanism(), model.base(), frames);
  return combination_table(heading, rows, combinations) + note_on_frames(model.mechanism(), frames) +
         note_on_names(model.mechanism(), frames) + speeds_text(equations, found.unknowns) +
         temperature_text(equations.further()) + load_text(equations) + gravity_text(found.unknowns);
}

std::string physical_text(const PhysicalParameters& physical) {
  return fmt::format(
      "\nnearest links that a body can have: {:.2g} standard deviations from pi_b at most{}\n"
      "divergence from the file's links: {:.2g} (0: the same; a link that is twice as heavy counts 1.2)\n",
      physical.largest_misfit, physical.converged ? "" : "; the search did not converge", physical.divergence);
}

// The further parameters that go with the links, where they are others than those that go with π_b.
std::string further_of_links_text(const TorqueEquations& equations, const Identification& found) {
  constexpr double kMuch = 1;  // standard deviations
  const Eigen::VectorXd of_links = found.physical_values();
  std::string others;
  for (int k = equations.model().parameters(); k < equations.parameters() - equations.corrections(); ++k) {
    const double change = std::abs(of_links(k) - found.estimate.values(k)),
                 deviation = std::sqrt(found.estimate.covariance(k, k));
    const bool is_told = std::isfinite(found.estimate.standard_deviations(k));
    if (is_told ? change < kMuch * deviation : change < 1e-6 * std::abs(of_links(k))) continue;
    others += fmt::format(" {} {:.6g}", equations.names()[static_cast<std::size_t>(k)], of_links(k));
  }
  if (others.empty()) return "";
  return "with these links, other further parameters fit the log than with pi_b:" + others + "\n";
}

// The residual of an equation in other logs, as a multiple of the one before. Where other things measure the
// motion, what noise makes of residuals differs, and residuals are compared with that.
double validation_ratio(const Identification& found, std::size_t i) {
  const double before = found.measurement.observations.joints[i].rms_residual(found.estimate.values);
  const double now = found.validation->observations.joints[i].rms_residual(found.estimate.values);
  if (!(before > 0)) return 0;
  const bool is_alike =
      found.measurement.logs.front().differentiations == found.validation->logs.front().differentiations;
  const double ratio = now / before;
  return is_alike ? ratio : std::min(ratio, found.validation_fits[i].ratio / found.fits[i].ratio);
}

// The equation whose residuals grow most on other logs, and by how much; those of which nothing can be said, and
// whether the log that the parameters come from lacks them. Residuals that are a small part of the torque do not count.
struct ValidationVerdict {
  static constexpr double kMuch = 1.5;  // times
  double worst = 0;
  bool has_small = false;  // whether some residuals grow by more, but are a small part of the torque
  std::size_t equation = 0;
  std::vector<std::string> not_judged;
};

constexpr double kSmallPart = 0.02;  // of a joint's torque (rms)

bool is_small_part(const JointObservations& joint, const Eigen::VectorXd& values) {
  return joint.rms_residual(values) < kSmallPart * joint.rms_torque();
}

ValidationVerdict verdict_of(const TorqueModel& model, const Identification& found) {
  ValidationVerdict verdict;
  for (std::size_t i = 0; i < found.validation_fits.size(); ++i) {
    const bool is_in_both =
        found.validation->observations.joints[i].rows > 0 && found.measurement.observations.joints[i].rows > 0;
    if (is_in_both) {
      const double ratio = validation_ratio(found, i);
      const bool is_small = is_small_part(found.validation->observations.joints[i], found.estimate.values);
      verdict.has_small |= is_small && ratio >= ValidationVerdict::kMuch;
      if (is_small && ratio >= ValidationVerdict::kMuch) continue;
      if (ratio > verdict.worst) std::tie(verdict.worst, verdict.equation) = std::pair(ratio, i);
    } else if (static_cast<int>(i) >= first_equation(model, found.validation->observations)) {
      verdict.not_judged.push_back(model.name_of(static_cast<int>(i)));
    }
  }
  return verdict;
}

std::string verdict_text(const TorqueModel& model, const Identification& found) {
  const ValidationVerdict verdict = verdict_of(model, found);
  const auto equation = static_cast<int>(verdict.equation);
  std::string text;
  if (found.is_starved() || (!(verdict.worst > 0) && !verdict.has_small)) {
    text = "Nothing can be said of whether the parameters hold for this motion: there are too few equations.\n";
  } else if (!(verdict.worst > 0)) {
    text = fmt::format("The parameters hold for other motions: residuals are at most {:.2g} % of the torque.\n",
                       100 * kSmallPart);
  } else {
    text = fmt::format("{} {:.2g} times those of the log that the parameters come from ({}{}){}.\n",
                       verdict.worst < ValidationVerdict::kMuch
                           ? "The parameters hold for other motions: residuals are at most"
                           : "The parameters do not hold for this motion: residuals are up to",
                       verdict.worst, equation < model.first_joint() ? "" : "joint ", model.name_of(equation),
                       verdict.has_small ? fmt::format(", or {:.2g} % of the torque", 100 * kSmallPart) : "");
  }
  if (!verdict.not_judged.empty()) {
    text +=
        fmt::format("Not judged, as one of the logs has no rows of them: {}.\n", fmt::join(verdict.not_judged, ", "));
  }
  return text;
}

// How the parameters do on other logs, in a table and a sentence.
std::string validation_text(const TorqueModel& model, const Identification& found) {
  if (!found.validation) return "";
  const Measurement& judged = *found.validation;
  return "\n" + equation_table(model, judged, fits_in(judged, found.validation_fits, model, found), true) +
         verdict_text(model, found);
}

}  // namespace

std::string describe_identification(const TorqueEquations& equations, const Identification& found,
                                    ParameterFrames frames) {
  const TorqueModel& model = equations.model();
  const Estimate& estimate = found.estimate;
  return data_text(found.measurement, found.unknowns) + "\n" + fit_text(model, found) +
         repetition_text(found.measurement, estimate) + compensation_text(equations, estimate) + "\n" +
         parameter_table(equations, found, frames) + conditioning_text(estimate) +
         untold_text(equations, estimate, first_equation(model, found.measurement.observations) > 0) +
         physical_text(found.physical) + further_of_links_text(equations, found) + validation_text(model, found);
}

namespace {

// Without the entries of a floating base.
std::vector<double> of_joints(const TorqueModel& model, const std::vector<double>& by_equation) {
  if (by_equation.empty()) return {};
  return {by_equation.begin() + model.first_joint(), by_equation.end()};
}

void add_parameters(const TorqueEquations& equations, const Identification& found, ParameterFrames frames,
                    nlohmann::ordered_json& json) {
  const TorqueModel& model = equations.model();
  const Estimate& estimate = found.estimate;
  const Combinations canonical(model.mechanism(), model.base(), ParameterFrames::canonical);
  const Combinations in_file(model.mechanism(), model.base(), ParameterFrames::file);
  json["frames"] = name_of(frames);
  for (int k = 0; k < model.parameters(); ++k) {
    json["base_parameters"].push_back({{"kept", equations.names()[static_cast<std::size_t>(k)]},
                                       {"combination", canonical.text(k, kJsonDigits)},
                                       {"value", estimate.values(k)},
                                       {"standard_deviation", estimate.standard_deviations(k)},
                                       {"file", model.file_values()[static_cast<std::size_t>(k)]}});
    nlohmann::ordered_json& parameter = json["base_parameters"].back();
    if (frames == ParameterFrames::file) parameter["file_combination"] = in_file.text(k, kJsonDigits);
    if (found.joint_by_joint) parameter["joint_by_joint"] = (*found.joint_by_joint)(k);
  }
  json["further_parameters"] = nlohmann::ordered_json::array();
  const Eigen::VectorXd of_links = found.physical_values();
  for (int k = model.parameters(); k < equations.parameters() - equations.corrections(); ++k) {
    json["further_parameters"].push_back({{"name", equations.names()[static_cast<std::size_t>(k)]},
                                          {"value", estimate.values(k)},
                                          {"standard_deviation", estimate.standard_deviations(k)},
                                          {"value_with_links", of_links(k)}});
  }
  const NonlinearUnknowns& unknowns = found.unknowns;
  json["friction_speeds"] = of_joints(model, equations.further().speeds);
  json["friction_speed_deviations"] = of_joints(model, unknowns.speed_deviations);
  json["temperature"] = equations.further().temperature ? nlohmann::ordered_json(*equations.further().temperature)
                                                        : nlohmann::ordered_json();
  json["delay"] = unknowns.delay;
  json["delay_deviation"] = unknowns.delay_deviation;
  if (!unknowns.gravity) return;
  json["gravity"] = {{"value", list(unknowns.gravity->gravity)},
                     {"standard_deviation", list(deviations_of(*unknowns.gravity))},
                     {"not_told", nlohmann::ordered_json::array()}};
  for (const Eigen::Vector3d& each : untold_directions(unknowns.gravity->told)) {
    json["gravity"]["not_told"].push_back(list(each));
  }
}

}  // namespace

nlohmann::ordered_json identification_json(const TorqueEquations& equations, const Identification& found,
                                           ParameterFrames frames) {
  const TorqueModel& model = equations.model();
  const Estimate& estimate = found.estimate;
  nlohmann::ordered_json json = {{"samples", found.measurement.count.lines},
                                 {"used", found.measurement.count.used},
                                 {"gaps", found.measurement.count.gaps},
                                 {"interpolated", found.measurement.count.interpolated}};
  for (const MeasuredLog& log : found.measurement.logs) {
    json["logs"].push_back({{"name", log.identity.name},
                            {"filter_band", log.filter.band},
                            {"decimation", log.filter.decimate},
                            {"rest_speed", log.rest_speed}});
  }
  json["joints"] = objects_of(equation_fields(false), fits_of_estimate(model, found));
  add_parameters(equations, found, frames, json);
  if (const std::optional<LargestCompensation> largest = largest_compensation(estimate)) {
    json["compensation"] = {{"used", estimate.is_compensated},
                            {"parameter", equations.names()[static_cast<std::size_t>(largest->parameter)]},
                            {"standard_deviations", largest->deviations}};
  }
  json["fast_ripple"] = nlohmann::ordered_json::array();
  for (const auto& [equation, line] : found.fast_ripples) {
    json["fast_ripple"].push_back({{"joint", model.name_of(equation)},
                                   {"amplitude", line.amplitude},
                                   {"periods", line.rate},
                                   {"share", line.share}});
  }
  json["motions"] = nlohmann::ordered_json::array();
  for (const RepeatedMotion& motion : estimate.motions) {
    const SampleFilter& filter = found.measurement.logs[static_cast<std::size_t>(motion.log)].filter;
    json["motions"].push_back({{"seconds", motion.period * filter.dt * filter.decimate}, {"count", motion.count}});
  }
  json["singular_values"] = list(estimate.singular_values);
  json["condition_number"] = estimate.condition();
  json["weights"] = {{"stable", estimate.converged}, {"iterations", estimate.iterations}};
  json["physical"] = {{"pi", found.physical.pi},
                      {"largest_misfit", found.physical.largest_misfit},
                      {"divergence", found.physical.divergence},
                      {"converged", found.physical.converged}};
  if (found.hypothesis) {
    json["hypothesis"] = {{"text", found.hypothesis->text}, {"explained", found.hypothesis->explained}};
  }
  if (found.validation) {
    json["validation"] =
        objects_of(equation_fields(true), fits_in(*found.validation, found.validation_fits, model, found));
  }
  json["doubts"] = found.warning_texts;
  json["damped"] = json["hidden"] = nlohmann::ordered_json::array();
  for (const auto& [singular_value, components] : estimate.damped) {
    json["damped"].push_back({{"relative_singular_value", singular_value}, {"components", list(components)}});
  }
  for (const auto& [deviation, components] : estimate.hidden) {
    json["hidden"].push_back({{"standard_deviation", deviation}, {"components", list(components)}});
  }
  return json;
}

}  // namespace flatdyn
