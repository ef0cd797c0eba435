# SPDX-License-Identifier: GPL-2.0-or-later
"""Times the Python module's batches of the Panda beside the C++ batch's, in turn, in the current folder: panda.py with its
library, and libpeer.so of python_peer.cpp. Prints medians in ns per state and their ratio. `scripts/bench --python` runs it.

Python makes new arrays of results in each call, of rows as numpy has them; C++ writes into arrays that are there.
"""

import ctypes
import statistics
import sys
import time

import numpy

import panda

STATES, REPETITIONS = 100_000, int(sys.argv[1])
peer = ctypes.CDLL("./libpeer.so")
number = panda.gravity(numpy.zeros(7)).dtype
random = numpy.random.default_rng(1)
rows = [random.uniform(-2, 2, (STATES, 7)).astype(number) for _ in range(3)]
columns = [numpy.ascontiguousarray(x.T) for x in rows]


def seconds(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


print(f"{STATES} states, {number}{'C++, ns':>20}{'Python, ns':>12}   ratio")
for name, inputs, entries in (
    ("inverse_dynamics", 3, 7),
    ("inertia_matrix", 1, 49),
    ("gravity", 1, 7),
    ("forward_dynamics", 3, 7),
):
    result = numpy.zeros((entries, STATES), dtype=number)
    pointers = [ctypes.c_void_p(x.ctypes.data) for x in columns[:inputs] + [result]]
    in_cpp, in_python = [], []
    for _ in range(REPETITIONS):
        in_cpp.append(seconds(lambda: getattr(peer, name)(ctypes.c_size_t(STATES), *pointers)))
        in_python.append(seconds(lambda: getattr(panda, name)(*rows[:inputs])))
    cpp, python = (statistics.median(times) / STATES * 1e9 for times in (in_cpp, in_python))
    # The results for the same states are equal up to the rounding of sines.
    found = getattr(panda, name)(*rows[:inputs]).reshape(STATES, entries).T
    scale = numpy.abs(result).max()
    assert numpy.abs(found - result).max() < 1e4 * numpy.finfo(number).eps * scale, name
    print(f"{name:<27}{cpp:>14.1f}{python:>12.1f}   {python / cpp:.2f}")
