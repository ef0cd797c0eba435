# SPDX-License-Identifier: BSD-3-Clause
"""Whole-body DDP of a quadruped on its feet, with Crocoddyl's dynamics and with generated ones.

Both problems have the same costs, contacts and solver. docs/contacts.md has the commands that make the library and
install Crocoddyl. Usage: quadruped.py LIBRARY ROBOT.urdf
"""
import ctypes
import statistics
import sys
import time

import crocoddyl
import numpy as np
import pinocchio as pin

FEET = ("FL_FOOT", "FR_FOOT", "HL_FOOT", "HR_FOOT")
STEPS, STEP = 30, 0.02


class Generated:
    """The functions of the C form: quadruped12_constrained_forward_dynamics() and the Jacobian of it."""

    def __init__(self, library):
        c = ctypes.CDLL(library)
        self.value, self.jacobian = (
            getattr(c, f"quadruped12_{name}constrained_forward_dynamics") for name in ("", "jac_"))
        for function in (self.value, self.jacobian):
            function.restype = ctypes.c_bool
        self.q, self.g, self.v, self.tau = np.zeros(12), np.zeros(3), np.zeros(18), np.zeros(18)
        self.a, self.f, self.condition = np.zeros(18), np.zeros(12), np.zeros(1)
        self.by = [np.zeros((rows, n)) for rows in (18, 12) for n in (18, 3, 18, 18)]
        pointers = [[ctypes.c_void_p(x.ctypes.data) for x in part] for part in (
            (self.q, self.g, self.v, self.tau), (self.a, self.f, self.condition), self.by)]
        self.of_value, self.of_jacobian = pointers[0] + pointers[1], pointers[0] + pointers[2]

    def set(self, x, u):
        """x: position and quaternion (x, y, z, w) of the base, joints, then velocities in base axes."""
        self.q[:], self.v[:], self.tau[6:] = x[7:19], x[19:], u
        self.g[:] = pin.Quaternion(x[6], *x[3:6]).toRotationMatrix().T @ [0, 0, -9.81]

    def accelerations(self):
        assert self.value(*self.of_value)
        return self.a

    def derivatives(self):
        """Of the accelerations by positions and velocities, and by torques."""
        assert self.jacobian(*self.of_jacobian)
        by_q, _, by_v, by_tau = self.by[:4]
        return np.hstack([by_q, by_v]), by_tau[:, 6:]


class GeneratedModel(crocoddyl.DifferentialActionModelAbstract):
    """Crocoddyl's model with the dynamics replaced."""

    def __init__(self, state, costs, dynamics):
        crocoddyl.DifferentialActionModelAbstract.__init__(self, state, costs.nu, costs.nr)
        self.costs, self.dynamics = costs, dynamics

    def createData(self):
        data = crocoddyl.DifferentialActionModelAbstract.createData(self)
        data.collector = crocoddyl.DataCollectorMultibody(self.state.pinocchio.createData())
        data.costs = self.costs.createData(data.collector)
        data.costs.shareMemory(data)
        return data

    def calc(self, data, x, u=None):
        if u is not None:
            self.dynamics.set(x, u)
            data.xout = self.dynamics.accelerations()
            self.costs.calc(data.costs, x, u)
        else:
            self.costs.calc(data.costs, x)
        data.cost = data.costs.cost

    def calcDiff(self, data, x, u=None):
        if u is not None:
            self.dynamics.set(x, u)
            data.Fx, data.Fu = self.dynamics.derivatives()
            self.costs.calcDiff(data.costs, x, u)
        else:
            self.costs.calcDiff(data.costs, x)


class Task:
    """The robot squats by 5 cm, from standing."""

    def __init__(self, robot):
        self.model = pin.buildModelFromUrdf(robot, pin.JointModelFreeFlyer())
        self.state = crocoddyl.StateMultibody(self.model)
        self.actuation = crocoddyl.ActuationModelFloatingBase(self.state)
        self.nu = self.actuation.nu
        stand = np.concatenate([[0, 0, 0, 0, 0, 0, 1], np.tile([0, 0.8, -1.6], 4), np.zeros(18)])
        self.start, self.goal = stand, stand.copy()
        self.goal[2] -= 0.05
        self.guess = np.zeros(self.nu)

    def costs(self, weight):
        sum_of_costs = crocoddyl.CostModelSum(self.state, self.nu)
        off = crocoddyl.ResidualModelState(self.state, self.goal, self.nu)
        weights = np.concatenate([[10, 10, 100, 10, 10, 10], np.full(12, 0.1), np.full(18, 1.0)])
        activation = crocoddyl.ActivationModelWeightedQuad(weights)
        sum_of_costs.addCost("state", crocoddyl.CostModelResidual(self.state, activation, off), weight)
        torques = crocoddyl.ResidualModelControl(self.state, self.nu)
        sum_of_costs.addCost("torques", crocoddyl.CostModelResidual(self.state, torques), 1e-2)
        return sum_of_costs

    def crocoddyls_own(self, costs):
        contacts = crocoddyl.ContactModelMultiple(self.state, self.nu)
        for foot in FEET:
            held = crocoddyl.ContactModel3D(self.state, self.model.getFrameId(foot), np.zeros(3),
                                            pin.LOCAL_WORLD_ALIGNED, self.nu, np.zeros(2))
            contacts.addContact(foot, held)
        return crocoddyl.DifferentialActionModelContactFwdDynamics(self.state, self.actuation, contacts, costs)

    def solver(self, model_of):
        running = crocoddyl.IntegratedActionModelEuler(model_of(self.costs(1)), STEP)
        last = crocoddyl.IntegratedActionModelEuler(model_of(self.costs(100)), 0)
        return crocoddyl.SolverFDDP(crocoddyl.ShootingProblem(self.start, [running] * STEPS, last))


def median_time(function, calls=300, rounds=21):
    times = []
    for _ in range(rounds):
        begin = time.perf_counter()
        for _ in range(calls):
            function()
        times.append((time.perf_counter() - begin) / calls)
    return 1e6 * statistics.median(times)


def main():
    library, robot = sys.argv[1:]
    task, dynamics = Task(robot), Generated(library)
    names = [task.model.names[k] for k in range(2, task.model.njoints)]
    print("joints:", ", ".join(names))

    own = task.crocoddyls_own(task.costs(1))
    data = own.createData()
    random = np.random.default_rng(1)
    differences = []
    for _ in range(20):
        x = task.state.integrate(task.start, 0.2 * random.uniform(-1, 1, 36))
        u = random.uniform(-2, 2, task.nu)
        own.calc(data, x, u)
        own.calcDiff(data, x, u)
        dynamics.set(x, u)
        found = (dynamics.accelerations(), *dynamics.derivatives())
        for y, wanted in zip(found, (data.xout, data.Fx, data.Fu)):
            differences.append(np.abs(y - wanted).max() / np.abs(wanted).max())
    print(f"largest difference of accelerations and derivatives: {max(differences):.1e} of the largest entry")

    solvers = [task.solver(task.crocoddyls_own), task.solver(lambda costs: GeneratedModel(task.state, costs, dynamics))]
    for name, solver in zip(("Crocoddyl's", "generated"), solvers):
        done = solver.solve([task.start] * (STEPS + 1), [task.guess] * STEPS, 100)
        print(f"{name} dynamics: {'solved' if done else 'not solved'} in {solver.iter} iterations, cost {solver.cost:.9g}")

    times = [median_time(lambda: own.calc(data, x, u)), median_time(lambda: own.calcDiff(data, x, u)),
             median_time(lambda: dynamics.value(*dynamics.of_value)),
             median_time(lambda: dynamics.jacobian(*dynamics.of_jacobian))]
    print("microseconds: calc {:.1f}, calcDiff {:.1f}; generated, called by ctypes: {:.1f}, {:.1f}".format(*times))


if __name__ == "__main__":
    main()
