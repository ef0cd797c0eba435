# SPDX-License-Identifier: GPL-2.0-or-later
"""The leaves of a certified function: arguments, sines and cosines, constants."""

import math
import re
from fractions import Fraction

import mpmath

from certificate_check.arithmetic import rounded_to
from certificate_check.expressions import parsed

def is_constant(leaf):
    return leaf["name"][0] == "k"


def error_of_constant(leaf, scalar):
    """The largest distance of a constant in the scalar from the model's numbers that are printed as it is."""
    literal = abs(float(leaf["meaning"]))
    value, exact = Fraction(rounded_to(scalar, literal)), [Fraction(text) for text in leaf["exact"]]
    if any(float(x) != literal for x in exact):
        raise ValueError(f"{leaf['name']} stands for {', '.join(leaf['exact'])}, which is not {literal}")
    if not exact:
        return math.ulp(literal) / 2 + float(abs(value - Fraction(literal)))
    return float(max(abs(x - value) for x in exact))


def is_sine(leaf):
    return leaf["name"][:2] in ("s_", "c_")


def angle_of(leaf):
    """The angle of a sine or cosine if it is computed, as that of a joint that follows others."""
    found = re.fullmatch(r"(?:sin|cos)\((.*)\)", leaf["meaning"])
    return parsed(found[1]) if found else None


def exact_constant(leaf):
    is_known = len(leaf["exact"]) == 1
    size = mpmath.mpf(leaf["exact"][0]) if is_known else abs(mpmath.mpf(leaf["meaning"]))
    return -size if leaf["meaning"].startswith("-") else size
