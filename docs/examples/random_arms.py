#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Arms with random twists, offsets, inertias and limits, by seed: SEED.toml in a folder.

usage: random_arms.py FOLDER JOINTS SEED...
"""

import pathlib
import random
import sys


def inertia(draw, mass):
    """About the centre of mass: of a random cloud of points, and 0.005 m^2 of the mass in each direction."""
    a = [[draw.gauss(0, 1) for _ in range(3)] for _ in range(3)]
    second = [[0.002 * mass * sum(a[i][k] * a[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    for i in range(3):
        second[i][i] += 0.005 * mass
    trace = sum(second[i][i] for i in range(3))
    return [[(trace if i == j else 0) - second[i][j] for j in range(3)] for i in range(3)]


def link(draw, joint):
    yield "\n[[link]]"
    if joint > 0:
        yield f"alpha = {draw.choice([-1, 1]) * draw.uniform(0.4, 2.7):.4f}"
        yield f"a = {draw.uniform(0, 0.12):.4f}"
    yield f"d = {draw.uniform(0.05, 0.25):.4f}"
    mass = draw.uniform(0.6, 1.2) * 5 * 0.88**joint
    yield f"mass = {mass:.4f}"
    yield "com = [{}]".format(", ".join(f"{draw.uniform(-0.09, 0.09):.4f}" for _ in range(3)))
    I = inertia(draw, mass)
    names = {"xx": I[0][0], "yy": I[1][1], "zz": I[2][2], "xy": I[0][1], "xz": I[0][2], "yz": I[1][2]}
    yield "inertia = { " + ", ".join(f"{name} = {value:.5f}" for name, value in names.items()) + " }"
    yield 'inertia_about = "com"'
    yield "\n[link.limits]\nlower = -3\nupper = 3"
    yield f"velocity = {draw.uniform(1.5, 3):.1f}"
    yield f"acceleration = {draw.uniform(5, 15):.1f}"
    yield f"effort = {round(300 / (joint + 1))}"


def arm(joints, seed):
    draw = random.Random(seed)
    lines = [f'name = "arm_{seed}"', 'description = "random twists"', f'source = "random_arms.py {joints} {seed}"']
    lines.append('dh = "modified"')
    for joint in range(joints):
        lines.extend(link(draw, joint))
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for seed in map(int, sys.argv[3:]):
        (folder / f"{seed}.toml").write_text(arm(int(sys.argv[2]), seed))


if __name__ == "__main__":
    main()
