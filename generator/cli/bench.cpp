// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/bench.hpp"

#include <fmt/format.h>

#include <set>

#include "laboratory/bench/gpu.hpp"
#include "laboratory/bench/growth.hpp"

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"
#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "code/languages/language_table.hpp"
#include "pipeline/generation.hpp"
#include "report/bench_plot.hpp"
#include "report/bench_report.hpp"
#include "report/generator_report.hpp"
#include "report/gpu_report.hpp"
#include "report/growth_report.hpp"
#include "report/json_text.hpp"

namespace flatdyn {
namespace {

struct BenchArguments : RobotArguments {
  std::vector<std::string> robots;
  std::vector<std::string> functions;
  std::string folder;
  BenchOptions bench;
  bool growth = false;
  GrowthOptions growth_plan;
  bool generator = false;
  bool gpu = false, prepare = false;
};

// Writes the results where they are wanted. They are printed first, so that measurements are not lost with a file that
// cannot be written.
void deliver(const BenchArguments& arguments, const std::string& name, const nlohmann::ordered_json& json,
             const std::string& text, const std::function<std::string()>& picture) {
  print_result(arguments.json ? json_text(json) : text);
  std::fflush(stdout);
  if (arguments.folder.empty()) return;
  const std::string stem = (std::filesystem::path(arguments.folder) / name).string();
  std::vector<TextFile> files = {{stem + ".json", json_text(json)}};
  if (picture) files.push_back({stem + ".svg", picture()});
  write_files(files);
  if (arguments.json || arguments.quiet) return;
  for (const TextFile& file : files) fmt::print("wrote {}\n", file.path.string());
}

BenchReport bench_robot(const BenchArguments& arguments, const std::string& robot) {
  PipelineOptions options = arguments.options();
  options.functions = arguments.functions;
  const LoadedRobot model = load_robot(robot, options);
  refuse_loops(model, "bench");
  print_diagnostics(model.diagnostics, arguments);
  if (model.robot.scene.at_rest || !model.robot.scene.outputs.empty()) {
    throw Failure(FailureKind::unsupported, "bench compares whole functions in motion with peers",
                  "take static and [outputs] out of the scene");
  }
  Diagnostics findings;
  Progress progress(arguments.quiet);
  const std::vector<Function> functions = functions_of(make_functions(model, options, progress, findings));
  print_diagnostics(findings, arguments);
  return bench(model, functions, arguments.bench, progress);
}

ExitCode run_robots(const BenchArguments& arguments) {
  std::vector<BenchReport> reports;
  for (const std::string& robot : arguments.robots) reports.push_back(bench_robot(arguments, robot));
  nlohmann::ordered_json json = {{"robots", nlohmann::ordered_json::array()}};
  std::string text;
  for (const BenchReport& report : reports) {
    json["robots"].push_back(bench_json(report));
    text += (text.empty() ? "" : "\n") + bench_text(report);
  }
  deliver(arguments, "bench", json, text, [&reports] { return bench_plot(reports); });
  return ExitCode::ok;
}

ExitCode run_growth(const BenchArguments& arguments) {
  GrowthOptions options = arguments.growth_plan;
  options.seconds = arguments.bench.seconds;
  options.seed = arguments.bench.seed;
  if (!arguments.functions.empty()) options.functions = arguments.functions;
  Progress progress(arguments.quiet);
  const GrowthReport report = bench_growth(options, progress);
  deliver(arguments, "growth", growth_json(report), growth_text(report), [&report] { return growth_plot(report); });
  return ExitCode::ok;
}

ExitCode run_generator(const BenchArguments& arguments) {
  GenerationOptions options;
  static_cast<PipelineOptions&>(options) = arguments.options();
  options.functions = arguments.functions;
  options.in_processes = false;  // the cost of each function by itself
  Progress progress(arguments.quiet);
  const GenerationResult result = generate_code(arguments.robots.front(), options, progress);
  print_diagnostics(result.robot.diagnostics, arguments);
  print_diagnostics(result.findings, arguments);
  const GeneratorCost cost{result.robot.mechanism.name, progress.steps(), result.functions};
  deliver(arguments, "generator", generator_json(cost), generator_text(cost), {});
  return ExitCode::ok;
}

// The robot's files in the folder of the benchmark on a graphics processor; its lines of cases are added to `cases`.
std::vector<SourceFile> gpu_robot(const BenchArguments& arguments, const std::string& robot, std::string& cases) {
  GenerationOptions options;
  static_cast<PipelineOptions&>(options) = arguments.options();
  options.functions = arguments.functions;
  options.form.language = language_with(&LanguageRow::has_kernels).option;
  {
    const LoadedRobot read = load_robot(robot, options);
    refuse_loops(read, "bench");
    refuse_spherical_joints(read, "bench --gpu");
    check_for_gpu(read.mechanism);
    options.form.name_space = gpu_name(read.mechanism);
  }
  Progress progress(arguments.quiet);
  const std::vector<GenerationResult> results = generate_code_for(robot, options, {"float", "double"}, progress);
  const GenerationResult& first = results.front();
  print_diagnostics(first.robot.diagnostics, arguments);
  print_diagnostics(first.findings, arguments);
  progress.step("computing in 50 digits");
  const std::vector<Function> functions = functions_of(first);
  const GpuSubject subject{options.form.name_space, first.robot.mechanism, functions, first.files.front().text,
                           results.back().files.front().text};
  cases += gpu_cases(subject);
  return gpu_files(subject);
}

// Writes the folder of the benchmark, all files or none.
void write_gpu_folder(const std::filesystem::path& folder, const std::vector<SourceFile>& sources) {
  std::vector<TextFile> files;
  for (const SourceFile& source : sources) files.push_back({folder / source.path, source.text});
  write_files(files);
  using std::filesystem::perms;
  constexpr perms kRuns = perms::owner_exec | perms::group_exec | perms::others_exec;
  std::filesystem::permissions(folder / "run", kRuns, std::filesystem::perm_options::add);
}

// Refuses two robots of one name, whose files have the same names.
void check_gpu_names(const std::vector<SourceFile>& sources) {
  std::set<std::filesystem::path> names;
  for (const SourceFile& source : sources) {
    if (names.insert(source.path).second) continue;
    throw Failure(FailureKind::usage, fmt::format("bench --gpu: two robots would write {}", source.path.string()),
                  "measure them one by one");
  }
}

ExitCode run_gpu(const BenchArguments& arguments) {
  if (!arguments.prepare) require_gpu();
  std::vector<SourceFile> sources;
  std::string cases;
  for (const std::string& robot : arguments.robots) {
    for (SourceFile& file : gpu_robot(arguments, robot, cases)) sources.push_back(std::move(file));
  }
  check_gpu_names(sources);
  for (SourceFile& file : gpu_program(cases)) sources.push_back(std::move(file));
  if (arguments.prepare) {
    write_gpu_folder(arguments.folder, sources);
    if (!arguments.quiet) fmt::print("wrote {0}: run {0}/run where there are nvcc and a device\n", arguments.folder);
    return ExitCode::ok;
  }
  const TemporaryFolder folder;
  write_gpu_folder(folder.path(), sources);
  const int status = run_command("TMPDIR=. ./run > printed 2> log", folder.path());
  GpuReport report = read_gpu_report(content_of_file(folder.path() / "printed"));
  if (status != 0) report.failures.push_back("run has failed: " + content_of_file(folder.path() / "log"));
  deliver(arguments, "gpu", gpu_json(report), gpu_text(report), {});
  return report.failures.empty() ? ExitCode::ok : ExitCode::bug;
}

void check_gpu(const BenchArguments& arguments) {
  if (arguments.prepare && arguments.folder.empty()) {
    throw Failure(FailureKind::usage, "--prepare writes a folder, and none is named", "name one with -o");
  }
}

void check_generator(const BenchArguments& arguments) {
  if (arguments.robots.size() == 1) return;
  throw Failure(FailureKind::usage, "--generator measures one robot, as peak memory is that of the whole program",
                "name one robot file");
}

ExitCode run_bench(const BenchArguments& arguments) {
  if (arguments.growth && !arguments.robots.empty()) {
    throw Failure(FailureKind::usage, "--growth makes its own robots", "leave out " + arguments.robots.front());
  }
  if (!arguments.growth && arguments.robots.empty()) {
    throw Failure(FailureKind::usage, "no robot file is given", "name one, or ask for --growth");
  }
  if (arguments.growth && !arguments.search.empty()) {
    throw Failure(FailureKind::usage, "--growth takes the usual choices", "leave out --search");
  }
  if (arguments.generator) {
    check_generator(arguments);
    return run_generator(arguments);
  }
  if (arguments.gpu) {
    check_gpu(arguments);
    return run_gpu(arguments);
  }
  return arguments.growth ? run_growth(arguments) : run_robots(arguments);
}

}  // namespace

Run add_bench(CLI::App& app) {
  auto* command = app.add_subcommand(
      "bench",
      "Measure run time and rounding errors of every function, in every variant, beside other libraries.\n\n"
      "  flatdyn bench robots/panda.urdf --functions inverse_dynamics,inertia_matrix\n"
      "  flatdyn bench robots/panda.urdf robots/ur5.urdf -o out/ --time 60\n"
      "  flatdyn bench --growth --joints 16 -o out/\n"
      "  flatdyn bench --generator robots/panda.urdf\n"
      "  flatdyn bench --gpu robots/panda.urdf --functions inverse_dynamics,inertia_matrix");
  const auto arguments = std::make_shared<BenchArguments>();
  command->add_option("robot", arguments->robots, kRobotMeaning)->type_name("FILE");
  arguments->add_settings_to(*command);
  add_functions_option(*command, arguments->functions);
  add_error_budget_option(*command, *arguments);
  add_search_option(*command, *arguments);
  command->add_option("--time", arguments->bench.seconds, "of all timing; per robot")
      ->capture_default_str()
      ->type_name("S")
      ->check(number_between(0.001, 1e5));
  add_names_option(*command, "--variants", arguments->bench.variants,
                   fmt::format("ways to call, and peers, separated by commas; default: all of {}",
                               fmt::join(bench_variant_names(), ", ")));
  command->add_option("--states", arguments->bench.states, "random states at which errors are measured, at most")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->add_option("--seed", arguments->bench.seed, "of the states and of the order of the runs")
      ->capture_default_str();
  auto* gpu = command->add_flag("--gpu", arguments->gpu,
                                "instead: the CUDA form on a graphics processor, in float and double; needs nvcc "
                                "(or $NVCC) and a device");
  command
      ->add_flag("--prepare", arguments->prepare,
                 "write the folder -o for another machine, where its `run` compiles and measures; needs neither")
      ->needs(gpu);
  auto* growth =
      command->add_flag("--growth", arguments->growth,
                        "instead: cost over the number of joints, of chains and trees of 2, 4, 8 ... joints");
  command
      ->add_flag("--generator", arguments->generator,
                 "instead: the cost of generation itself, by stage and function: processor time and peak memory; of "
                 "one robot, with all functions that generate writes by default")
      ->excludes(growth)
      ->excludes(gpu);
  growth->excludes(gpu);
  for (const char* option : {"--time", "--variants", "--states", "--seed"}) gpu->excludes(option);
  command->add_option("--joints", arguments->growth_plan.joints, "of the largest of these, at most")
      ->capture_default_str()
      ->check(CLI::Range(2, 64))
      ->needs("--growth");
  command
      ->add_option(
          "-o,--output", arguments->folder,
          "folder for bench.json and bench.svg (growth.json and growth.svg; generator.json; gpu.json); made if "
          "it is not there")
      ->check(folder_name())
      ->type_name("FOLDER");
  return [arguments] { return run_bench(*arguments); };
}

}  // namespace flatdyn
