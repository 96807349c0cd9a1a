"""A rule for α: the computer's share grows while the tree slides on nothing.  usage: alpha_rule.py [SEEDS]"""
import pathlib
import sys

import numpy as np

import glissade

OPERATOR, CONTACT = 1, 2  # authors of nodes
STEPS = 40  # one second of the operator's time

samples = pathlib.Path(__file__).resolve().parent.parent
scenario = glissade.load_scenario(str(samples / "environment-1" / "scenario.json"))


def solved_by(seed, rule):
    """Runs Algorithm 1 with α from the rule, which gets the share of new nodes by the hand or its contact."""
    session = glissade.Session(scenario, strategy="contact-birrt", operator="novice", seed=seed)
    seen = 0
    while session.step(STEPS) == "running":
        authors = session.roadmap.authors[seen:]
        seen += len(authors)
        share = np.isin(authors, (OPERATOR, CONTACT)).mean() if len(authors) else 0.0
        session.set(alpha=rule(session.parameters["alpha"], share))
    return session


rules = {"α = 0.2": lambda alpha, share: 0.2,
         "α by the hand's share": lambda alpha, share: float(np.clip(alpha + (0.05 if share < 0.3 else -0.05), 0.02, 0.8))}
seeds = range(1, 1 + int(sys.argv[1]) if len(sys.argv) > 1 else 11)
for name, rule in rules.items():
    sessions = [solved_by(seed, rule) for seed in seeds]
    solved = [session.counts.nodes for session in sessions if session.path]
    print(f"{name}: {len(solved)} of {len(sessions)} solved, {np.median(solved):.0f} nodes in the median")
