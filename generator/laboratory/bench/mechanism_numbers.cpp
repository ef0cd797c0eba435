// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "code/emit/page.hpp"
#include "code/emit/writer.hpp"
#include "laboratory/bench/peers.hpp"
#include "robot/model/physical_inertia.hpp"
#include "robot/model/spherical_joint.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

// Prints exact numbers as C++ text of the nearest doubles.
class NumberList {
 public:
  NumberList(const Mechanism& mechanism, const SymbolValues& symbols) {
    for (std::size_t k = 0; k < symbols.size(); ++k) values_[mechanism.symbols[k].symbol] = symbols[k];
  }

  std::string operator()(const Number& a) const { return to_decimal(a.subs(values_), 17); }
  std::string operator()(const Vec3& v) const {
    return fmt::format("{{{}, {}, {}}}", (*this)(v[0]), (*this)(v[1]), (*this)(v[2]));
  }
  std::string operator()(const Mat3& m) const {
    std::vector<std::string> entries;
    for (const Vec3& row : m) {
      for (const Number& entry : row) entries.push_back((*this)(entry));
    }
    return fmt::format("{{{}}}", fmt::join(entries, ", "));
  }

 private:
  GiNaC::exmap values_;
};

std::string rotor_text(const NumberList& number, const Body& body) {
  const Rotor rotor = body.rotor.value_or(Rotor{});
  return fmt::format("{{{}, {}, {}, {}}}", rotor.carrier, number(rotor.gear_ratio), number(rotor.inertia),
                     number(rotor.axis));
}

std::string dry_friction_text(const NumberList& number, const DryFriction& dry) {
  return fmt::format("{{{}, {}, {}, {}, {}}}", number(dry.speed), number(dry.offset), number(dry.excess),
                     number(dry.stribeck_speed), number(dry.asymmetry));
}

// The constant rotation between the frames of a link and of its parent; for the first body of a spherical joint that
// between the axes of the joint and of the parent.
Mat3 joint_rotation(const Body& body) {
  const Mat3 R = constant_rotation(body);
  return body.spherical == 1 ? with_columns_cycled(with_columns_cycled(R)) : R;  // thrice is no change
}

std::string link_text(const NumberList& number, const Body& body) {
  const InertialParameters& of = body.inertia;
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}", body.parent, body.prismatic,
                     body.spherical, number(joint_rotation(body)), number(body.p), number(of.mass),
                     number(centre_of_mass(of)), number(central_tensor(of)), number(body.viscous), number(body.coulomb),
                     number(body.armature), rotor_text(number, body), number(body.stiffness),
                     number(body.spring_reference), dry_friction_text(number, body.dry));
}

// The numbers of a text such as "{{1, 2}, {3, 4}}" with blanks between them.
std::string without_braces(std::string text) {
  std::erase_if(text, [](char c) { return c == '{' || c == '}' || c == ','; });
  return text;
}

std::string link_line(const NumberList& number, const Body& body) {
  const InertialParameters& of = body.inertia;
  const std::string lists =
      fmt::format("{} {} {} {} {} {}", number(joint_rotation(body)), number(body.p), number(of.mass),
                  number(centre_of_mass(of)), number(central_tensor(of)), number(body.armature));
  return fmt::format("{} {:d} {} {}\n", body.parent, body.prismatic, body.spherical, without_braces(lists));
}

}  // namespace

std::string mechanism_file(const Mechanism& mechanism, const SymbolValues& symbols) {
  const NumberList number(mechanism, symbols);
  std::string text =
      fmt::format("{} {} {}\n", mechanism.size(), mechanism.base_bodies(), without_braces(number(mechanism.gravity)));
  for (const Body& body : mechanism.bodies) text += link_line(number, body);
  return text;
}

std::string mechanism_numbers(const Mechanism& mechanism, const SymbolValues& symbols) {
  const NumberList number(mechanism, symbols);
  std::vector<std::string> links;
  for (const Body& body : mechanism.bodies) links.push_back(link_text(number, body));
  kainjow::mustache::data page;
  page["robot"] = comment_text(mechanism.name);
  page["joints"] = std::to_string(mechanism.size());
  page["positions"] = std::to_string(mechanism.position_count());
  page["base_bodies"] = std::to_string(mechanism.base_bodies());
  page["links"] = list_of(links);
  page["gravity"] = number(mechanism.gravity);
  page["tip_link"] = std::to_string(mechanism.tip.body);
  page["tip_R"] = number(mechanism.tip.R);
  page["tip_p"] = number(mechanism.tip.p);
  return rendered(templates::bench_mechanism_hpp, page);
}

}  // namespace flatdyn
