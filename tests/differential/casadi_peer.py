# SPDX-License-Identifier: GPL-2.0-or-later
# CasADi loads functions that flatdyn wrote for it. tests/differential/casadi_test.cpp runs this by the Python of
# build/peers, in the folder of the library.
#
#   casadi_peer.py derivatives LIBRARY FUNCTION...      everything that CasADi derives, beside differences
#   casadi_peer.py reach LIBRARY ROBOT EXAMPLE          an optimal control problem, beside CasADi's own expressions
import importlib.util
import sys

import casadi as ca
import numpy as np

CLOSE = 1e-9  # of the largest entry
STEP = 1e-2  # of differences of sixth order
WEIGHTS = (-1 / 60, 3 / 20, -3 / 4, 0, 3 / 4, -3 / 20, 1 / 60)
TIMES_FASTER = 5

failures = 0


def expect(condition, text):
    global failures
    if not condition:
        failures += 1
        print("FAILED:", text)


def expect_close(found, wanted, text):
    found, wanted = np.array(ca.DM(found)), np.array(ca.DM(wanted))
    expect(found.shape == wanted.shape, f"{text}: {found.shape} instead of {wanted.shape}")
    difference = np.max(np.abs(found - wanted), initial=0) / max(1, np.max(np.abs(wanted), initial=0))
    print(f"{text}: {difference:.1e}")
    expect(difference < CLOSE, text)


def dense(function, values):
    """All entries of all results, one after the other."""
    return ca.vertcat(*[ca.vec(ca.densify(each)) for each in function.call(values)])


def differences(function, x):
    """The Jacobian of a function of one vector."""
    columns = []
    for k in range(x.size):
        unit = STEP * np.eye(x.size)[k]
        sums = sum(w * np.array(function(x + s * unit)) for w, s in zip(WEIGHTS, range(-3, 4)) if w)
        columns.append(sums.flatten() / STEP)
    return np.array(columns).T


def check_derivatives(library, name):
    f = ca.external(name, library)
    sizes = [f.size1_in(k) for k in range(f.n_in())]
    ends = np.cumsum([0] + sizes)
    x = ca.MX.sym("x", int(ends[-1]))
    y = dense(f, ca.vertsplit(x, ends.tolist()))
    weights = ca.MX.sym("weights", y.numel())
    direction = ca.MX.sym("direction", x.numel())
    value = ca.Function("value", [x], [y])
    gradient = ca.Function("gradient", [x, weights], [ca.jtimes(y, x, weights, True)])
    random = np.random.default_rng(7)
    at, w, d = random.uniform(0.2, 0.9, x.numel()), random.uniform(-1, 1, y.numel()), random.uniform(-1, 1, x.numel())
    by_differences = differences(value, at)
    rates = ca.Function("rates", [x, direction], [ca.jtimes(y, x, direction)])
    expect_close(ca.Function("jacobian", [x], [ca.jacobian(y, x)])(at), by_differences, f"{name}, Jacobian")
    expect_close(gradient(at, w), by_differences.T @ w, f"{name}, adjoint")
    expect_close(rates(at, d), by_differences @ d, f"{name}, forward")
    hessian = ca.Function("hessian", [x, weights], [ca.hessian(ca.dot(weights, y), x)[0]])
    expect_close(hessian(at, w), differences(lambda each: gradient(each, w), at), f"{name}, Hessian")
    expect(f.jacobian().class_name() == "External", f"jac_{name} is not in the library")
    expect(f.reverse(1).class_name() == "External", f"adj1_{name} is not in the library")
    expect(f.reverse(1).jacobian().class_name() == "External", f"jac_adj1_{name} is not in the library")


def inverse_dynamics(robot):
    """Newton and Euler's recursion over a robot that is a chain of revolute joints, as an expression."""
    import pinocchio as pin

    model = pin.buildModelFromUrdf(robot)
    n = model.nv
    q, qd, qdd = (ca.SX.sym(name, n) for name in ("q", "qd", "qdd"))
    axis = ca.DM([0, 0, 1])
    omega, domega, acceleration = ca.SX.zeros(3), ca.SX.zeros(3), ca.SX(ca.DM(-model.gravity.linear))
    rotations, places, forces, moments = [], [], [], []
    for k in range(n):
        placement, inertia = model.jointPlacements[k + 1], model.inertias[k + 1]
        c, s = ca.cos(q[k]), ca.sin(q[k])
        turn = ca.vertcat(ca.horzcat(c, -s, 0), ca.horzcat(s, c, 0), ca.horzcat(0, 0, 1))
        # Right angles in the file have ten digits: their zeros are zeros.
        rotation = np.where(np.abs(placement.rotation) < 1e-9, 0, placement.rotation)
        rotations.append(ca.mtimes(ca.sparsify(ca.DM(rotation)), turn))
        places.append(ca.DM(placement.translation))
        into, p = rotations[k].T, places[k]
        acceleration = ca.mtimes(
            into, acceleration + ca.cross(domega, p) + ca.cross(omega, ca.cross(omega, p)))
        before = ca.mtimes(into, omega)
        domega = ca.mtimes(into, domega) + axis * qdd[k] + ca.cross(before, axis * qd[k])
        omega = before + axis * qd[k]
        centre, about_centre = ca.DM(inertia.lever), ca.DM(inertia.inertia)
        force = inertia.mass * (acceleration + ca.cross(domega, centre) + ca.cross(omega, ca.cross(omega, centre)))
        moment = ca.mtimes(about_centre, domega) + ca.cross(omega, ca.mtimes(about_centre, omega))
        forces.append(force)
        moments.append(moment + ca.cross(centre, force))
    tau = [None] * n
    for k in reversed(range(n)):
        tau[k] = moments[k][2]
        if k > 0:
            force = ca.mtimes(rotations[k], forces[k])
            forces[k - 1] += force
            moments[k - 1] += ca.mtimes(rotations[k], moments[k]) + ca.cross(places[k], force)
    return ca.Function("own_inverse_dynamics", [q, qd, qdd], [ca.vertcat(*tau)])


def forward_dynamics(torques):
    q, qd, tau = (ca.SX.sym(name, torques.size1_in(0)) for name in ("q", "qd", "tau"))
    qdd = ca.SX.sym("qdd", tau.numel())
    inertia, bias = ca.jacobian(torques(q, qd, qdd), qdd), torques(q, qd, ca.SX.zeros(tau.numel()))
    return ca.Function("own_forward_dynamics", [q, qd, tau], [ca.solve(inertia, tau - bias)])


def same_functions(found, own, text):
    """Values and first and second derivatives of two functions."""
    at = np.random.default_rng(3).uniform(-1, 1, (3, own.size1_in(0)))
    weights = np.random.default_rng(4).uniform(-1, 1, own.size1_out(0))
    expect_close(found(*at), own(*at), f"{text}, value")
    for k, (a, b) in enumerate(zip(found.jacobian()(*at, 0), own.jacobian()(*at, 0))):
        expect_close(a, b, f"{text}, Jacobian {k}")
    for k, (a, b) in enumerate(zip(found.reverse(1)(*at, 0, weights), own.reverse(1)(*at, 0, weights))):
        expect_close(a, b, f"{text}, adjoint {k}")
    second = [f.reverse(1).jacobian()(*at, 0, weights, 0, 0, 0) for f in (found, own)]
    for k, (a, b) in enumerate(zip(*second)):
        expect_close(a, b, f"{text}, derivative {k} of the adjoint")


def evaluation_seconds(statistics):
    """Seconds that IPOPT waited for functions and their derivatives, per iteration."""
    total = sum(value for key, value in statistics.items() if key.startswith("t_wall_nlp_"))
    return total / statistics["iter_count"]


def check_reach(library, robot, example):
    spec = importlib.util.spec_from_file_location("reach", example)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    own = inverse_dynamics(robot)
    same_functions(ca.external("inverse_dynamics", library), own, "inverse dynamics")
    generated, own = ca.external("forward_dynamics", library), forward_dynamics(own)
    same_functions(generated, own, "forward dynamics")
    motion, torques, statistics = module.reach(generated)
    own_motion, own_torques, own_statistics = module.reach(own)
    expect(statistics["return_status"] == "Solve_Succeeded", statistics["return_status"])
    expect(statistics["iter_count"] == own_statistics["iter_count"], "iterations")
    expect_close(motion, own_motion, "motion")
    expect_close(torques, own_torques, "torques")
    ratio = evaluation_seconds(own_statistics) / evaluation_seconds(statistics)
    print(f"{statistics['iter_count']} iterations each; evaluation takes {ratio:.1f} times less")
    expect(ratio > TIMES_FASTER, "time of evaluation")


if sys.argv[1] == "derivatives":
    for each in sys.argv[3:]:
        check_derivatives(sys.argv[2], each)
else:
    check_reach(*sys.argv[2:])
sys.exit(1 if failures else 0)
