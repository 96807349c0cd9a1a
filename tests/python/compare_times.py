"""Times of the package against those of glissade-cli: the runs of test_agreement.py, each as often in turn.

usage: PYTHONPATH=BUILD/python compare_times.py [TIMES]
Prints for each run the least seconds of both, and their ratio: of planning for paths, with the reading for products.
"""
import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import glissade  # noqa: E402
from test_agreement import PATHS, PRODUCTS, by_command  # noqa: E402

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def seconds_of(call):
    begin = time.perf_counter()
    call()
    return time.perf_counter() - begin


def compare(name, by_cli, by_python, times):
    cli, python = map(min, zip(*[(by_cli(), by_python()) for _ in range(times)]))
    print(f"{name:50} {cli:9.3f} s {python:9.3f} s {python / cli:6.3f}")
    return cli, python


times = int(sys.argv[1]) if len(sys.argv) > 1 else 5
least = []
for name, strategy, operator in PATHS:
    file = str(SAMPLES / name)
    scenario = glissade.load_scenario(file)
    least.append(compare(
        f"{name} {strategy} {operator}",
        lambda: by_command("plan", file, "--strategy", strategy, "--operator", operator, "--seed", 3)["planning_s"],
        lambda: glissade.plan(scenario, strategy=strategy, operator=operator, seed=3).seconds, times))
for name in PRODUCTS:
    file = str(SAMPLES / name)
    with tempfile.TemporaryDirectory() as folder:
        least.append(compare(
            name, lambda: by_command("sequence", file, "--seed", 3, "--out", folder + "/plan.json")["wall_s"],
            lambda: seconds_of(lambda: glissade.sequence(glissade.load_product(file), seed=3)), times))
cli, python = (sum(column) for column in zip(*least))
print(f"{'together':50} {cli:9.3f} s {python:9.3f} s {python / cli:6.3f}")
