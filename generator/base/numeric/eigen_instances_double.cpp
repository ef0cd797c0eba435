// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/numeric/eigen_instances.hpp"

FLATDYN_EIGEN_DECOMPOSITIONS(double, )
FLATDYN_EIGEN_DECOMPOSITIONS_OF_DOUBLE()
