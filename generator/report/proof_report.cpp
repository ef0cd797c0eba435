// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/proof_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flatdyn {

std::string describe_proofs(const std::vector<Proof>& proofs, const AsReadResult& as_read,
                            const std::string& constants) {
  if (proofs.empty()) return "proven: nothing, as there is no function";
  int entries = 0;
  double worst = proofs.front().result.failure_log2;
  for (const Proof& proof : proofs) {
    entries += proof.result.entries;
    worst = std::max(worst, proof.result.failure_log2);
  }
  return fmt::format(
      "proven in exact arithmetic: all {} entries of {} function{} are what the Lagrangian says, each wrong with "
      "probability below 2^{:.0f}; the Lagrangian is that of {}; the text, read back, says the same with constants "
      "rounded to {}",
      entries, proofs.size(), proofs.size() == 1 ? "" : "s", std::ceil(worst), describe_as_read(as_read), constants);
}

std::string describe_as_read(const AsReadResult& as_read) {
  std::string text = fmt::format("the robot as read, its {} links", as_read.links);
  if (as_read.rotors > 0) text += fmt::format(" and {} rotor{}", as_read.rotors, as_read.rotors == 1 ? "" : "s");
  text += fmt::format(" by themselves ({} numbers", as_read.numbers);
  if (as_read.digits() < AsReadResult::kMostDigits) text += fmt::format(", to {} digits", as_read.digits());
  return text + (as_read.has_loops ? "; what closes its loops is not among them)" : ")");
}

nlohmann::ordered_json as_read_json(const AsReadResult& as_read) {
  nlohmann::ordered_json json = {{"links", as_read.links},
                                 {"rotors", as_read.rotors},
                                 {"numbers", as_read.numbers},
                                 {"digits", as_read.digits()},
                                 {"energies_equal", as_read.is_exact}};
  if (as_read.is_exact) {
    json["points"] = as_read.points;
    json["primes"] = as_read.primes;
    json["degree_at_most"] = as_read.degree_bound;
    json["log2_of_failure_below"] = std::ceil(as_read.failure_log2);
  }
  json["not_compared"] = nlohmann::ordered_json::array();
  if (as_read.has_loops) json["not_compared"].push_back("closure of loops");
  return json;
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
