#include "engine/fits/liaison_graph.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/geometry/joined_sets.h"

namespace glissade {
namespace {

using BodyPair = std::pair<std::size_t, std::size_t>;

/// The edge between two bodies, which is made where it is missing.
Liaison& between(std::size_t one, std::size_t other, std::map<BodyPair, Liaison>& edges) {
  const BodyPair pair = std::minmax(one, other);
  Liaison& edge = edges[pair];
  edge.a = pair.first;
  edge.b = pair.second;
  return edge;
}

void addJoint(const Joint& joint, std::size_t other, std::map<BodyPair, Liaison>& edges) {
  Liaison& edge = between(joint.body, other, edges);
  if (std::find(edge.joints.begin(), edge.joints.end(), joint.kind) == edge.joints.end()) {
    edge.joints.push_back(joint.kind);
  }
  if (joint.direction.norm() > 0.0) {
    edge.lettingGo.push_back((joint.body == edge.b ? 1.0 : -1.0) * joint.direction.normalized());
  }
}

bool connects(const Liaison& edge) {
  return std::any_of(edge.joints.begin(), edge.joints.end(),
                     [](JointKind kind) { return kind != JointKind::Flexible; });
}

}  // namespace

LiaisonGraph::LiaisonGraph(std::size_t bodies, const std::vector<Contact>& contacts, const Joints& joints)
    : neighbours_(bodies) {
  std::map<BodyPair, Liaison> edges;
  for (const Joint& joint : joints) {
    for (const std::size_t other : joint.others) addJoint(joint, other, edges);
    for (const std::size_t clamped : joint.clamped) addJoint(joint, clamped, edges);
  }
  for (const Contact& contact : contacts) {
    if (contact.kind == ContactKind::Clearance) continue;
    Liaison& edge = between(contact.a, contact.b, edges);
    edge.contact = contact.kind;
    if (!contact.axis || !edge.lettingGo.empty()) continue;
    const Vector3 axis = contact.axis->direction.normalized();
    edge.lettingGo = {axis, -axis};
  }
  for (auto& [pair, edge] : edges) {
    neighbours_[edge.a].push_back(edge.b);
    neighbours_[edge.b].push_back(edge.a);
    liaisons_.push_back(std::move(edge));
  }
  for (std::vector<std::size_t>& neighbours : neighbours_) std::sort(neighbours.begin(), neighbours.end());
}

std::vector<std::vector<std::size_t>> LiaisonGraph::clusters() const {
  JoinedSets clusters(neighbours_.size());
  for (const Liaison& edge : liaisons_) {
    if (connects(edge)) clusters.join(static_cast<std::uint32_t>(edge.a), static_cast<std::uint32_t>(edge.b));
  }
  return std::move(clusters).several();
}

}  // namespace glissade
