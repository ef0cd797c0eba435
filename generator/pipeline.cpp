// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>
#include <fstream>
#include <sstream>

namespace flatdyn {
namespace {

std::string hash_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  const std::string bytes = content.str();
  boost::uuids::detail::sha1 sha;
  sha.process_bytes(bytes.data(), bytes.size());
  boost::uuids::detail::sha1::digest_type digest;
  sha.get_digest(digest);
  std::string text = "sha1:";
  for (const auto word : digest) text += fmt::format("{:08x}", word);
  return text;
}

std::vector<std::string> names_of_functions(bool on_request) {
  std::vector<std::string> names;
  for (const FunctionEntry& entry : function_table()) {
    if (entry.on_request == on_request) names.emplace_back(entry.name);
  }
  return names;
}

}  // namespace

Model read_model(const std::filesystem::path& path, const PipelineOptions& options) {
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_robot(path, options.read, diagnostics);
  const bool refused_warnings = options.warnings_are_errors && diagnostics.has_warnings();
  if (!robot || refused_warnings) {
    const ExitCode code = diagnostics.only_unsupported() ? ExitCode::unsupported : ExitCode::input;
    throw BadInput(code, std::move(diagnostics));
  }
  Mechanism mechanism = make_mechanism(*robot);
  return {std::move(*robot), std::move(mechanism), std::move(diagnostics), hash_of(path)};
}

std::vector<std::string> default_function_names() { return names_of_functions(false); }
std::vector<std::string> requested_function_names() { return names_of_functions(true); }

std::vector<OptimisedFunction> make_functions(const Model& model, const PipelineOptions& options, Progress& progress) {
  std::vector<OptimisedFunction> result;
  for (const std::string& name : options.functions.empty() ? default_function_names() : options.functions) {
    progress.step("deriving " + name);
    Function derived = derive_function(model.mechanism, name);
    OptimisedFunction optimised{{}, count_operations(derived), {}};
    progress.step("optimising " + name);
    optimised.function = run_passes(std::move(derived), &optimised.passes);
    result.push_back(std::move(optimised));
  }
  return result;
}

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised) {
  std::vector<Function> functions;
  for (const OptimisedFunction& each : optimised) functions.push_back(each.function);
  return functions;
}

}  // namespace flatdyn
