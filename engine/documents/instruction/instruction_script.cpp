#include "engine/documents/instruction/instruction_script.h"

namespace glissade {

const char* const kInstructionStyle = R"(
* { box-sizing: border-box; }
html, body { margin: 0; height: 100%; }
body { display: flex; flex-direction: column; background: #ffffff; color: #1d2329; overflow: hidden;
  font: 20px/1.35 "DejaVu Sans", "Segoe UI", system-ui, sans-serif; }
header { display: flex; align-items: center; gap: 1rem; padding: 0.4rem 1rem; border-bottom: 1px solid #c9d0d8; }
header strong { flex: 1; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
header img { max-height: 2.4rem; max-width: 10rem; }
main { flex: 1; min-height: 0; position: relative; }
section { display: none; position: absolute; inset: 0; flex-direction: column; padding: 0.6rem 1rem; overflow: auto; }
section.shown { display: flex; }
.top { display: flex; align-items: flex-start; gap: 1.2rem; flex-wrap: wrap; }
.number { font-size: 2.8rem; font-weight: 700; line-height: 1; }
.words { flex: 1; min-width: 14rem; }
.words p { margin: 0 0 0.2rem; }
.work { font-size: 1.3rem; font-weight: 700; }
.turn { background: #f0e442; font-weight: 700; padding: 0.1rem 0.5rem; display: inline-block; }
.soft { color: #5b646e; }
.fetch { display: flex; gap: 1rem; flex-wrap: wrap; }
.fetch div { text-align: center; max-width: 11rem; overflow-wrap: anywhere; }
.fetch img { height: 4.5rem; display: block; margin: 0 auto; }
.picture { flex: 1; min-height: 50vh; position: relative; }
.picture img, .picture canvas { position: absolute; inset: 0; width: 100%; height: 100%; object-fit: contain; }
.picture canvas { background: #ffffff; touch-action: none; }
table { border-collapse: collapse; }
th, td { text-align: left; padding: 0.3rem 1rem 0.3rem 0; border-bottom: 1px solid #c9d0d8; }
td img { height: 4rem; }
td.count { font-weight: 700; }
nav { display: flex; gap: 0.6rem; padding: 0.6rem; border-top: 1px solid #c9d0d8; }
nav button { flex: 1; min-height: 4.4rem; font: inherit; font-size: 1.4rem; border: 0; border-radius: 0.5rem;
  background: #0072b2; color: #ffffff; }
nav button:disabled { background: #c9d0d8; }
nav button.scene { flex: 0 0 7rem; background: #ffffff; color: #0072b2; border: 2px solid #0072b2; }
nav button.pressed { background: #0072b2; color: #ffffff; }
button:focus-visible { outline: 4px solid #e69f00; }
@media print { html, body { height: auto; overflow: visible; display: block; } nav { display: none; }
  section { display: flex; position: static; height: 95vh; break-after: page; } }
)";

const char* const kInstructionScript = R"(
(function () {
  var sections = Array.prototype.slice.call(document.querySelectorAll('section'));
  var previous = document.getElementById('previous'), next = document.getElementById('next');
  var place = document.getElementById('place'), current = 0, listeners = [];
  function show(index, keepHash) {
    current = Math.max(0, Math.min(sections.length - 1, index));
    sections.forEach(function (section, i) { section.classList.toggle('shown', i === current); });
    previous.disabled = current === 0;
    next.disabled = current === sections.length - 1;
    place.textContent = (current + 1) + ' / ' + sections.length;
    if (!keepHash) { try { history.replaceState(null, '', '#' + (current + 1)); } catch (error) { /* a file's page */ } }
    listeners.forEach(function (listener) { listener(sections[current]); });
  }
  function step(by) { show(current + by); }
  previous.addEventListener('click', function () { step(-1); });
  next.addEventListener('click', function () { step(1); });
  document.addEventListener('keydown', function (event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    var onButton = event.target instanceof HTMLButtonElement;
    if (event.key === 'ArrowRight' || event.key === 'PageDown' || (event.key === ' ' && !onButton)) step(1);
    else if (event.key === 'ArrowLeft' || event.key === 'PageUp') step(-1);
    else if (event.key === 'Home') show(0);
    else if (event.key === 'End') show(sections.length - 1);
    else return;
    event.preventDefault();
  });
  var from = null;
  document.addEventListener('touchstart', function (event) {
    var ofScene = event.target instanceof HTMLCanvasElement;
    from = event.touches.length === 1 && !ofScene ? event.touches[0] : null;
  }, { passive: true });
  document.addEventListener('touchend', function (event) {
    if (!from) return;
    var dx = event.changedTouches[0].clientX - from.clientX, dy = event.changedTouches[0].clientY - from.clientY;
    if (Math.abs(dx) > 60 && Math.abs(dx) > 2 * Math.abs(dy)) step(dx < 0 ? 1 : -1);
    from = null;
  }, { passive: true });
  window.instruction = { show: show, step: step, shown: function () { return current; },
    onShown: function (listener) { listeners.push(listener); } };
  show((parseInt(location.hash.slice(1), 10) || 1) - 1, true);
})();
)";

const char* const kInstructionSceneScript = R"(
(function () {
  var button = document.getElementById('scene'), data = window.instructionScene, seconds = 2, hold = 1;
  var on = false, ready = false, renderer, scene, camera, controls, mixer, action, bodies = [], panel = null, began = 0;
  var homes = {}, all = Math.max.apply(null, data.steps);
  function bytes(text) {
    var raw = atob(text), all = new Uint8Array(raw.length);
    for (var i = 0; i < raw.length; ++i) all[i] = raw.charCodeAt(i);
    return all.buffer;
  }
  function prepare(done) {
    try { renderer = new THREE.WebGLRenderer({ antialias: true }); }
    catch (error) { button.disabled = true; on = false; return; }
    scene = new THREE.Scene();
    scene.background = new THREE.Color(0xffffff);
    camera = new THREE.PerspectiveCamera(30, 1, 0.001, 1000);
    scene.add(new THREE.HemisphereLight(0xffffff, 0xbbbbbb, 0.72));
    var light = new THREE.DirectionalLight(0xffffff, 0.3);
    light.position.set(-1, 1, 2);
    camera.add(light); scene.add(camera);
    controls = new THREE.OrbitControls(camera, renderer.domElement);
    new THREE.GLTFLoader().parse(bytes(document.getElementById('glb').textContent), '', function (gltf) {
      scene.add(gltf.scene);
      var nodes = gltf.parser.json.nodes, root = gltf.parser.json.scenes[0].nodes[0];
      Promise.all(nodes[root].children.map(function (i) { return gltf.parser.getDependency('node', i); }))
        .then(function (found) {
          bodies = found.map(function (node) {
            var meshes = [];
            node.traverse(function (object) { if (object.isMesh) meshes.push(object); });
            meshes.forEach(function (mesh) {
              mesh.material = new THREE.MeshLambertMaterial({ color: 0xeeeeee, polygonOffset: true,
                polygonOffsetFactor: 1, polygonOffsetUnits: 1, side: THREE.DoubleSide });
              mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 25),
                new THREE.LineBasicMaterial({ color: 0x808890 })));
            });
            return { node: node, meshes: meshes };
          });
          mixer = new THREE.AnimationMixer(gltf.scene);
          action = mixer.clipAction(gltf.animations[0]);
          action.play();
          ready = true; done();
        });
    });
  }
  function paint(section) {
    panel = section && (section.dataset.from || section.dataset.line) ? section : null;
    button.disabled = !panel;
    button.classList.toggle('pressed', on);
    if (renderer && renderer.domElement.parentNode) renderer.domElement.parentNode.removeChild(renderer.domElement);
    if (!on || !panel || !ready) return;
    bringHome();
    var from = +panel.dataset.from, to = +panel.dataset.to, line = data.lines[panel.dataset.line];
    bodies.forEach(function (body, i) {
      var step = data.steps[i], comes = line ? isMoved(line, i) : step >= from && step <= to;
      body.node.visible = line ? comes || line.present.indexOf(i) >= 0 : step <= to;
      body.meshes.forEach(function (mesh) {
        mesh.material.color.setHex(comes ? 0xf5a623 : 0xeeeeee);
        mesh.children[0].material.color.setHex(comes ? 0x202020 : 0x9098a0);
      });
    });
    action.time = seconds * (line ? all : to) - 1e-3; mixer.update(0);
    scene.updateMatrixWorld(true);
    var box = new THREE.Box3();
    bodies.forEach(function (body) { if (body.node.visible) box.expandByObject(body.node); });
    var sphere = box.getBoundingSphere(new THREE.Sphere()), eye = data.views[panel.dataset.view];
    camera.up.set(0, eye[1] < 0 ? -1 : 1, 0);
    controls.dispose();
    controls = new THREE.OrbitControls(camera, renderer.domElement);
    controls.target.copy(sphere.center);
    camera.position.set(eye[0], eye[1], eye[2]).multiplyScalar(4.0 * sphere.radius).add(sphere.center);
    camera.near = 0.05 * sphere.radius; camera.far = 50 * sphere.radius;
    panel.querySelector('.picture').appendChild(renderer.domElement);
    began = performance.now();
    requestAnimationFrame(frame);
  }
  function isMoved(line, i) {
    return line.moves.some(function (move) { return move.bodies.indexOf(i) >= 0; });
  }
  // The mixer does not write again what it has written before.
  function bringHome() {
    Object.keys(homes).forEach(function (i) {
      bodies[i].node.position.copy(homes[i].position);
      bodies[i].node.quaternion.copy(homes[i].quaternion);
    });
    homes = {};
  }
  function moved(pose, home) {
    var turn = new THREE.Quaternion(pose[3], pose[4], pose[5], pose[6]);
    return { position: home.position.clone().applyQuaternion(turn).add(new THREE.Vector3(pose[0], pose[1], pose[2])),
             quaternion: turn.multiply(home.quaternion) };
  }
  function moveLine(line, time) {
    line.moves.forEach(function (move, k) {
      var last = move.poses.length - 1, at = last * Math.min(Math.max(time / seconds - k, 0), 1);
      var i = Math.min(Math.floor(at), last - 1);
      move.bodies.forEach(function (b) {
        var node = bodies[b].node;
        homes[b] = homes[b] || { position: node.position.clone(), quaternion: node.quaternion.clone() };
        var before = moved(move.poses[i], homes[b]), after = moved(move.poses[i + 1], homes[b]);
        node.position.copy(before.position).lerp(after.position, at - i);
        node.quaternion.copy(before.quaternion).slerp(after.quaternion, at - i);
      });
    });
  }
  function frame(now) {
    var canvas = renderer.domElement, place = canvas.parentNode;
    if (!place || !on) return;
    var width = place.clientWidth, height = place.clientHeight, scale = Math.min(window.devicePixelRatio || 1, 2);
    renderer.setPixelRatio(scale);
    renderer.setSize(width, height, false);
    camera.aspect = width / Math.max(1, height);
    camera.updateProjectionMatrix();
    var from = +panel.dataset.from, to = +panel.dataset.to, line = data.lines[panel.dataset.line];
    var length = seconds * (line ? line.moves.length : to - from + 1);
    var time = Math.max(0, Math.min(((now - began) / 1000) % (length + hold), length - 1e-3));
    if (line) { moveLine(line, time); }
    else { action.time = seconds * (from - 1) + time; mixer.update(0); }
    controls.update();
    renderer.render(scene, camera);
    window.instruction.frames = (window.instruction.frames || 0) + 1;
    requestAnimationFrame(frame);
  }
  button.addEventListener('click', function () {
    on = !on;
    var section = document.querySelector('section.shown');
    if (on && !renderer) prepare(function () { paint(document.querySelector('section.shown')); });
    paint(section);
  });
  window.instruction.onShown(paint);
  paint(document.querySelector('section.shown'));
})();
)";

}  // namespace glissade
