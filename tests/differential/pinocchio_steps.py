# SPDX-License-Identifier: GPL-2.0-or-later
# Steps in time of a robot with a fixed base from Pinocchio's dynamics, by the formulas of the methods.
# tests/differential/pinocchio_peer.py has the dynamics.
import numpy as np


class Steps:
    """Steps of length h from q, v with constant tau, each a list of the results of flatdyn's function of this name."""

    def step_semi_implicit_euler(self):
        v = self.v + self.h * self.forward_dynamics()[0]
        return [self.q + self.h * v, v]

    def step_derivatives_semi_implicit_euler(self):
        one = np.eye(len(self.q))
        by_q, by_v, by_tau = self.forward_dynamics_derivatives()
        rates = self.h * np.hstack([by_q, by_v, by_tau]) + np.hstack([0 * one, one, 0 * one])
        return self.halves(self.h * rates + np.hstack([one, 0 * one, 0 * one]), rates)

    def halves(self, positions, rates):
        """A and B from rows by q, v and tau."""
        n = 2 * len(self.q)
        rows = np.vstack([positions, rates])
        return [rows[:, :n], rows[:, n:]]

    def runge_kutta(self, change):
        """The state after a step of the classical method for x' = change(x)."""
        x = self.q, self.v
        h = self.h
        after = lambda part, k: tuple(a + part * b for a, b in zip(x, k))
        k1 = change(x)
        k2 = change(after(h / 2, k1))
        k3 = change(after(h / 2, k2))
        k4 = change(after(h, k3))
        return [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(x, k1, k2, k3, k4)]

    def step_rk4(self):
        return self.runge_kutta(lambda x: (x[1], self.at_motion(*x).forward_dynamics()[0]))

    def step_derivatives_rk4(self):
        n, h = len(self.q), self.h
        zero, one = np.zeros((n, n)), np.eye(n)
        first = np.hstack([one, zero, zero]), np.hstack([zero, one, zero])
        by_tau = np.hstack([zero, zero, one])
        states, changes = [(self.q, self.v)], []
        positions, rates = first
        for part, weight in ((h / 2, h / 6), (h / 2, h / 3), (h, h / 3), (0 * h, h / 6)):
            q, v = states[-1]
            here = self.at_motion(q, v)
            by_q, by_v, inverse = here.forward_dynamics_derivatives()
            changes.append((weight, rates, by_q @ positions + by_v @ rates + inverse @ by_tau))
            positions, rates = first[0] + part * rates, first[1] + part * changes[-1][2]
            states.append((self.q + part * v, self.v + part * here.forward_dynamics()[0]))
        after = [x + sum(weight * change[k] for weight, *change in changes) for k, x in enumerate(first)]
        return self.halves(*after)

    def middle(self):
        v = (self.v + self.qd_end) / 2
        return self.at_motion(self.q + self.h / 2 * v, v, (self.qd_end - self.v) / self.h)

    def newton(self, middle):
        by_q, by_v = middle.inverse_dynamics_derivatives()
        return middle.inertia_matrix()[0] + self.h / 2 * by_v + self.h**2 / 4 * by_q

    def step_implicit_midpoint(self):
        middle = self.middle()
        residual = middle.inverse_dynamics()[0] - self.tau
        v = self.qd_end - self.h * np.linalg.solve(self.newton(middle), residual)
        return [self.q + self.h / 2 * (self.v + v), v, residual]

    def step_derivatives_implicit_midpoint(self):
        middle, one = self.middle(), np.eye(len(self.q))
        K = self.newton(middle)
        by_q = middle.inverse_dynamics_derivatives()[0]
        right = np.hstack([-self.h * by_q, 2 * middle.inertia_matrix()[0] - K, self.h * one])
        rates = np.linalg.solve(K, right)
        return self.halves(self.h / 2 * rates + np.hstack([one, self.h / 2 * one, 0 * one]), rates)
