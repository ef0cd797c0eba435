// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/convention_header.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/table.hpp"
#include "base/diagnostics/version.hpp"
#include "code/conventions/coverage.hpp"
#include "code/conventions/meanings.hpp"
#include "code/emit/licence.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/page.hpp"
#include "code/emit/page_writer.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/cpp/adaptor.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/cpp/function.hpp"
#include "code/languages/cpp/steps.hpp"
#include "robot/model/field_mechanism.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

const char* const kStretchedJoint =
    "The quaternion of a spherical joint is used as it is: with |q|^2 = 1 + e it is a matrix that is off by 2 |e| "
    "at most.";

std::string friction_text(const Mechanism& mechanism, const Convention& convention) {
  const FrictionOfOrigin friction = friction_of_origin(mechanism, convention);
  if (friction.is_zero()) return "";
  return fmt::format(
      "Friction of the base that depends on the velocity of its origin along axes of the world is added "
      "here{}. But for it: ",
      vanishes(friction.coulomb) ? ""
                                 : ", its Coulomb friction as well, which flatdyn's own functions "
                                   "leave out");
}

// The paragraphs at the head of the file.
std::vector<std::string> paragraphs_of(const Mechanism& mechanism, const Convention& convention) {
  if (!mechanism.floating_base) {
    return {
        fmt::format("Results are those of flatdyn's own functions{}. {} integrate() returns quaternions of unit "
                    "length, and has the digits of double.",
                    convention.scalar_first ? "" : ", which take quaternions as (w, x, y, z)", kStretchedJoint)};
  }
  const std::string base = comment_text(mechanism.base_link().link);
  return {
      fmt::format("Base axes are those of link \"{}\", and its linear velocity is that of its origin, about which the "
                  "moment is. The quaternion turns base axes into world axes: R(quaternion) x is in world axes what x "
                  "is in base axes. v^T tau is the power. Tip, centre of mass and momentum are in world axes{}.",
                  base, mechanism.contacts.empty() ? "" : ", and so are contacts"),
      fmt::format("A quaternion is used as it is, by the polynomials of second degree that are R for unit length: for "
                  "another length R is a rotation times the square of the length, and a term of a result is off by the "
                  "sixth power at most. A length that is wrong by 1e-7 makes at most 6.1e-7 of the sum of the terms' "
                  "magnitudes. {}integrate() returns quaternions of unit length, and has the digits of double.",
                  mechanism.has_spherical_joints() ? std::string(kStretchedJoint) + " " : ""),
      friction_text(mechanism, convention) +
          (convention.linear_in_world
               ? "Torques depend on the velocity of the base's origin through its acceleration only. So where the "
                 "acceleration is an argument, or zero, the functions called are given the base as it is for an "
                 "observer "
                 "who moves with the origin at the moment: without linear velocity, and no omega x v is added and "
                 "taken "
                 "away again."
               : "Velocities of the base are in axes that turn. The acceleration of its origin is its linear part of a "
                 "plus "
                 "omega x v, in base axes; for spatial vectors a is the spatial acceleration of the base.")};
}

std::vector<std::string> prose(const Mechanism& mechanism, const Convention& convention) {
  std::vector<std::string> lines;
  for (const std::string& paragraph : paragraphs_of(mechanism, convention)) {
    if (!lines.empty()) lines.emplace_back();
    for (const std::string& line : wrapped_words(paragraph, kCommentWidth)) lines.push_back(" " + line);
  }
  return lines;
}

// How the robot moves while the entries of v are constant.
std::string constant_motion(const Mechanism& mechanism, const Convention& convention) {
  if (!mechanism.floating_base) {
    return "The entries of v are constant, so the child of a spherical joint turns about an axis of its own.";
  }
  if (!convention.linear_in_world) {
    return "The entries of v are constant, so the base moves along a screw: the exponential of SE(3).";
  }
  return std::string(
             "The entries of v are constant: the origin moves along a line, and the base turns about an axis "
             "through it") +
         (convention.angular_in_world ? "." : ", as by mj_integratePos().");
}

// The comments of integrate() and difference().
std::vector<std::string> integrate_comment(const Mechanism& mechanism, const Convention& convention) {
  const std::string of_loops = mechanism.has_loops()
                                   ? fmt::format(
                                         " Joints that closed loops move stay where they are: close_loops(q_next + {}, "
                                         "tolerance) of the robot's header moves them.",
                                         pose_entries(mechanism))
                                   : "";
  return wrapped_words(fmt::format("The positions q_next to which v moves the robot from q in the time dt (s). {}{} "
                                   "q_next may be q.",
                                   constant_motion(mechanism, convention), of_loops),
                       kCommentWidth);
}

std::vector<std::string> difference_comment(const Mechanism& mechanism) {
  const char* const what = !mechanism.has_spherical_joints() ? "the base turns"
                           : mechanism.floating_base         ? "the base and spherical joints turn"
                                                             : "spherical joints turn";
  return wrapped_words(fmt::format("The inverse: v with integrate(q_0, v, 1) = q_1, for quaternions of unit length, "
                                   "such that {} by pi at most; {} are not wrapped. The entries of v are m and rad. v "
                                   "may be q_0 or q_1.",
                                   what, mechanism.has_spherical_joints() ? "joints of one axis" : "joints"),
                       kCommentWidth);
}

// The statements that compute R^T g_0.
std::string gravity_statement(const Vec3& gravity, const Dialect& dialect) {
  std::string sum;
  for (std::size_t k = 0; k < gravity.size(); ++k) {
    if (vanishes(gravity[k])) continue;
    if (!is_rational(gravity[k])) {
      throw Failure(FailureKind::unsupported, "--convention: gravity is not a number", "give it by --gravity");
    }
    sum += fmt::format("{}R_[{}][k] * {}", sum.empty() ? "" : " + ", k, dialect.literal(to_rational(gravity[k])));
  }
  return without_newline(code_line(fmt::format("for (int k = 0; k < 3; ++k) g_b[k] = {};", sum), 4));
}

class ConventionWriter {
 public:
  ConventionWriter(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                   const Convention& convention)
      : mechanism_(mechanism),
        options_(options),
        convention_(convention),
        texts_(function_texts(CppDialect(options), mechanism, functions, options)),
        core_(namespace_of(mechanism.name, options.name_space)),
        code_{mechanism, convention, core_, functions, texts_} {}

  ConventionHeader written() {
    ConventionHeader result;
    data page;
    write_names(page);
    write_base(page);
    write_steps(page);
    write_adaptors(page, result.left_out);
    result.file = {fmt::format("{}_{}.hpp", file_name(mechanism_, options_), convention_.name),
                   rendered(templates::convention_hpp, page)};
    return result;
  }

 private:
  void write_names(data& page) const {
    const std::string name_space = core_ + "::" + convention_.name;
    const std::string core = file_name(mechanism_, options_) + ".hpp";
    page["opening"] = list_of(wrapped_words(
        fmt::format("The dynamics of robot \"{}\" in the convention of {}: thin functions over {}. Generated by "
                    "flatdyn {} with that file; to change it, generate both again.",
                    comment_text(mechanism_.name), convention_.whose, core, kProgramVersion),
        kCommentWidth));
    page["core"] = core;
    page["namespace"] = name_space;
    page["guard"] = guard_of(name_space, "hpp",
                             {kProgramVersion, options_.options_stamp, options_.input_hash, options_.scene_stamp});
    page["velocities"] = count_of_velocities(mechanism_);
    page["n"] = std::to_string(mechanism_.size());
    page["table"] = list_of(argument_table());
    page["prose"] = list_of(prose(mechanism_, convention_));
  }

  std::vector<std::string> argument_table() const {
    const auto sized = [](const char* name, int length) { return fmt::format("{}[{}]", name, length); };
    const int n = mechanism_.size();
    const JointCounts counts(mechanism_);
    const int positions = pose_entries(mechanism_) + mechanism_.position_count();
    const std::vector<std::array<std::string, 2>> rows = {{sized("q", positions), meaning_of_pose(convention_, counts)},
                                                          {sized("v", n), meaning_of_velocity(convention_, counts)},
                                                          {sized("a", n), "derivatives of the entries of v"},
                                                          {sized("tau", n), meaning_of_force(convention_, counts)}};
    std::vector<std::vector<std::string>> lines;
    constexpr std::size_t kBefore = 12;  // columns before a meaning
    for (const auto& [name, meaning] : rows) add_row(lines, {name}, wrapped_words(meaning, kCommentWidth - kBefore));
    return aligned_lines(lines);
  }

  void write_base(data& page) const {
    const int first = convention_.scalar_first ? 1 : 0;  // of a quaternion's vector part
    page["w"] = std::to_string(convention_.scalar_first ? 0 : 3);
    page["x"] = std::to_string(first);
    page["y"] = std::to_string(first + 1);
    page["z"] = std::to_string(first + 2);
    page["floating?"] = mechanism_.floating_base;
    page["plain?"] = convention_.is_plain();
    page["linear_in_world?"] = convention_.linear_in_world;
    page["angular_in_world?"] = convention_.angular_in_world;
    page["angular_first?"] = convention_.angular_first;
    page["screw?"] = has_screw();
    page["linear"] = std::string(convention_.angular_first ? "3 + " : "");
    page["angular"] = std::string(convention_.angular_first ? "" : "3 + ");
    page["gravity?"] = mechanism_.has_base_gravity();
    write_friction(page);
    if (mechanism_.has_base_gravity()) page["gravity"] = gravity_statement(mechanism_.gravity, CppDialect());
  }

  void write_friction(data& page) const {
    const FrictionOfOrigin friction = friction_of_origin(mechanism_, convention_);
    const bool is_used = std::any_of(code_.functions.begin(), code_.functions.end(), [this](const Function& function) {
      return is_rubbed(function, mechanism_, convention_);
    });
    page["friction?"] = is_used;
    if (!is_used) return;
    const CppDialect dialect;
    std::string sum;
    const auto add = [&](const Number& factor, const std::string& of) {
      if (vanishes(factor)) return;
      if (!is_rational(factor)) {
        throw Failure(FailureKind::unsupported, "--convention: friction of the base is not a number",
                      "give it a number in the file");
      }
      sum += fmt::format("{}{} * {}", sum.empty() ? "" : " + ", dialect.literal(to_rational(factor)), of);
    };
    add(friction.viscous, "f_b[k]");
    add(friction.coulomb, core_ + "::detail::sign(f_b[k])");
    page["friction"] = without_newline(code_line(fmt::format("for (int k = 0; k < 3; ++k) f_b[k] = {};", sum), 4));
  }

  bool has_screw() const { return mechanism_.floating_base && !convention_.linear_in_world; }

  void write_steps(data& page) const {
    page["spherical?"] = mechanism_.has_spherical_joints();
    page["integrate_comment"] = list_of(integrate_comment(mechanism_, convention_));
    page["difference_comment"] = list_of(difference_comment(mechanism_));
    page["integrate_joints"] = list_of(integrate_joints(mechanism_));
    page["difference_joints"] = list_of(difference_joints(mechanism_));
    page["reorders?"] = has_other_quaternions(convention_, mechanism_);
    page["joint_entries"] = std::to_string(mechanism_.position_count());
    data quaternions(data::type::list);
    for (const int first : mechanism_.quaternions()) {
      data item;
      item["first"] = std::to_string(first);
      quaternions << item;
    }
    page["quaternions"] = data(quaternions);
  }

  void write_adaptors(data& page, std::vector<std::string>& left_out) const {
    data list(data::type::list);
    std::vector<ShapedFunction> shapes;
    std::vector<std::string> refusals;
    for (std::size_t k = 0; k < code_.functions.size(); ++k) {
      const std::string reason = why_not(code_.functions[k], code_.functions, convention_, mechanism_);
      if (!reason.empty()) {
        left_out.push_back(fmt::format("{} is left out of {}: {}", code_.functions[k].name, convention_.name, reason));
        continue;
      }
      const Adaptor found = adaptor(code_, k);
      data item;
      item["comment"] = list_of(found.comment);
      item["template_parameters"] = found.template_parameters;
      item["signature"] = found.signature;
      item["body"] = found.body;
      list << item;
      shapes.push_back(found.shape);
      refusals.push_back(refusal_of_objects(found.shape.name, "::" + core_ + "::"));
    }
    page["refusals?"] = !refusals.empty();
    page["refusals"] = list_of(refusals);
    page["licence"] = licence_comment();
    page["functions"] = data(list);
    page["base?"] = mechanism_.floating_base && (!shapes.empty() || has_screw());  // screws turn vectors, too
    write_shapes(page, shapes, core_ + "::" + convention_.name);
  }

  const Mechanism& mechanism_;
  const EmitOptions& options_;
  const Convention& convention_;
  const std::vector<FunctionText> texts_;
  const std::string core_;  // its namespace
  const AdaptedCode code_;
};

}  // namespace

ConventionHeader convention_header(const Mechanism& mechanism, const std::vector<Function>& functions,
                                   const EmitOptions& options, const Convention& convention) {
  check_conventions_apply(mechanism);
  return ConventionWriter(mechanism, functions, options, convention).written();
}

}  // namespace flatdyn
