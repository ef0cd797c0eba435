// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/toolchain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <future>

#include "diagnostics/diagnostics.hpp"
#include "diagnostics/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

bool succeeds(const std::string& command) {
  return run_command(command + " > /dev/null 2>&1", fs::temp_directory_path()).status == 0;
}

Finished compiler_run(const std::string& command, const fs::path& folder, const std::string& log) {
  // A cached object would say nothing about the compiler's time.
  const Finished finished = run_command(fmt::format("CCACHE_DISABLE=1 {} > {} 2>&1", command, log), folder);
  if (finished.status != 0) {
    throw Failure(ExitCode::bug, fmt::format("{}\ndoes not compile:\n{}", command, content_of_file(folder / log)));
  }
  return finished;
}

}  // namespace

std::string Toolchain::version() const {
  const TemporaryFolder folder;
  run_command(compiler + " --version > version", folder.path());
  const std::string text = content_of_file(folder.path() / "version");
  return text.substr(0, text.find('\n'));
}

Toolchain find_toolchain() {
  const char* chosen = std::getenv("CXX");
  Toolchain toolchain;
  toolchain.compiler = chosen != nullptr && *chosen != '\0' ? chosen : "c++";
  if (!succeeds(toolchain.compiler + " --version")) {
    throw Failure(ExitCode::io, fmt::format("no C++ compiler: {} cannot be run", toolchain.compiler),
                  "install g++ or set CXX");
  }
  toolchain.has_xsimd = succeeds("echo '#include <xsimd/xsimd.hpp>' | " + toolchain.compiler + " -M -x c++ -");
  toolchain.has_eigen = succeeds("pkg-config --exists eigen3");
  toolchain.has_kdl = toolchain.has_eigen && succeeds("pkg-config --exists orocos-kdl");
  return toolchain;
}

Finished compile_object(const Toolchain& toolchain, const fs::path& folder, const std::string& stem,
                        const std::string& flags) {
  return compiler_run(fmt::format("{0} {1} -I. -c {2}.cpp -o {2}.o", toolchain.compiler, flags, stem), folder,
                      stem + ".log");
}

std::vector<Finished> compile_objects(const Toolchain& toolchain, const fs::path& folder,
                                      const std::vector<CompileJob>& jobs) {
  std::vector<std::future<Finished>> running;
  for (const CompileJob& job : jobs) {
    running.push_back(std::async(std::launch::async, [&toolchain, &folder, &job] {
      return compile_object(toolchain, folder, job.stem, job.flags);
    }));
  }
  std::vector<Finished> finished;
  for (std::future<Finished>& each : running) finished.push_back(each.get());
  return finished;
}

void link_program(const Toolchain& toolchain, const fs::path& folder, const std::vector<std::string>& stems,
                  const std::string& libraries) {
  const std::string objects = fmt::format("{}.o", fmt::join(stems, ".o "));
  compiler_run(fmt::format("{} {} -o program {}", toolchain.compiler, objects, libraries), folder, "link.log");
}

}  // namespace flatdyn
