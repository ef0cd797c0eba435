// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/proof.hpp"

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

// One point modulo each prime: a difference stays unseen with a probability of about 2^-150.
constexpr ExactOptions kQuick{1, 1};

[[noreturn]] void refuse(const std::string& why) {
  throw Failure(ExitCode::verification_failed, why,
                "nothing was written; this is a mistake of the program: report it, with the robot file");
}

void require(const ExactResult& result, const std::string& function, const std::string& than) {
  if (!result.equal) refuse(function + " is not what " + than + ": " + result.summary());
}

Proof proof_of(const Mechanism& mechanism, const std::string& name, const Function& function) {
  Proof proof{name, prove_exactly(mechanism, function, kQuick)};
  require(proof.result, name, "the Lagrangian says");
  return proof;
}

void require_unchanged(const Function& derived, const Function& function) {
  require(prove_equal(derived, function, kQuick), function.name, "it was before the passes");
}

// The functions in the order of the text.
std::vector<Function> written(const std::vector<OptimisedFunction>& functions, const std::optional<Stages>& stages) {
  std::vector<Function> list = functions_of(functions);
  if (!stages) return list;
  const auto add = [&list](const Stage& stage) {
    list.push_back(stage.make);
    list.insert(list.end(), stage.members.begin(), stage.members.end());
  };
  add(stages->configuration);
  if (!stages->motion.members.empty()) add(stages->motion);
  return list;
}

}  // namespace

std::vector<Proof> prove(const Mechanism& mechanism, const std::vector<OptimisedFunction>& functions,
                         const std::optional<OptimisedFusion>& fused, const std::optional<Stages>& stages) {
  std::vector<Proof> proofs;
  for (const OptimisedFunction& each : functions) {
    proofs.push_back(proof_of(mechanism, each.function.name, each.function));
    require_unchanged(each.derived, each.function);
  }
  if (fused) {
    const Fusion& fusion = fused->fusion;
    for (std::size_t k = 0; k < fusion.parts.size(); ++k) {
      const std::string name = fusion.function.name + "::" + fusion.parts[k].name;
      proofs.push_back(proof_of(mechanism, name, function_of(fusion, k)));
    }
    require_unchanged(fused->derived, fusion.function);
  }
  if (stages) {
    for (const Function& member : members_in_full(*stages)) {
      proofs.push_back(proof_of(mechanism, "at(q)::" + member.name, member));
    }
  }
  return proofs;
}

AsReadResult prove_robot(const Robot& robot, const Mechanism& mechanism) {
  AsReadResult result = prove_as_read(robot, mechanism);
  if (!result.holds) refuse("the mechanism is not the robot as read: " + result.summary());
  return result;
}

void prove_text(const EmittedText& text, const std::vector<OptimisedFunction>& functions,
                const std::optional<Stages>& stages) {
  const std::vector<Function> wanted = written(functions, stages);
  if (text.functions().size() != wanted.size()) {
    throw Failure(ExitCode::bug, "the emitted text has other functions than were made");
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Function printed = as_printed(wanted[k], text.constants());
    require(prove_equal(printed, text.read(k, printed), kQuick), "the text of " + wanted[k].name, "was to be printed");
  }
}

void prove_text(const std::string& header, const std::vector<OptimisedFunction>& functions,
                const std::optional<Stages>& stages) {
  prove_text(EmittedText(header), functions, stages);
}

}  // namespace flatdyn
