"""A planner of one's own: RRT (S. M. LaValle 1998) in Python. The library certifies its path."""
import numpy as np

import glissade


def rrt(context):
    """Grows a tree from the start until the straight motion from its newest node to the goal is free."""
    problem, query = context.problem, context.query
    random = np.random.default_rng(context.seed)
    lower, upper = problem.bounds
    step = context.parameter("growth_step")
    goal = np.asarray(problem.goal)
    nodes, parents = [np.asarray(problem.start)], [None]
    while context.step():
        position = goal[:3] if random.random() < 0.1 else random.uniform(lower, upper)
        drawn = np.concatenate([position, goal[3:]])
        near = min(range(len(nodes)), key=lambda i: np.linalg.norm(nodes[i][:3] - position))
        share = 0.95 * query.free_share(nodes[near], drawn, step)
        if share * np.linalg.norm(nodes[near][:3] - position) < step:
            continue
        nodes.append(nodes[near] + share * (drawn - nodes[near]))
        parents.append(near)
        if query.free_share(nodes[-1], goal, step) < 1:
            continue
        way, node = [goal], len(nodes) - 1
        while node is not None:
            way.append(nodes[node])
            node = parents[node]
        return np.array(way[::-1])
    return None


cube = glissade.Mesh.box([0.2, 0.2, 0.2])
walls = [glissade.Body("wall", glissade.Mesh.box([0.1, 1, 1])), glissade.Body("post", cube, [0.6, 0, 0.1])]
problem = glissade.Problem(glissade.World(walls, cube), [-1, 0, 0], [1, 0, 0], bounds=([-2, -2, -2], [2, 2, 2]))
for strategy in ("rrt-in-python", "birrt"):
    run = glissade.plan(problem, strategy=strategy, seed=1, planners={"rrt-in-python": rrt})
    print(strategy, run.path, run.counts)
