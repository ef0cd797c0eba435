// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/gappa.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {
namespace {

Verdict verdict_on(const GappaScript& script, std::size_t index, const std::filesystem::path& folder, double seconds) {
  constexpr int kOutOfTime = 124;  // the exit status of `timeout`
  const std::string file = fmt::format("{}.g", index);
  write_file(folder / file, script.text);
  const int code = run_command(fmt::format("timeout {} gappa {} > /dev/null 2>&1", seconds, file), folder);
  return code == 0 ? Verdict::proven : code == kOutOfTime ? Verdict::out_of_time : Verdict::refused;
}

}  // namespace

bool has_gappa() {
  static const bool found = run_command("gappa --version > /dev/null 2>&1", temporary_root()) == 0;
  return found;
}

std::vector<Verdict> run_gappa(const std::vector<GappaScript>& scripts, double seconds) {
  const TemporaryFolder folder;
  std::vector<Verdict> verdicts(scripts.size(), Verdict::refused);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < scripts.size(); k = next++) {
      verdicts[k] = verdict_on(scripts[k], k, folder.path(), seconds);
    }
  };
  std::vector<std::future<void>> running;
  for (unsigned core = 0; core < std::max(1u, std::thread::hardware_concurrency()); ++core) {
    running.push_back(std::async(std::launch::async, work));
  }
  for (std::future<void>& each : running) each.get();
  return verdicts;
}

}  // namespace flatdyn
