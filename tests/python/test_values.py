import numpy as np
import pytest

import glissade


def test_arrays_of_a_mesh_share_its_memory(cube):
    assert cube.vertices.shape == (8, 3) and cube.triangles.shape == (12, 3)
    assert cube.vertices.ctypes.data == cube.vertices.ctypes.data
    with pytest.raises(ValueError):
        cube.vertices[0, 0] = 1.0
    vertices = glissade.Mesh.box([1, 1, 1]).vertices  # the mesh lives as long as its array
    assert vertices.max() == 0.5


def test_a_pose_is_a_value_seven_numbers_a_position_or_a_matrix(world):
    query = world.query()
    matrix = np.eye(4)
    matrix[:3, 3] = [1, 0, 0]
    poses = [glissade.Pose([1, 0, 0]), [1, 0, 0, 0, 0, 0, 1], np.array([1.0, 0, 0]), matrix]
    assert {query.nearest(pose).distance for pose in poses} == {0.75}
    turned = glissade.Pose([0, 0, 0], [0, 0, 1, 0])
    assert np.array_equal(np.asarray(turned), [0, 0, 0, 0, 0, 1, 0])


def test_a_query_answers(world):
    query = world.query()
    assert query.collides([0, 0, 0]) and not query.collides([1, 0, 0])
    nearest = query.nearest([1, 0, 0])
    assert nearest.body == "wall" and nearest.on_object[0] == 0.95
    assert query.certify([-1, 0, 1], [1, 0, 1], 1e-3).certified
    assert query.certify([-1, 0, 0], [1, 0, 0], 1e-3).status == "violated"
    assert query.free_share([-1, 0, 0], [1, 0, 0], 0.01) == pytest.approx(0.375, abs=0.01)


def test_every_value_says_what_it_is(problem, samples):
    scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))
    run = glissade.plan(problem, strategy="birrt")
    product = glissade.Product([glissade.Body("a", glissade.Mesh.box([1, 1, 1])),
                                glissade.Body("b", glissade.Mesh.box([1, 1, 1]), [0, 0, 1])])
    plan = glissade.sequence(product)
    values = [glissade.Pose(), problem, problem.world, problem.world.object, problem.world.obstacles[0], scenario, run,
              run.path, run.path.certificate, run.counts, run.path.certificate.nearest, product, plan, plan.steps[0],
              glissade.fits(product)[0], glissade.check(problem, run.path)]
    for value in values:
        assert repr(value).startswith("<glissade.") and "object at" not in repr(value), repr(value)


def test_the_stubs_name_what_the_module_has():
    import ast
    import pathlib
    stub = ast.parse((pathlib.Path(glissade.__file__).parent / "__init__.pyi").read_text())
    named = {node.name: node for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    present = {name for name in dir(glissade) if not name.startswith("_")}
    assert set(named) == present
    for name, node in named.items():
        if not isinstance(node, ast.ClassDef) or name == "Error":
            continue
        members = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        members |= {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
        has = {member for member in vars(getattr(glissade, name)) if not member.startswith("_")}
        assert {member for member in members if not member.startswith("_")} == has, name
