"""The layers of Cailhol et al. 2019: the coarse way through the shape game changes with an attribute of a hole."""
import pathlib

import numpy as np

import glissade

samples = pathlib.Path(__file__).resolve().parent.parent
scenario = glissade.load_scenario(str(samples / "shape-game" / "tight-star.json"))
layers = glissade.Layers(scenario)
free = layers.cells.kinds == 0
print(f"{len(layers.cells)} cells, {np.sum(layers.cells.sizes[free] ** 3):.3f} m3 are free")
for place in layers.places:
    if place.passage:
        print(f"{place.name}: hole of {1e3 * place.narrowness:.0f} mm, compatibility {place.attributes['compatibility']:.2f}")

plan = layers.coarse_plan("gts")
print("rule of nodes:", plan.rules.node)
print("cost {:.2f}:".format(plan.cost), plan)
hole = next(step.place for step in plan.steps if layers.places[step.place].passage)
closed = layers.with_place_value(hole, "forbidden", True)
other = closed.coarse_plan("gts")
print(f"without {layers.places[hole].name}, cost {other.cost:.2f}:", other)
print("changed:", [step.place for step in other.steps] != [step.place for step in plan.steps])
run = glissade.plan(layers.problem, strategy="gts", seed=1)
print(run.path)
