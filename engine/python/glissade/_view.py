"""Pictures: PNG by the offscreen program, and pages with three.js."""
import base64
import html
import json
import os
import pathlib
import subprocess
import tempfile

import numpy as np

from . import _glissade as g

THREE = pathlib.Path("/usr/share/javascript/three")  # Debian's package libjs-three
COLOURS = ["#8fa3b8", "#c9b68f", "#9dbf9e", "#c79a9a", "#a9a4c9", "#b8b8b8"]
MOVING = "#f5a623"


def _failure(kind, reason, advice):
    error = g.Error(f"{reason}. {advice}")
    error.kind, error.file, error.place, error.reason, error.advice = kind, "", "", reason, advice
    return error


def _product(a, b):
    """The quaternion a b; x y z w."""
    vector = a[3] * b[:3] + b[3] * a[:3] + np.cross(a[:3], b[:3])
    return np.append(vector, a[3] * b[3] - a[:3] @ b[:3])


def _turned(q, point):
    return point + 2 * np.cross(q[:3], np.cross(q[:3], point) + q[3] * point)


def _composed(a, b):
    """The pose a b of two arrays of 7 numbers."""
    return np.append(a[:3] + _turned(a[3:], b[:3]), _product(a[3:], b[3:]))


def _inverse(pose):
    back = pose[3:] * [-1, -1, -1, 1]
    return np.append(-_turned(back, pose[:3]), back)


def _shares(poses, radius):
    """The share of the way that lies before each pose."""
    moves = np.linalg.norm(np.diff(poses[:, :3], axis=0), axis=1)
    turns = 2 * np.arccos(np.clip(np.abs(np.sum(poses[1:, 3:] * poses[:-1, 3:], axis=1)), 0, 1))
    way = np.append(0, np.cumsum(np.hypot(moves, radius * turns)))
    return way / way[-1] if way[-1] > 0 else np.linspace(0, 1, len(poses))


class _Shown:
    """A body with its poses at moments in [0, 1]. It is there until `leaves`."""

    def __init__(self, name, mesh, pose, colour):
        self.name, self.mesh, self.colour = name, mesh, colour
        self.moments, self.poses, self.leaves = np.zeros(1), np.asarray(pose).reshape(1, 7), np.inf

    def radius(self):
        return np.linalg.norm(self.mesh.vertices, axis=1).max()

    def move(self, moments, poses):
        self.moments, self.poses = moments, poses

    def pose(self, moment):
        last = min(np.searchsorted(self.moments, moment, side="right"), len(self.moments)) - 1
        if last + 1 == len(self.moments) or last < 0:
            return self.poses[max(last, 0)]
        a, b = self.poses[last], self.poses[last + 1]
        share = (moment - self.moments[last]) / (self.moments[last + 1] - self.moments[last])
        turn = b[3:] if a[3:] @ b[3:] >= 0 else -b[3:]
        angle = np.arccos(np.clip(a[3:] @ turn, -1, 1))
        weights = np.sin([(1 - share) * angle, share * angle]) / np.sin(angle) if angle > 1e-9 else [1 - share, share]
        return np.append((1 - share) * a[:3] + share * b[:3], weights[0] * a[3:] + weights[1] * turn)


class View:
    """A picture of placed bodies at a moment of a path or a plan, in [0, 1]. A notebook shows it with three.js."""

    def __init__(self, bodies, moment, pixels):
        self._bodies, self._moment, self._pixels = bodies, moment, pixels

    def __repr__(self):
        return f"<glissade.View of {len(self._bodies)} bodies>"

    def png(self):
        """The picture as PNG, by the program glissade-offscreen (package glissade)."""
        program = g.program_file("glissade-offscreen")
        if not os.access(program, os.X_OK):
            raise _failure("usage", f"{program} is missing, which draws pictures", "Install the package glissade.")
        with tempfile.TemporaryDirectory() as folder:
            scenario, picture = pathlib.Path(folder, "scenario.json"), pathlib.Path(folder, "picture.png")
            self._save_scenario(scenario)
            done = subprocess.run([program, scenario, "--offscreen", "--thumbnail", picture, "--thumbnail-pixels",
                                   str(self._pixels)], capture_output=True, text=True)
            if done.returncode != 0:
                raise _failure("internal", f"no picture was drawn: {done.stderr.strip()}", "")
            return picture.read_bytes()

    def html(self):
        """A page with three.js (package libjs-three), which needs no network."""
        try:
            library = "\n".join((THREE / file).read_text() for file in
                                ("build/three.min.js", "examples/js/controls/OrbitControls.js"))
        except OSError as missing:
            raise _failure("usage", "three.js is not installed", "Install the package libjs-three.") from missing
        data = json.dumps({"moment": self._moment, "bodies": list(map(_as_data, self._bodies))})
        # A "<" could end the script.
        return PAGE.replace("%LIBRARY%", library).replace("%DATA%", data.replace("<", "\\u003c"))

    def _repr_html_(self):
        try:
            page = self.html()
        except g.Error as error:
            return html.escape(str(error))
        return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="{self._pixels}" style="border:0"></iframe>'

    def _save_scenario(self, file):
        """The visible bodies as a scenario; the one that moves is the object."""
        shown = [body for body in self._bodies if self._moment < body.leaves] or self._bodies[:1]
        shown.sort(key=lambda body: len(body.poses) == 1)
        described, assets = [], []
        for number, body in enumerate(shown):
            _save_stl(body.mesh, file.with_name(f"{number}.stl"))
            pose = body.pose(self._moment)
            assets.append({"id": f"a{number}", "path": f"{number}.stl", "unit": 1.0, "up_axis": "z"})
            colour = [int(body.colour[at:at + 2], 16) / 255 for at in (1, 3, 5)]
            described.append({"id": f"b{number}", "name": f"b{number}", "geometry": {"mesh": f"a{number}"},
                              "pose": _pose_json(pose), "colour": colour})
        start = described[0].pop("pose")
        corners = np.array([box for body in shown for box in _corners(body, self._moment)])
        margin = np.ptp(corners, axis=0).max()
        file.write_text(json.dumps({
            "format": "glissade-scenario", "version": 1, "name": "view", "assets": assets, "bodies": described[1:],
            "object": described[0], "start": start, "goal": "out",
            "workspace": {"min": (corners.min(axis=0) - margin).tolist(),
                          "max": (corners.max(axis=0) + margin).tolist()}}))


def _pose_json(pose):
    return {"position": pose[:3].tolist(), "orientation": pose[3:].tolist()}


def _corners(body, moment):
    pose = body.pose(moment)
    placed = pose[:3] + _turned(pose[3:], body.mesh.vertices)
    return placed.min(axis=0), placed.max(axis=0)


def _save_stl(mesh, file):
    facet = np.zeros(len(mesh.triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("", "<u2")])
    facet["corners"] = mesh.vertices[mesh.triangles]
    file.write_bytes(bytes(80) + np.uint32(len(facet)).tobytes() + facet.tobytes())


def _as_data(body):
    def text(array, kind):
        return base64.b64encode(np.ascontiguousarray(array, kind).tobytes()).decode()
    return {"name": body.name, "colour": body.colour, "vertices": text(body.mesh.vertices, "<f4"),
            "triangles": text(body.mesh.triangles, "<u4"), "moments": body.moments.tolist(),
            "poses": body.poses.tolist(), "leaves": None if np.isinf(body.leaves) else body.leaves}


def _bodies_of(bodies):
    return [_Shown(body.name, body.mesh, body.pose, COLOURS[number % len(COLOURS)])
            for number, body in enumerate(bodies)]


def _along_path(problem, path):
    moving = _Shown("object", problem.world.object, problem.start, MOVING)
    if path is not None:
        moving.move(_shares(path.configurations, moving.radius()), path.configurations)
    return _bodies_of(problem.world.obstacles) + [moving]


def _along_plan(product, plan):
    shown = dict(zip([body.id for body in product.bodies], _bodies_of(product.bodies)))
    motions = [] if plan is None else [motion for step in plan.steps for motion in step.motions]
    for number, motion in enumerate(motions):
        for name in motion.bodies:
            if name not in shown:
                raise ValueError(f"the plan names no body of the product: {name}")
            body = shown[name]
            moments = (number + _shares(motion.path, body.radius())) / len(motions)
            from_start = _composed(_inverse(motion.path[0]), body.poses[0])
            body.move(moments, np.array([_composed(pose, from_start) for pose in motion.path]))
            body.leaves = (number + 1) / len(motions)
    return list(shown.values())


def view(subject, path=None, plan=None, *, moment=0.0, pixels=480):
    """A View of a Product, a Scenario or a Problem. `path`: the object moves along it; `plan`: the bodies of the product
    leave. `moment`: share of the path or the plan that the picture shows."""
    if path is not None and plan is not None:
        raise ValueError("path and plan are both given")
    if not 0 <= moment <= 1:
        raise ValueError("moment is not in [0, 1]")
    if not 16 <= pixels <= 2048:
        raise ValueError("pixels are not from 16 to 2048")
    for value, kind, name in ((path, g.Path, "path"), (plan, g.AssemblyPlan, "plan")):
        if value is not None and not isinstance(value, kind):
            raise TypeError(f"{name} is no {kind.__name__}")
    if isinstance(subject, g.Scenario):
        subject = subject.product if plan is not None else subject.problem
    if isinstance(subject, g.Problem) and plan is None:
        return View(_along_path(subject, path), moment, pixels)
    if isinstance(subject, g.Product) and path is None:
        return View(_along_plan(subject, plan), moment, pixels)
    raise TypeError("view() takes a Product with a plan, or a Scenario or a Problem with a path")


PAGE = """<!doctype html><html><head><meta charset="utf-8"><style>
body { margin: 0; overflow: hidden; font: 13px sans-serif }
input { position: absolute; left: 5%; bottom: 8px; width: 90% }
</style></head><body><script>%LIBRARY%</script><script>
(function () {
  var data = %DATA%, moves = false;
  function bytes(text) {
    var raw = atob(text), all = new Uint8Array(raw.length);
    for (var i = 0; i < raw.length; ++i) all[i] = raw.charCodeAt(i);
    return all.buffer;
  }
  var renderer;
  try { renderer = new THREE.WebGLRenderer({ antialias: true }); }
  catch (error) { document.body.textContent = 'This browser has no WebGL.'; return; }
  document.body.appendChild(renderer.domElement);
  var scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 1, 0.001, 1000), box = new THREE.Box3();
  scene.background = new THREE.Color(0xffffff);
  scene.add(new THREE.HemisphereLight(0xffffff, 0xbbbbbb, 0.72));
  var light = new THREE.DirectionalLight(0xffffff, 0.3);
  light.position.set(-1, 1, 2);
  camera.add(light); scene.add(camera);
  var shown = data.bodies.map(function (body) {
    var geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(bytes(body.vertices)), 3));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytes(body.triangles)), 1));
    geometry = geometry.toNonIndexed();
    geometry.computeVertexNormals();
    var mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: body.colour, polygonOffset: true,
      polygonOffsetFactor: 1, polygonOffsetUnits: 1, side: THREE.DoubleSide }));
    mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), new THREE.LineBasicMaterial({ color: 0x606870 })));
    moves = moves || body.poses.length > 1;
    scene.add(mesh);
    return mesh;
  });
  function place(mesh, body, moment) {
    var last = 0;
    while (last + 1 < body.moments.length && body.moments[last + 1] <= moment) ++last;
    var a = body.poses[last], b = body.poses[Math.min(last + 1, body.poses.length - 1)], length = 0;
    if (last + 1 < body.moments.length) length = body.moments[last + 1] - body.moments[last];
    var share = length > 0 ? Math.max(0, moment - body.moments[last]) / length : 0;
    mesh.position.set(a[0], a[1], a[2]).lerp(new THREE.Vector3(b[0], b[1], b[2]), share);
    mesh.quaternion.set(a[3], a[4], a[5], a[6]).slerp(new THREE.Quaternion(b[3], b[4], b[5], b[6]), share);
    mesh.visible = body.leaves === null || moment < body.leaves;
  }
  function show(moment) {
    data.bodies.forEach(function (body, i) { place(shown[i], body, moment); });
    draw();
  }
  function draw() {
    var width = window.innerWidth, height = window.innerHeight;
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  }
  data.bodies.forEach(function (body, i) { place(shown[i], body, 0); });
  scene.updateMatrixWorld(true);
  shown.forEach(function (mesh) { box.expandByObject(mesh); });
  var sphere = box.getBoundingSphere(new THREE.Sphere());
  camera.up.set(0, 0, 1);
  camera.position.set(0.6, -1, 0.7).normalize().multiplyScalar(4 * sphere.radius).add(sphere.center);
  camera.near = 0.05 * sphere.radius; camera.far = 50 * sphere.radius;
  var controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.target.copy(sphere.center);
  controls.update();
  controls.addEventListener('change', draw);
  window.addEventListener('resize', draw);
  if (moves) {
    var slider = document.createElement('input');
    slider.type = 'range'; slider.max = 1; slider.step = 'any'; slider.value = data.moment;
    slider.setAttribute('aria-label', 'moment');
    slider.addEventListener('input', function () { show(+slider.value); });
    document.body.appendChild(slider);
  }
  show(data.moment);
})();
</script></body></html>
"""
