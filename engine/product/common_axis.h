#pragma once

#include <optional>
#include <vector>

#include "engine/product/contact_report.h"

namespace glissade {

/// The axis that a shaft of one body has in common with a hole of the other, beside each other; of several the pair
/// whose radii are nearest. They need not touch: the radii differ by a fifth at most. Nothing where there is none.
std::optional<ContactAxis> commonAxisOf(const ContactBody& a, const ContactBody& b);
/// All of them, those whose radii are nearest first.
std::vector<ContactAxis> commonAxesOf(const ContactBody& a, const ContactBody& b);

}  // namespace glissade
