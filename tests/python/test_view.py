"""Pictures and tables for notebooks."""
import os
import re
import struct

import numpy as np
import pytest

import glissade

offscreen = pytest.mark.skipif(not os.access(glissade.program_file("glissade-offscreen"), os.X_OK),
                               reason="glissade-offscreen is not built")
HOSTILE = "</script><script>alert(1)</script>&\""


@pytest.fixture(scope="module")
def product():
    cube = glissade.Mesh.box([1, 1, 1])
    return glissade.Product([glissade.Body("a", cube, name=HOSTILE), glissade.Body("b", cube, [0, 0, 1])])


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", png[16:24])


@offscreen
def test_a_picture_is_drawn_by_the_offscreen_program(product, problem):
    assert size_of(glissade.view(product, pixels=96).png()) == (96, 96)
    path = glissade.Path([[-1, 0, 0], [0, 0, 1], [1, 0, 0]])
    pictures = {glissade.view(problem, path, moment=moment, pixels=96).png() for moment in (0, 0.5)}
    assert len(pictures) == 2  # the object has moved


def test_without_the_offscreen_program_the_error_names_its_package(product, monkeypatch, tmp_path):
    monkeypatch.setenv("GLISSADE_PROGRAMS", str(tmp_path))
    with pytest.raises(glissade.Error, match="Install the package glissade") as caught:
        glissade.view(product).png()
    assert caught.value.kind == "usage"


def test_a_page_shows_every_body_and_escapes_its_names(product):
    plan = glissade.sequence(product)
    page = glissade.view(product, plan=plan, moment=0.25).html()
    assert page.count("<script>") == 2 and page.count("</script>") == 2 and "http://" not in page.split("var data")[1]
    assert page.count('"vertices"') == 2 and '"leaves": 1.0' in page
    framed = glissade.view(product, plan=plan)._repr_html_()
    assert framed.count("<") == 2 and "iframe" in framed  # all of the page is an escaped attribute


def test_without_three_js_the_text_names_its_package(product, monkeypatch, tmp_path):
    monkeypatch.setattr("glissade._view.THREE", tmp_path)
    with pytest.raises(glissade.Error, match="libjs-three"):
        glissade.view(product).html()
    assert "libjs-three" in glissade.view(product)._repr_html_()


def test_bodies_of_a_plan_are_where_their_motions_bring_them(samples):
    product = glissade.load_product(str(samples / "bolted-brackets" / "scenario.json"))
    plan = glissade.sequence(product)
    view = glissade.view(product, plan=plan)
    first = plan.steps[0].motions[0]
    moved = next(body for body in view._bodies if body.leaves == min(other.leaves for other in view._bodies))
    home = next(body.pose for body in product.bodies if body.id == first.bodies[0])
    assert np.allclose(moved.poses[0], np.asarray(home)) and moved.moments[0] == 0
    # Assembled, the pose of a motion of one body is that of the body.
    assert np.allclose(moved.poses, first.path)
    assert sum(np.isinf(body.leaves) for body in view._bodies) == len(plan.staying)


def test_values_are_tables_that_escape_their_texts(product, samples):
    scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))
    run = glissade.plan(scenario, operator="expert", seed=1)
    layers = glissade.Layers(scenario)
    plan = glissade.sequence(product)
    values = {product: "closed", scenario: "wall_L1", run: "random configurations", run.path: "certified",
              plan: "certified", glissade.check(scenario, run.path): "valid", layers: "complexity",
              layers.coarse_plan("gts"): "cost"}
    for value, says in values.items():
        shown = value._repr_html_()
        assert says in shown and HOSTILE not in shown
        assert len(re.findall("<t[rdh]>", shown)) == len(re.findall("</t[rdh]>", shown))
    fits = glissade.fits(product)
    assert isinstance(fits, list) and "planar" in fits._repr_html_()
    joints = glissade.joints(glissade.load_product(str(samples / "bolted-brackets" / "scenario.json")))
    assert "screw" in joints._repr_html_() or "nut" in joints._repr_html_()
