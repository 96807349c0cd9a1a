#pragma once

#include <QImage>

#include "engine/study/instruction/work_instruction.h"
#include "widgets/instruction/line_drawing.h"

namespace glissade {

/// Draws the pictures of work instructions from the product itself: what the window shows and hides, its sections and
/// its camera have no part in them. Any thread. Refers to the product.
class StepDrawer {
 public:
  explicit StepDrawer(const AssembledProduct& product) : product_(product) {}

  /// What is there is pale, all that comes is on its way with an arrow, and a close-up is in a corner where the panel
  /// asks for one.
  QImage panel(const InstructionPanel& panel, const QSize& pixels) const;
  /// Bodies where they are assembled, in their colours.
  QImage finished(const std::vector<std::string>& bodies, const QSize& pixels) const;
  /// Parts to be fetched.
  QImage parts(const std::vector<std::string>& bodies, const QSize& pixels) const;
  /// The whole product, each body at its pose times where it is assembled.
  QImage exploded(const std::vector<Pose>& moved, const QSize& pixels) const;

 private:
  const RigidBody& body(const std::string& id) const { return product_.bodies[*product_.indexOf(id)]; }
  QImage drawn(const std::vector<DrawnBody>& bodies, const QSize& pixels) const;

  const AssembledProduct& product_;
};

}  // namespace glissade
