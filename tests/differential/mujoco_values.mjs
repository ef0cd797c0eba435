// SPDX-License-Identifier: GPL-2.0-or-later
// node mujoco_values.mjs IN OUT: what MuJoCo computes of an MJCF text at the states in IN, to OUT. Exits with 77 where
// MuJoCo is not installed.
import {readFileSync, writeFileSync} from 'node:fs';

const kTime = 0.7;  // of a step, s
const kFriction = 4, kLimits = 8, kContacts = 16, kConstraints = 1;  // bits of disableflags

let mujoco;
try {
  const load = (await import(process.env.FLATDYN_MUJOCO ?? '@mujoco/mujoco')).default;
  mujoco = await load({print: () => {}, printErr: () => {}});
} catch {
  process.exit(77);
}

const {xml, files, states} = JSON.parse(readFileSync(process.argv[2], 'utf8'));
mujoco.FS.mkdir('/model');
for (const [name, bytes] of Object.entries(files)) mujoco.FS.writeFile('/model/' + name, Uint8Array.from(bytes));
mujoco.FS.writeFile('/model/main.xml', xml);
const model = mujoco.MjModel.from_xml_path('/model/main.xml');
const data = new mujoco.MjData(model);
const n = model.nv;

function largestGap() {
  model.opt.disableflags = kFriction | kLimits | kContacts;
  mujoco.mj_forward(model, data);
  return Math.max(0, ...Array.from(data.efc_pos, Math.abs));
}

// The positions after a step, and the velocity that leads to them in the time 1.
function stepFrom(q, qd) {
  const next = mujoco.DoubleBuffer.FromArray(q), difference = new mujoco.DoubleBuffer(n);
  mujoco.mj_integratePos(model, next, qd, kTime);
  mujoco.mj_differentiatePos(model, difference, 1, q, Array.from(next.GetView()));
  return {next: Array.from(next.GetView()), difference: Array.from(difference.GetView())};
}

function valuesAt({q, qd, qdd}) {
  data.qpos.set(q);
  data.qvel.set(qd);
  const gap = largestGap();
  model.opt.disableflags = kConstraints;
  mujoco.mj_forward(model, data);
  const B = new mujoco.DoubleBuffer(n * n);
  mujoco.mj_fullM(model, data, B);
  const bias = Array.from(data.qfrc_bias, (force, i) => force - data.qfrc_passive[i]);
  data.qacc.set(qdd);
  mujoco.mj_inverse(model, data);
  return {B: Array.from(B.GetView()), bias, tau: Array.from(data.qfrc_inverse), gap, ...stepFrom(q, qd)};
}

const bodies = Array.from(model.body_mass, (mass, i) => ({
  mass, com: Array.from(model.body_ipos.slice(3 * i, 3 * i + 3)),
  axes: Array.from(model.body_iquat.slice(4 * i, 4 * i + 4)),
  moments: Array.from(model.body_inertia.slice(3 * i, 3 * i + 3)).sort((a, b) => a - b)}));
const coulomb = Array.from(model.dof_frictionloss);
writeFileSync(process.argv[3], JSON.stringify({n, coulomb, bodies, states: states.map(valuesAt)}));
