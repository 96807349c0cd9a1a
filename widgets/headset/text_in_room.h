#pragma once

#include "widgets/headset/shown_hands.h"

namespace glissade {

/// A text that is read from everywhere: it faces the head, is upright in the room, and seems to be as large wherever it
/// is. Texts are pictures with capital letters of 16 pixels, which are 0.6 degrees high.
///
/// p_RT: its middle, in the room. The place is one of the room, too: metres.
ShownPicture textInRoom(const FlatPicturePtr& picture, const Vector3& p_RT, const Vector3& p_RH);

}  // namespace glissade
