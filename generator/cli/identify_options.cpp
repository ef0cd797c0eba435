// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/identify_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/output_file.hpp"
#include "laboratory/identify/part_file.hpp"

namespace flatdyn {
namespace {

const std::map<std::string, FrictionLaw> kFrictionLaws = {{"coulomb", FrictionLaw::coulomb},
                                                          {"asymmetric", FrictionLaw::asymmetric},
                                                          {"stribeck", FrictionLaw::stribeck},
                                                          {"smooth", FrictionLaw::smooth},
                                                          {"load", FrictionLaw::load}};

// Parses "2/8", part 2 of 8.
void read_part(const std::string& text, StreamOptions& options) {
  int part = 0, parts = 0, length = 0;
  const bool read = std::sscanf(text.c_str(), "%d/%d%n", &part, &parts, &length) == 2;
  if (!read || static_cast<std::size_t>(length) != text.size() || part < 1 || part > parts) {
    throw Failure(FailureKind::usage, fmt::format("--part {}: write k/N with 1 <= k <= N, such as 2/8", text));
  }
  if (parts > kMostParts) {
    throw Failure(FailureKind::usage, fmt::format("--part {}: at most {} parts", text, kMostParts));
  }
  options.part = part;
  options.parts = parts;
}

void check_identify_usage(const IdentifyArguments& arguments) {
  if (arguments.logs.empty() == arguments.parts.empty()) {
    throw Failure(FailureKind::usage, "identify needs --data LOG.csv, or --merge PART..., and not both");
  }
  if (!arguments.part.empty() && (arguments.output.empty() || arguments.logs.empty())) {
    throw Failure(FailureKind::usage, "--part needs --data LOG.csv and -o FILE: the part is written to that file");
  }
  const bool reads_otherwise = arguments.stream.band || arguments.stream.decimate ||
                               !arguments.stream.rest_speed.empty() || !arguments.stream.imu.empty();
  if (!arguments.parts.empty() && reads_otherwise) {
    throw Failure(FailureKind::usage, "--band, --decimate, --rest-speed and --imu have no effect with --merge",
                  "give them with --part, where the logs are read");
  }
  const bool reads_again = arguments.delay || arguments.gravity_direction || arguments.robust ||
                           !arguments.signals.empty() || !is_linear(arguments.further.law) ||
                           arguments.estimator == "iv";
  if ((!arguments.part.empty() || !arguments.parts.empty()) && reads_again) {
    throw Failure(FailureKind::usage,
                  "--delay, --gravity-direction, --robust, --signals, --estimator iv and friction with a speed or a "
                  "load read the logs more than once",
                  "give them with --data, without --part");
  }
  if (!arguments.part.empty() &&
      (!arguments.validation.empty() || !arguments.covariance.empty() || !arguments.module.empty())) {
    throw Failure(FailureKind::usage, "--validate, --covariance and --module have no effect with --part",
                  "give them with --merge");
  }
  if (arguments.estimator == "iv" && arguments.robust) {
    throw Failure(FailureKind::usage, "--estimator iv and --robust exclude each other");
  }
  if (arguments.estimator == "iv" && !arguments.identification.estimate.compensates) {
    throw Failure(FailureKind::usage, "--no-bias-compensation has no effect with --estimator iv, which has no bias");
  }
  check_other_logs(arguments.logs, arguments.validation, "--validate");
  if (arguments.further.law == FrictionLaw::asymmetric && arguments.further.offsets) {
    throw Failure(
        FailureKind::usage,
        "--friction asymmetric and --offsets cannot be told apart: while a joint moves, friction that is larger "
        "in one direction adds the same constant to its torques as an offset does",
        "give one of them");
  }
  if (arguments.further.springs && (arguments.further.law == FrictionLaw::asymmetric || arguments.further.offsets)) {
    throw Failure(
        FailureKind::usage,
        "--springs cannot be told apart from --offsets and --friction asymmetric: where a spring is relaxed is "
        "a constant in its joint's torques",
        "give one of them");
  }
  if (arguments.parameters == "inertial" && (arguments.friction != "coulomb" || arguments.further.temperature)) {
    throw Failure(FailureKind::usage,
                  "--friction and --temperature have no effect with --parameters inertial, which has no friction",
                  "give --parameters full");
  }
  if (!arguments.validation_plot.empty() && arguments.validation.empty()) {
    throw Failure(FailureKind::usage, "--validation-plot needs --validate LOG.csv");
  }
  if (!arguments.part.empty() && (!arguments.plot.empty() || arguments.identification.sequential)) {
    throw Failure(FailureKind::usage, "--plot and --sequential have no effect with --part",
                  "give them with --merge, where the parameters are estimated");
  }
}

// The options that say what is estimated, and how.
void add_estimation_options(CLI::App& command, IdentifyArguments& arguments) {
  command
      .add_option("--damping", arguments.identification.estimate.damping,
                  "directions whose relative singular value is below this stay near the file's values")
      ->check(number_between(0, 1))
      ->capture_default_str();
  command
      .add_option(
          "--friction", arguments.friction,
          "the law: F_v qd + F_s sgn qd (coulomb); with other Coulomb friction backwards (asymmetric); with more "
          "friction near rest (stribeck); F_v qd + F_s tanh(qd/v) (smooth); or with c |tau_l| sgn qd, where tau_l is "
          "the torque that the drive carries (load)")
      ->check(CLI::IsMember({"coulomb", "asymmetric", "stribeck", "smooth", "load"}))
      ->capture_default_str();
  command
      .add_option("--temperature", arguments.further.temperature,
                  "also how F_v and F_s change with the temperatures of the joints, columns temperature1...; the F_v "
                  "and F_s that are written are those at this temperature, in degrees Celsius")
      ->check(number_between(-100, 200))
      ->type_name("DEGREES");
  command.add_flag("--offsets", arguments.further.offsets, "also a constant offset of each joint's torques");
  command.add_flag("--springs", arguments.further.springs,
                   "also the stiffness k of each joint's spring, and k q_0, which says where it is relaxed");
  command.add_flag("--delay", arguments.delay, "also the time by which all torques are late; reads the logs again");
  command
      .add_option("--estimator", arguments.estimator,
                  "least squares (ls), or instrumental variables (iv) against noise in q: the instrument is the same "
                  "motion, smoothed far more; iv reads the logs again")
      ->check(CLI::IsMember({"ls", "iv"}))
      ->capture_default_str();
  command.add_flag_callback(
      "--no-bias-compensation", [&arguments] { arguments.identification.estimate.compensates = false; },
      "keep what noise of positions adds to the parameters: it then counts in their deviations alone");
  command.add_flag("--robust", arguments.robust, "Huber's weights: outliers count less; reads the logs again");
  command.add_flag("--gravity-direction", arguments.gravity_direction,
                   "also the direction of gravity, which is then written into the robot file; reads the logs again");
  command.add_flag("--sequential", arguments.identification.sequential, "also the textbook's joint-by-joint procedure");
}

}  // namespace

void settle(IdentifyArguments& arguments) {
  arguments.further.law = kFrictionLaws.at(arguments.friction);
  check_identify_usage(arguments);
  arguments.stream.temperatures = arguments.further.temperature.has_value();
  if (!arguments.part.empty()) read_part(arguments.part, arguments.stream);
}

void check_options_for(const Mechanism& mechanism, const IdentifyArguments& arguments) {
  const Vec3& g = mechanism.gravity;
  if (arguments.gravity_direction && std::all_of(g.begin(), g.end(), vanishes)) {
    throw Failure(FailureKind::usage, "--gravity-direction: the robot is without gravity, which has no direction then");
  }
  if (mechanism.is_coupled() && arguments.further.springs) {
    throw Failure(FailureKind::unsupported, "--springs is for robots without coupled joints and closed loops");
  }
  if (mechanism.is_coupled() && (arguments.further.law == FrictionLaw::load || arguments.further.temperature)) {
    throw Failure(FailureKind::unsupported,
                  "--friction load and --temperature are for robots without coupled joints and closed loops");
  }
  if (mechanism.has_spherical_joints() && arguments.further.temperature) {
    throw Failure(FailureKind::unsupported, "--temperature is for robots without spherical joints");
  }
  if (mechanism.floating_base && arguments.gravity_direction) {
    throw Failure(FailureKind::unsupported,
                  "--gravity-direction is for robots with a fixed base: on a floating one gravity is part of what an "
                  "accelerometer shows, or its direction is that of the pose");
  }
  if (mechanism.has_spherical_joints() && arguments.gravity_direction) {
    throw Failure(FailureKind::unsupported, "--gravity-direction is for robots without spherical joints");
  }
  check_imu(mechanism, arguments.stream.imu);
  if (mechanism.has_loops() && (arguments.gravity_direction || arguments.estimator == "iv")) {
    throw Failure(FailureKind::unsupported,
                  "--gravity-direction and --estimator iv are for robots without closed loops");
  }
}

void require_friction(const Mechanism& mechanism, const IdentifyArguments& arguments) {
  if (arguments.friction == "coulomb" && !arguments.further.temperature) return;
  const std::vector<int> all = parameter_indices(mechanism);
  const std::vector<bool> present = parameters_in(mechanism, arguments.identification.set);
  const bool has_friction = std::ranges::any_of(all, [&](int index) {
    const Parameter kind = parameter_of(index);
    return present[static_cast<std::size_t>(index)] && (kind == Parameter::Fs || kind == Parameter::Fv);
  });
  if (has_friction) return;
  throw Failure(FailureKind::usage,
                "--friction and --temperature have no effect: no friction is among the parameters, as the robot file "
                "gives none",
                "give --parameters full");
}

void check_files(const IdentifyArguments& arguments, const Robot& robot) {
  std::vector<std::string> inputs = robot.files;
  inputs.insert(inputs.end(), arguments.logs.begin(), arguments.logs.end());
  inputs.insert(inputs.end(), arguments.parts.begin(), arguments.parts.end());
  inputs.insert(inputs.end(), arguments.validation.begin(), arguments.validation.end());
  check_outputs({arguments.output, arguments.plot, arguments.validation_plot, arguments.covariance, arguments.signals,
                 arguments.module},
                inputs);
}

void add_identify_options(CLI::App& command, IdentifyArguments& arguments) {
  arguments.add_to(command);
  command.add_option("--data", arguments.logs, "logs: t, q1..., tau1..., and qd, qdd, h_e where there are any")
      ->type_name("LOG.csv");
  command.add_option("--merge", arguments.parts, "instead of logs: all parts that --part has written")
      ->type_name("PART");
  command.add_option("-o,--output", arguments.output, "the robot file with the identified parameters; of a part")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_plot_option(command, arguments.plot, "torques and residuals over time");
  command.add_option("--validate", arguments.validation, "other logs, on which the parameters are judged")
      ->type_name("LOG.csv");
  add_picture_option(command, "--validation-plot", arguments.validation_plot,
                     "torques and residuals of --validate over time");
  command.add_option("--covariance", arguments.covariance, "the covariance of the parameters, as CSV")
      ->check(kNotEmpty)
      ->type_name("FILE.csv");
  command
      .add_option("--module", arguments.module,
                  "the parameters as a Python module: names, values, deviations, covariance, and arrays() of NumPy")
      ->check(kNotEmpty)
      ->type_name("FILE.py");
  command
      .add_option("--signals", arguments.signals,
                  "filtered q, qd, qdd and torques, the model's torques, and which rows were used, as CSV")
      ->check(kNotEmpty)
      ->type_name("FILE.csv");
  command.add_option("--part", arguments.part, "read the k-th of N parts of the logs, and write what it says")
      ->type_name("k/N");
  add_identified_option(command, arguments.parameters);
  add_frames_option(command, arguments.frames);
  add_stream_options(command, arguments.stream);
  add_imu_option(command, arguments.stream.imu);
  add_estimation_options(command, arguments);
}

}  // namespace flatdyn
