"""Wrong arguments of every function and constructor are exceptions."""
import ast
import pathlib

import numpy as np
import pytest

import glissade

NAN = float("nan")
CUBE = glissade.Mesh.box([1, 1, 1])
WORLD = glissade.World([glissade.Body("wall", CUBE)], CUBE)
PROBLEM = glissade.Problem(WORLD, [-3, 0, 0], [3, 0, 0])
PATH = glissade.Path([[-3, 0, 0], [3, 0, 0]])
PRODUCT = glissade.Product([glissade.Body("a", CUBE), glissade.Body("b", CUBE, [0, 0, 1])])
QUERY = WORLD.query()
PLAN = glissade.sequence(PRODUCT)
LAYERS = glissade.Layers(PROBLEM, topology_level=3)
SCENARIO = glissade.load_scenario(str(pathlib.Path(__file__).parents[2] / "samples" / "sliding-plane" / "scenario.json"))

WRONG = {
    "mesh of nothing": lambda: glissade.Mesh([], []),
    "mesh of flat arrays": lambda: glissade.Mesh(np.zeros(9), np.zeros(3, int)),
    "mesh of two columns": lambda: glissade.Mesh(np.zeros((3, 2)), [[0, 1, 2]]),
    "mesh of NaN": lambda: glissade.Mesh([[NAN, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]),
    "mesh of an index below 0": lambda: glissade.Mesh(np.eye(3), [[0, 1, -1]]),
    "mesh of an index of no vertex": lambda: glissade.Mesh(np.eye(3), [[0, 1, 3]]),
    "mesh of texts": lambda: glissade.Mesh("vertices", "triangles"),
    "mesh of None": lambda: glissade.Mesh(None, None),
    "flat box": lambda: glissade.Mesh.box([1, 1, 0]),
    "box of two edges": lambda: glissade.Mesh.box([1, 1]),
    "pose of two numbers": lambda: glissade.Pose([1, 2]),
    "pose of three angles": lambda: glissade.Pose([0, 0, 0], [0, 0, 0]),
    "body without an id": lambda: glissade.World([glissade.Body("", CUBE)], CUBE),
    "body without a mesh": lambda: glissade.Body("a", None),
    "equal ids": lambda: glissade.World([glissade.Body("a", CUBE)] * 2, CUBE),
    "quaternion of length 2": lambda: QUERY.collides([0, 0, 0, 0, 0, 0, 2]),
    "pose of NaN": lambda: QUERY.nearest([NAN, 0, 0]),
    "pose of a sheared matrix": lambda: QUERY.nearest(np.ones((4, 4))),
    "pose of a text": lambda: QUERY.nearest("here"),
    "pose of None": lambda: QUERY.collides(None),
    "clearance of 0": lambda: QUERY.certify([0, 0, 2], [0, 0, 3], 0),
    "step of NaN": lambda: QUERY.free_share([0, 0, 2], [0, 0, 3], NAN),
    "start of NaN": lambda: glissade.Problem(WORLD, [NAN, 0, 0]),
    "bounds upside down": lambda: glissade.Problem(WORLD, [3, 0, 0], bounds=([1, 1, 1], [0, 0, 0])),
    "bounds of one corner": lambda: glissade.Problem(WORLD, [3, 0, 0], bounds=[[1, 1, 1]]),
    "unknown parameter": lambda: glissade.Problem(WORLD, [3, 0, 0], parameters={"alfa": 1}),
    "parameter out of range": lambda: glissade.plan(PROBLEM, parameters={"alpha": 2}),
    "empty path": lambda: glissade.Path([]),
    "path of a flat array": lambda: glissade.Path(np.zeros(7)),
    "path of NaN": lambda: glissade.Path(np.full((2, 7), NAN)),
    "plan of no task": lambda: glissade.plan(None),
    "unknown strategy": lambda: glissade.plan(PROBLEM, strategy="nonsense"),
    "unknown operator": lambda: glissade.plan(PROBLEM, operator="nobody"),
    "operator that is none": lambda: glissade.plan(PROBLEM, strategy="contact-birrt", operator=7),
    "operator without a pose": lambda: glissade.plan(PROBLEM, strategy="contact-birrt", operator=lambda view: None),
    "session of no task": lambda: glissade.Session(None),
    "session of an unknown strategy": lambda: glissade.Session(PROBLEM, strategy="nonsense"),
    "session of an unknown operator": lambda: glissade.Session(PROBLEM, operator="nobody"),
    "session with an unknown parameter": lambda: glissade.Session(PROBLEM, parameters={"alfa": 1}),
    "unknown parameter of a session": lambda: glissade.Session(PROBLEM).set(alfa=1),
    "text as a parameter of a session": lambda: glissade.Session(PROBLEM).set(alpha="half"),
    "negative steps": lambda: glissade.Session(PROBLEM).step(-1),
    "negative seed": lambda: glissade.plan(PROBLEM, seed=-1),
    "id of another planner": lambda: glissade.plan(PROBLEM, planners={"birrt": lambda context: None}),
    "planner that is none": lambda: glissade.plan(PROBLEM, strategy="mine", planners={"mine": 7}),
    "start in collision": lambda: glissade.plan(glissade.Problem(WORLD, [0, 0, 0], [3, 0, 0])),
    "clearance below 0": lambda: glissade.check(PROBLEM, PATH, required_clearance=-1),
    "check of a path by a plan": lambda: glissade.check(PRODUCT, PATH),
    "check of no files": lambda: glissade.check("/no/scenario.json", "/no/path.csv"),
    "product of one body": lambda: glissade.Product([glissade.Body("a", CUBE)]),
    "fits up to NaN": lambda: glissade.fits(PRODUCT, clearance_up_to=NAN),
    "fits of None": lambda: glissade.fits(None),
    "joints of None": lambda: glissade.joints(None),
    "negative threads": lambda: glissade.sequence(PRODUCT, threads=-1),
    "unknown base": lambda: glissade.sequence(PRODUCT, staying=["nobody"]),
    "time limit of NaN": lambda: glissade.sequence(PRODUCT, time_limit=NAN),
    "sweep of no poses": lambda: glissade.sweep(CUBE, []),
    "sweep with a bound of 0": lambda: glissade.sweep(CUBE, PATH, bound=0),
    "too many samples": lambda: glissade.clearance(WORLD, PATH, samples=10**12),
    "no scenario": lambda: glissade.load_scenario("/no/scenario.json"),
    "no product": lambda: glissade.load_product("/no/product.step"),
    "no mesh": lambda: glissade.load_mesh("/no/mesh.stl"),
    "no path": lambda: glissade.load_path("/no/path.csv"),
    "no plan": lambda: glissade.load_plan("/no/plan.json"),
    "layers of no task": lambda: glissade.Layers(None),
    "cells of NaN": lambda: glissade.Layers(PROBLEM, cell_size=NAN),
    "memory below 0": lambda: glissade.Layers(PROBLEM, memory=-1),
    "unknown identifier": lambda: glissade.Layers(PROBLEM, identifier="nonsense"),
    "place of no number": lambda: LAYERS.with_place_value(999, "forbidden", True),
    "place of no name": lambda: LAYERS.with_place_value("P999", "forbidden", True),
    "place below 0": lambda: LAYERS.with_place_value(-1, "forbidden", True),
    "unknown attribute": lambda: LAYERS.with_place_value(0, "nonsense", True),
    "attribute of NaN": lambda: LAYERS.with_place_value(0, "preference", NAN),
    "attribute out of range": lambda: LAYERS.with_place_value(0, "preference", -1),
    "attribute of another kind": lambda: LAYERS.with_place_value(0, "forbidden", "yes"),
    "attribute of None": lambda: LAYERS.with_place_value(0, "forbidden", None),
    "attributes of no body": lambda: LAYERS.of_body("nobody"),
    "attribute of no body": lambda: LAYERS.with_body_value("nobody", "mobility", "static"),
    "attribute that is no word": lambda: LAYERS.with_attribute("Not a word"),
    "attribute that exists": lambda: LAYERS.with_attribute("forbidden"),
    "attribute whose function returns NaN": lambda: LAYERS.with_attribute("risk", lambda place: NAN),
    "attribute whose function returns too much": lambda: LAYERS.with_attribute("risk", lambda place: 2, maximum=1),
    "attribute whose function returns None": lambda: LAYERS.with_attribute("risk", lambda place: None),
    "attribute whose function is none": lambda: LAYERS.with_attribute("risk", 7),
    "rules of a text": lambda: LAYERS.with_rules("distance"),
    "rules that do not parse": lambda: LAYERS.with_rules(glissade.Rules(edge="distance +")),
    "rules of an unknown name": lambda: LAYERS.with_rules(glissade.Rules(edge="place.nonsense")),
    "rules of None": lambda: glissade.Rules(node=None),
    "fine rule of None": lambda: glissade.FineRule(None, "rrt"),
    "rules of an unknown planner": lambda: LAYERS.with_rules(glissade.Rules(fine=[glissade.FineRule("1", "none")])),
    "rules of no strategy": lambda: LAYERS.rules("birrt"),
    "coarse plan of no strategy": lambda: LAYERS.coarse_plan("nonsense"),
    "sampler that is none": lambda: glissade.plan(PROBLEM, strategy="birrt", sampler=7),
    "sampler without a function": lambda: glissade.plan(PROBLEM, strategy="birrt", sampler=lambda task, seed: 7),
    "sampler of NaN": lambda: glissade.plan(PROBLEM, strategy="birrt", sampler=lambda *task: lambda: [NAN, 0, 0]),
    "sampler of a session that is none": lambda: glissade.Session(PROBLEM, sampler="nobody"),
    "view of None": lambda: glissade.view(None),
    "view of a path by a plan": lambda: glissade.view(PROBLEM, plan=PATH),
    "view of a path and a plan": lambda: glissade.view(PROBLEM, PATH, PLAN),
    "view of a plan by a problem": lambda: glissade.view(PROBLEM, plan=PLAN),
    "view at NaN": lambda: glissade.view(PRODUCT, moment=NAN),
    "view without pixels": lambda: glissade.view(PRODUCT, pixels=0),
    "program of None": lambda: glissade.program_file(None),
    "path saved to no folder": lambda: PATH.save("/no/folder/path.csv", SCENARIO),
    "path saved without a format": lambda: PATH.save("path.nonsense", SCENARIO),
    "plan saved to no folder": lambda: PLAN.save("/no/folder/plan.json", "product.step"),
    "document of a plan of None": lambda: PLAN.json(None),
    "context that is made": lambda: glissade.PlannerContext().parameter("alpha"),
    "deflection of NaN": lambda: glissade.load_product("/no/product.step", deflection=NAN),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_argument_is_an_exception(name):
    with pytest.raises((glissade.Error, ValueError, TypeError, RuntimeError)) as caught:
        WRONG[name]()
    assert str(caught.value)


def test_an_error_has_file_reason_and_kind():
    with pytest.raises(glissade.Error) as caught:
        glissade.load_scenario("/no/scenario.json")
    assert caught.value.file == "/no/scenario.json" and caught.value.kind == "malformed_input" and caught.value.reason


def test_every_function_with_arguments_is_called_wrongly():
    stub = ast.parse((pathlib.Path(glissade.__file__).parent / "__init__.pyi").read_text())
    named = set()
    for node in stub.body:
        if isinstance(node, ast.FunctionDef):
            named.add(node.name)
        for item in node.body if isinstance(node, ast.ClassDef) else []:
            takes = isinstance(item, ast.FunctionDef) and len(item.args.args) + len(item.args.kwonlyargs) > 1
            if takes or isinstance(item, ast.FunctionDef) and item.args.kwarg:
                named.add(node.name if item.name == "__init__" else item.name)
    called = {node.func.attr for node in ast.walk(ast.parse(pathlib.Path(__file__).read_text()))
              if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)}
    assert named <= called, named - called
