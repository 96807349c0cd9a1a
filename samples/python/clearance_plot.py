"""Plans environment 1 and plots the clearance along the path.  usage: clearance_plot.py OUT.png"""
import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import glissade

samples = pathlib.Path(__file__).resolve().parent.parent
scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))
run = glissade.plan(scenario, operator="expert", seed=1)
curve = glissade.clearance(scenario.problem.world, run.path, samples=400)
print(run.path, run.counts)

figure, axes = plt.subplots(figsize=(7, 3), layout="constrained")
axes.plot(100 * curve["share"], 1e3 * curve["distance"])
axes.axhline(1e3 * run.path.certificate.proved_clearance, color="tab:red", linestyle="--", label="proved")
axes.set(xlabel="share of the path, %", ylabel="clearance, mm", title=scenario.name)
axes.set_yscale("log")
axes.legend()
figure.savefig(sys.argv[1])
