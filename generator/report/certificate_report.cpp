// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/certificate_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/diagnostics/version.hpp"
#include "code/readback/file_reader.hpp"
#include "report/fields.hpp"
#include "report/snap_report.hpp"
#include "robot/model/rounded_up.hpp"

namespace flatdyn {
namespace {

// The most rows of a table; longer ones show the largest bounds, and the files have all of them.
constexpr std::size_t kLongestTable = 12;

const std::string kAllZero = "Every entry is 0, and so is its error.\n";

const char* prover(const Certificate& certificate, const CertifiedOutput& output) {
  if (output.terms == 0) return "exact";
  if (!certificate.by_gappa) return "flatdyn";
  switch (output.verdict) {
    case Verdict::proven:
      return "Gappa";
    case Verdict::out_of_time:
      return "flatdyn: Gappa ran out of time";
    case Verdict::refused:
      break;
  }
  return "flatdyn: GAPPA REFUSES IT";
}

double ratio(const CertifiedOutput& output) { return output.observed > 0 ? output.bound / output.observed : 0; }

const char* verdict_name(Verdict verdict) {
  return verdict == Verdict::proven ? "proven" : verdict == Verdict::refused ? "refused" : "out of time";
}

ReportFields<CertifiedOutput> output_fields(const Certificate& certificate) {
  using Json = nlohmann::ordered_json;
  const auto effort_used = [](const CertifiedOutput& each) {
    return each.effort ? Json(100 * each.bound / *each.effort) : Json();
  };
  const auto gappa = [&certificate](const CertifiedOutput& each) {
    return certificate.by_gappa ? Json(verdict_name(each.verdict)) : Json();
  };
  return {{"output", "output", &CertifiedOutput::name},
          {"", "also", &CertifiedOutput::also},
          {"", "result", &CertifiedOutput::result},
          {"unit", "unit", &CertifiedOutput::unit},
          {"bound", "bound", &CertifiedOutput::bound, "{:.3e}"},  // all digits of the bound
          {"seen", "", [](auto& each) { return rounded_down(each.observed, 3); }, "{:.2e}"},
          {"", "seen", &CertifiedOutput::observed},
          {"ratio", "", [](auto& each) { return each.observed > 0 ? fmt::format("{:.3g}", ratio(each)) : "-"; }},
          {"of effort", "", effort_used, "{:.2g} %"},
          {"proven by", "", [&certificate](auto& each) { return prover(certificate, each); }},
          {"", "errors", &CertifiedOutput::terms},
          {"", "effort_limit", [](auto& each) { return each.effort ? Json(*each.effort) : Json(); }},
          {"", "gappa", gappa}};
}

// The outputs with the largest bound, the largest ratio, and those that Gappa did not prove.
std::vector<CertifiedOutput> most_telling(const Certificate& certificate, std::vector<CertifiedOutput> outputs) {
  if (outputs.size() <= kLongestTable) return outputs;
  const auto by = [&outputs](auto less) { return *std::max_element(outputs.begin(), outputs.end(), less); };
  std::vector<CertifiedOutput> chosen = {by([](const auto& a, const auto& b) { return a.bound < b.bound; }),
                                         by([](const auto& a, const auto& b) { return ratio(a) < ratio(b); })};
  if (chosen[0].name == chosen[1].name) chosen.pop_back();
  for (const CertifiedOutput& output : outputs) {
    const bool is_shown = output.name == chosen.front().name || output.name == chosen.back().name;
    if (certificate.by_gappa && output.verdict != Verdict::proven && !is_shown) chosen.push_back(output);
  }
  return chosen;
}

std::string heading(const CertifiedFunction& function) {
  return fmt::format("{}: bounds in {:.1f} s, Gappa {:.1f} s", function.name, function.seconds, function.gappa_seconds);
}

// Says whether errors are proven to be below the share `enough` of the effort limits ("enough", "not proven to be
// enough", "not enough"), and where not.
std::string judgement(const Certificate& certificate, double enough) {
  std::vector<std::string> unproven, exceeded;
  bool has_torques = false;
  for (const CertifiedFunction& function : certificate.functions) {
    for (const CertifiedOutput& output : function.outputs) {
      if (!output.effort) continue;
      has_torques = true;
      const double allowed = enough * *output.effort;
      const std::string name = function.name + "::" + output.name;
      if (output.observed > allowed) {
        exceeded.push_back(name);
      } else if (output.bound > allowed) {
        unproven.push_back(name);
      }
    }
  }
  if (!has_torques) return "";
  const std::string part = fmt::format("{:.3g} % of the joints' effort limits", 100 * enough);
  if (!exceeded.empty()) {
    return fmt::format("{} is not enough: errors of more than {} were seen in {}\n", certificate.scalar, part,
                       fmt::join(exceeded, ", "));
  }
  if (!unproven.empty()) {
    return fmt::format("{} is not proven to be enough for {}: {}; larger errors were not seen\n", certificate.scalar,
                       part, fmt::join(unproven, ", "));
  }
  return fmt::format("{} is enough: no torque is off by more than {}\n", certificate.scalar, part);
}

std::string trigonometry(const Certificate& certificate) {
  return fmt::format("sines and cosines that are off by no more than {:g} ulp, {:.3e}",
                     certificate.options.trigonometry_ulp, trigonometry_error(certificate.options));
}

// Says what quaternions have to be. The header has more positions than joints only for spherical ones, as closed loops
// are refused.
std::string quaternions_text(const FileContents& contents) {
  if (!contents.has_positions) return "";
  return "- where each quaternion of q has unit length; of others the bounds say how far results are from what the "
         "same formulas give without rounding, and not how far that is from the model;\n";
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format("| {} |\n", fmt::join(row, " | "));
    if (&row == &rows.front()) text += "|---|---|---:|---:|---:|---:|---|\n";
  }
  return text;
}

// The numbers of the robot file that are others in the model.
std::string snaps_text(const CertifiedHeader& header) {
  if (header.snaps.empty()) return "All numbers of the model are those of the robot file.\n\n";
  std::string text = "The model has exact numbers in place of these of the robot file. " +
                     (header.snap_effects.bound
                          ? fmt::format("It is proven that all together they change no torque by more than {:.1e} N m "
                                        "(N) within the limits.",
                                        rounded_up(*header.snap_effects.bound, 2))
                          : "How much that changes torques is not proven, as joints are coupled or in loops.") +
                     "\n\n";
  for (std::size_t k = 0; k < header.snaps.size(); ++k) {
    text += "- " + snap_text(header.snaps[k], header.snap_effects.each[k]) + "\n";
  }
  return text + "\n";
}

nlohmann::ordered_json leaves_json(const CertifiedFunction& function) {
  nlohmann::ordered_json leaves = nlohmann::ordered_json::array();
  for (const CertifiedLeaf& leaf : function.leaves) {
    leaves.push_back({{"operation", leaf.operation}, {"name", leaf.name}, {"meaning", leaf.meaning}});
    if (leaf.limit) leaves.back()["limit"] = *leaf.limit;
    if (leaf.name.front() == 'k') leaves.back()["exact"] = leaf.exact;
  }
  return leaves;
}

// The constants of the header by the model. Where a joint has no limit, it is null.
nlohmann::ordered_json constants_json(const FileContents& contents) {
  nlohmann::ordered_json constants = {{"joint_count", contents.joints}};
  if (contents.has_positions) constants["position_count"] = contents.positions;
  if (contents.velocities) constants["velocity_count"] = *contents.velocities;
  if (contents.angles > contents.positions) constants["angle_count"] = contents.angles;
  if (contents.base_count) constants["base_parameter_count"] = *contents.base_count;
  for (const std::vector<FileTable>* tables : {&contents.tables, &contents.base_tables}) {
    for (const FileTable& table : *tables) {
      nlohmann::ordered_json entries = table.texts;
      for (const double number : table.numbers) {
        entries.push_back(std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr));
      }
      constants[table.name] = entries;
    }
  }
  return constants;
}

// The arguments of a function in their order, with their lengths: of a matrix rows and columns.
nlohmann::ordered_json arguments_json(const FileFunction& function, const FileContents& contents) {
  nlohmann::ordered_json arguments = nlohmann::ordered_json::array();
  for (const EmittedParameter& each : parameters_of(function, contents)) {
    const std::vector<int> lengths =
        each.columns == 0 ? std::vector<int>{each.length} : std::vector<int>{each.length / each.columns, each.columns};
    arguments.push_back({{"name", each.name}, {"lengths", lengths}});
  }
  return arguments;
}

}  // namespace

std::string describe_certificate(const Certificate& certificate, double enough) {
  std::string text;
  for (const CertifiedFunction& function : certificate.functions) {
    const std::vector<CertifiedOutput> shown = most_telling(certificate, function.outputs);
    text += heading(function) + "\n";
    if (shown.size() < function.outputs.size()) {
      text += fmt::format("the largest bound and the largest ratio of {} outputs\n", function.outputs.size());
    }
    text += "\n" + (shown.empty() ? kAllZero : table_of(output_fields(certificate), shown)) + "\n";
  }
  text += fmt::format(
      "bound: of the absolute rounding error in {}, within the joints' limits, for {}\n"
      "seen: the largest at {} states, half of them random, the others sought where errors are large\n",
      certificate.scalar, trigonometry(certificate), certificate.options.observed.states);
  return text + judgement(certificate, enough);
}

std::string certificate_markdown(const Certificate& certificate, double enough, const CertifiedHeader& header) {
  std::string text = fmt::format(
      "# Rounding errors of {} in {}\n\n"
      "The bounds below say how far a result of the text of `{}` ({}) can be from the exact value of the model, with "
      "the model's exact numbers, at the same inputs.\n\n"
      "They hold\n\n"
      "- within the limits of position, speed, acceleration and torque that the header states, each as the nearest "
      "{};\n"
      "{}"
      "- for {}, as the header's own are to 1 ulp up to {} rad (the scripts `sines.*.g` prove it, in units of the last "
      "place of 1), those of glibc's <cmath>, and those of `flatdyn::TogetherSinCos`, in float to 2 ulp;\n"
      "- in files that include the header, or the source of the same functions as a pair, for which "
      "`rounding_is_as_written<{}>()` is true in the calling thread.\n\n"
      "{}"
      "Check it with Gappa alone: `for g in {}/*.g; do gappa $g || echo \"$g: refused\"; done`. Gappa proves what each "
      "script says: how large the error of each operation is, and that all together are within the bound. How large an "
      "operation's result can be, and how much of its error reaches an output, are hypotheses there, which flatdyn "
      "has proven from norms and from motions of links. Gappa checks each script by itself. That all belong together, "
      "and to the header, is for flatdyn's scripts/check-certificate to check.\n",
      certificate.robot, certificate.scalar, header.name, header.hash, certificate.scalar,
      quaternions_text(header.contents), trigonometry(certificate), certificate.scalar == "float" ? "6400" : "1e5",
      certificate.scalar, snaps_text(header), std::filesystem::path(header.name).replace_extension("gappa").string());
  for (const CertifiedFunction& function : certificate.functions) {
    const std::vector<CertifiedOutput>& outputs = function.outputs;
    text += fmt::format("\n## {}\n\n{}", function.name,
                        outputs.empty() ? kAllZero : markdown_table(cells_of(output_fields(certificate), outputs)));
  }
  text += fmt::format(
      "\nSeen: the largest error at {} states within the limits, half of them random, the others sought where "
      "errors are large.\n",
      certificate.options.observed.states);
  const std::string judged = judgement(certificate, enough);
  return judged.empty() ? text : text + "\n" + judged;
}

nlohmann::ordered_json certificate_json(const Certificate& certificate, const CertifiedHeader& header) {
  nlohmann::ordered_json json = {{"flatdyn", kProgramVersion},
                                 {"robot", certificate.robot},
                                 {"scalar", certificate.scalar},
                                 {"header", header.name},
                                 {"hash", header.hash},
                                 {"trigonometry_ulp", certificate.options.trigonometry_ulp},
                                 {"trigonometry_error", trigonometry_error(certificate.options)},
                                 {"gappa", certificate.by_gappa},
                                 {"states", certificate.options.observed.states},
                                 {"seed", certificate.options.observed.seed}};
  json["snapped"] = snaps_json(header.snaps, header.snap_effects);
  if (header.snap_effects.bound) json["snapped_torque_bound"] = rounded_up(*header.snap_effects.bound, 2);
  json["constants"] = constants_json(header.contents);
  json["functions"] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < certificate.functions.size(); ++k) {
    const CertifiedFunction& function = certificate.functions[k];
    json["functions"].push_back({{"name", function.name},
                                 {"arguments", arguments_json(header.contents.functions.at(k), header.contents)},
                                 {"leaves", leaves_json(function)},
                                 {"outputs", objects_of(output_fields(certificate), function.outputs)}});
  }
  return json;
}

}  // namespace flatdyn
