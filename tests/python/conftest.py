import pathlib

import numpy as np
import pytest

import glissade

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


@pytest.fixture
def samples():
    return SAMPLES


@pytest.fixture
def cube():
    return glissade.Mesh.box([0.1, 0.1, 0.1])


@pytest.fixture
def world(cube):
    return glissade.World([glissade.Body("wall", glissade.Mesh.box([0.4, 0.4, 0.4]))], cube)


@pytest.fixture
def problem(world):
    return glissade.Problem(world, [-1, 0, 0], [1, 0, 0], bounds=(np.full(3, -2.0), np.full(3, 2.0)))
