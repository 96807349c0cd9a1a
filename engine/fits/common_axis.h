#pragma once

#include <optional>
#include <vector>

#include "engine/fits/contact_report.h"

namespace glissade {

/// The axis that a shaft of one body shares with a hole of the other, beside each other; of several, the pair with the
/// nearest radii. They need not touch: the radii may differ by a fifth. Nothing if there is none.
std::optional<ContactAxis> commonAxisOf(const ContactBody& a, const ContactBody& b);
/// All such axes, those with the nearest radii first.
std::vector<ContactAxis> commonAxesOf(const ContactBody& a, const ContactBody& b);

}  // namespace glissade
