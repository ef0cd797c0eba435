// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/derive.hpp"
#include "derivation/notation/latex.hpp"

namespace flatdyn {
namespace {

void append_section(std::string& text, const std::string& title, const std::vector<DerivedLine>& lines) {
  text += "\n" + title + "\n";
  for (const DerivedLine& line : lines) text += line.name + " = " + line.text + "\n";
}

void append_latex(std::string& text, const std::string& title, const std::vector<DerivedLine>& lines) {
  if (lines.empty()) return;
  text += "\n% " + title + "\n\\begin{align*}\n";
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string side = lines[k].left_out ? "\\text{" + lines[k].text + "}" : latex_lines(lines[k].text);
    text += "  " + lines[k].name + " &= " + side + (k + 1 < lines.size() ? " \\\\\n" : "\n");
  }
  text += "\\end{align*}\n";
}

// The section on products of velocities: Christoffel symbols, or what takes their place.
void append_velocity_section(std::string& text, const DerivedModel& model) {
  const bool is_quasi = model.has_quasi_velocities;
  const std::string title = is_quasi ? "Coriolis and centrifugal terms h(q, v): h_k is the sum of h_kij v_i v_j over "
                                       "i <= j"
                                     : "Christoffel symbols c_ijk(q), (7.45)";
  std::vector<DerivedLine> lines = model.shared;
  const std::vector<DerivedLine>& own = is_quasi ? model.velocity_terms : model.christoffel;
  lines.insert(lines.end(), own.begin(), own.end());
  if (own.empty()) {
    text += "\n" + title + ": all are zero\n";
  } else {
    append_section(text, title + "; all others are zero", lines);
  }
}

std::string gravity_title(const DerivedModel& model) {
  return model.has_quasi_velocities ? "Gravity g, (7.39)" : "Gravity g(q), (7.39)";
}

std::string equations_title(const DerivedModel& model) {
  return std::string("Equations of motion (7.42)") +
         (model.has_quasi_velocities ? ": B(q) dv/dt + h(q, v) + g = tau" : "");
}

}  // namespace

std::string derive_text(const Mechanism& mechanism, const DeriveOptions& options) {
  const DerivedModel model = derive_model(mechanism, options, Notation::text);
  std::string text = mechanism.name + "\n";
  for (const DerivedLine& joint : model.joints) text += joint.name + ": " + joint.text + "\n";
  for (const std::string& joint : model.coupled) text += joint + "\n";
  for (const std::string& line : model.conventions) text += line + "\n";
  append_section(text, "Inertia matrix B(q), (7.32)", model.inertia);
  append_velocity_section(text, model);
  append_section(text, gravity_title(model), model.gravity);
  text += "\n" + equations_title(model) + "\n";
  for (const DerivedLine& line : model.equations) text += line.text + " = " + line.name + "\n";
  if (!model.notes.empty()) text += "\n";
  for (const std::string& note : model.notes) text += note + "\n";
  return text;
}

std::string derive_latex(const Mechanism& mechanism, const DeriveOptions& options) {
  const DerivedModel model = derive_model(mechanism, options, Notation::latex);
  std::string text = "% " + mechanism.name + "\n";
  if (model.has_quasi_velocities) {
    for (const DerivedLine& joint : model.joints) text += "% " + joint.name + ": " + joint.text + "\n";
  }
  for (const std::string& joint : model.coupled) text += "% " + joint + "\n";
  for (const std::string& line : model.conventions) text += "% " + line + "\n";
  append_latex(text, "Inertia matrix B(q), (7.32)", model.inertia);
  append_latex(text, "Shared by Christoffel symbols", model.shared);
  append_latex(text, "Christoffel symbols c_ijk(q), (7.45); all others are zero", model.christoffel);
  append_latex(text, "Coriolis and centrifugal terms: h_k is the sum of h_kij v_i v_j over i <= j; all others are zero",
               model.velocity_terms);
  append_latex(text, gravity_title(model), model.gravity);
  append_latex(text, equations_title(model), model.equations);
  for (const std::string& note : model.notes) text += "% " + note + "\n";
  return text;
}

}  // namespace flatdyn
