#pragma once

#include <optional>
#include <vector>

#include "engine/product/designation.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// What the name of each body says: its own, or that of the assembly that it is in alone.
std::vector<std::optional<Designation>> designationsOf(const AssembledProduct& product);

/// Adds to a joint what the name of its body states, where that agrees with its shape: designation, drive, pitch and
/// the diameter of a thread that is drawn by its core. Where they disagree the shape counts and the joint is doubtful.
void addDesignation(const Designation& said, Joint& joint);

/// A head of the proportions of ISO 4762 that is drawn without a recess has a hexagon socket.
void addUsualDrive(const TurnedShape& shape, Joint& joint);

}  // namespace glissade
