"""Motion planning for assembly, with certificates.

Lengths are metres, angles radians. A pose is a Pose, 7 numbers (x y z, quaternion x y z w), 3 numbers (x y z), or a
4 x 4 matrix. Errors are glissade.Error. Ctrl+C ends every function.
"""
from ._glissade import *  # noqa: F401,F403
from ._glissade import __version__  # noqa: F401
