"""The Python package and glissade-cli do the same work: their files are equal bit by bit, and so are their counts."""
import json
import os
import subprocess
import tempfile

import pytest

import glissade

PATHS = [("environment-1/scenario.json", "contact-birrt", "expert"),
         ("sliding-plane/scenario.json", "contact-birrt", "novice"), ("teaching/scenario.json", "birrt", "none"),
         ("shape-game/paper-like-circle.json", "gts", "none"), ("shape-game/paper-like-star.json", "auto", "none"),
         ("pump/unmount.json", "auto", "none"), ("pump/mount.json", "auto", "none"),
         ("interlocked/turn.json", "auto", "none"), ("puzzles/bent-bars.json", "auto", "none"),
         ("bolted-brackets/scenario.json", "auto", "none")]
PRODUCTS = ["bolted-brackets/scenario.json", "roller-stand/scenario.json", "nut-and-bolt/scenario.json"]


def by_command(*arguments):
    program = glissade.program_file("glissade-cli")
    with tempfile.TemporaryDirectory() as cache:  # of fits, which the package does not keep
        done = subprocess.run([program, *map(str, arguments), "--json"], capture_output=True, text=True,
                              env=os.environ | {"XDG_CACHE_HOME": cache})
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.parametrize("name, strategy, operator", PATHS)
def test_a_path_is_that_of_the_command_line(name, strategy, operator, samples, tmp_path):
    file = samples / name
    said = by_command("plan", file, "--strategy", strategy, "--operator", operator, "--seed", 3, "--out",
                      tmp_path / "command.json")
    scenario = glissade.load_scenario(str(file))
    run = glissade.plan(scenario, strategy=strategy, operator=operator, seed=3)
    run.path.save(str(tmp_path / "python.json"), scenario)
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "command.json").read_bytes()
    counts = {key: getattr(run.counts, key) for key in ("steps", "nodes", "random_configurations", "collision_queries",
                                                        "distance_queries")}
    assert counts == {key: said[key] for key in counts}


@pytest.mark.parametrize("name", PRODUCTS)
def test_a_plan_is_that_of_the_command_line(name, samples, tmp_path):
    file = str(samples / name)
    by_command("sequence", file, "--seed", 3, "--out", tmp_path / "command.json")
    plan = glissade.sequence(glissade.load_product(file), seed=3)
    plan.save(str(tmp_path / "python.json"), file)
    assert (tmp_path / "python.json").read_bytes() == (tmp_path / "command.json").read_bytes()
