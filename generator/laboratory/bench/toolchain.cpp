// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/toolchain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <future>
#include <sstream>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

bool succeeds(const std::string& command) { return run_command(command + " > /dev/null 2>&1", temporary_root()) == 0; }

void compiler_run(const std::string& command, const fs::path& folder, const std::string& log) {
  if (run_command(fmt::format("export LC_ALL=C; ({}) > {} 2>&1", command, log), folder) == 0) return;
  const std::string messages = content_of_file(folder / log);
  check_room(folder, messages);
  throw Failure(FailureKind::bug, fmt::format("{}\nfails:\n{}", command, messages));
}

std::string compile_command(const Toolchain& toolchain, const CompileJob& job) {
  return fmt::format("{0} {1} -I. -c {2}.cpp -o {2}.o", toolchain.compiler, job.flags, job.stem);
}

}  // namespace

std::string Toolchain::version() const {
  const TemporaryFolder folder;
  run_command(compiler + " --version > version", folder.path());
  const std::string text = content_of_file(folder.path() / "version");
  return text.substr(0, text.find('\n'));
}

std::string bench_flags() { return *kTuning == '\0' ? kNativeFlags : fmt::format("{} {}", kNativeFlags, kTuning); }

Toolchain find_toolchain() {
  Toolchain toolchain;
  toolchain.compiler = machine_compiler();
  const auto has_header = [&toolchain](const std::string& name) {
    return succeeds(fmt::format("echo '#include <{}>' | {} -M -x c++ -", name, toolchain.compiler));
  };
  toolchain.has_xsimd = has_header("xsimd/xsimd.hpp");
  toolchain.has_eigen = succeeds("pkg-config --exists eigen3");
  toolchain.has_kdl = toolchain.has_eigen && succeeds("pkg-config --exists orocos-kdl");
  toolchain.has_mujoco = has_header("mujoco/mujoco.h");
  toolchain.has_dart = toolchain.has_eigen && succeeds("pkg-config --exists dart");
  const char* const peers = std::getenv("FLATDYN_PEERS");
  if (peers != nullptr && fs::exists(fs::path(peers) / "library.o")) {
    toolchain.peers_folder = fs::absolute(peers).string();
  }
  return toolchain;
}

void compile_objects(const Toolchain& toolchain, const fs::path& folder, const std::vector<CompileJob>& jobs) {
  std::vector<std::future<void>> running;
  for (const CompileJob& job : jobs) {
    running.push_back(std::async(std::launch::async, [&toolchain, &folder, &job] {
      compiler_run(compile_command(toolchain, job), folder, job.stem + ".log");
    }));
  }
  for (std::future<void>& each : running) each.get();
}

void record_source(const fs::path& folder, const std::string& command, const std::string& file) {
  compiler_run(fmt::format("{} > {}", command, file), folder, file + ".log");
}

CompilerUsage compiler_usage(const Toolchain& toolchain, const fs::path& folder, const CompileJob& job) {
  compiler_run(fmt::format("{} -O1 usage.cpp -o usage", toolchain.compiler), folder, "usage.log");
  // ccache is disabled: a cached object would say nothing about the compiler.
  compiler_run(fmt::format("CCACHE_DISABLE=1 ./usage '{}'", compile_command(toolchain, job)), folder, "used");
  CompilerUsage usage;
  std::istringstream(content_of_file(folder / "used")) >> usage.seconds >> usage.peak_kilobytes;
  return usage;
}

void link_program(const Toolchain& toolchain, const fs::path& folder, const std::vector<std::string>& stems,
                  const std::string& libraries) {
  const std::string objects = fmt::format("{}.o", fmt::join(stems, ".o "));
  compiler_run(fmt::format("{} {} -o program {}", toolchain.compiler, objects, libraries), folder, "link.log");
}

}  // namespace flatdyn
