// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/proof_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flatdyn {

std::string describe_proofs(const std::vector<Proof>& proofs, const std::string& constants) {
  if (proofs.empty()) return "proven: nothing, as there is no function";
  int entries = 0;
  double worst = proofs.front().result.failure_log2;
  for (const Proof& proof : proofs) {
    entries += proof.result.entries;
    worst = std::max(worst, proof.result.failure_log2);
  }
  return fmt::format(
      "proven in exact arithmetic: all {} entries of {} function{} are what the Lagrangian says, each wrong with "
      "probability below 2^{:.0f}; the text, read back, says the same with constants rounded to {}",
      entries, proofs.size(), proofs.size() == 1 ? "" : "s", std::ceil(worst), constants);
}

nlohmann::ordered_json proofs_json(const std::vector<Proof>& proofs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Proof& proof : proofs) {
    json.push_back({{"function", proof.function},
                    {"entries", proof.result.entries},
                    {"points", proof.result.points},
                    {"primes", proof.result.primes},
                    {"degree_at_most", proof.result.degree_bound},
                    {"log2_of_failure_below", std::ceil(proof.result.failure_log2)}});
  }
  return json;
}

}  // namespace flatdyn
