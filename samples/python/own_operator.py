"""A simulated operator of one's own, alone (α = 0): it leads the object over a wall and down behind it."""
import numpy as np

import glissade

SPEED = 0.5  # metres a second
WAY = np.array([[-1, 0, 0.4], [0.8, 0, 0.4], [0.8, 0, 0], [1, 0, 0]])


class Operator:
    """Follows its way at a constant speed, more slowly near obstacles."""

    def __init__(self, way):
        self.left = list(way)

    def __call__(self, view):
        hand = np.array(view.hand)
        if not self.left:
            return hand
        to = self.left[0] - hand[:3]
        speed = SPEED * np.clip(view.clearance / 0.1, 0.2, 1)
        share = min(1.0, speed * view.seconds / max(1e-12, np.linalg.norm(to)))
        if share == 1.0:
            self.left.pop(0)
        hand[:3] += share * to
        return hand


cube = glissade.Mesh.box([0.1, 0.1, 0.1])
wall = glissade.Body("wall", glissade.Mesh.box([0.4, 4, 0.6]))
problem = glissade.Problem(glissade.World([wall], cube), [-1, 0, 0], [1, 0, 0], bounds=([-2, -2, -2], [2, 2, 2]))
run = glissade.plan(problem, strategy="contact-birrt", seed=1, operator=Operator(WAY),
                    parameters={"alpha": 0, "contact_distance": 0.05})
print(run.path, run.counts)
