// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/proof_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatdyn {
namespace {

// Functions whose degree is too large for the primes: they are equal at random points, and that is all.
std::string without_bound(const std::vector<Proof>& proofs) {
  std::vector<std::string> texts;
  for (const Proof& proof : proofs) {
    if (!proof.result.is_weak()) continue;
    texts.push_back(fmt::format("{} (at {} random points)", proof.function, proof.result.points));
  }
  if (texts.empty()) return "";
  return fmt::format("; the probability of a mistake has no bound, because of too large a degree, for {}",
                     fmt::join(texts, ", "));
}

}  // namespace

std::string describe_proofs(const std::vector<Proof>& proofs, const AsReadResult& as_read,
                            const std::string& constants) {
  if (proofs.empty()) return "proven: nothing, as there is no function";
  int entries = 0;
  double worst = std::numeric_limits<double>::lowest();
  for (const Proof& proof : proofs) {
    entries += proof.result.entries;
    if (!proof.result.is_weak()) worst = std::max(worst, proof.result.failure_log2);
  }
  const bool all_weak =
      std::all_of(proofs.begin(), proofs.end(), [](const Proof& each) { return each.result.is_weak(); });
  const std::string bound =
      all_weak ? "" : fmt::format(", each wrong with probability below 2^{:.0f}", std::ceil(worst));
  return fmt::format(
      "proven in exact arithmetic: all {} entries of {} function{} are what the Lagrangian says{}{}; the Lagrangian is "
      "that of {}; the text, read back, says the same with constants rounded to {}",
      entries, proofs.size(), proofs.size() == 1 ? "" : "s", bound, without_bound(proofs), describe_as_read(as_read),
      constants);
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
