# SPDX-License-Identifier: BSD-3-Clause
"""The Panda reaches from one posture to another with little torque: CasADi and IPOPT over generated functions.

Hermite-Simpson collocation with accelerations from forward_dynamics, within the limits of positions, velocities and
torques of the Panda. docs/casadi.md has the commands that make libpanda.so. Usage: reach.py [LIBRARY]
"""
import sys

import casadi as ca
import numpy as np

JOINTS = 7
START = np.array([0, -0.785, 0, -2.356, 0, 1.571, 0.785])
GOAL = np.array([1.2, 0.4, -0.5, -1.2, 0.6, 2.2, -0.4])
LOWER = np.array([-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973])
UPPER = np.array([2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973])
SPEED = np.array([2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61])
TORQUE = np.array([87, 87, 87, 87, 12, 12, 12])


def reach(forward_dynamics, seconds=1.5, intervals=20):
    """The motion from START to GOAL, at rest at both: positions and velocities, torques, and IPOPT's statistics."""
    h = seconds / intervals
    x = [ca.MX.sym(f"x{k}", 2 * JOINTS) for k in range(intervals + 1)]
    u = [ca.MX.sym(f"u{k}", JOINTS) for k in range(intervals + 1)]

    def rate(state, torque):
        q, qd = ca.vertsplit(state, JOINTS)
        return ca.vertcat(qd, forward_dynamics(q, qd, torque))

    cost, defects = 0, []
    rates = [rate(x[k], u[k]) for k in range(intervals + 1)]
    for k in range(intervals):
        middle = (x[k] + x[k + 1]) / 2 + h / 8 * (rates[k] - rates[k + 1])
        torque = (u[k] + u[k + 1]) / 2
        defects.append(x[k + 1] - x[k] - h / 6 * (rates[k] + 4 * rate(middle, torque) + rates[k + 1]))
        cost += h * (ca.sumsqr(torque / TORQUE) + 1e-3 * ca.sumsqr(middle[JOINTS:]))

    guess, lower, upper = [], [], []
    for k in range(intervals + 1):
        share = k / intervals
        share = share**2 * (3 - 2 * share)
        still = START if k == 0 else GOAL if k == intervals else None
        guess += [START + (GOAL - START) * share, np.zeros(2 * JOINTS)]
        lower += [LOWER if still is None else still, -SPEED if still is None else 0 * SPEED, -TORQUE]
        upper += [UPPER if still is None else still, SPEED if still is None else 0 * SPEED, TORQUE]
    variables = ca.vertcat(*[part for k in range(intervals + 1) for part in (x[k], u[k])])
    problem = {"x": variables, "f": cost, "g": ca.vertcat(*defects)}
    options = {"print_time": False, "ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-8}}
    solver = ca.nlpsol("solver", "ipopt", problem, options)
    found = solver(x0=np.concatenate(guess), lbx=np.concatenate(lower), ubx=np.concatenate(upper), lbg=0, ubg=0)
    motion = np.array(found["x"]).reshape(intervals + 1, 3 * JOINTS)
    return motion[:, : 2 * JOINTS], motion[:, 2 * JOINTS :], solver.stats()


def main():
    library = sys.argv[1] if len(sys.argv) > 1 else "./libpanda.so"
    motion, torques, statistics = reach(ca.external("forward_dynamics", library))
    print(f"{statistics['return_status']} after {statistics['iter_count']} iterations")
    print(f"largest torque, of its limit: {np.max(np.abs(torques) / TORQUE):.3f}")
    print(f"largest speed, of its limit: {np.max(np.abs(motion[:, JOINTS:]) / SPEED):.3f}")


if __name__ == "__main__":
    main()
