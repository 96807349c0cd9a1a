"""Saves a path and has it judged again from the files alone.  usage: check_certificate.py OUT.csv"""
import json
import pathlib
import sys

import glissade

samples = pathlib.Path(__file__).resolve().parent.parent
file = str(samples / "environment-1" / "scenario.json")
scenario = glissade.load_scenario(file)
path = glissade.plan(scenario, strategy="birrt", seed=1).path
path.save(sys.argv[1], scenario)

verdict = glissade.check(file, sys.argv[1])
report = json.loads(verdict.json)
print(verdict.text)
print("certificate:", report["certificate"]["status"], "edges:", len(report["certificate"]["edges"]))
