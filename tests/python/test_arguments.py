"""Wrong arguments of every function and constructor are exceptions."""
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
