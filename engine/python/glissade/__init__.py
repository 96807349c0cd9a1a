"""Motion planning for assembly, with certificates.

Lengths are metres, angles radians. A pose is a Pose, 7 numbers (x y z, quaternion x y z w), 3 numbers (x y z), or a
4 x 4 matrix. Errors are glissade.Error. Ctrl+C ends every function.
"""
from ._glissade import *  # noqa: F401,F403
from ._glissade import __version__  # noqa: F401
from ._networkx import to_networkx as _to_networkx
from ._tables import TABLES as _TABLES
from ._view import View, view  # noqa: F401

TopologicalGraph.to_networkx = _to_networkx  # noqa: F405
for _type, _table in _TABLES.items():
    _type._repr_html_ = _table
