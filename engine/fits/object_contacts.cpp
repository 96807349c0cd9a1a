#include "engine/fits/object_contacts.h"

#include <algorithm>

#include "engine/fits/common_axis.h"

namespace glissade {
namespace {

Contact exchanged(Contact contact) {
  std::swap(contact.a, contact.b);
  if (contact.axis) contact.axis = glissade::exchanged(*contact.axis);
  return contact;
}

double measured(const Contact& contact) { return contact.overlap + contact.deviation; }

class ObjectContacts {
 public:
  ObjectContacts(const FitQuestion& question, const std::vector<Pose>& ends, ThinnableBodies& thinnable,
                 const StopToken& stop)
      : question_(question),
        object_(question.product.bodies[question.object]),
        ends_(ends),
        thinnable_(thinnable),
        stop_(stop) {}

  Result<std::map<std::size_t, FoundContact>> find() {
    if (const Outcome known = checkBodies(); !known) return known.error();
    findContactsAtEnds();
    addHooks();
    if (const Outcome marked = addMarkedThreads(); !marked) return marked.error();
    if (const Outcome sound = checkAllowances(); !sound) return sound.error();
    return std::move(contacts_);
  }

 private:
  const std::vector<FitEdit>& edits() const { return question_.product.fits.pairs; }
  const RigidBody& body(std::size_t index) const { return question_.product.bodies[index]; }

  static Diagnostic refused(std::size_t edit, const Message& reason, const Message& advice) {
    return {ErrorKind::MalformedInput, "", "/fits/pairs/" + std::to_string(edit), reason, advice};
  }

  Outcome checkBodies() const {
    for (std::size_t i = 0; i < edits().size(); ++i) {
      for (const BodyId& id : {edits()[i].a, edits()[i].b}) {
        if (question_.product.find(id)) continue;
        return refused(i, {GLISSADE_TEXT("names the body '%1', which is not there"), {id.text()}},
                       GLISSADE_TEXT("See 'glissade-cli fits' for the names."));
      }
    }
    return Done{};
  }

  void findContactsAtEnds() {
    if (question_.contacts != nullptr) {
      for (const Contact& contact : *question_.contacts) addContact(contact, ends_.front());
      return;
    }
    std::vector<ContactBody> bodies = contactBodiesOf(question_.product);
    ContactLimits limits = question_.limits;
    limits.only = question_.object;
    for (const Pose& end : ends_) {
      bodies[question_.object].X_WB = end;
      for (const Contact& contact : findContacts(bodies, limits, stop_).contacts) addContact(contact, end);
    }
  }

  void addContact(const Contact& found, const Pose& end) {
    if (found.a != question_.object && found.b != question_.object) return;
    const Contact contact = found.b == question_.object ? found : exchanged(found);
    FoundContact& known = contacts_.try_emplace(contact.a, FoundContact{contact, {}, end}).first->second;
    if (measured(contact) > measured(known.contact)) known = {contact, std::move(known.at), end};
    known.at.push_back(end);
  }

  /// Adds pairs of a hook and its edge, which need not touch.
  void addHooks() {
    for (const evidence::SnapWord& snap : question_.product.snaps) {
      if (snap.hook != object_.id && snap.edge != object_.id) continue;
      const auto other = question_.product.find(snap.hook == object_.id ? snap.edge : snap.hook);
      if (!other) continue;
      const Contact apart{*other, question_.object, ContactKind::Clearance, 0, 0, 0, 0, 0, {}};
      contacts_.try_emplace(*other, FoundContact{apart, ends_, ends_.front()});
    }
  }

  Outcome checkAllowances() const {
    for (std::size_t i = 0; i < edits().size(); ++i) {
      const FitEdit& edit = edits()[i];
      if (!edit.allowance || *edit.allowance == 0.0) continue;
      if (edit.a != object_.id && edit.b != object_.id) continue;
      const std::size_t other = question_.product.indexOf(edit.a == object_.id ? edit.b : edit.a);
      if (contacts_.count(other) == 0) {
        return refused(i,
                       {GLISSADE_TEXT("allows for '%1' and '%2', which do not touch where they are assembled"),
                        {edit.a.text(), edit.b.text()}},
                       GLISSADE_TEXT("Remove the allowance."));
      }
      const double most = kMostThinning * std::max(thicknessOf(object_), thicknessOf(body(other)));
      if (*edit.allowance > most) {
        return refused(i,
                       {GLISSADE_TEXT("allows %1, more than the thickness of '%2' or of '%3' gives"),
                        {Length{*edit.allowance}, edit.a.text(), edit.b.text()}},
                       {GLISSADE_TEXT("Give at most %1."), {Length{most}}});
      }
    }
    return Done{};
  }

  double thicknessOf(const RigidBody& body) const {
    const ThinnableMesh* thinnable = thinnable_.of(body.mesh);
    return thinnable != nullptr ? thinnable->thickness() : 0.0;
  }

  /// Adds pairs that a person calls a thread, which need not touch.
  Outcome addMarkedThreads() {
    for (const FitEdit& edit : edits()) {
      if (edit.kind != ContactKind::Thread || (edit.a != object_.id && edit.b != object_.id)) continue;
      const std::size_t obstacle = question_.product.indexOf(edit.a == object_.id ? edit.b : edit.a);
      const auto known = contacts_.find(obstacle);
      if (known != contacts_.end() && hasShaft(known->second.contact)) continue;
      FoundContact found{Contact{obstacle, question_.object, ContactKind::Clearance, 0, 0, 0, 0, 0, {}}, {}, {}};
      if (known != contacts_.end()) found = known->second;
      found.contact.axis.reset();  // the axis of a cone is no thread's
      for (const Pose& end : ends_) {
        const RigidBody& other = body(obstacle);
        const auto axis = commonAxisOf(contactBody(other, other.X_WB), contactBody(object_, end));
        if (!axis) continue;
        if (!found.contact.axis) found.measuredAt = end;
        if (!found.contact.axis) found.contact.axis = axis;
        if (known == contacts_.end()) found.at.push_back(end);
      }
      if (!found.contact.axis) {
        return refused(static_cast<std::size_t>(&edit - edits().data()),
                       {GLISSADE_TEXT("calls '%1' and '%2' a thread, but no shaft of the one is on the axis of a hole "
                                      "of the other"),
                        {edit.a.text(), edit.b.text()}},
                       GLISSADE_TEXT("Give another kind."));
      }
      contacts_[obstacle] = std::move(found);
    }
    return Done{};
  }

  const FitQuestion& question_;
  const RigidBody& object_;
  const std::vector<Pose>& ends_;
  ThinnableBodies& thinnable_;
  const StopToken& stop_;
  std::map<std::size_t, FoundContact> contacts_;
};

}  // namespace

ContactAxis exchanged(ContactAxis axis) {
  std::swap(axis.radiusA, axis.radiusB);
  axis.shaftIsA = !axis.shaftIsA;
  return axis;
}

bool hasShaft(const Contact& contact) { return contact.axis && !contact.axis->conical; }

ContactBody contactBody(const RigidBody& body, const Pose& X_WB) { return {body.id, body.mesh, X_WB, 0.0}; }

Result<std::map<std::size_t, FoundContact>> findObjectContacts(const FitQuestion& question,
                                                               const std::vector<Pose>& ends,
                                                               ThinnableBodies& thinnable, const StopToken& stop) {
  return ObjectContacts(question, ends, thinnable, stop).find();
}

}  // namespace glissade
