"""Takes a product apart and lists its parts in the order of assembly."""
import pathlib

import glissade

samples = pathlib.Path(__file__).resolve().parent.parent
product = glissade.load_product(str(samples / "bolted-brackets" / "scenario.json"))
names = {body.id: body.name for body in product.bodies}
plan = glissade.sequence(product)
print(plan)

print("base:", ", ".join(names[body] for body in plan.staying))
for number, step in enumerate(reversed(plan.steps), start=1):
    for motion in reversed(step.motions):
        parts = " + ".join(names[body] for body in motion.bodies)
        print(f"{number:2}  {parts:20} {motion.method:12} clearance {1e3 * motion.min_clearance:.3f} mm")
for joint in glissade.joints(product):
    print(f"{joint.kind} {names[joint.body]} holds {', '.join(names[body] for body in joint.others)}")
print(glissade.check(product, plan).text)
