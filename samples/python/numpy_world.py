"""Plans in a world of NumPy arrays: a rod has to pass a hole in a wall."""
import numpy as np

import glissade


def box(lower, upper):
    """Vertices and triangles of a box between two corners."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    vertices = np.where(corners, upper, lower)
    triangles = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                          [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
    return glissade.Mesh(vertices, triangles)


walls = {"left": box([-0.05, -1, -1], [0.05, -0.15, 1]), "right": box([-0.05, 0.15, -1], [0.05, 1, 1]),
         "below": box([-0.05, -0.15, -1], [0.05, 0.15, -0.15]), "above": box([-0.05, -0.15, 0.15], [0.05, 0.15, 1])}
rod = box([-0.05, -0.3, -0.05], [0.05, 0.3, 0.05])
world = glissade.World([glissade.Body(name, mesh) for name, mesh in walls.items()], rod)
problem = glissade.Problem(world, start=[-0.6, 0, 0], goal=[0.6, 0, 0], bounds=([-1, -1, -1], [1, 1, 1]))
run = glissade.plan(problem, strategy="auto", seed=1)
print(run.path)
print(glissade.check(problem, run.path).text)
