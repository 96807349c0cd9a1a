"""Draws a product with half of its parts removed, and a page with three.js.  usage: pictures.py OUT.png OUT.html"""
import pathlib
import sys

import glissade

samples = pathlib.Path(__file__).resolve().parent.parent
product = glissade.load_product(str(samples / "bolted-brackets" / "scenario.json"))
view = glissade.view(product, plan=glissade.sequence(product), moment=0.5)
pathlib.Path(sys.argv[1]).write_bytes(view.png())
pathlib.Path(sys.argv[2]).write_text(view.html(), encoding="utf-8")
print(view)
