# SPDX-License-Identifier: BSD-3-Clause
"""The functions for acados beside Pinocchio's dynamics, as CasADi finds them in a library.

Their names, the numbers and shapes of their arguments and results, and values at random states. docs/acados.md has the
commands that make the library. Usage: check.py ./libpanda_model.so robots/panda.urdf
"""
import sys

import casadi
import numpy as np
import pinocchio as pin

library, robot = sys.argv[1:]
model = pin.buildModelFromUrdf(robot)
data = model.createData()
n = model.nv
zero, one = np.zeros((n, n)), np.eye(n)
SHAPES = {  # as acados' generator has them, with x of 2n entries, u of n, one parameter, and neither z nor t
    "expl_ode_fun": (["x", "u", "p"], ["x"]),
    "expl_vde_forw": (["x", "Sx", "Su", "u", "p"], ["x", "Sx", "Su"]),
    "expl_vde_adj": (["x", "x", "u", "p"], ["xu"]),
    "impl_dae_fun": (["x", "x", "u", "none", "none", "p"], ["x"]),
    "impl_dae_fun_jac_x_xdot_z": (["x", "x", "u", "none", "none", "p"], ["x", "Sx", "Sx", "z"]),
    "impl_dae_fun_jac_x_xdot_u": (["x", "x", "u", "none", "none", "p"], ["x", "Sx", "Sx", "Su"]),
    "impl_dae_fun_jac_x_xdot_u_z": (["x", "x", "u", "none", "none", "p"], ["x", "Sx", "Sx", "Su", "z"]),
    "impl_dae_jac_x_xdot_u_z": (["x", "x", "u", "none", "none", "p"], ["Sx", "Sx", "Su", "z"]),
    "dyn_disc_phi_fun": (["x", "u", "p"], ["x"]),
    "dyn_disc_phi_fun_jac": (["x", "u", "p"], ["x", "jac"]),
}
SIZES = {
    "x": (2 * n, 1), "u": (n, 1), "p": (1, 1), "Sx": (2 * n, 2 * n), "Su": (2 * n, n), "xu": (3 * n, 1),
    "none": (0, 0), "z": (2 * n, 0), "jac": (3 * n, 2 * n),
}  # fmt: skip
functions = {}
for name, (inputs, outputs) in SHAPES.items():
    f = functions[name] = casadi.external("panda_" + name, library)
    assert [f.size_in(k) for k in range(f.n_in())] == [SIZES[each] for each in inputs], name
    assert [f.size_out(k) for k in range(f.n_out())] == [SIZES[each] for each in outputs], name


def forward(x, u):
    return np.concatenate([x[n:], pin.aba(model, data, x[:n], x[n:], u)])


def forward_derivatives(x, u):
    by_q, by_v, inverse = pin.computeABADerivatives(model, data, x[:n], x[n:], u)
    inverse = np.triu(inverse) + np.triu(inverse, 1).T
    return np.block([[zero, one], [by_q, by_v]]), np.vstack([zero, inverse])


def step(x, u, h):
    """A step of the classical Runge-Kutta method, and its derivatives by x and u."""
    weights, parts = np.array([1, 2, 2, 1]) * h / 6, (h / 2, h / 2, h, 0)
    at, by_x, by_u = x, np.eye(2 * n), np.zeros((2 * n, n))
    next_x, A, B = x.copy(), np.eye(2 * n), np.zeros((2 * n, n))
    for weight, part in zip(weights, parts):
        k, (F, G) = forward(at, u), forward_derivatives(at, u)
        k_x, k_u = F @ by_x, F @ by_u + G
        next_x, A, B = next_x + weight * k, A + weight * k_x, B + weight * k_u
        at, by_x, by_u = x + part * k, np.eye(2 * n) + part * k_x, part * k_u
    return next_x, A, B


def wanted(x, xdot, u, h, Sx, Su, lam):
    q, v, a = x[:n], x[n:], xdot[n:]
    f, (F, G) = forward(x, u), forward_derivatives(x, u)
    implicit = np.concatenate([xdot[:n] - v, pin.rnea(model, data, q, v, a) - u])
    tau_q, tau_v, B = pin.computeRNEADerivatives(model, data, q, v, a)
    B = np.triu(B) + np.triu(B, 1).T
    by_x, by_xdot = np.block([[zero, -one], [tau_q, tau_v]]), np.block([[one, zero], [zero, B]])
    by_u, by_z = np.vstack([zero, -one]), np.zeros((2 * n, 0))
    phi, A, B = step(x, u, h)
    dae = (x, xdot, u, casadi.DM(0, 0), casadi.DM(0, 0), h)
    return {
        "expl_ode_fun": ((x, u, h), [f]),
        "expl_vde_forw": ((x, Sx, Su, u, h), [f, F @ Sx, F @ Su + G]),
        "expl_vde_adj": ((x, lam, u, h), [np.concatenate([F.T @ lam, G.T @ lam])]),
        "impl_dae_fun": (dae, [implicit]),
        "impl_dae_fun_jac_x_xdot_z": (dae, [implicit, by_x, by_xdot, by_z]),
        "impl_dae_fun_jac_x_xdot_u": (dae, [implicit, by_x, by_xdot, by_u]),
        "impl_dae_fun_jac_x_xdot_u_z": (dae, [implicit, by_x, by_xdot, by_u, by_z]),
        "impl_dae_jac_x_xdot_u_z": (dae, [by_x, by_xdot, by_u, by_z]),
        "dyn_disc_phi_fun": ((x, u, h), [phi]),
        "dyn_disc_phi_fun_jac": ((x, u, h), [phi, np.hstack([B, A]).T]),
    }


rng = np.random.default_rng(1)
largest = dict.fromkeys(SHAPES, 0.0)
for _ in range(20):
    x, xdot, lam = rng.uniform(-1, 1, (3, 2 * n))
    Sx, Su, u = rng.uniform(-1, 1, (2 * n, 2 * n)), rng.uniform(-1, 1, (2 * n, n)), rng.uniform(-5, 5, n)
    for name, (arguments, results) in wanted(x, xdot, u, 0.01, Sx, Su, lam).items():
        found = functions[name](*arguments)
        for mine, true in zip(found if isinstance(found, tuple) else (found,), results):
            difference = np.abs(np.asarray(mine).reshape(true.shape) - true).max(initial=0)
            largest[name] = max(largest[name], difference / max(1.0, np.abs(true).max(initial=0)))
for name, difference in largest.items():
    print(f"{difference:8.1e}  {name}")
sys.exit(0 if max(largest.values()) < 1e-9 else 1)
