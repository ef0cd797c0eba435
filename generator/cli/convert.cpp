// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "delivery/convert/conversion.hpp"
#include "delivery/convert/decimals.hpp"
#include "delivery/convert/round_trip.hpp"

namespace flatdyn {
namespace {

struct ConvertArguments : RobotArguments {
  std::string output;
};

bool is_toml(const std::string& path) { return path.ends_with(".toml"); }

// The name of the file, or of one in the format that can say everything where the result goes to stdout.
std::string named_output(const ConvertArguments& arguments) {
  return arguments.output == kStdout ? "robot.toml" : arguments.output;
}

// The numbers that were rounded must not change torques by more than this part of the largest.
constexpr double kSameTorque = 1e-15;

void check_round_trip(const Conversion& conversion, const RoundTrip& trip) {
  if (trip.is_exact || (!conversion.rounded.empty() && trip.largest < kSameTorque)) return;
  if (trip.where == "tip") {
    throw Failure(FailureKind::unsupported,
                  "the file would be read as a robot with another tip: its format has none, and is read as if the last "
                  "link, depth-first, were the tip",
                  "write a TOML file, or take that link: --tip; frames of --frame count as links");
  }
  throw Failure(FailureKind::unsupported,
                fmt::format("the file would be read as another robot: {} differs, and torques by {:.2g} of the largest",
                            trip.where, trip.largest),
                "numbers near to others are snapped when they are read: leave --snap out, or write a TOML file");
}

void note_rounded(const Conversion& conversion, const RoundTrip& trip, const ConvertArguments& arguments) {
  const std::string place = arguments.output == kStdout ? "standard output" : arguments.output;
  if (conversion.rounded.empty()) return;
  Diagnostics notes;
  notes.note({place, 0},
             fmt::format("{} numbers are no finite decimals and are rounded to {} digits; first: {}",
                         conversion.rounded.size(), kWrittenDigits, conversion.rounded.front()),
             trip.is_exact
                 ? "the file is read as the same mechanism, exactly"
                 : fmt::format("torques at random states differ by at most {:.2g} of the largest", trip.largest));
  print_diagnostics(notes, arguments);
}

ExitCode convert(const ConvertArguments& arguments) {
  const LoadedRobot model = load_robot(arguments.robot, arguments.options());
  print_diagnostics(model.diagnostics, arguments);
  check_outputs({arguments.output}, model.robot.files);
  const std::string output_name = named_output(arguments);
  Diagnostics lost;
  const Conversion conversion = (is_toml(output_name) ? toml_of : urdf_of)(model.robot, lost);
  if (lost.has_errors()) throw BadInput(FailureKind::unsupported, lost);
  const RoundTrip trip = round_trip(conversion.text, output_name, model);
  check_round_trip(conversion, trip);
  note_rounded(conversion, trip, arguments);
  CommandOutput output;
  output.text =
      trip.is_exact
          ? "read back: the same mechanism, exactly\n"
          : fmt::format("read back: torques at random states differ by at most {:.2g} of the largest\n", trip.largest);
  output.json = {{"exact", trip.is_exact}, {"largest_difference", trip.largest}, {"rounded", conversion.rounded}};
  write_and_print({{arguments.output, conversion.text}}, output, arguments);
  return ExitCode::ok;
}

}  // namespace

Run add_convert(CLI::App& app) {
  auto* command = app.add_subcommand(
      "convert",
      "Write the robot as understood into a new URDF or TOML file: links, joints, bodies, friction, limits, couplings, "
      "without what has nothing to do with dynamics. The file is read back and compared before it is written.\n\n"
      "  flatdyn convert robots/rx90.toml -o rx90.urdf\n"
      "  flatdyn convert robots/panda.urdf --fix panda_finger_joint1 --fix panda_finger_joint2 -o arm.toml");
  const auto arguments = std::make_shared<ConvertArguments>();
  arguments->add_to(*command);
  const auto has_format = [](const std::string& name) {
    const bool says = name.ends_with(".urdf") || is_toml(name) || name == kStdout;
    return says ? "" : "the file's name must end in .urdf or .toml";
  };
  command
      ->add_option("-o,--output", arguments->output,
                   "the file to write; its name says in which format; - writes TOML to stdout")
      ->required()
      ->check(CLI::Validator(has_format, ""))
      ->type_name("FILE.urdf|FILE.toml");
  return [arguments] { return convert(*arguments); };
}

}  // namespace flatdyn
