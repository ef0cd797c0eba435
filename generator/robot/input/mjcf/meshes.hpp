// SPDX-License-Identifier: GPL-2.0-or-later
// Masses and moments of inertia of the meshes of <asset>.
#pragma once

#include "robot/input/mjcf/mesh_moments.hpp"
#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

class MjcfMeshes {
 public:
  explicit MjcfMeshes(const MjcfModel& model) : model_(model) {}

  // The moments of a mesh, which is read once.
  struct Solid {
    Pose frame;  // in which the moments are, in the geom's
    MeshMoments moments;
  };
  // nullptr, and an error, if there is no such mesh or no file of it, or if its inertia is not supported. geom: the
  // attribute that names it. what: the geom in messages.
  const Solid* find(const FileAttribute& geom, const std::string& what);

 private:
  const MjcfModel& model_;
  std::map<std::string, std::optional<Solid>> known_;
};

}  // namespace flatdyn
