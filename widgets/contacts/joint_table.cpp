#include "widgets/contacts/joint_table.h"

#include <algorithm>
#include <utility>

namespace glissade {
namespace {

JointRowState stateOf(const Joint& joint) {
  switch (joint.state) {
    case JointState::Recognised: return JointRowState::Recognised;
    case JointState::Suggested: return JointRowState::Suggested;
    case JointState::Confirmed: break;
  }
  return JointRowState::Confirmed;
}

JointRowState stateOf(const JointEdit& edit) {
  switch (edit.word) {
    case JointEdit::Word::Confirmed: return edit.made ? JointRowState::Made : JointRowState::Confirmed;
    case JointEdit::Word::Dissolved: return JointRowState::Dissolved;
    case JointEdit::Word::PressedOut: return JointRowState::PressedOut;
    case JointEdit::Word::Opened: break;
  }
  return JointRowState::Opened;
}

/// Whether the bends are equal. A statement that confirms a bend repeats it, and changes nothing.
bool hasSameBend(const Joint& found, const Joint& joint) {
  return joint.kind == JointKind::Snap && found.bend == joint.bend && found.direction == joint.direction;
}

/// The key of the joint after the edit: an insert that is pressed out becomes a pin.
JointKey keyAfter(const JointEdit& edit) {
  JointKey key = edit.key;
  if (edit.word == JointEdit::Word::PressedOut) key.kind = JointKind::Pin;
  return key;
}

}  // namespace

bool JointRow::counts() const {
  return state != JointRowState::Dissolved && state != JointRowState::Opened && state != JointRowState::Refused;
}

/// An impossible statement is refused alone; the others take effect.
JointTable::JointTable(ProductPtr product, std::shared_ptr<const Joints> found, std::vector<JointEdit> said)
    : product_(std::move(product)), found_(std::move(found)), said_(std::move(said)) {
  Result<Joints> joints = applied(*found_, said_, *product_);
  std::vector<JointEdit> sound = said_;
  std::vector<std::pair<JointEdit, Diagnostic>> refused;
  if (!joints) {
    sound.clear();
    joints = *found_;
    for (const JointEdit& edit : said_) {
      sound.push_back(edit);
      Result<Joints> more = applied(*found_, sound, *product_);
      if (more) {
        joints = std::move(more);
      } else {
        sound.pop_back();
        refused.emplace_back(edit, more.error());
      }
    }
  }
  addRows(*joints, sound);
  addDissolved(sound);
  std::stable_sort(rows_.begin(), rows_.end(), [](const JointRow& a, const JointRow& b) {
    return std::pair(a.joint.body, a.key.kind) < std::pair(b.joint.body, b.key.kind);
  });
  for (const auto& [edit, why] : refused) addRefused(edit, why);
}

void JointTable::addRows(const Joints& joints, const std::vector<JointEdit>& sound) {
  for (const Joint& joint : joints) {
    JointRow row{joint, keyOf(joint, *product_), stateOf(joint)};
    for (const JointEdit& edit : sound) {
      if (!isSameJoint(keyAfter(edit), row.key)) continue;
      row.key = edit.key;
      row.state = stateOf(edit);
      break;
    }
    const Joint* found = foundJoint(row.key);
    row.isFound = found != nullptr;
    if (row.state == JointRowState::Made && row.isFound && hasSameBend(*found, joint)) {
      row.state = JointRowState::Confirmed;
    }
    rows_.push_back(std::move(row));
  }
}

void JointTable::addDissolved(const std::vector<JointEdit>& sound) {
  for (const JointEdit& edit : sound) {
    const JointRowState state = stateOf(edit);
    if (state != JointRowState::Dissolved && state != JointRowState::Opened) continue;
    if (const Joint* joint = foundJoint(edit.key)) rows_.push_back({*joint, edit.key, state});
  }
}

void JointTable::addRefused(const JointEdit& edit, const Diagnostic& why) {
  const Joint* found = foundJoint(edit.key);
  JointRow row{found != nullptr ? *found : Joint{}, edit.key, JointRowState::Refused, found != nullptr, why};
  row.joint.kind = edit.key.kind;
  rows_.push_back(std::move(row));
}

const Joint* JointTable::foundJoint(const JointKey& key) const {
  const auto found = std::find_if(found_->begin(), found_->end(),
                                  [&](const Joint& joint) { return isSameJoint(keyOf(joint, *product_), key); });
  return found == found_->end() ? nullptr : &*found;
}

std::size_t JointTable::count(JointRowState state) const {
  return static_cast<std::size_t>(
      std::count_if(rows_.begin(), rows_.end(), [state](const JointRow& row) { return row.state == state; }));
}

QString JointTable::shown(const BodyId& id) const {
  const auto body = product_->find(id);
  return QString::fromStdString(body ? product_->bodies[*body].shown() : id.text());
}

bool isSameJoint(JointKey one, JointKey other) {
  std::sort(one.others.begin(), one.others.end());
  std::sort(other.others.begin(), other.others.end());
  return one == other;
}

std::vector<JointEdit> withoutEdit(std::vector<JointEdit> said, const JointKey& key) {
  std::erase_if(said, [&](const JointEdit& edit) { return isSameJoint(edit.key, key); });
  return said;
}

std::vector<JointEdit> withEdit(std::vector<JointEdit> said, const JointEdit& word) {
  said = withoutEdit(std::move(said), word.key);
  said.push_back(word);
  return said;
}

std::vector<JointEdit> withoutJoint(std::vector<JointEdit> said, const JointRow& row) {
  if (!row.isFound) return withoutEdit(std::move(said), row.key);
  return withEdit(std::move(said), {row.key, JointEdit::Word::Dissolved});
}

}  // namespace glissade
