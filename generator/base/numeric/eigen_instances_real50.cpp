// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/numeric/eigen_instances.hpp"

FLATDYN_EIGEN_DECOMPOSITIONS(flatdyn::reference::Real50, )
