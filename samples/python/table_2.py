"""Table II of Blin et al. 2016: nodes against α with contact, environment 1.  usage: table_2.py OUT.png [SEEDS]"""
import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import glissade

PAPER = {0.8: 1729, 0.5: 1314, 0.2: 715, 0.1: 679, 0.08: 538, 0.05: 547, 0.04: 602, 0.02: 658, 0.01: 768, 0.0: 894}
# Operators know the way; the table's person is between the two.
OPERATORS = ("expert", "novice")

samples = pathlib.Path(__file__).resolve().parent.parent
scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))
seeds = range(1, 1 + int(sys.argv[2]) if len(sys.argv) > 2 else 31)
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.plot(range(len(PAPER)), list(PAPER.values()), "ks", label="paper")
for operator in OPERATORS:
    medians = []
    for alpha in PAPER:
        parameters = {"alpha": alpha, "contact_samples": 10, "contact_distance": 0.15, "max_steps": 60000}
        nodes = []
        for seed in seeds:
            try:
                run = glissade.plan(scenario, strategy="contact-birrt", operator=operator, seed=seed,
                                    parameters=parameters)
                nodes.append(run.counts.nodes)
            except glissade.Error as error:
                if error.kind not in ("no_path", "limit_reached"):
                    raise
        medians.append(np.median(nodes) if nodes else np.nan)
        print(f"{operator:8} α = {alpha:<5} {len(nodes)} of {len(seeds)} solved, {medians[-1]:.0f} nodes, "
              f"paper {PAPER[alpha]}")
    axes.plot(range(len(PAPER)), medians, "o-", label=f"{operator}, median of {len(seeds)} seeds")
axes.set(xticks=range(len(PAPER)), xticklabels=PAPER, xlabel="α", ylabel="nodes", title="Table II, environment 1")
axes.set_ylim(bottom=0)
axes.legend()
figure.savefig(sys.argv[1])
