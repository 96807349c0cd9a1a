"""Tables of values for notebooks."""
import html

import numpy as np

from . import _glissade as g


def table(caption, head, rows):
    """An HTML table. All texts are escaped."""
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"
    return (f"<table><caption>{html.escape(caption)}</caption>" + (line(head, "th") if head else "") +
            "".join(line(row, "td") for row in rows) + "</table>")


def millimetres(metres):
    return f"{1e3 * metres:.4g}"


def clearance(metres, body):
    return f"{millimetres(metres)} mm" + (f" to {body}" if body else "") if np.isfinite(metres) else "nothing near"


def of_product(product):
    rows = []
    for body in product.bodies:
        size = np.ptp(body.mesh.vertices, axis=0)
        rows.append([body.id, body.name, " × ".join(map(millimetres, size)), len(body.mesh.triangles),
                     "closed" if body.mesh.closed else "open"])
    return table(product.file or "product", ["id", "name", "size, mm", "triangles", "surface"], rows)


def of_scenario(scenario):
    problem = scenario.problem
    goal = "out" if problem.goal is None else np.asarray(problem.goal)
    rows = [["file", scenario.file], ["strategy", f"{scenario.strategy}, seed {scenario.seed}"],
            ["start", np.asarray(problem.start)], ["goal", goal],
            ["obstacles", ", ".join(body.name for body in problem.world.obstacles)]]
    return table(scenario.name, [], rows + [["warning", text] for text in scenario.warnings])


def certificate_rows(certificate):
    if certificate.status == "undecided":
        return [["certificate", "undecided"]]
    return [["certificate", certificate.status],
            ["clearance", clearance(certificate.min_clearance, certificate.nearest.body)],
            ["proved clearance", f"{millimetres(certificate.proved_clearance)} mm"]]


def path_rows(path):
    return [["configurations", len(path)], ["length", f"{millimetres(path.length)} mm"],
            ["rotation", f"{np.degrees(path.rotation):.4g}°"], *certificate_rows(path.certificate)]


def of_path(path):
    return table("path", [], path_rows(path))


def of_run(run):
    counts = run.counts
    return table("run", [], [["strategy", f"{run.strategy}, seed {run.seed}"], ["time", f"{run.seconds:.3g} s"],
                             ["nodes", counts.nodes], ["random configurations", counts.random_configurations],
                             *path_rows(run.path)])


def of_plan(plan):
    rows = []
    for number, step in enumerate(plan.steps, start=1):
        for motion in step.motions:
            rows.append([number, " + ".join(motion.bodies), motion.method,
                         "certified" if motion.certified else "not certified",
                         clearance(motion.min_clearance, motion.nearest)])
    rows += [["stuck", stuck.body, stuck.reason, "", ", ".join(stuck.blocked_by)] for stuck in plan.stuck]
    return table(f"{plan.removed} of {plan.parts} parts removed, {plan.end}",
                 ["step", "bodies", "motion", "proof", "clearance"], rows)


def of_verdict(verdict):
    return f"<b>{html.escape(verdict.kind)}</b><pre>{html.escape(verdict.text)}</pre>"


def of_layers(layers):
    return table("places", ["name", "complexity", "narrowness, mm", "passage", "attributes"],
                 [[place.name, place.complexity, millimetres(place.narrowness), "yes" if place.passage else "",
                   ", ".join(f"{name}: {value}" for name, value in place.attributes.items())]
                  for place in layers.places])


def of_coarse_plan(plan):
    return table(f"{plan.strategy}, cost {plan.cost:.4g}", ["place", "border", "planner", "reason"],
                 [[step.place_name, step.border_name, step.planner, step.reason] for step in plan.steps] +
                 [[name, "", "", "closed"] for name in plan.closed])


TABLES = {g.Product: of_product, g.Scenario: of_scenario, g.Path: of_path, g.Run: of_run, g.AssemblyPlan: of_plan,
          g.Verdict: of_verdict, g.Layers: of_layers, g.CoarsePlan: of_coarse_plan}


class Fits(list):
    """A list of Fit."""

    def _repr_html_(self):
        return table(f"{len(self)} fits", ["a", "b", "kind", "gap, mm", "overlap, mm", "allowance, mm", "status"],
                     [[fit.a, fit.b, fit.kind, millimetres(fit.gap), millimetres(fit.overlap),
                       millimetres(fit.allowance), fit.status] for fit in self])


class Joints(list):
    """A list of Joint."""

    def _repr_html_(self):
        return table(f"{len(self)} joints", ["kind", "state", "body", "joined to", "clamps", "designation", "evidence"],
                     [[joint.kind, joint.state, joint.body, ", ".join(joint.others), ", ".join(joint.clamped),
                       joint.designation, "; ".join(joint.evidence)] for joint in self])
