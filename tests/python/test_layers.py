import builtins

import numpy as np
import pytest

import glissade


@pytest.fixture(scope="module")
def problem():
    """A wall with a window near the straight way, and another one."""
    def beam(name, edges, middle):
        return glissade.Body(name, glissade.Mesh.box(edges), middle)
    walls = [beam("below", [0.2, 4, 1.5], [0, 0, -1.25]), beam("above", [0.2, 4, 1.5], [0, 0, 1.25]),
             beam("left", [0.2, 0.8, 1], [0, -1.6, 0]), beam("post", [0.2, 1.2, 1], [0, 0.1, 0]),
             beam("right", [0.2, 0.6, 1], [0, 1.7, 0])]
    world = glissade.World(walls, glissade.Mesh.box([0.2, 0.2, 0.2]))
    return glissade.Problem(world, [-1.5, 0.7, 0], [1.5, 0.7, 0], bounds=([-2, -2, -2], [2, 2, 2]))


@pytest.fixture(scope="module")
def layers(problem):
    return glissade.Layers(problem, cell_size=0.1, topology_level=5)


def places_of(plan):
    return [step.place for step in plan.steps]


def window_of(layers, plan):
    return next(place for place in places_of(plan) if layers.places[place].passage)


def test_layers_are_arrays_and_values(layers):
    cells = layers.cells
    assert cells.centres.shape == (len(cells), 3) and set(cells.kinds) == {0, 2}
    assert np.sum(cells.sizes ** 3) == pytest.approx(64)
    for place in layers.places:
        assert place.boxes.shape[1:] == (2, 3)
        assert np.prod(place.boxes[:, 1] - place.boxes[:, 0], axis=1).sum() == pytest.approx(place.volume)
        assert place.attributes["complexity"] == place.complexity and place.attributes["forbidden"] is False
    assert all(max(border.places) < len(layers.places) for border in layers.borders)
    assert layers.of_body("post")["mobility"] == "static" and layers.of_body(layers.object_id)


def test_an_attribute_changes_the_coarse_plan(layers):
    plan = layers.coarse_plan("gt")
    window = window_of(layers, plan)
    closed = layers.with_place_value(layers.places[window].name, "forbidden", np.bool_(True))
    assert window not in places_of(closed.coarse_plan("gt")) and window in places_of(layers.coarse_plan("gt"))
    run = glissade.plan(closed.problem, strategy="gts", seed=1)
    assert glissade.check(closed.problem, run.path).valid


def test_an_attribute_and_rules_from_outside(layers):
    window = window_of(layers, layers.coarse_plan("gt"))
    own = layers.with_attribute("near", lambda place: np.float64(place.anchor[1] > 0), minimum=0, maximum=1)
    own = own.with_rules(glissade.Rules(edge="distance * (1 + 100 * place.near)"))
    assert own.rules("own").edge == "distance * (1 + 100 * place.near)" and own.rules("own").fine[0].local == "rrt"
    assert window not in places_of(own.coarse_plan("own"))
    with pytest.raises(LookupError):
        layers.with_attribute("near", lambda place: {}["no"])


def test_a_graph_of_networkx_has_the_same_shortest_way(layers):
    import networkx
    for strategy in ("gt", "gts2"):
        plan = layers.coarse_plan(strategy)
        graph = plan.graph.to_networkx()
        assert networkx.shortest_path(graph, 0, 1, weight="weight") == plan.nodes
        assert networkx.shortest_path_length(graph, 0, 1, weight="weight") == pytest.approx(plan.cost)
    assert graph.nodes[0]["name"] == "S" and len(graph.edges) == len(plan.graph.edges)


def test_without_networkx_the_error_names_its_package(layers, monkeypatch):
    real = builtins.__import__

    def without(name, *arguments, **named):
        if name == "networkx":
            raise ImportError(name)
        return real(name, *arguments, **named)
    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ImportError, match="python3-networkx"):
        layers.coarse_plan("gt").graph.to_networkx()


def test_a_sampler_in_python_draws_for_every_planner(problem):
    def sampler(task, seed):
        random = np.random.default_rng(seed)
        return lambda: random.uniform(*task.bounds)
    for strategy in ("birrt", "auto", "ompl-rrtconnect"):
        runs = [glissade.plan(problem, strategy=strategy, seed=1, sampler=sampler) for _ in range(2)]
        assert glissade.check(problem, runs[0].path).valid
        assert np.array_equal(runs[0].path.configurations, runs[1].path.configurations), strategy
    assert glissade.plan(problem, strategy="birrt", sampler=sampler).path.rotation < 1e-9  # it turns nothing


def test_a_wrong_sampler_is_an_error(problem):
    for wrong, reason in (([7, 0, 0], "outside of the bounds"), ([float("nan"), 0, 0], "not finite")):
        for strategy in ("birrt", "ompl-rrtconnect"):
            with pytest.raises(glissade.Error, match=reason) as caught:
                glissade.plan(problem, strategy=strategy, sampler=lambda task, seed: lambda: wrong)
            assert caught.value.kind == "usage"
    for wrong in (lambda task, seed: None, lambda task, seed: lambda: None, 7):
        with pytest.raises((TypeError, ValueError)):
            glissade.plan(problem, strategy="birrt", sampler=wrong)


def test_an_exception_of_a_sampler_ends_the_run_and_each_later_step(problem):
    def fails(task, seed):
        raise LookupError("nothing")
    with pytest.raises(LookupError):
        glissade.plan(problem, strategy="auto", sampler=fails)
    session = glissade.Session(problem, strategy="birrt", sampler=fails)
    with pytest.raises(LookupError):
        session.step(10)
    session.step(10)
    assert session.path is None
