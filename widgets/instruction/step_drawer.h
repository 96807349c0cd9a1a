#pragma once

#include <QImage>

#include "engine/documents/instruction/work_instruction.h"
#include "widgets/instruction/line_drawing.h"

namespace glissade {

/// Draws the pictures of work instructions from the product itself, independently of hidden bodies, sections and camera
/// of the window. May be used on any thread. It refers to the product.
class StepDrawer {
 public:
  explicit StepDrawer(const AssembledProduct& product) : product_(product) {}

  /// Draws present parts pale and the coming ones on their way, with arrows. A close-up is in a corner if the panel
  /// requests one.
  QImage panel(const InstructionPanel& panel, const QSize& pixels) const;
  /// Draws the bodies at their assembled poses, in their colours. `up`: see AssemblyPlan::up.
  QImage finished(const std::vector<BodyId>& bodies, const QSize& pixels, const Vector3& up = Vector3::UnitZ()) const;
  /// Draws the parts to be fetched.
  QImage parts(const std::vector<BodyId>& bodies, const QSize& pixels) const;
  /// Draws the whole product. Each body is at `moved` times its assembled pose.
  QImage exploded(const std::vector<Pose>& moved, const QSize& pixels) const;

 private:
  const RigidBody& body(const BodyId& id) const { return product_.body(id); }
  QImage drawn(const std::vector<DrawnBody>& bodies, const QSize& pixels, const Vector3& up = Vector3::UnitZ()) const;

  const AssembledProduct& product_;
};

}  // namespace glissade
