#include "engine/fits/joint_edits.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>

#include "engine/evidence/hook.h"
#include "engine/fits/joint.h"
#include "engine/fits/product_shapes.h"
#include "engine/model/designation.h"

namespace glissade {
namespace {

/// Maps bonded bodies to one representative.
class JoinedBodies {
 public:
  JoinedBodies(const Joints& joints, std::size_t bodies) : parent_(bodies) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const Joint& joint : joints) {
      const bool isOne =
          joint.kind == JointKind::Insert || joint.kind == JointKind::Permanent || joint.kind == JointKind::Unit;
      if (!isOne || joint.state == JointState::Suggested) continue;
      for (const std::size_t other : joint.others) parent_[rootOf(other)] = rootOf(joint.body);
    }
  }

  std::size_t rootOf(std::size_t body) const {
    while (parent_[body] != body) body = parent_[body];
    return body;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// For each body, the bodies that leave after it.
std::vector<std::vector<std::size_t>> laterBodies(const Joints& joints, const JoinedBodies& joined,
                                                  std::size_t bodies) {
  std::vector<std::vector<std::size_t>> later(bodies);
  for (const Joint& joint : joints) {
    if (joint.state == JointState::Suggested) continue;
    std::vector<std::size_t> after = joint.clamped;
    const bool isBeforeOthers = joint.kind == JointKind::Nut || joint.kind == JointKind::Flexible;
    if (isBeforeOthers) after.insert(after.end(), joint.others.begin(), joint.others.end());
    const std::size_t first = joined.rootOf(joint.body);
    for (const std::size_t body : after) {
      if (joined.rootOf(body) != first) later[first].push_back(joined.rootOf(body));
    }
  }
  return later;
}

/// A circle of bodies, beginning with this body, each of which has to leave before the next one, and the last before
/// the first. Empty if there is none. A screw leaves before the parts that it clamps, a nut before those and its shaft,
/// a flexible body before the bodies that it goes around; host and guest, welded bodies and units are one body.
/// Suggested joints do not count.
std::vector<std::size_t> circleThrough(std::size_t body, const Joints& joints, std::size_t bodies) {
  const JoinedBodies joined(joints, bodies);
  const auto later = laterBodies(joints, joined, bodies);
  const std::size_t start = joined.rootOf(body);
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> from(bodies, kNone);
  std::vector<std::size_t> open{start};
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const std::size_t next : later[open[i]]) {
      if (next == start) {
        std::vector<std::size_t> circle;
        for (std::size_t at = open[i]; at != start; at = from[at]) circle.push_back(at);
        circle.push_back(start);
        std::reverse(circle.begin(), circle.end());
        return circle;
      }
      if (from[next] != kNone) continue;
      from[next] = open[i];
      open.push_back(next);
    }
  }
  return {};
}

/// Largest distance of the bodies of a joint that a person makes, as a share of the smaller one's diagonal.
constexpr double kFarShare = 0.1;
constexpr double kNearEnough = 5e-4;  ///< metres: bodies within this distance are always near

Diagnostic refusal(const JointKey& key, const Message& reason, const Message& advice) {
  return {ErrorKind::Usage, "", inWords(key), reason, advice};
}

double diagonalOf(const ProductShapes& shapes, std::size_t body) { return shapes.box(body).diagonal().norm(); }

class JointEditor {
 public:
  JointEditor(Joints joints, const AssembledProduct& product)
      : joints_(std::move(joints)), product_(product), shapes_(product) {}

  Outcome take(const JointEdit& edit) {
    if (const Outcome known = knowBodies(edit); !known) return known;
    switch (edit.word) {
      case JointEdit::Word::Confirmed: return edit.made ? make(edit) : confirm(edit);
      case JointEdit::Word::Dissolved: return dissolve(edit, GLISSADE_TEXT("dissolved"));
      case JointEdit::Word::PressedOut: return pressOut(edit);
      case JointEdit::Word::Opened: return open(edit);
    }
    return Done{};
  }

  Joints& joints() { return joints_; }

 private:
  Outcome knowBodies(const JointEdit& edit) const {
    std::vector<BodyId> ids = edit.key.others;
    ids.push_back(edit.key.body);
    ids.insert(ids.end(), edit.clamped.begin(), edit.clamped.end());
    for (const BodyId& id : ids) {
      if (product_.find(id)) continue;
      return refusal(edit.key, {GLISSADE_TEXT("there is no body '%1'"), {id.text()}},
                     GLISSADE_TEXT("Name bodies by the ids that 'joints --json' prints."));
    }
    const std::set<BodyId> distinct(ids.begin(), ids.end());
    if (distinct.size() == ids.size()) return Done{};
    return refusal(edit.key, GLISSADE_TEXT("it names a body twice"), GLISSADE_TEXT("Name each body of a joint once."));
  }

  Joints::iterator find(const JointKey& key) {
    return std::find_if(joints_.begin(), joints_.end(),
                        [&](const Joint& joint) { return isMeant(keyOf(joint, product_), key); });
  }

  /// True if the keys are equal, in any order of the other bodies.
  static bool isMeant(JointKey one, JointKey other) {
    std::sort(one.others.begin(), one.others.end());
    std::sort(other.others.begin(), other.others.end());
    return one == other;
  }

  static Outcome isMissing(const JointKey& key, CatalogueText word) {
    return refusal(key, {GLISSADE_TEXT("there is no such joint that could be %1"), {word}},
                   GLISSADE_TEXT("'glissade-cli joints' lists those that are found; 'made' makes one."));
  }

  Outcome confirm(const JointEdit& edit) {
    const auto joint = find(edit.key);
    if (joint == joints_.end()) return isMissing(edit.key, GLISSADE_TEXT("confirmed"));
    joint->state = JointState::Confirmed;
    return Done{};
  }

  Outcome dissolve(const JointEdit& edit, CatalogueText word) {
    const auto joint = find(edit.key);
    if (joint == joints_.end()) return isMissing(edit.key, word);
    joints_.erase(joint);
    return Done{};
  }

  Outcome pressOut(const JointEdit& edit) {
    if (edit.key.kind != JointKind::Insert) {
      return refusal(edit.key, GLISSADE_TEXT("only an insert is pressed out"),
                     GLISSADE_TEXT("Dissolve the joint, or say 'opened' of a unit."));
    }
    const auto joint = find(edit.key);
    if (joint == joints_.end()) return isMissing(edit.key, GLISSADE_TEXT("pressed out"));
    joint->kind = JointKind::Pin;
    joint->state = JointState::Confirmed;
    joint->evidence.emplace_back(GLISSADE_TEXT("the user has it pressed out"));
    return Done{};
  }

  Outcome open(const JointEdit& edit) {
    if (edit.key.kind != JointKind::Unit) {
      return refusal(edit.key, GLISSADE_TEXT("only a unit is opened"), GLISSADE_TEXT("Dissolve the joint."));
    }
    return dissolve(edit, GLISSADE_TEXT("opened"));
  }

  Outcome make(const JointEdit& edit) {
    Joint made = *edit.made;
    made.kind = edit.key.kind;
    made.state = JointState::Confirmed;
    made.body = product_.indexOf(edit.key.body);
    made.others = product_.indicesOf(edit.key.others);
    made.clamped = product_.indicesOf(edit.clamped);
    if (made.others.empty() && made.kind != JointKind::Flexible) {
      return refusal(edit.key, GLISSADE_TEXT("it has one body only"),
                     GLISSADE_TEXT("Name what it is joined with in 'others'."));
    }
    if (const Outcome near = checkNear(made, edit.key); !near) return near;
    if (const Outcome sound = checkBend(made, edit.key); !sound) return sound;
    if (!made.designation.empty()) {
      const auto said = designationOf(made.designation);
      if (!said) return refusal(edit.key, said.error().reason, said.error().advice);
    }
    if (isScrewed(made.kind) && (!made.thread || made.thread->pitch == 0.0)) {
      return refusal(edit.key, GLISSADE_TEXT("its thread is not stated"),
                     GLISSADE_TEXT("Give 'thread' with diameter, pitch and engaged length."));
    }
    made.evidence = {GLISSADE_TEXT("user-defined")};
    const auto before = find(edit.key);
    if (before == joints_.end()) {
      joints_.push_back(std::move(made));
    } else {
      *before = std::move(made);
    }
    return Done{};
  }

  /// Checks that each of the other bodies is near the body, or near one that is.
  Outcome checkNear(const Joint& joint, const JointKey& key) const {
    std::vector<std::size_t> reached{joint.body};
    std::vector<std::size_t> open = joint.others;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (std::size_t k = 0; k < open.size();) {
        const double limit =
            std::max(kNearEnough, kFarShare * std::min(diagonalOf(shapes_, reached[i]), diagonalOf(shapes_, open[k])));
        if (shapes_.apart(reached[i], open[k], limit) > limit) {
          ++k;
          continue;
        }
        reached.push_back(open[k]);
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(k));
      }
    }
    if (open.empty()) return Done{};
    const std::string far = product_.bodies[open.front()].shown();
    return refusal(key, {GLISSADE_TEXT("'%1' is far from '%2'"), {far, product_.bodies[joint.body].shown()}},
                   GLISSADE_TEXT("Join bodies that touch, or nearly do."));
  }

  Outcome checkBend(const Joint& joint, const JointKey& key) const {
    if (joint.kind != JointKind::Snap) {
      if (joint.bend == 0.0) return Done{};
      return refusal(key, GLISSADE_TEXT("only a snap bends"), GLISSADE_TEXT("Remove 'bend_m'."));
    }
    const double most = evidence::mostBendOf(*product_.bodies[joint.body].mesh);
    if (joint.bend >= 0.0 && joint.bend <= most) return Done{};
    return refusal(key, {GLISSADE_TEXT("a hook does not bend by %1"), {Length{joint.bend}}},
                   {GLISSADE_TEXT("Give 0 to %1 for this body."), {Length{most}}});
  }

  Joints joints_;
  const AssembledProduct& product_;
  ProductShapes shapes_;
};

std::string joinedIds(const std::vector<std::size_t>& bodies, const AssembledProduct& product) {
  std::string text;
  for (const std::size_t body : bodies) text += (text.empty() ? "'" : " -> '") + product.bodies[body].id.text() + "'";
  return text;
}

}  // namespace

JointKey keyOf(const Joint& joint, const AssembledProduct& product) {
  JointKey key{joint.kind, product.bodies[joint.body].id, {}};
  for (const std::size_t other : joint.others) key.others.push_back(product.bodies[other].id);
  return key;
}

Message inWords(const JointKey& key) {
  constexpr std::array kOfBody{
      GLISSADE_TEXT("screw of %1"),    GLISSADE_TEXT("nut of %1"),       GLISSADE_TEXT("thread of %1"),
      GLISSADE_TEXT("insert of %1"),   GLISSADE_TEXT("pin of %1"),       GLISSADE_TEXT("snap of %1"),
      GLISSADE_TEXT("flexible of %1"), GLISSADE_TEXT("permanent of %1"), GLISSADE_TEXT("unit of %1")};
  static_assert(kOfBody.size() == std::size(kJointKindNames.names));
  return {kOfBody[static_cast<std::size_t>(key.kind)], {key.body.text()}};
}

Result<Joints> applied(Joints joints, const std::vector<JointEdit>& edits, const AssembledProduct& product) {
  if (edits.empty()) return joints;
  JointEditor editor(std::move(joints), product);
  for (const JointEdit& edit : edits) {
    if (const Outcome taken = editor.take(edit); !taken) return taken.error();
  }
  for (const JointEdit& edit : edits) {
    if (!edit.made) continue;
    const auto circle = circleThrough(product.indexOf(edit.key.body), editor.joints(), product.bodies.size());
    if (circle.empty()) continue;
    return refusal(edit.key, {GLISSADE_TEXT("joints hold each other in a circle: %1"), {joinedIds(circle, product)}},
                   GLISSADE_TEXT("Dissolve or change one of them."));
  }
  std::stable_sort(editor.joints().begin(), editor.joints().end(),
                   [](const Joint& a, const Joint& b) { return a.body != b.body ? a.body < b.body : a.kind < b.kind; });
  return std::move(editor.joints());
}

JointEdit confirmationOf(const Joint& joint, const AssembledProduct& product) {
  JointEdit edit{keyOf(joint, product), JointEdit::Word::Confirmed};
  if (joint.kind == JointKind::Snap && joint.bend > 0.0) edit.made = joint;
  return edit;
}

std::vector<JointEdit> confirmationsOf(const Joints& joints, const AssembledProduct& product) {
  std::vector<JointEdit> edits;
  for (const Joint& joint : joints) {
    if (joint.state == JointState::Suggested) edits.push_back(confirmationOf(joint, product));
  }
  return edits;
}

std::vector<evidence::SnapWord> bendsOf(const std::vector<JointEdit>& edits) {
  std::vector<evidence::SnapWord> bends;
  for (const JointEdit& edit : edits) {
    if (edit.key.kind != JointKind::Snap) continue;
    const std::vector<BodyId>& edges = edit.key.others;
    std::erase_if(bends, [&](const evidence::SnapWord& earlier) {
      return earlier.hook == edit.key.body && std::find(edges.begin(), edges.end(), earlier.edge) != edges.end();
    });
    if (edit.word != JointEdit::Word::Confirmed || !edit.made || !(edit.made->bend > 0.0)) continue;
    for (const BodyId& edge : edges) {
      bends.push_back({edit.key.body, edge, edit.made->bend, edit.made->direction});
    }
  }
  return bends;
}

std::vector<evidence::SnapWord> bendsOf(const Joints& joints, const AssembledProduct& product) {
  return bendsOf(withBends({}, joints, product));
}

std::vector<JointEdit> withBends(std::vector<JointEdit> edits, const Joints& joints, const AssembledProduct& product) {
  for (const Joint& joint : joints) {
    if (joint.kind != JointKind::Snap || !(joint.bend > 0.0)) continue;
    const JointEdit said = confirmationOf(joint, product);
    const bool known = std::any_of(edits.begin(), edits.end(), [&](const JointEdit& edit) {
      return edit.key == said.key && edit.made.has_value();
    });
    if (!known) edits.push_back(said);
  }
  return edits;
}

}  // namespace glissade
