// SPDX-License-Identifier: GPL-2.0-or-later
// The subcommands. Each adds itself to the command line and leaves a function to run if it was the one asked for.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/telling.hpp"
#include "identify/motion_stream.hpp"
#include "planning/make_functions.hpp"
#include "symbolic/parameters/parameters.hpp"

namespace flatdyn {

using Run = std::function<ExitCode()>;

// What every subcommand that reads a robot takes.
struct RobotArguments : Manner {
  std::string robot;
  std::string snap = "1e-5";
  std::string scene;
  std::string gravity;
  std::string error_budget;
  std::string search;
  std::string tip;
  std::vector<std::string> fixed_joints;
  std::vector<std::string> xacro;
  bool warnings_are_errors = false;

  void add_to(CLI::App& command);
  void add_settings_to(CLI::App& command);  // all but the robot itself
  PipelineOptions options() const;
  PipelineOptions options_without_error_budget() const;  // for subcommands that do not make functions for others
  // TOML lines that repeat --gravity, --tip and --fix, and what the scene says of these, for a file over the robot
  // file. Throws Failure(unsupported) if the scene says more.
  std::vector<std::string> settings(const LoadedRobot& model) const;
  // Those of these options that shape emitted text, for its stamp; behind others. Of a search, how far it went.
  std::string stamp_of_settings(const std::vector<OptimisedFunction>& functions) const;
  // For subcommands that make no functions: what of the scene has no effect.
  void note_function_keys(const LoadedRobot& model) const;
  // Ends the run with BadInput after an error, or after a warning if these are errors; else prints what was found.
  void report(const Diagnostics& found) const;
  // Of what was found in a file, none of its lines in particular.
  void warn_of(const std::vector<std::string>& doubts, const std::string& file) const;
};

// The argument of all subcommands that read a robot.
inline constexpr const char* kRobotMeaning = "robot file: URDF, xacro or TOML; - reads a URDF or TOML from stdin";

// For options that name something.
inline const CLI::Validator kNotEmpty([](const std::string& text) { return text.empty() ? "it is empty" : ""; }, "");

// For folders with several files in them, for which "-" cannot stand.
CLI::Validator folder_name();

// For options that are numbers. CLI11's own let NaN pass, and print bounds with 300 digits.
CLI::Validator positive_number();
CLI::Validator number_between(double least, double most);

// A list of names with commas between, which may have blanks around them.
CLI::Option* add_names_option(CLI::App& command, const std::string& option, std::vector<std::string>& names,
                              const std::string& meaning);

// --error-budget.
void add_error_budget_option(CLI::App& command, RobotArguments& arguments);

// --search.
void add_search_option(CLI::App& command, RobotArguments& arguments);

// --functions, with its meaning, and the table of functions at the end of the help.
void add_functions_option(CLI::App& command, std::vector<std::string>& functions,
                          const std::string& meaning =
                              "what to compute, separated by commas; default: what the scene names, else all below "
                              "down to the blank line");

// Options as they go into the stamp of emitted text, those without a value left out: "--scalar float --tip hand".
std::string stamp(const std::vector<std::pair<std::string, std::string>>& options);

// --band and --decimate.
void add_stream_options(CLI::App& command, StreamOptions& options);

// --trajectory.
void add_trajectory_option(CLI::App& command, std::string& file);

// --plot, a picture whose format its name says; `meaning`: what is drawn.
void add_plot_option(CLI::App& command, std::string& file, const std::string& meaning);

// --parameters, for what `use` says; and the set that its value names.
void add_parameters_option(CLI::App& command, std::string& name, const std::string& use);
ParameterSet parameter_set(const std::string& name);

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
Run add_man(CLI::App& app);
Run add_completion(CLI::App& app);

}  // namespace flatdyn
