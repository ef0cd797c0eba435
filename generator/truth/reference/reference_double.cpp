// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/reference_instances.hpp"

FLATDYN_REFERENCE_OVER(double, )
