"""Each example runs and prints what it is for."""
import os
import pathlib
import subprocess
import sys

import pytest

import glissade

SAYS = {"clearance_plot.py": "certified", "numpy_world.py": "valid", "take_apart.py": "valid",
        "check_certificate.py": "certificate: certified", "own_planner.py": "rrt-in-python <glissade.Path",
        "own_operator.py": "<glissade.Path", "alpha_rule.py": "α = 0.2: 1 of 1 solved",
        "table_2.py": "expert   α = 0.08  1 of 1 solved", "coarse_plan.py": "changed: True",
        "own_sampler.py": "judge: valid", "export_plan.py": "motions of", "pictures.py": "<glissade.View of"}
WRITES = {"clearance_plot.py": ["clearance.png"], "check_certificate.py": ["path.csv"], "table_2.py": ["table.png"],
          "export_plan.py": ["plan.csv", "plan.json"], "pictures.py": ["product.png", "product.html"]}
DRAWS = os.access(glissade.program_file("glissade-offscreen"), os.X_OK)
SEEDS = {"alpha_rule.py": "1", "table_2.py": "1"}


@pytest.mark.parametrize("name", SAYS)
def test_an_example_runs(name, samples, tmp_path):
    if name == "pictures.py" and not DRAWS:
        pytest.skip("glissade-offscreen is not built")
    out = [str(tmp_path / file) for file in WRITES.get(name, [])]
    seeds = [SEEDS[name]] if name in SEEDS else []
    done = subprocess.run([sys.executable, str(samples / "python" / name), *out, *seeds], capture_output=True,
                          text=True, timeout=110)
    assert done.returncode == 0, done.stderr
    assert SAYS[name] in done.stdout
    assert all(pathlib.Path(file).stat().st_size > 400 for file in out)


def test_every_example_is_tested(samples):
    assert {file.name for file in (samples / "python").glob("*.py")} == set(SAYS)
