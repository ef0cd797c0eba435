# SPDX-License-Identifier: GPL-2.0-or-later
# Emitted code against Pinocchio at random states of a robot in URDF. tests/differential/pinocchio_test.cpp runs it by
# the Python of build/peers. Every public function of the module has to have its counterpart here. Prints the largest
# difference of each result, of its largest entry, and fails where one is above its limit.
import argparse
import copy
import ctypes
import importlib
import inspect
import json
import pathlib
import sys
import xml.etree.ElementTree

import numpy as np
import pinocchio as pin
from pinocchio_steps import Steps

STATES = 20
CLOSE = 1e-12  # what is added up
SOLVED = 1e-9  # what B's condition multiplies
SOLUTIONS = ("forward_dynamics", "forward_dynamics_derivatives", "inverse_dynamics_floating", "contact_impact")
WORLD = pin.LOCAL_WORLD_ALIGNED


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--module", help="the module in the present folder")
    parser.add_argument("--convention", help="a library with the functions of --convention pinocchio")
    parser.add_argument("--functions", default="", help="those of the library, separated by commas")
    parser.add_argument("--floating", action="store_true")
    parser.add_argument("--tip", required=True)
    parser.add_argument("--contact", action="append", default=[], help="LINK:X,Y,Z:point or LINK:X,Y,Z:surface")
    parser.add_argument("robot")
    return parser.parse_args()


class Peer(Steps):
    """The robot in Pinocchio, and functions by their names in flatdyn, at a state."""

    def __init__(self, robot, floating, tip, contacts):
        root = [pin.JointModelFreeFlyer()] if floating else []
        self.model = pin.buildModelFromUrdf(robot, *root)
        self.data = self.model.createData()
        self.tip, self.base = tip, 6 if floating else 0
        # Pinocchio orders children by their names, flatdyn by their places in the file.
        tree = xml.etree.ElementTree.parse(robot)
        self.links = [link.get("name") for link in tree.getroot().findall("link")]
        joints = [joint for joint in tree.iter("joint") if joint.get("type") not in (None, "fixed")]
        self.joints = [self.model.getJointId(joint.get("name")) for joint in joints]
        velocities = [self.model.joints[i].idx_v for i in self.joints]
        self.order = np.array([*range(self.base), *velocities])
        # Pinocchio knows friction and does not add it.
        dynamics = [{} if joint.find("dynamics") is None else joint.find("dynamics").attrib for joint in joints]
        of_joints = ([float(each.get(name, 0)) for each in dynamics] for name in ("damping", "friction"))
        self.viscous, self.coulomb = (np.concatenate([np.zeros(self.base), x]) for x in of_joints)
        self.contacts = [self.contact(*contact.split(":")) for contact in contacts]

    def contact(self, link, position, kind):
        frame = self.model.frames[self.frame(link)]
        place = frame.placement * pin.SE3(np.eye(3), np.array([float(x) for x in position.split(",")]))
        return frame.parentJoint, place, 3 if kind == "point" else 6

    def read_canonical_frames(self, file):
        """Of each joint the frame of its link that flatdyn computes with, in that of Pinocchio."""
        places = []
        for joint in json.loads(pathlib.Path(file).read_text())["joints"]:
            origin = pin.SE3(*(np.array(joint["canonical"]["origin"][name]) for name in "Rp"))
            places.append(places[joint["parent"]] * origin if joint["parent"] >= 0 else origin)
        pin.forwardKinematics(self.model, self.data, pin.neutral(self.model))
        here = [self.data.oMi[i] for i in self.joints]
        self.canonical = [at.inverse() * place for at, place in zip(here, places[self.base :])]

    def frame(self, link):
        assert self.model.existBodyName(link), link
        return self.model.getBodyId(link)

    # States: flatdyn's entries q of the joints, v, a and tau, and the pose of the base.
    def move(self, rng, in_world):
        n = len(self.order)
        self.q = rng.uniform(-1, 1, len(self.joints))
        self.v, self.a, self.tau = rng.uniform(-2, 2, n), rng.uniform(-5, 5, n), rng.uniform(-10, 10, n)
        self.h_e = rng.uniform(-10, 10, 6)
        self.h, self.v_end = rng.uniform(0.001, 0.02, 1), self.v + rng.uniform(-0.2, 0.2, n)
        self.pose = pin.SE3.Random() if self.base else pin.SE3.Identity()
        if self.base:
            turn = rng.normal(size=4)
            turn /= np.linalg.norm(turn)
            self.pose = pin.SE3(pin.Quaternion(turn[3], *turn[:3]), rng.uniform(-1, 1, 3))
        self.g_b = self.pose.rotation.T @ self.model.gravity.linear
        # Axes and origin in which results about points and momenta are.
        self.axes = np.eye(3) if in_world else self.pose.rotation.T
        self.origin = np.zeros(3) if in_world else self.pose.translation
        self.axes_twice = np.kron(np.eye(2), self.axes)
        self.place()

    def place(self):
        """Pinocchio's configuration from the pose and q."""
        self.at = np.empty(self.model.nq)
        if self.base:
            self.at[:7] = pin.SE3ToXYZQUAT(self.pose)
        for i, x in zip(self.joints, self.q):
            k, size = self.model.joints[i].idx_q, self.model.joints[i].nq
            self.at[k : k + size] = x if size == 1 else (np.cos(x), np.sin(x))  # two for a continuous joint

    def at_motion(self, q, v, a=None):
        """The same robot at another motion."""
        there = copy.copy(self)
        there.q, there.v, there.a = q, v, a
        there.place()
        return there

    def configuration(self):
        """q of the convention: Pinocchio's pose, and joints in the order of the file."""
        return np.concatenate([self.at[:7], self.q])

    def to_pinocchio(self, x):
        y = np.empty_like(x)
        y[self.order] = x
        return y

    def rows(self, matrix):
        return matrix[self.order]

    def square(self, matrix):
        return matrix[np.ix_(self.order, self.order)]

    def at_rest(self):
        return np.zeros(self.model.nv)

    def friction(self):
        return self.viscous * self.v + self.coulomb * np.sign(self.v)

    def forces(self):
        """What is left of tau after friction, in Pinocchio's order."""
        return self.to_pinocchio(self.tau - self.friction())

    # Functions, each a list of the results of flatdyn's function of this name.
    def inverse_dynamics(self):
        tau = pin.rnea(self.model, self.data, self.at, self.to_pinocchio(self.v), self.to_pinocchio(self.a))
        return [self.rows(tau) + self.friction()]

    def inverse_dynamics_tip_force(self):
        return [self.inverse_dynamics()[0] + self.external_torque(self.tip)[0]]

    def external_torque(self, link):
        return [self.jacobian(link)[0].T @ self.h_e]

    def inertia_matrix(self):
        upper = np.triu(pin.crba(self.model, self.data, self.at))
        return [self.square(upper + np.triu(upper, 1).T)]

    def coriolis_matrix(self):
        return [self.square(pin.computeCoriolisMatrix(self.model, self.data, self.at, self.to_pinocchio(self.v)))]

    def gravity(self):
        return [self.rows(pin.computeGeneralizedGravity(self.model, self.data, self.at))]

    def bias(self):
        n = pin.nonLinearEffects(self.model, self.data, self.at, self.to_pinocchio(self.v))
        return [self.rows(n) + self.friction()]

    def forward_dynamics(self):
        return [self.rows(pin.aba(self.model, self.data, self.at, self.to_pinocchio(self.v), self.forces()))]

    def momentum(self):
        return [self.inertia_matrix()[0] @ self.v]

    def coriolis_transpose_qd(self):
        return [self.coriolis_matrix()[0].T @ self.v]

    def kinetic_energy(self):
        return [pin.computeKineticEnergy(self.model, self.data, self.at, self.to_pinocchio(self.v))]

    def potential_energy(self):
        # flatdyn counts a fixed base's link, too, which Pinocchio does not, and has zero at a floating base's origin.
        at = self.at.copy()
        if self.base:
            at[:3] = 0
        fixed = self.model.inertias[0]
        energy = pin.computePotentialEnergy(self.model, self.data, at)
        return [energy - fixed.mass * self.model.gravity.linear @ fixed.lever]

    def forward_kinematics(self):
        pin.framesForwardKinematics(self.model, self.data, self.at)
        place = self.data.oMf[self.frame(self.tip)]
        return [self.axes @ place.rotation, self.axes @ (place.translation - self.origin)]

    def link_poses(self):
        pin.framesForwardKinematics(self.model, self.data, self.at)
        places = [self.data.oMf[self.frame(link)] for link in self.links]
        return [np.vstack([self.axes @ place.rotation for place in places]),
                np.concatenate([self.axes @ (place.translation - self.origin) for place in places])]

    def jacobian(self, link=None):
        frame = self.frame(link or self.tip)
        J = pin.computeFrameJacobian(self.model, self.data, self.at, frame, WORLD)
        return [self.axes_twice @ J[:, self.order]]

    def jacobian_dot_qd(self):
        pin.forwardKinematics(self.model, self.data, self.at, self.to_pinocchio(self.v), self.at_rest())
        a = pin.getFrameClassicalAcceleration(self.model, self.data, self.frame(self.tip), WORLD)
        return [self.axes_twice @ a.vector]

    def frame_velocity(self):
        pin.forwardKinematics(self.model, self.data, self.at, self.to_pinocchio(self.v))
        return [self.axes_twice @ pin.getFrameVelocity(self.model, self.data, self.frame(self.tip), WORLD).vector]

    def frame_acceleration(self):
        v, a = self.to_pinocchio(self.v), self.to_pinocchio(self.a)
        pin.forwardKinematics(self.model, self.data, self.at, v, a)
        of_frame = pin.getFrameClassicalAcceleration(self.model, self.data, self.frame(self.tip), WORLD)
        return [self.axes_twice @ of_frame.vector]

    def inverse_dynamics_derivatives(self):
        v, a = self.to_pinocchio(self.v), self.to_pinocchio(self.a)
        by_q, by_v, _ = pin.computeRNEADerivatives(self.model, self.data, self.at, v, a)
        return [self.square(by_q), self.square(by_v) + np.diag(self.viscous)]

    def forward_dynamics_derivatives(self):
        v = self.to_pinocchio(self.v)
        by_q, by_v, inverse = pin.computeABADerivatives(self.model, self.data, self.at, v, self.forces())
        inverse = self.square(np.triu(inverse) + np.triu(inverse, 1).T)
        return [self.square(by_q), self.square(by_v) - inverse * self.viscous, inverse]

    def regressor(self):
        v, a = self.to_pinocchio(self.v), self.to_pinocchio(self.a)
        Y = self.rows(pin.computeJointTorqueRegressor(self.model, self.data, self.at, v, a))
        columns = [Y[:, :10] @ parameters_from(pin.SE3.Identity())] if self.base else []
        for k, (i, place) in enumerate(zip(self.joints, self.canonical)):
            row = self.base + k
            own = np.zeros((len(Y), 3))  # by armature and friction
            own[row] = self.a[row], self.v[row], np.sign(self.v[row])
            columns += [Y[:, 10 * (i - 1) : 10 * i] @ parameters_from(place), own]
        return [np.hstack(columns)]

    def centroidal_momentum_matrix(self):
        A = pin.computeCentroidalMap(self.model, self.data, self.at)
        return [self.axes_twice @ A[:, self.order]]

    def centroidal_bias(self):
        v = self.to_pinocchio(self.v)
        return [self.axes_twice @ pin.dccrba(self.model, self.data, self.at, v) @ v]

    def centre_of_mass(self):
        J = pin.jacobianCenterOfMass(self.model, self.data, self.at)
        return [self.axes @ (self.data.com[0] - self.origin), self.axes @ J[:, self.order]]

    def inverse_dynamics_floating(self):
        B, bias, b = self.inertia_matrix()[0], self.bias()[0], self.base
        a = self.a.copy()
        a[:b] = np.linalg.solve(B[:b, :b], -B[:b, b:] @ a[b:] - bias[:b])
        tau = self.rows(pin.rnea(self.model, self.data, self.at, self.to_pinocchio(self.v), self.to_pinocchio(a)))
        tau[:b] = 0
        return [a[:b], tau + self.friction()]

    # Contacts: Pinocchio's rigid constraints, with forces in the axes of the joint that holds the contact.
    def constraints(self):
        models = pin.StdVec_RigidConstraintModel()
        for joint, place, rows in self.contacts:
            kind = pin.ContactType.CONTACT_3D if rows == 3 else pin.ContactType.CONTACT_6D
            models.append(pin.RigidConstraintModel(kind, self.model, joint, place, WORLD))
        datas = pin.StdVec_RigidConstraintData()
        for model in models:
            datas.append(model.createData())
        pin.initConstraintDynamics(self.model, self.data, models, datas)
        return models, datas

    def contact_forces(self, datas):
        rows = [rows for _, _, rows in self.contacts]
        return np.concatenate([self.axes_of(n) @ d.contact_force.vector[:n] for n, d in zip(rows, datas)])

    def axes_of(self, rows):
        return self.axes_twice[:rows, :rows]

    def contact_jacobian(self):
        pin.computeJointJacobians(self.model, self.data, self.at)
        positions, J = [], []
        for joint, place, rows in self.contacts:
            at = self.data.oMi[joint] * place
            to_contact = pin.SE3(np.eye(3), -at.translation).toActionMatrix()
            of_joint = pin.getJointJacobian(self.model, self.data, joint, pin.WORLD)
            positions.append(self.axes @ (at.translation - self.origin))
            J.append(self.axes_of(rows) @ (to_contact @ of_joint)[:rows, self.order])
        return [np.concatenate(positions), np.vstack(J)]

    def contact_bias(self):
        pin.forwardKinematics(self.model, self.data, self.at, self.to_pinocchio(self.v), self.at_rest())
        found = []
        for joint, place, rows in self.contacts:
            a = pin.getFrameClassicalAcceleration(self.model, self.data, joint, place, WORLD)
            found.append(self.axes_of(rows) @ a.vector[:rows])
        return [np.concatenate(found)]

    def constrained_forward_dynamics(self):
        if any(rows == 6 for _, _, rows in self.contacts):
            return self.forward_dynamics_at_surfaces()
        models, datas = self.constraints()
        settings = pin.ProximalSettings(1e-14, 0, 20)
        v = self.to_pinocchio(self.v)
        a = pin.constraintDynamics(self.model, self.data, self.at, v, self.forces(), models, datas, settings)
        return [self.rows(a), self.contact_forces(datas)]

    def forward_dynamics_at_surfaces(self):
        # Pinocchio's constraint of a surface keeps its spatial acceleration at zero. That of the point at the contact,
        # which flatdyn means, is another where the contact moves. This function takes any constraint.
        bias, found = self.contact_bias()[0], self.contact_jacobian()[1]
        J = np.empty_like(found)
        J[:, self.order] = found
        v = self.to_pinocchio(self.v)
        a = pin.forwardDynamics(self.model, self.data, self.at, v, self.forces(), J, bias)
        return [self.rows(a), self.data.lambda_c]

    def contact_impact(self):
        models, datas = self.constraints()
        settings = pin.ProximalSettings(1e-14, 0, 20)
        v = self.to_pinocchio(self.v)
        after = pin.impulseDynamics(self.model, self.data, self.at, v, models, datas, 0, settings)
        return [self.rows(after), self.contact_forces(datas)]

    def contact_inverse_dynamics(self):
        tau, J = self.inverse_dynamics()[0], self.contact_jacobian()[1]
        f = np.linalg.lstsq(J.T[: self.base], tau[: self.base], rcond=None)[0]
        tau = tau - J.T @ f
        tau[: self.base] = 0
        return [tau, f]

    # Steps of the convention, for 0.3 s.
    def step(self):
        return pin.integrate(self.model, self.at, 0.3 * self.to_pinocchio(self.v))

    def integrate(self):
        there, joints = self.step(), []
        for i in self.joints:
            k, size = self.model.joints[i].idx_q, self.model.joints[i].nq
            joints.append(there[k] if size == 1 else np.arctan2(there[k + 1], there[k]))
        return [np.concatenate([there[:7], joints])]

    def difference(self):
        return [self.rows(pin.difference(self.model, self.at, self.step()))]


def parameters_from(place):
    """Pinocchio's parameters of a link (m, m l, xx, xy, yy, xz, yz, zz) by flatdyn's, in and about a frame there."""
    H = place.homogeneous
    columns = []
    for k in range(10):
        # Of the points of the link: the sum of mass, of (x, y, z), and of their squares and products.
        m, mx, my, mz, xx, xy, xz, yy, yz, zz = np.eye(10)[k]
        half = (xx + yy + zz) / 2
        rows = [half - xx, -xy, -xz, mx], [-xy, half - yy, -yz, my], [-xz, -yz, half - zz, mz], [mx, my, mz, m]
        sums = H @ np.array(rows) @ H.T
        inertia = np.trace(sums[:3, :3]) * np.eye(3) - sums[:3, :3]
        columns.append([sums[3, 3], *sums[:3, 3], *(inertia[i, j] for i in range(3) for j in range(i + 1))])
    return np.array(columns).T


def numbers(results):
    results = results if isinstance(results, tuple) else (results,)
    return [np.asarray(result) for result in results]


class Differences:
    def __init__(self):
        self.largest, self.limits = {}, {}

    def add(self, name, found, wanted):
        # Functions at contacts return `condition` after what Pinocchio has.
        assert len(found) >= len(wanted), name
        for k, (x, y) in enumerate(zip(found, wanted)):
            y = np.asarray(y)
            key = name if len(wanted) == 1 else f"{name}, result {k + 1}"
            assert x.shape == y.shape or x.size == y.size, (key, x.shape, y.shape)
            difference = np.abs(x.reshape(y.shape) - y).max() / np.abs(y).max()
            self.largest[key] = np.maximum(self.largest.get(key, 0), difference)  # nan stays
            solved = name in SOLUTIONS or name.startswith(("constrained", "step"))
            self.limits[key] = SOLVED if solved else CLOSE

    def report(self):
        for key, difference in self.largest.items():
            verdict = "" if difference <= self.limits[key] else "  ABOVE " + str(self.limits[key])
            print(f"{difference:8.1e}  {key}{verdict}")
        return all(difference <= self.limits[key] for key, difference in self.largest.items())


def compare_module(module, peer, rng):
    functions = [f for name, f in inspect.getmembers(module, inspect.isfunction) if name != "rounding_is_as_written"]
    assert functions
    different = Differences()
    for _ in range(STATES):
        peer.move(rng, in_world=False)
        given = {name: getattr(peer, name) for name in ("q", "v", "a", "tau", "g_b", "h_e", "h", "v_end")}
        given |= {"qd": peer.v, "qdd": peer.a, "qd_end": peer.v_end}
        for function in functions:
            name, link = function.__name__, []
            if name.startswith("external_torque_"):
                name, link = "external_torque", [name.removeprefix("external_torque_")]
            results = function(*(given[argument] for argument in inspect.signature(function).parameters))
            different.add(function.__name__, numbers(results), getattr(peer, name)(*link))
    return different.report()


# Arguments of the functions in Pinocchio's convention after q; others take q alone.
OF_MOTION = ("coriolis_matrix", "bias", "jacobian_dot_qd", "centroidal_bias", "contact_bias", "contact_impact")
ARGUMENTS = dict.fromkeys(OF_MOTION + ("integrate", "difference"), ("v",)) | {
    "inverse_dynamics": ("v", "a"),
    "inverse_dynamics_tip_force": ("v", "a", "h_e"),
    "inverse_dynamics_derivatives": ("v", "a"),
    "forward_dynamics": ("v", "tau"),
    "forward_dynamics_derivatives": ("v", "tau"),
    "constrained_forward_dynamics": ("v", "tau"),
    "contact_inverse_dynamics": ("v", "a"),
}


def compare_convention(path, functions, peer, rng):
    library = ctypes.CDLL(path)
    different = Differences()
    for _ in range(STATES):
        peer.move(rng, in_world=True)
        for name in functions:
            wanted = [np.asarray(y, dtype=float) for y in getattr(peer, name)()]
            results = [np.full(y.shape, np.nan) for y in wanted]
            given = [peer.configuration(), *(getattr(peer, argument) for argument in ARGUMENTS.get(name, ()))]
            getattr(library, name)(*(ctypes.c_void_p(x.ctypes.data) for x in given + results))
            different.add(name, results, wanted)
    return different.report()


def main():
    given = arguments()
    peer = Peer(given.robot, given.floating, given.tip, given.contact)
    rng = np.random.default_rng(1)
    passed = True
    if given.module:
        sys.path.insert(0, ".")
        module = importlib.import_module(given.module)
        wanted = [peer.model.names[i] for i in peer.joints]
        assert list(module.joint_names) == wanted, (module.joint_names, wanted)
        peer.read_canonical_frames(given.module + ".json")
        passed = compare_module(module, peer, rng)
    if given.convention:
        print("In the convention of Pinocchio:")
        passed = compare_convention(given.convention, given.functions.split(","), peer, rng) and passed
    sys.exit(0 if passed else 1)


main()
