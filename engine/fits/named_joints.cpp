#include "engine/fits/named_joints.h"

#include <algorithm>
#include <cmath>

#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// Relative tolerances of a stated diameter; a core is thinner.
constexpr double kSameDiameter = 0.06;
constexpr double kThinnestCore = 0.75;
/// Crests that are modelled for plastic stand out: a screw "M2x10" has 2.2 mm.
constexpr double kThickestCrest = 1.12;
constexpr double kSameDriveSize = 0.1;

bool agrees(StandardPart part, JointKind kind) {
  switch (kind) {
    case JointKind::Screw: return part == StandardPart::Screw || part == StandardPart::SetScrew;
    case JointKind::Nut: return part == StandardPart::Nut;
    case JointKind::Thread:
      return part == StandardPart::Screw || part == StandardPart::SetScrew || part == StandardPart::Nut;
    case JointKind::Insert:
      return part == StandardPart::Insert || part == StandardPart::Bearing || part == StandardPart::Pin ||
             part == StandardPart::Nut || part == StandardPart::Seal || part == StandardPart::Ring;
    case JointKind::Pin: return part == StandardPart::Pin || part == StandardPart::Screw;
    case JointKind::Unit: return part == StandardPart::Bearing;
    case JointKind::Flexible:
      return part == StandardPart::Belt || part == StandardPart::Seal || part == StandardPart::Ring;
    case JointKind::Snap:
    case JointKind::Permanent: break;
  }
  return false;
}

void doubt(Joint& joint, const Message& why) {
  joint.isDoubtful = true;
  joint.evidence.push_back(why);
}

void addThread(const Designation& said, Joint& joint) {
  JointThread& thread = *joint.thread;
  if (said.diameter <= 0.0) return;
  const double share = thread.diameter / said.diameter;
  if (share < kThinnestCore || share > (thread.isPitchStated ? kThickestCrest : 1.0 + kSameDiameter)) {
    doubt(joint, {GLISSADE_TEXT("the name says a thread of %1, the shape is %2"),
                  {Length{said.diameter}, Length{thread.diameter}}});
    return;
  }
  if (share <= 1.0 + kSameDiameter) thread.diameter = said.diameter;
  if (said.pitch < 0.0 && thread.isPitchStated && thread.pitch > 0.0) {
    doubt(joint, GLISSADE_TEXT("the name says a left-hand thread, the shape is a right-hand one"));
  }
  if (thread.isPitchStated) return;
  thread.pitch = said.pitch != 0.0 ? said.pitch : coarsePitch(0.5 * said.diameter).pitch;
  if (said.pitch < 0.0) joint.evidence.emplace_back(GLISSADE_TEXT("the name says a left-hand thread"));
}

/// Adds the thread that the other body's name states, if the body's own name states none.
void addThreadOfOther(const Designation& own, const Designation& other, Joint& joint) {
  const bool hasThread = agrees(other.part, JointKind::Thread);
  if (hasThread && own.pitch == 0.0 && other.pitch != 0.0) addThread(other, joint);
}

void addDrive(const Designation& said, Joint& joint) {
  if (said.drive == DriveKind::None) return;
  if (joint.drive == DriveKind::None) {
    joint.drive = said.drive;
    joint.driveSize = said.driveSize;
    joint.evidence.emplace_back(GLISSADE_TEXT("the drive is that of the name"));
    return;
  }
  if (joint.drive != said.drive) {
    doubt(joint, {GLISSADE_TEXT("the name says the drive '%1', the shape is '%2'"),
                  {kDriveNames.of(said.drive), kDriveNames.of(joint.drive)}});
  } else if (said.driveSize > 0.0 && joint.driveSize > 0.0 &&
             std::abs(joint.driveSize - said.driveSize) > kSameDriveSize * said.driveSize) {
    doubt(joint, {GLISSADE_TEXT("the name says a drive of %1, the shape has %2"),
                  {Length{said.driveSize}, Length{joint.driveSize}}});
  }
}

/// Adds the designation of the body's name.
void addDesignation(const Designation& said, Joint& joint) {
  if (!agrees(said.part, joint.kind)) {
    doubt(joint, {GLISSADE_TEXT("the name says '%1'"), {CatalogueText{kStandardPartNames.of(said.part)}}});
    return;
  }
  // A word such as "screw" is evidence, but no designation.
  const bool statesSize = std::any_of(said.text.begin(), said.text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (statesSize) joint.designation = said.text;
  joint.evidence.push_back({GLISSADE_TEXT("the name says '%1'"), {said.text}});
  if (joint.thread) addThread(said, joint);
  addDrive(said, joint);
}

}  // namespace

Designations designationsOf(const AssembledProduct& product) {
  const Product& tree = product.tree;
  Designations said;
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    const auto node = tree.find(product.bodies[body].id.text());
    auto own = designationIn(product.nameInFile(body));
    const auto above = node ? tree.nodes()[*node].parent : std::nullopt;
    if (!own && above && tree.nodes()[*above].children.size() == 1)
      own = designationIn(tree.nodes()[*above].names.product);
    said.push_back(std::move(own));
  }
  return said;
}

bool says(const Designations& said, std::size_t body, std::initializer_list<StandardPart> parts) {
  return said[body] && std::find(parts.begin(), parts.end(), said[body]->part) != parts.end();
}

bool isScrewByItself(const ProductShapes& shapes, const Designations& said, std::size_t body) {
  if (says(said, body, {StandardPart::Screw, StandardPart::SetScrew})) return true;
  const TurnedShape* shape = shapes.turned(body);
  if (shape == nullptr) return false;
  if (shape->drive.kind != DriveKind::None) return true;
  return hasCapHead(*shape, 2.0 * shape->shaft) && !says(said, body, {StandardPart::Pin});
}

void addDesignations(const Designations& said, Joint& joint) {
  const auto& own = said[joint.body];
  if (own) addDesignation(*own, joint);
  if (!joint.thread) return;
  for (const std::size_t other : joint.others) {
    if (said[other]) addThreadOfOther(own.value_or(Designation{}), *said[other], joint);
  }
}

void addUsualDrive(const TurnedShape& shape, Joint& joint) {
  if (joint.kind != JointKind::Screw || joint.drive != DriveKind::None || !joint.thread) return;
  const double diameter = joint.thread->diameter;
  if (!hasCapHead(shape, diameter)) return;
  joint.drive = DriveKind::HexSocket;
  joint.driveSize = usualDriveSize(DriveKind::HexSocket, diameter);
  joint.evidence.emplace_back(GLISSADE_TEXT("the head has the proportions of ISO 4762"));
}

}  // namespace glissade
