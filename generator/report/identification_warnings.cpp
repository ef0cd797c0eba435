// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laboratory/identify/gravity_search.hpp"
#include "laboratory/identify/residual_lines.hpp"
#include "report/base_warnings.hpp"
#include "report/identification_report.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

double largest_rms_torque(const Identification& found) {
  double largest = 0;
  for (const JointObservations& joint : found.measurement.observations.joints) {
    largest = std::max(largest, joint.rms_torque());
  }
  return largest;
}

// Reports joints whose torque the model hardly explains, unless that is noise of a joint that barely moves. Such a
// joint gets little weight, so the others' residuals do not show it.
void warn_of_joints(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  constexpr double kHalf = 0.5, kNoise = 0.05;  // share of the joint's torque, squared; share of the largest torque
  const std::vector<JointObservations>& joints = found.measurement.observations.joints;
  const double largest = largest_rms_torque(found);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double torque = joints[i].rms_torque(), residual = joints[i].rms_residual(found.estimate.values);
    if (joints[i].rows == 0 || torque == 0) continue;
    if (residual * residual < kHalf * torque * torque || residual < kNoise * largest) continue;
    warning_texts.push_back(
        fmt::format("{}: the model leaves {:.3g} of {:.3g} {} (rms); units, signs or delays of the log, or the robot's "
                    "geometry, can hardly be right",
                    model.subject_of(static_cast<int>(i)), residual, torque, model.unit_of(static_cast<int>(i))));
  }
}

// Reports joints whose rows are all left out, although their torques change: they may have moved.
void warn_of_frozen(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  for (int equation = model.first_joint(); equation < model.equations(); ++equation) {
    const auto i = static_cast<std::size_t>(equation);
    const Body& body = model.mechanism().joint(equation);
    const JointObservations& joint = found.measurement.observations.joints[i];
    if (joint.rows > 0) continue;
    if (joint.left_out > 0) {
      warning_texts.push_back(
          fmt::format("joint \"{}\" moves at only {} of {} instants, too few to tell their noise by: it counts as one "
                      "that stands still, and its friction and rotor keep the robot file's values; log a motion in "
                      "which it moves for longer, or faster than {:.2g} {}",
                      body.joint, joint.left_out, found.measurement.count.used, found.measurement.rest_speeds()[i],
                      body.prismatic ? "m/s" : "rad/s"));
      continue;
    }
    warning_texts.push_back(
        fmt::format("joint \"{}\" stands still in all of the log: its friction and rotor keep the robot file's values; "
                    "if it moved, "
                    "its encoder is frozen",
                    body.joint));
  }
}

// Parameters, determined by the data (`told`) or not, of whose uncertainty more than a share comes from directions with
// so much noise of positions.
std::vector<std::string> parameters_in_noise(const TorqueModel& model, const Estimate& estimate, double least,
                                             bool told, double share) {
  std::vector<std::string> names;
  for (int k = 0; k < model.parameters(); ++k) {
    if (std::isfinite(estimate.standard_deviations(k)) != told) continue;
    double noisy = 0, all = 0;
    for (const NoisyDirection& each : estimate.noisy) {
      const double square = std::pow(each.components(k), 2);
      all += square;
      if (each.share >= least) noisy += square;
    }
    if (noisy > share * all) names.push_back(model.parameter_name_of(k));
  }
  return names;
}

std::string some_of(std::vector<std::string> names) {
  constexpr std::size_t kMost = 8;
  const std::size_t count = names.size();
  if (count <= kMost) return fmt::format("{}", fmt::join(names, ", "));
  names.resize(kMost);
  return fmt::format("{} and {} more", fmt::join(names, ", "), count - kMost);
}

// Reports parameters for which noise of positions is a considerable share of the motion's information on them.
void warn_of_noise_in_q(const TorqueModel& model, const Estimate& estimate, std::vector<std::string>& warning_texts) {
  constexpr double kConsiderable = 0.25;
  constexpr const char* kRemedy = "a faster or larger motion tells more of them, and a lower --band may do so, too";
  const std::vector<std::string> open = parameters_in_noise(model, estimate, NoisyDirection::kMost, false, 0.01);
  if (!open.empty()) {
    warning_texts.push_back(
        fmt::format("noise in q is most of what the motion seems to tell of {}, so that it does not tell them; {}",
                    some_of(open), kRemedy));
  }
  const std::vector<std::string> noisy = parameters_in_noise(model, estimate, kConsiderable, true, 0.5);
  if (!noisy.empty()) {
    warning_texts.push_back(
        fmt::format("noise in q is a considerable share of what the motion tells of {}; it is taken off, and their "
                    "intervals are wider; {}",
                    some_of(noisy), kRemedy));
  }
}

// Whether residuals have a reason, or are so large that links near the parameters say nothing.
bool is_gross(const Identification& found) {
  constexpr double kGross = 10;  // times the noise
  return found.hypothesis.has_value() || std::any_of(found.fits.begin(), found.fits.end(), [](const JointFit& fit) {
           return !fit.is_sound() && fit.ratio > kGross;
         });
}

// Reports residuals that are no noise, and the reason that explains them, where there is one.
void warn_of_fit(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  std::vector<std::string> bad;
  for (int i = 0; i < model.equations(); ++i) {
    const JointFit& fit = found.fits[static_cast<std::size_t>(i)];
    if (fit.is_sound()) continue;
    bad.push_back(fmt::format("{} {:.3g}", model.name_of(i), fit.ratio));
    if (!fit.limit) continue;
    warning_texts.push_back(fmt::format("{}: its torques look cut off at {:.3g} {}; leave such times out",
                                        model.subject_of(i), *fit.limit, model.unit_of(i)));
  }
  if (found.hypothesis) {
    warning_texts.push_back(found.hypothesis->text);
    if (found.hypothesis->explained > 0) {
      warning_texts.back() +=
          fmt::format("; that explains {:.0f} % of what noise does not", 100 * found.hypothesis->explained);
    }
  }
  if (bad.empty()) return;
  warning_texts.push_back(
      fmt::format("the model does not fit: residuals to the noise of the log: {}{}{}", fmt::join(bad, ", "),
                  found.measurement.count.lost > 0
                      ? "; readings that were lost make such residuals: cut these times out of the log first"
                  : found.hypothesis
                      ? ""
                      : "; the model may lack friction or rotors (--parameters full), another law of friction "
                        "(--friction), ripple or flexibility; the torques may have noise or vibration that is slower "
                        "than the band, which intervals take account of; the log may have been filtered before, which "
                        "takes the noise away that residuals are compared with; or columns, units or times of the log "
                        "are not what they say",
                  found.hypothesis ? "" : imu_question(found.measurement.logs)));
}

// Reports joints whose residuals are steps of the encoder.
void warn_of_coarse_steps(const TorqueModel& model, const Identification& found,
                          std::vector<std::string>& warning_texts) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    if (found.fits[i].is_of_coarse_steps()) names.push_back(model.name_of(static_cast<int>(i)));
  }
  if (names.empty()) return;
  warning_texts.push_back(
      fmt::format("the encoders' steps are most of what is left of the torques of {}; rounding is not white noise, so "
                  "that intervals may be too narrow: a lower --band, --estimator iv or a faster motion has less of it",
                  some_of(names)));
}

// The joint that a parameter belongs to, or the link of a floating base.
std::string owner_of(const TorqueModel& model, int k) {
  const Body& body = model.body_of_parameter(k);
  const bool is_of_base = joint_of(model.base().columns[static_cast<std::size_t>(k)]) < model.first_joint();
  return is_of_base ? "link " + body.link : joint_name(body);
}

// Reports friction, rotors and masses that are clearly negative, which no joint has. A base parameter that is named for
// a mass may be a difference of masses: it counts where the robot file's is positive.
void warn_of_signs(const TorqueModel& model, const Estimate& estimate, std::vector<std::string>& warning_texts) {
  constexpr double kClearly = 5;        // standard deviations
  constexpr double kOfRounding = 1e-9;  // of the largest parameter: logs without noise leave no deviation
  const double least = kOfRounding * estimate.values.head(model.parameters()).cwiseAbs().maxCoeff();
  std::vector<std::string> names;
  for (int k = 0; k < model.parameters(); ++k) {
    if (std::abs(estimate.values(k)) < least) continue;
    const int index = model.base().columns[static_cast<std::size_t>(k)];
    const bool is_inertial = static_cast<int>(parameter_of(index)) < kInertialPerBody;
    const bool is_mass = parameter_of(index) == Parameter::m && model.file_values()[static_cast<std::size_t>(k)] > 0;
    if (is_inertial && !is_mass) continue;
    if (estimate.values(k) > -kClearly * estimate.standard_deviations(k)) continue;
    names.push_back(fmt::format("{} ({})", model.parameter_name_of(k), owner_of(model, k)));
  }
  if (names.empty()) return;
  warning_texts.push_back(
      fmt::format("negative, which no friction, no rotor and no mass can be: {}; the sign of that joint's torques or "
                  "positions is reversed, gravity points elsewhere, or the model lacks something",
                  fmt::join(names, ", ")));
}

// Reports masses that are far larger or smaller than the file's.
void warn_of_scale(const TorqueModel& model, const Estimate& estimate, std::vector<std::string>& warning_texts) {
  constexpr double kFar = 5, kAlike = 0.8;  // factor; correlation
  constexpr double kUnsure = 0.3;           // standard deviation, a share of the parameter
  double of_file = 0, of_both = 0, of_found = 0;
  for (int k = 0; k < model.parameters(); ++k) {
    const int index = model.base().columns[static_cast<std::size_t>(k)];
    const double deviation = estimate.standard_deviations(k);
    const double file = model.file_values()[static_cast<std::size_t>(k)];
    if (static_cast<int>(parameter_of(index)) >= kInertialPerBody || !std::isfinite(deviation)) continue;
    if (deviation > kUnsure * std::max(std::abs(file), std::abs(estimate.values(k)))) continue;
    of_file += file * file;
    of_both += file * estimate.values(k);
    of_found += estimate.values(k) * estimate.values(k);
  }
  const double scale = of_file > 0 ? of_both / of_file : 1;
  const bool is_alike = of_both * of_both > kAlike * kAlike * of_file * of_found;
  if (!is_alike || scale <= 0 || (scale < kFar && scale > 1 / kFar)) return;
  warning_texts.push_back(fmt::format(
      "masses look {:.3g} times {} than the robot file's; torques of motors before their gears, or another unit?",
      scale > 1 ? scale : 1 / scale, scale > 1 ? "larger" : "smaller"));
}

// Reports base parameters of implausible size, caused by wrong units or by directions that are hardly determined but
// not damped.
void warn_of_sizes(const TorqueModel& model, const Estimate& estimate, std::vector<std::string>& warning_texts) {
  constexpr double kMuch = 100;
  double largest = 0;
  for (const double value : model.file_values()) largest = std::max(largest, std::abs(value));
  std::vector<std::string> names;
  for (int k = 0; k < model.parameters(); ++k) {
    const bool is_odd = std::abs(estimate.values(k)) > kMuch * largest;
    if (is_odd) names.push_back(model.parameter_name_of(k));
  }
  if (names.empty() || largest == 0) return;
  warning_texts.push_back(fmt::format(
      "{}: more than {} times all that the robot file has, which can hardly be right: units of the log or of the file "
      "are wrong, or the motion tells too little (--damping leaves more of it near the file's values)",
      fmt::join(names, ", "), kMuch));
}

// Whether rotors or friction of some joints are not among the parameters. The model has those that are.
bool leaves_some_out(const TorqueModel& model) {
  const std::vector<bool> present = parameters_in(model.mechanism(), ParameterSet::given);
  const std::vector<int> all = parameter_indices(model.mechanism());
  return std::any_of(all.begin(), all.end(), [&](int index) { return !present[static_cast<std::size_t>(index)]; });
}

// Reports links that are far from π_b, which says something about the log only if the search came to its end.
void warn_of_misfit(const TorqueModel& model, const PhysicalParameters& physical,
                    std::vector<std::string>& warning_texts) {
  constexpr double kMuch = 10;  // standard deviations
  if (!physical.converged || physical.largest_misfit <= kMuch) return;
  warning_texts.push_back(fmt::format(
      "the nearest links are {:.2g} standard deviations from pi_b, more than noise explains: motion, "
      "torques, units or geometry that cannot be right, or noise that the log does not show above the band{}",
      physical.largest_misfit,
      leaves_some_out(model) ? ", or rotors and friction that are left out (--parameters full)" : ""));
}

void warn_of_search(const PhysicalParameters& physical, std::vector<std::string>& warning_texts) {
  if (physical.converged) return;
  warning_texts.push_back(
      fmt::format("the search for the nearest links did not converge: it ended {:.2g} standard deviations from pi_b, "
                  "where nearer links may be; pi_b and its intervals are not affected",
                  physical.largest_misfit));
}

// Reports joints whose residuals with the links are so many times those with π_b, and this share of the torque.
void warn_of_links_residuals(const TorqueModel& model, const Identification& found, double times, double share,
                             std::vector<std::string>& warning_texts) {
  constexpr double kRounding = 1e-6;  // share of the largest torque
  const double negligible = kRounding * largest_rms_torque(found);
  for (std::size_t i = 0; i < found.fits.size(); ++i) {
    const JointObservations& joint = found.measurement.observations.joints[i];
    if (joint.rows == 0) continue;
    const double residual = joint.rms_residual(found.estimate.values),
                 of_links = joint.rms_residual(found.physical_values());
    if (of_links < std::max({times * residual, share * joint.rms_torque(), negligible})) continue;
    const auto equation = static_cast<int>(i);
    warning_texts.push_back(fmt::format("{}: the links leave {:.3g} {} (rms), where pi_b leaves {:.3g}",
                                        model.subject_of(equation), of_links, model.unit_of(equation), residual));
  }
}

// Reports links that are far from the estimate. Those of a robot cannot be near parameters that are not those of one
// (`is_doubtful`), and then only count where they are clearly worse.
void warn_of_links(const TorqueModel& model, const Identification& found, bool is_doubtful,
                   std::vector<std::string>& warning_texts) {
  constexpr double kLarger = 1.5, kMuchLarger = 3, kShare = 0.1;
  // Links have the friction that a joint can have, where the log does not determine it.
  const std::vector<bool>& told = found.unknowns.friction_told;
  if (std::find(told.begin(), told.end(), false) != told.end()) return;
  if (!is_doubtful) warn_of_misfit(model, found.physical, warning_texts);
  warn_of_links_residuals(model, found, is_doubtful ? kMuchLarger : kLarger, is_doubtful ? kShare : 0, warning_texts);
}

// Names what a joint's residuals repeat with, where they are more than noise.
void warn_of_lines(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  constexpr double kMost = 0.5;  // explained by another reason, which makes lines, too
  if (found.hypothesis && found.hypothesis->explained > kMost) return;
  const Observations& observations = found.measurement.observations;
  const Eigen::MatrixXd left = residuals(observations, found.estimate.values);
  std::vector<double> bands;
  for (const MeasuredLog& log : found.measurement.logs) bands.push_back(log.filter.band);
  for (int i = model.first_joint(); i < model.equations(); ++i) {
    const Body& body = model.mechanism().joint(i);
    if (found.fits[static_cast<std::size_t>(i)].is_sound() || body.spherical != 0) continue;
    const auto line = residual_line(observations, left.col(i), model.mechanism().position_of(i), body.prismatic, bands);
    if (!line) continue;
    const std::string sine = fmt::format("{}: {:.2g} of its residuals' squares are a sine of {:.3g} {}",
                                         model.subject_of(i), line->share, line->amplitude, model.unit_of(i));
    warning_texts.push_back(
        line->is_of_turns
            ? fmt::format("{} that repeats {:.4g} times {}, which the model lacks: ripple of its gears or its motor",
                          sine, line->rate, body.prismatic ? "in a metre" : "in a turn")
            : fmt::format("{} at {:.3g} Hz, which the model lacks: a resonance of a flexible joint, or vibration", sine,
                          line->rate));
  }
}

// The estimate of a joint's friction; 0 where it is no parameter.
double friction_of(const TorqueModel& model, const Identification& found, int joint, Parameter kind) {
  const std::vector<int>& columns = model.base().columns;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (joint_of(columns[k]) == joint && parameter_of(columns[k]) == kind) {
      return found.estimate.values(static_cast<Eigen::Index>(k));
    }
  }
  return 0;
}

// Reports friction that changes during the logs.
void warn_of_warmth(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  constexpr double kLeast = 1e-3;  // friction by the joint's torque
  const Observations& observations = found.measurement.observations;
  const Eigen::MatrixXd left = residuals(observations, found.estimate.values);
  for (int i = model.first_joint(); i < model.equations(); ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    if (joint.rows == 0 || model.mechanism().joint(i).spherical != 0) continue;
    const auto change =
        friction_change(observations, left.col(i), i, friction_of(model, found, i, Parameter::Fv),
                        friction_of(model, found, i, Parameter::Fs), kLeast * joint.rms_torque(), joint.correlation);
    if (!change) continue;
    warning_texts.push_back(fmt::format(
        "{}: its friction {} by {:.2g} % from the first half of each log to the second ({:+.2g} of F_v, {:+.2g} of "
        "F_s){}",
        model.subject_of(i), change->share < 0 ? "falls" : "grows", 100 * std::abs(change->share), change->viscous,
        change->coulomb,
        change->share < 0 ? "; it warms up: let it move before the log begins, or log temperatures (--temperature)"
                          : ""));
  }
}

}  // namespace

std::vector<std::string> plausibility_warnings(const TorqueModel& model, const Identification& found) {
  if (found.is_starved()) {
    return {fmt::format(
        "{} equations for {} parameters are too few: parameters and intervals hardly mean anything, and "
        "nothing is said about whether the model fits; log a longer motion, without gaps; where rows are left "
        "out, a wider --band or a lower --rest-speed keeps more of them",
        found.equations(), found.estimate.values.size())};
  }
  std::vector<std::string> warning_texts = base_warnings(model.mechanism(), found.measurement.observations);
  warn_of_fit(model, found, warning_texts);
  warn_of_lines(model, found, warning_texts);
  warn_of_warmth(model, found, warning_texts);
  const std::size_t count_of_fit = warning_texts.size();
  warn_of_frozen(model, found, warning_texts);
  if (!found.hypothesis) warn_of_joints(model, found, warning_texts);
  warn_of_signs(model, found.estimate, warning_texts);
  warn_of_scale(model, found.estimate, warning_texts);
  warn_of_sizes(model, found.estimate, warning_texts);
  warn_of_search(found.physical, warning_texts);
  warn_of_links(model, found, warning_texts.size() > (is_gross(found) ? 0 : count_of_fit), warning_texts);
  warn_of_coarse_steps(model, found, warning_texts);
  warn_of_noise_in_q(model, found.estimate, warning_texts);
  return warning_texts;
}

std::vector<std::string> temperature_warnings(const TorqueEquations& equations, const Estimate& estimate) {
  const TorqueModel& model = equations.model();
  std::vector<std::string> even, open;
  for (int i = model.first_joint(); i < model.equations() && equations.further().temperature; ++i) {
    const auto at = std::ranges::find(equations.names(), equations.name_of("FsT", i)) - equations.names().begin();
    const auto joint = static_cast<std::size_t>(i - model.first_joint());
    if (joint < equations.further().even_temperatures.size() && equations.further().even_temperatures[joint]) {
      even.push_back(model.name_of(i));
    } else if (at < estimate.standard_deviations.size() && !std::isfinite(estimate.standard_deviations[at])) {
      open.push_back(model.name_of(i));
    }
  }
  std::vector<std::string> texts;
  if (!even.empty()) {
    texts.push_back(
        fmt::format("{}: the temperatures hardly change, and do not tell friction at --temperature {:.6g}: "
                    "F_v and F_s are those at the temperatures of the log",
                    fmt::join(even, ", "), *equations.further().temperature));
  }
  if (!open.empty()) {
    texts.push_back(
        fmt::format("{}: the log does not tell how friction changes with the temperature, and so no friction "
                    "at --temperature {:.6g}: give the temperature that the log has, or logs of more than one",
                    fmt::join(open, ", "), *equations.further().temperature));
  }
  return texts;
}

std::vector<std::string> search_warnings(const NonlinearUnknowns& unknowns, const TorqueModel& model) {
  std::vector<std::string> warning_texts;
  for (std::size_t i = 0; i < unknowns.friction_told.size(); ++i) {
    if (unknowns.friction_told[i]) continue;
    warning_texts.push_back(
        fmt::format("joint \"{}\": the log does not tell the speed v of its friction, and so none of its friction's "
                    "parameters; a motion with slower and faster parts tells them, or --friction coulomb has no v",
                    model.name_of(static_cast<int>(i))));
  }
  const auto untold = unknowns.gravity ? untold_directions(unknowns.gravity->told) : std::vector<Eigen::Vector3d>();
  for (const Eigen::Vector3d& each : untold) {
    warning_texts.push_back(fmt::format(
        "nothing in the log tells gravity's component along [{:.3g}, {:.3g}, {:.3g}] in the base frame: it keeps the "
        "robot file's value, {:.4g} m/s^2",
        each.x(), each.y(), each.z(), each.dot(unknowns.gravity->gravity)));
  }
  if (unknowns.converged) return warning_texts;
  warning_texts.emplace_back(
      "the search for gravity's direction, the delay or friction did not come to rest: the parameters "
      "may be off by more than their intervals say");
  return warning_texts;
}

}  // namespace flatdyn
