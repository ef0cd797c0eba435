// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/derive.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "report/json_text.hpp"

namespace flatdyn {
namespace {

struct DeriveArguments : RobotArguments {
  DeriveOptions derive;
  bool latex = false;
};

nlohmann::ordered_json derived_json(const std::vector<DerivedLine>& lines) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const DerivedLine& line : lines) {
    json.push_back({{"name", line.name}, {"text", line.text}, {"terms", line.terms}, {"left_out", line.left_out}});
  }
  return json;
}

// Frames, order and units, and the names of the entries of v, dv/dt and tau.
void add_conventions(const DerivedModel& model, nlohmann::ordered_json& json) {
  json["conventions"] = model.conventions;
  json["entries"] = nlohmann::ordered_json::array();
  for (const EntryNames& entry : model.entries) {
    json["entries"].push_back(
        {{"velocity", entry.velocity}, {"acceleration", entry.acceleration}, {"torque", entry.torque}});
  }
}

nlohmann::ordered_json derived_json(const DerivedModel& model) {
  nlohmann::ordered_json json = {{"joints", derived_json(model.joints)}};
  if (model.has_quasi_velocities) add_conventions(model, json);
  json["inertia"] = derived_json(model.inertia);
  if (model.has_quasi_velocities) {
    json["velocity_terms"] = derived_json(model.velocity_terms);
  } else {
    json["shared"] = derived_json(model.shared);
    json["christoffel"] = derived_json(model.christoffel);
  }
  json["gravity"] = derived_json(model.gravity);
  json["equations"] = derived_json(model.equations);
  json["notes"] = model.notes;
  return json;
}

ExitCode run_derive(const DeriveArguments& arguments) {
  const LoadedRobot model = load_robot(arguments.robot, arguments.options());
  print_diagnostics(model.diagnostics, arguments);
  arguments.note_function_keys(model);
  if (arguments.json) {
    const Notation notation = arguments.latex ? Notation::latex : Notation::text;
    print_result(json_text(derived_json(derive_model(model.mechanism, arguments.derive, notation))));
  } else if (arguments.latex) {
    print_result(derive_latex(model.mechanism, arguments.derive));
  } else {
    print_result(derive_text(model.mechanism, arguments.derive));
  }
  return ExitCode::ok;
}

}  // namespace

Run add_derive(CLI::App& app) {
  auto* command =
      app.add_subcommand("derive",
                         "Print B, the Christoffel symbols, g and the equations of motion in closed form.\n\n"
                         "  flatdyn derive robots/planar_2r.toml\n"
                         "  flatdyn derive robots/planar_2r.toml --latex");
  const auto arguments = std::make_shared<DeriveArguments>();
  arguments->add_to(*command);
  command->add_flag("--latex", arguments->latex, "as LaTeX");
  command->add_option("--max-terms", arguments->derive.max_terms, "leave out longer expressions, saying so")
      ->check(number_between(0, 1e9))
      ->capture_default_str();
  command
      ->add_option("--digits", arguments->derive.digits,
                   "round numbers to so many significant digits; default: they are exact")
      ->check(CLI::Range(1, 50))
      ->type_name("N");
  return [arguments] { return run_derive(*arguments); };
}

}  // namespace flatdyn
