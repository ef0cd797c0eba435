// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/proof.hpp"

#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/readers.hpp"
#include "robot/input/common/content_hash.hpp"

namespace flatdyn {
namespace {

// One point modulo each prime: a difference stays unseen with a probability of about 2^-150, but for functions of large
// degree, which take more.
ExactOptions quick(std::uint64_t seed) { return {seed, 1, kEnoughPoints}; }

[[noreturn]] void refuse(const std::string& why) {
  throw Failure(FailureKind::verification_failed, why,
                "nothing was written; this is a mistake of the program: report it, with the robot file");
}

void require(const ExactResult& result, const std::string& function, const std::string& than) {
  if (!result.equal) refuse(function + " is not what " + than + ": " + result.summary());
}

Proof proof_of(const Mechanism& mechanism, const std::string& name, const Function& function, std::uint64_t seed) {
  Proof proof{name, prove_exactly(mechanism, function, quick(seed))};
  require(proof.result, name, "the Lagrangian says");
  return proof;
}

void require_unchanged(const Function& derived, const Function& function, std::uint64_t seed) {
  require(prove_equal(derived, function, quick(seed)), function.name, "it was before the passes");
}

}  // namespace

std::uint64_t proof_seed(const std::vector<std::string>& contents) {
  constexpr std::size_t kDigits = 16;
  constexpr int kHexadecimal = 16;
  const std::string hash = content_hash(contents);  // "sha1:…"
  return std::stoull(hash.substr(hash.find(':') + 1, kDigits), nullptr, kHexadecimal);
}

std::vector<Proof> prove(const Mechanism& mechanism, const std::vector<OptimisedFunction>& functions,
                         const std::vector<OptimisedFusion>& fused, const std::optional<Stages>& stages,
                         std::uint64_t seed) {
  std::vector<Proof> proofs;
  for (const OptimisedFunction& each : functions) {
    proofs.push_back(proof_of(mechanism, each.function.name, each.function, seed));
    require_unchanged(each.derived, each.function, seed);
  }
  for (const OptimisedFusion& each : fused) {
    const Fusion& fusion = each.fusion;
    for (std::size_t k = 0; k < fusion.parts.size(); ++k) {
      const std::string name = fusion.function.name + "::" + fusion.parts[k].name;
      proofs.push_back(proof_of(mechanism, name, function_of(fusion, k), seed));
    }
    require_unchanged(each.derived, fusion.function, seed);
  }
  if (stages) {
    for (const Function& member : members_in_full(*stages)) {
      proofs.push_back(proof_of(mechanism, "at(q)::" + member.name, member, seed));
    }
  }
  return proofs;
}

AsReadResult prove_robot(const Robot& robot, const Mechanism& mechanism) {
  AsReadResult result = prove_as_read(robot, mechanism);
  if (!result.holds) refuse("the mechanism is not the robot as read: " + result.summary());
  return result;
}

void prove_text(const EmittedText& text, const WrittenCode& code, std::uint64_t seed) {
  const std::vector<Function> wanted = functions_in_text(code);
  if (text.functions().size() != wanted.size()) {
    throw Failure(FailureKind::bug, "the emitted text has other functions than were made");
  }
  read_file(text, contents_of(code));
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Function printed = as_printed(wanted[k], text.constants());
    require(prove_equal(printed, text.read(k, printed), quick(seed)), "the text of " + wanted[k].name,
            "was to be printed");
  }
}

void prove_batch(const std::string& header, const std::string& batch, WrittenCode code, std::uint64_t seed) {
  prove_text(EmittedText(header + batch, batch_reader(code.options)), code, seed);
}

}  // namespace flatdyn
