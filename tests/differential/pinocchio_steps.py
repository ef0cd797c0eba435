# SPDX-License-Identifier: GPL-2.0-or-later
# Steps in time of a robot from Pinocchio's dynamics, by the formulas of the methods (docs/steps.md).
# tests/differential/pinocchio_peer.py has the dynamics.
import numpy as np
import pinocchio as pin


def derivative(function, x):
    """Of a vector by a vector, to rounding: functions here take complex numbers."""
    step = 1e-30
    columns = [function(x + 1j * step * e).imag / step for e in np.eye(len(x))]
    return np.stack(columns, axis=1)


def cross(a, b):
    """As numpy's, which conjugates nothing, but of any type."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def quaternion(sigma):
    """(w, x, y, z) of a turn with these modified Rodrigues parameters."""
    square = sigma @ sigma
    return np.concatenate([[1 - square], 2 * sigma]) / (1 + square)


def rotation(sigma):
    w, r = quaternion(sigma)[0], quaternion(sigma)[1:]
    return np.stack([e + 2 * w * cross(r, e) + 2 * cross(r, cross(r, e)) for e in np.eye(3)], axis=1)


def turn_by(sigma):
    """The turns R exp(S(d)) by which rotation(sigma) changes, by sigma."""
    back = rotation(sigma).T

    def turn(x):
        change = back @ rotation(x)
        return np.array([change[2, 1], change[0, 2], change[1, 0]])

    return derivative(turn, sigma)


class Steps:
    """Steps of length h from q, v with constant tau, each a list of the results of flatdyn's function of this name.

    A change c of positions has an entry for each of v: how far joints move, and of a floating base its displacement in
    base axes before the step, and the parameters of its turn.
    """

    def after(self, c, v=None, a=None):
        """This robot after a change, perhaps at another motion."""
        there = self.at_motion(self.q + c[self.base :], self.v if v is None else v, a)
        if self.base:
            there.pose = self.pose * pin.SE3(rotation(c[3:6]), c[:3])
            there.g_b = there.pose.rotation.T @ self.model.gravity.linear
            there.place()
        return there

    def rates(self, c, v):
        """The rates of c for velocities v at c."""
        if not self.base:
            return v
        sigma, omega = c[3:6], v[3:6]
        change = ((1 - sigma @ sigma) * omega + 2 * cross(sigma, omega) + 2 * sigma * (sigma @ omega)) / 4
        return np.concatenate([rotation(sigma) @ v[:3], change, v[6:]])

    def along(self, w):
        """c for w = h v: two turns for w/8 each, and the displacement along axes in the middle."""
        if not self.base:
            return w
        half = rotation(w[3:6] / 8)
        root = quaternion(w[3:6] / 8)
        twice = np.concatenate([[2 * root[0] ** 2 - 1], 2 * root[0] * root[1:]])
        return np.concatenate([half @ w[:3], twice[1:] / (1 + twice[0]), w[6:]])

    def middle_of(self, w):
        c = w / 2
        if self.base:
            c[3:6] = w[3:6] / 8
        return c

    def tangents(self, c):
        """How positions after a change depend on those before and on c, in tangent spaces."""
        n = len(c)
        by_position, by_change = np.eye(n), np.eye(n)
        if self.base:
            back = rotation(c[3:6]).T
            by_position[:3, :3] = by_position[3:6, 3:6] = by_change[:3, :3] = back
            by_position[:3, 3:6] = -back @ pin.skew(c[:3])
            by_change[3:6, 3:6] = turn_by(c[3:6])
        return by_position, by_change

    def positions_by(self, c, dc):
        """The derivatives of positions after c by the state before the step and tau."""
        n = len(c)
        by_position, by_change = self.tangents(c)
        return by_position @ np.eye(n, 3 * n) + by_change @ dc

    def state(self, c, v):
        result = [self.q + c[self.base :], v]
        return result + [c[:3], quaternion(c[3:6])] if self.base else result

    def parts(self):
        n = len(self.v)
        return (np.eye(n, 3 * n), np.eye(n, 3 * n, n), np.eye(n, 3 * n, 2 * n))

    def step_semi_implicit_euler(self):
        v = self.v + self.h * self.forward_dynamics()[0]
        return self.state(self.along(self.h * v), v)

    def step_derivatives_semi_implicit_euler(self):
        v = self.v + self.h * self.forward_dynamics()[0]
        rates = self.h * np.hstack(self.forward_dynamics_derivatives()) + self.parts()[1]
        w = self.h * v
        return self.halves(self.positions_by(self.along(w), derivative(self.along, w) @ (self.h * rates)), rates)

    def halves(self, positions, rates):
        """A and B from rows by q, v and tau."""
        n = 2 * len(self.v)
        rows = np.vstack([positions, rates])
        return [rows[:, :n], rows[:, n:]]

    def runge_kutta(self, change):
        """The state after a step of the classical method for x' = change(x)."""
        x = 0 * self.v, self.v
        h = self.h
        after = lambda part, k: tuple(a + part * b for a, b in zip(x, k))
        k1 = change(x)
        k2 = change(after(h / 2, k1))
        k3 = change(after(h / 2, k2))
        k4 = change(after(h, k3))
        return [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(x, k1, k2, k3, k4)]

    def step_rk4(self):
        return self.state(*self.runge_kutta(lambda x: (self.rates(*x), self.after(*x).forward_dynamics()[0])))

    def step_derivatives_rk4(self):
        zero, h = 0 * self.parts()[0], self.h
        first = zero, self.parts()[1]
        states, changes = [(0 * self.v, self.v)], []
        dc, dv = first
        for part, weight in ((h / 2, h / 6), (h / 2, h / 3), (h, h / 3), (0 * h, h / 6)):
            c, v = states[-1]
            here = self.after(c, v)
            by_q, by_v, inverse = here.forward_dynamics_derivatives()
            by_c = derivative(lambda x: self.rates(x, v + 0j), c) @ dc + derivative(lambda x: self.rates(c + 0j, x), v) @ dv
            changes.append((weight, by_c, by_q @ self.positions_by(c, dc) + by_v @ dv + inverse @ self.parts()[2]))
            dc, dv = part * by_c, first[1] + part * changes[-1][2]
            states.append((part * self.rates(c, v), self.v + part * here.forward_dynamics()[0]))
        after = [x + sum(weight * change[k] for weight, *change in changes) for k, x in enumerate(first)]
        c = self.runge_kutta(lambda x: (self.rates(*x), self.after(*x).forward_dynamics()[0]))[0]
        return self.halves(self.positions_by(c, after[0]), after[1])

    def middle(self):
        """The robot in the middle of a step, and how its positions depend on those before the step and on h v there."""
        v = (self.v + self.v_end) / 2
        c = self.middle_of(self.h * v)
        by_position, by_change = self.tangents(c)
        there = self.after(c, v, (self.v_end - self.v) / self.h)
        return there, by_position, by_change @ derivative(self.middle_of, self.h * v)

    def newton(self, there, by_w):
        by_q, by_v = there.inverse_dynamics_derivatives()
        return there.inertia_matrix()[0] + self.h / 2 * by_v + self.h**2 / 2 * by_q @ by_w

    def step_implicit_midpoint(self):
        there, _, by_w = self.middle()
        residual = there.inverse_dynamics()[0] - self.tau
        v = self.v_end - self.h * np.linalg.solve(self.newton(there, by_w), residual)
        return self.state(self.along(self.h / 2 * (self.v + v)), v) + [residual]

    def step_derivatives_implicit_midpoint(self):
        there, by_position, by_w = self.middle()
        K = self.newton(there, by_w)
        by_q = there.inverse_dynamics_derivatives()[0] @ by_position
        right = np.hstack([-self.h * by_q, 2 * there.inertia_matrix()[0] - K, self.h * np.eye(len(K))])
        rates = np.linalg.solve(K, right)
        w = self.h / 2 * (self.v + self.v_end)
        dw = self.h / 2 * (rates + self.parts()[1])
        return self.halves(self.positions_by(self.along(w), derivative(self.along, w) @ dw), rates)
