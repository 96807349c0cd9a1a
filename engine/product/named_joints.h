#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "engine/product/designation.h"
#include "engine/product/product_shapes.h"

namespace glissade {

/// What the name of each body says; nothing where it names no standard part.
using Designations = std::vector<std::optional<Designation>>;

/// Its own name, or that of the assembly that it is in alone.
Designations designationsOf(const AssembledProduct& product);

/// Whether the name of a body says that it is one of these.
bool says(const Designations& said, std::size_t body, std::initializer_list<StandardPart> parts);

/// Adds to a joint what the name of its body states, where that agrees with its shape: designation, drive, pitch and
/// hand, and the diameter of a thread that is drawn by its core. Where they disagree the shape counts and the joint is
/// doubtful. Of a thread the names of the bodies that it is in or on count, too: "M10 LH".
void addDesignations(const Designations& said, Joint& joint);

/// A head of the proportions of ISO 4762 that is drawn without a recess has a hexagon socket.
void addUsualDrive(const TurnedShape& shape, Joint& joint);

}  // namespace glissade
