"""A sampler, a semantic attribute and a rule of one's own: the object keeps to the lower one of two windows."""
import numpy as np

import glissade


class Sampler:
    """Draws along the line from the start to the goal, with a normal spread, and turns nothing."""

    def __init__(self, problem, seed):
        self.random = np.random.default_rng(seed)
        self.ends = np.stack([np.asarray(problem.start), np.asarray(problem.goal)])
        self.bounds = problem.bounds

    def __call__(self):
        pose = self.ends[0] + self.random.random() * (self.ends[1] - self.ends[0])
        pose[:3] = np.clip(pose[:3] + self.random.normal(0, 0.3, 3), *self.bounds)
        pose[3:] = self.ends[0, 3:]
        return pose


def wall(name, edges, middle):
    return glissade.Body(name, glissade.Mesh.box(edges), middle)


walls = [wall("below", [0.2, 4, 1.2], [0, 0, -1.4]), wall("between", [0.2, 4, 0.4], [0, 0, 0]),
         wall("above", [0.2, 4, 1.2], [0, 0, 1.4])]
walls += [wall(f"side {y} {z}", [0.2, 1.7, 0.6], [0, y, z]) for y in (-1.15, 1.15) for z in (-0.5, 0.5)]
world = glissade.World(walls, glissade.Mesh.box([0.2, 0.2, 0.2]))
problem = glissade.Problem(world, [-1.5, 0, 0.5], [1.5, 0, 0.5], bounds=([-2, -2, -2], [2, 2, 2]))
run = glissade.plan(problem, strategy="birrt", seed=1, sampler=Sampler)
print("own sampler:", run.path, run.counts)
print("without it: ", glissade.plan(problem, strategy="birrt", seed=1).counts)

layers = glissade.Layers(problem, cell_size=0.1, topology_level=5)
shortest = layers.coarse_plan("gt")
layers = layers.with_attribute("height", lambda place: float(place.anchor[2]), minimum=-2, maximum=2)
layers = layers.with_rules(glissade.Rules(edge="distance * if(place.height > 0.2 and place.complexity > 1, 10, 1)"))
own = layers.coarse_plan("own")
print("shortest way:", shortest)
print("own rule:    ", own)
run = glissade.plan(layers.problem, strategy="own", seed=1)
print("changed:", [step.place for step in own.steps] != [step.place for step in shortest.steps])
print("judge:", glissade.check(layers.problem, run.path).kind)
