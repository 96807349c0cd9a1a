import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import glissade


def test_a_scenario_is_planned_checked_and_measured(samples, tmp_path):
    file = str(samples / "environment-1" / "scenario.json")
    scenario = glissade.load_scenario(file)
    run = glissade.plan(scenario, operator="expert", seed=1)
    assert run.path.certificate.certified and run.path.configurations.shape[1] == 7
    assert glissade.check(scenario, run.path).valid
    run.path.save(str(tmp_path / "path.json"), scenario)
    assert glissade.check(file, str(tmp_path / "path.json")).valid
    assert len(glissade.load_path(str(tmp_path / "path.json"))) == len(run.path)
    again = glissade.plan(scenario, operator="expert", seed=1)
    assert np.array_equal(again.path.configurations, run.path.configurations)
    curve = glissade.clearance(scenario.problem.world, run.path, samples=50)
    assert curve["distance"].min() >= run.path.certificate.proved_clearance


def test_a_product_is_taken_apart(samples, tmp_path):
    file = str(samples / "bolted-brackets" / "scenario.json")
    product = glissade.load_product(file)
    seen = []
    plan = glissade.sequence(product, progress=lambda so_far: seen.append(len(so_far.steps)))
    assert plan.end == "complete" and plan.removed == plan.parts and seen[-1] == len(plan.steps)
    assert glissade.check(product, plan).valid
    plan.save(str(tmp_path / "plan.json"), file)
    assert glissade.check(file, str(tmp_path / "plan.json")).valid
    assert glissade.load_plan(str(tmp_path / "plan.json")).removed == plan.removed
    assert glissade.fits(product) and glissade.joints(product)


def test_a_swept_volume_contains_the_body(cube):
    swept = glissade.sweep(cube, [[0, 0, 0], [1, 0, 0]], bound=0.05)
    assert swept.surface.closed and swept.surface.vertices[:, 0].max() >= 1.05


def test_a_planner_in_python_is_certified(problem):
    around = [[-1, 0, 0], [0, 0, 1], [1, 0, 0]]
    run = glissade.plan(problem, strategy="mine", planners={"mine": lambda context: around})
    assert run.path.certificate.certified
    for wrong in ([], None, [[-1, 0, 0], [1, 0, 0]], [[-1, 0, 1], [1, 0, 0]]):
        with pytest.raises(glissade.Error) as caught:
            glissade.plan(problem, strategy="mine", planners={"mine": lambda context: wrong})
        assert caught.value.kind == "no_path"


def test_an_exception_of_a_callback_arrives(problem, samples):
    def fails(*arguments):
        raise LookupError("nothing")
    with pytest.raises(LookupError):
        glissade.plan(problem, strategy="mine", planners={"mine": fails})
    with pytest.raises(LookupError):
        glissade.plan(problem, strategy="birrt", progress=fails)
    with pytest.raises(LookupError):
        glissade.sequence(glissade.load_product(str(samples / "bolted-brackets" / "scenario.json")), progress=fails)
    with pytest.raises(ValueError):
        glissade.plan(problem, strategy="mine", planners={"mine": lambda context: "no path"})


def over_the_wall(view):
    """Up, over the wall of the problem, and down, at half a metre a second."""
    hand = np.array(view.hand)
    x, _, z = hand[:3]
    to = [x, 0, 0.5] if x < 0.9 and z < 0.49 else [1, 0, 0.5] if x < 0.99 else [1, 0, 0]
    way = np.array(to) - hand[:3]
    hand[:3] += min(1, 0.5 * view.seconds / max(1e-9, np.linalg.norm(way))) * way
    return hand


def test_an_operator_in_python_leads_the_object(problem):
    run = glissade.plan(problem, strategy="contact-birrt", operator=over_the_wall, parameters={"alpha": 0})
    assert run.path.certificate.certified
    with pytest.raises(KeyError):
        glissade.plan(problem, strategy="contact-birrt", operator=lambda view: {}["no"])


def test_a_session_goes_on_step_by_step(samples):
    scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))
    whole = glissade.plan(scenario, strategy="contact-birrt", operator="expert", seed=3)
    session = glissade.Session(scenario, strategy="contact-birrt", operator="expert", seed=3)
    while session.step(5) == "running":
        assert session.path is None
    assert session.state == "solved" and session.failure is None
    assert np.array_equal(session.path.configurations, whole.path.configurations)
    roadmap = session.roadmap
    nodes = len(roadmap.nodes)
    assert session.counts.nodes == nodes == len(roadmap.authors) == len(roadmap.trees)
    assert roadmap.nodes.shape == (nodes, 7) and roadmap.edges.max() < nodes and roadmap.edges.shape[1] == 2


def test_parameters_of_a_session_change_between_its_steps(samples):
    scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))
    session = glissade.Session(scenario, strategy="contact-birrt", operator="expert", parameters={"alpha": 1})
    session.step(50)
    assert not np.any(session.roadmap.authors == 1)
    session.set(alpha=0)
    assert session.parameters["alpha"] == 0
    session.step(200)
    assert np.any(session.roadmap.authors == 1)
    with pytest.raises(glissade.Error):
        session.set(alpha=2)


def test_an_exception_of_an_operator_leaves_its_step(problem):
    session = glissade.Session(problem, strategy="contact-birrt", operator=lambda view: {}["no"])
    with pytest.raises(KeyError):
        session.step(10)


def test_a_context_works_during_its_run_only(problem):
    kept = []
    with pytest.raises(glissade.Error):
        glissade.plan(problem, strategy="mine", planners={"mine": lambda context: kept.append(context)})
    with pytest.raises(RuntimeError):
        kept[0].step()


def test_other_threads_go_on_while_a_planner_works(problem):
    count = 0
    ended = threading.Event()

    def counts():
        nonlocal count
        while not ended.is_set():
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=counts)
    thread.start()
    glissade.sweep(glissade.Mesh.box([1, 1, 1]), [[0, 0, 0], [5, 0, 0], [5, 5, 0]], bound=0.1)
    ended.set()
    thread.join()
    assert count > 1


def test_ctrl_c_ends_a_run():
    program = """
import glissade
wall = glissade.Body("wall", glissade.Mesh.box([0.1, 9, 9]))
problem = glissade.Problem(glissade.World([wall], glissade.Mesh.box([0.1, 0.1, 0.1])), [-1, 0, 0], [1, 0, 0],
                           bounds=([-2, -2, -2], [2, 2, 2]))
print("begins", flush=True)
try:
    glissade.plan(problem, strategy="birrt", parameters={"max_steps": 1e9, "max_samples": 1e9, "time_limit": 1e5})
except KeyboardInterrupt:
    print("interrupted")
"""
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True, env=os.environ)
    assert child.stdout.readline() == "begins\n"
    time.sleep(0.3)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=60)[0] == "interrupted\n"
