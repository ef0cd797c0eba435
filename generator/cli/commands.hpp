// SPDX-License-Identifier: GPL-2.0-or-later
// The subcommands. Each adds itself to the command line and leaves a function that runs it if it was chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/messages.hpp"
#include "derivation/parameters/parameter_frames.hpp"
#include "derivation/parameters/parameters.hpp"
#include "functions/planning/make_functions.hpp"
#include "laboratory/identify/motion_stream.hpp"
#include "robot/input/formats.hpp"

namespace flatdyn {

using Run = std::function<ExitCode()>;

// The options of every subcommand that reads a robot.
struct RobotArguments : OutputStyle {
  std::string robot;
  std::string snap = "1e-5";
  std::string scene;
  std::string gravity;
  std::string base;
  std::string error_budget;
  std::string search;
  std::string tip;
  std::vector<std::string> fixed_joints;
  std::vector<std::string> frames;  // --frame
  std::vector<std::string> xacro;
  std::vector<std::string> ignored;
  bool warnings_are_errors = false;
  std::string model_name;  // --model
  std::string keyframe;    // --keyframe

  void add_to(CLI::App& command);
  void add_settings_to(CLI::App& command);  // adds all options but the robot itself
  PipelineOptions options() const;
  PipelineOptions options_without_error_budget() const;  // for subcommands that do not write functions
  // TOML lines that repeat --gravity, --tip and --fix, and the same settings of the scene, for a file over the robot
  // file. Throws Failure(unsupported) if the scene has other settings.
  std::vector<std::string> settings(const LoadedRobot& model) const;
  // The part of the stamp, for the end of it, with those of these options that shape emitted text; for a search the
  // number of candidates tried.
  std::string stamp_of_settings(const std::vector<OptimisedFunction>& functions) const;
  // Notes the scene's settings that have no effect on subcommands that make no functions.
  void note_function_keys(const LoadedRobot& model) const;
  // Ends the run with BadInput after an error, or after a warning if warnings are errors; otherwise prints the
  // findings.
  void report(const Diagnostics& found) const;
  // Warns of findings in a file that belong to no particular line.
  void warn_of(const std::vector<std::string>& warning_texts, const std::string& file) const;
};

// The description of the robot argument in all subcommands.
inline const std::string kRobotMeaning = "robot file: " + robot_formats_text() + "; - reads one but a xacro from stdin";

// A check for options that are names.
inline const CLI::Validator kNotEmpty([](const std::string& text) { return text.empty() ? "it is empty" : ""; }, "");

// A check for folders with several files in them, for which "-" has no meaning.
CLI::Validator folder_name();

// A check for positive numbers. CLI11's own lets NaN pass and prints bounds with 300 digits.
CLI::Validator positive_number();
// A check for numbers from `least` to `most`.
CLI::Validator number_between(double least, double most);

// Adds an option that is a list of names between commas, which may have blanks around them.
CLI::Option* add_names_option(CLI::App& command, const std::string& option, std::vector<std::string>& names,
                              const std::string& meaning);

// Adds --error-budget.
void add_error_budget_option(CLI::App& command, RobotArguments& arguments);

// Adds --search.
void add_search_option(CLI::App& command, RobotArguments& arguments);

// Adds --functions, with its meaning, and the table of functions at the end of the help.
void add_functions_option(CLI::App& command, std::vector<std::string>& functions,
                          const std::string& meaning =
                              "what to compute, separated by commas; default: what the scene names, else all below "
                              "down to the blank line");

// The options as they go into the stamp of emitted text, without those that have no value: "--scalar float --tip hand".
std::string stamp(const std::vector<std::pair<std::string, std::string>>& options);
// Stamps one after the other.
std::string joined_stamps(const std::vector<std::string>& stamps);

// Adds --band, --decimate and --rest-speed.
void add_stream_options(CLI::App& command, StreamOptions& options);
// Adds --imu.
void add_imu_option(CLI::App& command, std::string& imu);
// Throws Failure(usage) if --imu is given for a robot with a fixed base, or names a link that is not fixed to a
// floating one.
void check_imu(const Mechanism& mechanism, const std::string& imu);

// Adds --trajectory.
void add_trajectory_option(CLI::App& command, std::string& file);

// Adds --plot, a picture whose format follows from its name; `meaning`: the content of the picture.
void add_plot_option(CLI::App& command, std::string& file, const std::string& meaning);
void add_picture_option(CLI::App& command, const std::string& option, std::string& file, const std::string& meaning);

// Adds --parameters, for the purpose `use`. parameter_set() returns the set of that name.
void add_identified_option(CLI::App& command, std::string& name);
void add_parameters_option(CLI::App& command, std::string& name, const std::string& use);
ParameterSet parameter_set(const std::string& name);
// The same for identification: of no name, all parameters if the file gives no friction, else those that it gives.
ParameterSet parameter_set(const std::string& name, const Mechanism& mechanism);

// Adds --frames, to which the names of parameters refer. parameter_frames() returns those of that name.
void add_frames_option(CLI::App& command, std::string& name);
ParameterFrames parameter_frames(const std::string& name);

Run add_generate(CLI::App& app);
Run add_inspect(CLI::App& app);
Run add_derive(CLI::App& app);
Run add_verify(CLI::App& app);
Run add_eval(CLI::App& app);
Run add_identify(CLI::App& app);
Run add_payload(CLI::App& app);
Run add_excite(CLI::App& app);
Run add_report(CLI::App& app);
Run add_torques(CLI::App& app);
Run add_scale(CLI::App& app);
Run add_bench(CLI::App& app);
Run add_certify(CLI::App& app);
Run add_stress(CLI::App& app);
Run add_simulate(CLI::App& app);
Run add_manipulability(CLI::App& app);
Run add_convert(CLI::App& app);
Run add_help(CLI::App& app);
Run add_man(CLI::App& app);
Run add_completion(CLI::App& app);

}  // namespace flatdyn
