// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/diagnostics/table.hpp"
#include "cli/commands.hpp"
#include "cli/option_list.hpp"
#include "cli/option_values.hpp"
#include "cli/output_file.hpp"
#include "derivation/notation/number_text.hpp"
#include "functions/function_table.hpp"
#include "report/toml_string.hpp"
#include "robot/input/common/name_list.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/scene_frames.hpp"

namespace flatdyn {
namespace {

const std::map<std::string, ParameterSet> kParameterSets = {{"inertial", ParameterSet::inertial},
                                                            {"given", ParameterSet::given},
                                                            {"full", ParameterSet::full},
                                                            {"nonzero", ParameterSet::nonzero}};

// The option without a blank before the unit, so that it is one word in the stamp.
std::string without_blank_before_unit(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  const std::optional<std::string> degrees =
      sign == std::string::npos ? std::nullopt : number_of_degrees(text.substr(sign + 1));
  return degrees ? text.substr(0, sign + 1) + *degrees + "deg" : text;
}

// The position as text for a file. A file's expressions are never snapped, so a snapped position is written as the
// exact number.
std::string position_text(const JointPosition& lock, const Robot& robot) {
  for (const Joint& joint : robot.joints) {
    const bool is_snapped = joint.name == lock.joint && joint.held && !vanishes(joint.held->position - lock.position);
    if (is_snapped) return plain_number_text(joint.held->position);
  }
  return lock.written;
}

void add_verbosity_options(CLI::App& command, RobotArguments& arguments) {
  // The option -Werror as compilers spell it: CLI11 would read -W with the value "error".
  command
      .add_option_function<std::string>(
          "-W", [&arguments](const std::string&) { arguments.warnings_are_errors = true; },
          "-Werror: warnings are errors")
      ->type_name("error")
      ->check([](const std::string& value) { return value == "error" ? "" : "write -Werror"; });
  command.add_flag("--json", arguments.json, "print JSON on stdout");
  command.add_flag("-q,--quiet", arguments.quiet, "no notes, no progress, no tables beside files that are written");
  command.add_flag("-v,--verbose", arguments.verbose, "list what is otherwise told in one line");
}

}  // namespace

CLI::Validator folder_name() {
  const auto check = [](const std::string& text) {
    if (text == kStdout) return "several files result, and stdout has room for one: name a folder";
    return text.empty() ? "it is empty" : "";
  };
  return {check, ""};
}

CLI::Validator positive_number() {
  const auto check = [](const std::string& text) {
    double value = 0;
    const bool read = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return read && value > 0 ? "" : fmt::format("\"{}\" must be a number greater than 0", text);
  };
  return {check, "POSITIVE"};
}

CLI::Validator number_between(double least, double most) {
  const auto check = [least, most](const std::string& text) {
    double value = 0;
    const bool read = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return read && value >= least && value <= most
               ? ""
               : fmt::format("\"{}\" must be a number from {} to {}", text, least, most);
  };
  return {check, fmt::format("in [{} - {}]", least, most)};
}

void RobotArguments::add_to(CLI::App& command) {
  command.add_option("robot", robot, kRobotMeaning)->required()->type_name("FILE");
  add_settings_to(command);
}

void RobotArguments::add_settings_to(CLI::App& command) {
  const std::size_t before = command.get_options({}).size();
  command
      .add_option(
          "--snap", snap,
          "take angles this near to a multiple of pi/12 for it, and what is tiny beside its neighbours for 0; 0: never")
      ->capture_default_str()
      ->type_name("RAD");
  command.add_option("--scene", scene, "what is wanted of the robot here: docs/scene-format.md (TOML)")
      ->check(kNotEmpty)
      ->type_name("FILE");
  command.add_option("--gravity", gravity, "g_0 in the base frame, m/s^2, or off; overrides the files")
      ->type_name("X,Y,Z");
  command
      .add_option("--base", base,
                  "floating: the root link moves freely, and the base's velocities, accelerations and forces come "
                  "before those of the joints (docs/floating-base.md); fixed: it does not, whatever the file says")
      ->check(CLI::IsMember({"fixed", "floating"}))
      ->type_name("KIND");
  command.add_option("--tip", tip, "link whose frame is the tip; default: the last, depth-first, of those that move")
      ->type_name("LINK");
  command
      .add_option("--fix", fixed_joints,
                  "hold this joint at q = 0, or at a position (rad or m, such as pi/2, or 90deg), as if it were a "
                  "fixed one; may be repeated")
      ->allow_extra_args(false)
      ->transform(without_blank_before_unit, "")
      ->type_name("JOINT[=POSITION]");
  command
      .add_option("--frame", frames,
                  "a frame NAME that is fixed to a link, at X, Y, Z (m), turned by ROLL, PITCH, YAW (rad) as in URDF; "
                  "it is a link to all options, and in jacobian:NAME; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=LINK,X,Y,Z[,ROLL,PITCH,YAW]");
  command
      .add_option("--xacro", xacro, "an argument NAME:=VALUE of a .xacro file, which xacro expands; may be repeated")
      ->allow_extra_args(false)
      ->check([](const std::string& text) { return text.find(":=") == std::string::npos ? "write NAME:=VALUE" : ""; })
      ->type_name("ARGUMENT");
  command
      .add_option("--ignore", ignored,
                  "leave out elements, or attributes, of this name of an MJCF file, such as tendon; may be repeated")
      ->allow_extra_args(false)
      ->check(kNotEmpty)
      ->type_name("NAME");
  command.add_option("--model", model_name, "the model of an SDF file that has several")
      ->check(kNotEmpty)
      ->type_name("NAME");
  command.add_option("--keyframe", keyframe, "the keyframe of an MJCF file near which its closed loops are closed")
      ->check(kNotEmpty)
      ->type_name("NAME");
  add_verbosity_options(command, *this);
  const std::vector<CLI::Option*> options = command.get_options({});
  for (std::size_t i = before; i < options.size(); ++i) options[i]->group(kCommonOptions);
}

void add_error_budget_option(CLI::App& command, RobotArguments& arguments) {
  command
      .add_option(
          "--error-budget", arguments.error_budget,
          "leave out inertial parameters that change no torque by more than this within the limits: 0.1% of each "
          "joint's effort limit, or 0.05 N m; the bound is proven")
      ->check(kNotEmpty)
      ->type_name("BUDGET");
}

void add_search_option(CLI::App& command, RobotArguments& arguments) {
  command
      .add_option("--search", arguments.search,
                  "look for frames, units, parameters and orders of factoring from which functions cost less: a number "
                  "of candidates per function (200: the same result everywhere), or a time for all (30s)")
      ->check(kNotEmpty)
      ->type_name("LIMIT");
}

void add_functions_option(CLI::App& command, std::vector<std::string>& functions, const std::string& meaning) {
  add_names_option(command, "--functions", functions, meaning);
  std::vector<std::vector<std::string>> rows;
  for (const bool on_request : {false, true}) {
    if (on_request) rows.emplace_back();
    for (const FunctionRow& row : function_table()) {
      if (row.traits.on_request == on_request) rows.push_back({"", row.name, row.summary});
    }
  }
  command.footer("Functions:\n" + aligned_table(rows) + functions_of_links() +
                 "\nalso take a link: jacobian:LINK.\n"
                 "vjp:, jvp:, jac: and hessian:FUNCTION are its derivatives: docs/derivatives.md.");
}

CLI::Option* add_names_option(CLI::App& command, const std::string& option, std::vector<std::string>& names,
                              const std::string& meaning) {
  const auto take = [&names, option](const std::vector<std::string>& lists) {
    names.clear();
    for (const std::string& list : lists) {
      try {
        for (std::string& name : names_in(list)) names.push_back(std::move(name));
      } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError(option, error.what());
      }
    }
  };
  return command.add_option_function<std::vector<std::string>>(option, take, meaning)
      ->allow_extra_args(false)
      ->type_name("NAMES");
}

void add_trajectory_option(CLI::App& command, std::string& file) {
  command
      .add_option(
          "--trajectory", file,
          "the motion: samples (CSV: t, q1..., qd1..., qdd1..., or q_<joint>...; h_e1... where the tip pushes), or "
          "a plan (TOML: docs/trajectory-format.md)")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE");
}

void add_plot_option(CLI::App& command, std::string& file, const std::string& meaning) {
  add_picture_option(command, "--plot", file, meaning);
}

void add_picture_option(CLI::App& command, const std::string& option, std::string& file, const std::string& meaning) {
  const auto is_picture = [](const std::string& name) {
    const std::string extension = std::filesystem::path(name).extension();
    return extension == ".svg" || extension == ".png" ? "" : "the plot's name must end in .svg or .png";
  };
  command.add_option(option, file, meaning + "; needs gnuplot")
      ->check(CLI::Validator(is_picture, ""))
      ->type_name("FILE.svg|FILE.png");
}

void add_parameters_option(CLI::App& command, std::string& name, const std::string& use) {
  command
      .add_option("--parameters", name,
                  use +
                      "ten of every link (inertial), and rotors and friction that the file gives (given), all "
                      "thirteen (full), or those that are not zero (nonzero)")
      ->check(CLI::IsMember({"inertial", "given", "full", "nonzero"}))
      ->capture_default_str();
}

void add_identified_option(CLI::App& command, std::string& name) {
  command
      .add_option("--parameters", name,
                  "what is identified: ten of every link (inertial), and rotors and friction that the file gives "
                  "(given), all thirteen (full), or those that are not zero (nonzero); default: full if the file gives "
                  "no friction, else given")
      ->check(CLI::IsMember({"inertial", "given", "full", "nonzero"}));
}

ParameterSet parameter_set(const std::string& name) { return kParameterSets.at(name); }

ParameterSet parameter_set(const std::string& name, const Mechanism& mechanism) {
  if (!name.empty()) return parameter_set(name);
  const std::vector<bool> given = parameters_in(mechanism, ParameterSet::given);
  for (std::size_t index = 0; index < given.size(); ++index) {
    const Parameter parameter = parameter_of(static_cast<int>(index));
    if (given[index] && (parameter == Parameter::Fv || parameter == Parameter::Fs)) return ParameterSet::given;
  }
  return ParameterSet::full;
}

void add_frames_option(CLI::App& command, std::string& name) {
  command
      .add_option("--frames", name,
                  "base parameters as combinations of the parameters of links in the robot file, each in its own frame "
                  "(file), or of moving links in frames with z on the joint's axis (canonical)")
      ->check(CLI::IsMember({"file", "canonical"}))
      ->capture_default_str();
}

ParameterFrames parameter_frames(const std::string& name) {
  return name == "file" ? ParameterFrames::file : ParameterFrames::canonical;
}

std::string stamp(const std::vector<std::pair<std::string, std::string>>& options) {
  std::string text;
  for (const auto& [option, value] : options) {
    if (!value.empty()) text += (text.empty() ? "" : " ") + option + " " + value;
  }
  return text;
}

std::string joined_stamps(const std::vector<std::string>& stamps) {
  std::string text;
  for (const std::string& each : stamps) text += (text.empty() || each.empty() ? "" : " ") + each;
  return text;
}

std::string RobotArguments::stamp_of_settings(const std::vector<OptimisedFunction>& functions) const {
  const bool searched = !functions.empty() && functions.front().search;
  return stamp({{"--snap", snap == "1e-5" ? "" : snap},
                {"--gravity", gravity},
                {"--base", base},
                {"--error-budget", error_budget},
                {"--search", searched ? std::to_string(functions.front().search->candidates) : ""},
                {"--tip", tip},
                {"--fix", fmt::format("{}", fmt::join(fixed_joints, " --fix "))},
                {"--frame", fmt::format("{}", fmt::join(frames, " --frame "))},
                {"--xacro", fmt::format("{}", fmt::join(xacro, " --xacro "))},
                {"--ignore", fmt::format("{}", fmt::join(ignored, " --ignore "))},
                {"--model", model_name},
                {"--keyframe", keyframe}});
}

std::vector<std::string> RobotArguments::settings(const LoadedRobot& model) const {
  if (model.robot.file == kStandardInput || !xacro.empty() || !ignored.empty() || !model_name.empty() ||
      !keyframe.empty() || !frames.empty()) {
    throw Failure(FailureKind::usage,
                  "a robot file cannot name a robot that comes from stdin, or with --xacro, --ignore, --model, "
                  "--keyframe or --frame",
                  "write the robot to a file first: xacro FILE NAME:=VALUE > robot.urdf");
  }
  const Scene& wanted = model.robot.scene;
  if (wanted.payload || !wanted.frames.empty() || !wanted.friction || !wanted.springs || !wanted.limits.empty()) {
    throw Failure(FailureKind::unsupported,
                  "a robot file cannot repeat what the scene says of payload, frames, friction, springs and limits",
                  "use a scene with gravity and [locked] only, or write these into the robot file");
  }
  std::vector<std::string> lines;
  if (!gravity.empty() && gravity != "off") {
    lines.push_back(fmt::format("gravity = [{}]", gravity));
  } else if (wanted.gravity) {
    std::vector<std::string> entries;
    for (const Number& entry : *wanted.gravity) entries.push_back(plain_number_text(entry, 17));
    lines.push_back(fmt::format("gravity = [{}]", fmt::join(entries, ", ")));
  }
  if (!base.empty()) lines.push_back(fmt::format("base = \"{}\"", base));
  if (!tip.empty()) lines.push_back(fmt::format("tip = {{ link = {} }}", toml_string(tip)));
  std::vector<std::string> fixed;
  for (const JointPosition& lock : wanted.locked) {
    fixed.push_back(fmt::format("{} = {}", toml_string(lock.joint), toml_string(position_text(lock, model.robot))));
  }
  if (!fixed.empty()) lines.push_back(fmt::format("fixed = {{ {} }}", fmt::join(fixed, ", ")));
  return lines;
}

void RobotArguments::note_function_keys(const LoadedRobot& model) const {
  const Scene& wanted = model.robot.scene;
  if (!wanted.at_rest && wanted.functions.empty() && wanted.outputs.empty() && !wanted.error_budget) return;
  Diagnostics notes;
  notes.note({wanted.file, 0}, "static, error_budget, functions and outputs have no effect here",
             "they concern generate, verify and eval");
  print_diagnostics(notes, *this);
}

void RobotArguments::report(const Diagnostics& found) const {
  if (found.has_errors() || (warnings_are_errors && found.has_warnings())) throw BadInput(FailureKind::input, found);
  print_diagnostics(found, *this);
}

void RobotArguments::warn_of(const std::vector<std::string>& warning_texts, const std::string& file) const {
  Diagnostics warnings;
  for (const std::string& warning_text : warning_texts) warnings.warning({file, 0}, warning_text);
  report(warnings);
}

PipelineOptions RobotArguments::options_without_error_budget() const {
  PipelineOptions whole = options();
  whole.skip_error_budget = true;
  return whole;
}

PipelineOptions RobotArguments::options() const {
  PipelineOptions options;
  options.read.snap_tolerance = snap_option(snap);
  options.read.sources = std::make_shared<Sources>(xacro);
  options.read.ignored = ignored;
  options.read.scene_file = scene;
  if (!gravity.empty()) options.read.scene.gravity = gravity_option(gravity);
  if (!error_budget.empty()) options.read.scene.error_budget = error_budget_option(error_budget);
  if (!search.empty()) options.search = search_option(search);
  if (!tip.empty()) options.read.tip = tip;
  if (!base.empty()) options.read.floating_base = base == "floating";
  if (!model_name.empty()) options.read.model = model_name;
  if (!keyframe.empty()) options.read.keyframe = keyframe;
  options.read.scene.locked = fixed_options(fixed_joints);
  for (const std::string& frame : frames) options.read.scene.frames.push_back(frame_option(frame));
  options.warnings_are_errors = warnings_are_errors;
  options.in_processes = true;
  return options;
}

}  // namespace flatdyn
