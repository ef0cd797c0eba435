# SPDX-License-Identifier: GPL-2.0-or-later
"""The arithmetics in which expressions are evaluated: rounded as certified, exact, or modulo a prime."""

import struct
from fractions import Fraction

import mpmath

PRIME = 2**61 - 1

def rounded_to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def rounded_to(scalar, x):
    """The number of the scalar next to x, a result of one operation on such numbers. A double is between them."""
    return rounded_to_float(float(x)) if scalar == "float" else float(x)


def ratio(size, bound):
    return size / bound if bound > 0 else math.inf if size > 0 else 0.0


def modulo_prime(x):
    x = Fraction(x)
    return x.numerator * pow(x.denominator, -1, PRIME) % PRIME


class Arithmetic:
    """What an expression does: what constants are, how its value is rounded, and how each operation in it is."""

    def __init__(self, constant, rounded=lambda x: x, each=lambda x: x):
        self.constant, self.rounded, self.each = constant, rounded, each


PLAIN = Arithmetic(float)  # sizes, without regard of rounding
EXACT = Arithmetic(mpmath.mpf)


def certified(scalar):
    return Arithmetic(lambda x: rounded_to(scalar, x), lambda x: rounded_to(scalar, x))


def in_field(scalar):
    """Modulo a prime, where what is 0 at random is 0 everywhere."""
    return Arithmetic(lambda x: modulo_prime(rounded_to(scalar, x)), lambda x: x % PRIME, lambda x: x % PRIME)


def as_written(scalar, is_each_rounded):
    """Bit by bit. An operation inside an expression is exact unless each is rounded."""
    def rounded(x):
        return Fraction(rounded_to(scalar, x))

    return Arithmetic(rounded, rounded, rounded if is_each_rounded else lambda x: x)
