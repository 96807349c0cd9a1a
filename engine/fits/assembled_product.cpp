#include "engine/fits/assembled_product.h"

#include <algorithm>
#include <tuple>

namespace glissade {

std::optional<std::size_t> AssembledProduct::find(const BodyId& id) const {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const RigidBody& body) { return body.id == id; });
  if (found == bodies.end()) return std::nullopt;
  return static_cast<std::size_t>(found - bodies.begin());
}

std::map<BodyId, std::size_t> AssembledProduct::indicesById() const {
  std::map<BodyId, std::size_t> indices;
  for (std::size_t body = 0; body < bodies.size(); ++body) indices.emplace(bodies[body].id, body);
  return indices;
}

std::size_t AssembledProduct::indexOf(const BodyId& id) const { return find(id).value(); }

std::vector<std::size_t> AssembledProduct::indicesOf(const std::vector<BodyId>& ids) const {
  std::vector<std::size_t> indices;
  for (const BodyId& id : ids) indices.push_back(indexOf(id));
  return indices;
}

const std::string& AssembledProduct::nameInFile(std::size_t body) const {
  const auto node = tree.find(bodies[body].id.text());
  return node ? tree.nodes()[*node].names.product : bodies[body].name;
}

namespace {

bool areSameFits(const FitSettings& a, const FitSettings& b) {
  const auto tied = [](const FitEdit& edit) {
    return std::tie(edit.a, edit.b, edit.kind, edit.allowance, edit.accepted, edit.pitch, edit.turned);
  };
  return a.on == b.on && a.acceptedClash == b.acceptedClash && a.cut == b.cut &&
         std::equal(a.pairs.begin(), a.pairs.end(), b.pairs.begin(), b.pairs.end(),
                    [&](const FitEdit& one, const FitEdit& other) { return tied(one) == tied(other); });
}

}  // namespace

evidence::Body AssembledProduct::measured(std::size_t body) const {
  const RigidBody& own = bodies[body];
  return {own.id, own.shown(), own.mesh, own.X_WB, spacingOf(body), deflections[body]};
}

bool isSameProduct(const AssembledProduct& a, const AssembledProduct& b) {
  const auto sameMesh = [](const TriangleMesh& one, const TriangleMesh& other) {
    return &one == &other || (one.vertices == other.vertices && one.triangles == other.triangles);
  };
  const auto sameBody = [&](const RigidBody& one, const RigidBody& other) {
    return one.id == other.id && one.name == other.name && one.X_WB == other.X_WB && sameMesh(*one.mesh, *other.mesh);
  };
  return a.deflections == b.deflections && a.spacings == b.spacings && a.snaps == b.snaps &&
         areSameFits(a.fits, b.fits) &&
         std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(), sameBody);
}

std::vector<ContactBody> contactBodiesOf(const AssembledProduct& product) {
  std::vector<ContactBody> bodies;
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    const RigidBody& body = product.bodies[i];
    bodies.push_back({body.id, body.mesh, body.X_WB, product.deflections[i]});
  }
  return bodies;
}

std::vector<RigidBody> aboutTheirMiddles(std::vector<RigidBody> bodies) {
  struct Middle {
    Vector3 point;
    MeshPtr mesh;
  };
  std::map<MeshPtr, Middle> known;
  for (RigidBody& body : bodies) {
    Middle& middle = known[body.mesh];
    if (!middle.mesh) {
      middle.point = boundingBox(*body.mesh).center();
      middle.mesh = std::make_shared<const TriangleMesh>(transformed(*body.mesh, Pose::translation(-middle.point)));
    }
    body.X_WB.position = body.X_WB * middle.point;
    body.mesh = middle.mesh;
  }
  return bodies;
}

}  // namespace glissade
