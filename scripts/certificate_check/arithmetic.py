# SPDX-License-Identifier: GPL-2.0-or-later
"""The arithmetics in which expressions are evaluated: rounded as certified, exact, or modulo a prime."""

import math
import struct
from fractions import Fraction

import mpmath

PRIME = 2**61 - 1

def rounded_to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def rounded_to_odd(x):
    """A double next to x, the one with an odd last bit if x is between two: it is rounded to float as x is."""
    near = float(x)
    is_even = struct.unpack("<q", struct.pack("<d", near))[0] % 2 == 0
    if Fraction(near) == x or not is_even:
        return near
    return math.nextafter(near, math.inf if x > near else -math.inf)


def rounded_to(scalar, x):
    """The number of the scalar next to x, a result of one operation on such numbers."""
    if scalar != "float":
        return float(x)
    return rounded_to_float(rounded_to_odd(x) if isinstance(x, Fraction) else float(x))


def ratio(size, bound):
    return size / bound if bound > 0 else math.inf if size > 0 else 0.0


def modulo_prime(x):
    x = Fraction(x)
    return x.numerator * pow(x.denominator, -1, PRIME) % PRIME


class Arithmetic:
    """What an expression does: what constants are, how its value is rounded, and how each operation in it is.

    A fused multiply-add of the header is one operation; in scripts it is a product within a sum, which is not rounded.
    """

    def __init__(self, constant, rounded=lambda x: x, each=lambda x: x, fused=None):
        self.constant, self.rounded, self.each = constant, rounded, each
        self.fused, self.fused_in_sums = fused or (lambda a, b, c: each(a * b + c)), fused is not None


PLAIN = Arithmetic(float)  # sizes, without regard of rounding
EXACT = Arithmetic(mpmath.mpf)


def certified(scalar):
    def fused(a, b, c):
        return rounded_to(scalar, Fraction(a) * Fraction(b) + Fraction(c))

    return Arithmetic(lambda x: rounded_to(scalar, x), lambda x: rounded_to(scalar, x), fused=fused)


def in_field(scalar):
    """Modulo a prime, where what is 0 at random is 0 everywhere."""
    return Arithmetic(lambda x: modulo_prime(rounded_to(scalar, x)), lambda x: x % PRIME, lambda x: x % PRIME)


def as_written(scalar, is_each_rounded, sizes=None):
    """Bit by bit. An operation inside an expression is exact unless each is rounded; `sizes` then gets their results."""
    def rounded(x):
        return Fraction(rounded_to(scalar, x))

    def noted(x):
        result = rounded(x)
        if sizes is not None:
            sizes.add(abs(result))
        return result

    return Arithmetic(rounded, rounded, noted if is_each_rounded else lambda x: x)
