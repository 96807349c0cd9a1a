#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "engine/fits/product_shapes.h"
#include "engine/model/designation.h"

namespace glissade {

/// The designation in the name of each body; nothing if it names no standard part.
using Designations = std::vector<std::optional<Designation>>;

/// Reads the name of each body, or of an assembly that contains only this body.
Designations designationsOf(const AssembledProduct& product);

/// True if the name of the body says that it is one of these parts.
bool says(const Designations& said, std::size_t body, std::initializer_list<StandardPart> parts);

/// True if the body has a drive, the name of a screw, or the head of a cap screw and no name of a pin.
bool isScrewByItself(const ProductShapes& shapes, const Designations& said, std::size_t body);

/// Adds the facts of the body's name to a joint, if they agree with its shape: designation, drive, pitch and hand, and
/// the diameter of a thread that is drawn by its core. If they disagree, the shape counts and the joint is doubtful.
/// For a thread, the names of the bodies that it is in or on count as well: "M10 LH".
void addDesignations(const Designations& said, Joint& joint);

/// A head of the proportions of ISO 4762 that is drawn without a recess has a hexagon socket.
void addUsualDrive(const TurnedShape& shape, Joint& joint);

}  // namespace glissade
