"""Exports an assembly plan for other tools: a table of its steps and the ways of a robot.

usage: export_plan.py OUT.csv OUT.json
The table is for spreadsheets and planning of lines, in the order of assembly: millimetres, one row for each motion. The
other file has the way of each motion in the world: millimetres, quaternions w x y z, as many robots take them.
"""
import csv
import json
import pathlib
import sys

import numpy as np

import glissade

samples = pathlib.Path(__file__).resolve().parent.parent
product = glissade.load_product(str(samples / "bolted-brackets" / "scenario.json"))
names = {body.id: body.name for body in product.bodies}
fastened = {joint.body: joint for joint in glissade.joints(product)}
plan = glissade.sequence(product)
if not glissade.check(product, plan).valid:
    sys.exit("the plan is not valid")

rows, ways = [], []
for step, removed in enumerate(reversed(plan.steps), start=1):
    for motion in reversed(removed.motions):
        way = motion.path[::-1]
        approach = way[-1, :3] - way[-2, :3]
        length = np.linalg.norm(np.diff(way[:, :3], axis=0), axis=1).sum()
        joint = fastened.get(motion.bodies[0])
        rows.append({"step": step, "parts": " + ".join(names[body] for body in motion.bodies),
                     "joint": joint.kind if joint else "", "designation": joint.designation if joint else "",
                     "approach": " ".join(f"{c:.3f}" for c in approach / max(np.linalg.norm(approach), 1e-12)),
                     "way_mm": round(1e3 * length, 1),
                     "clearance_mm": round(1e3 * motion.min_clearance, 3) if np.isfinite(motion.min_clearance) else ""})
        ways.append({"step": step, "parts": motion.bodies,
                     "poses": [{"xyz_mm": (1e3 * pose[:3]).round(6).tolist(), "wxyz": pose[[6, 3, 4, 5]].tolist()}
                               for pose in way]})

with open(sys.argv[1], "w", newline="", encoding="utf-8") as file:
    writer = csv.DictWriter(file, rows[0])
    writer.writeheader()
    writer.writerows(rows)
pathlib.Path(sys.argv[2]).write_text(json.dumps({"base": plan.staying, "motions": ways}, indent=1), encoding="utf-8")
print(f"{len(rows)} motions of {len(plan.steps)} steps exported, base {', '.join(names[body] for body in plan.staying)}")
