#pragma once

#include "widgets/openxr/shown_hands.h"

namespace glissade {

/// A text that can be read from everywhere: it faces the head, is upright in the room, and appears in the same size at
/// each distance. Texts are pictures with capital letters of 16 pixels, which are 0.6 degrees high.
///
/// p_RT: middle of the text. The result is in the room, too: metres.
ShownPicture textInRoom(const FlatPicturePtr& picture, const Vector3& p_RT, const Vector3& p_RH);

}  // namespace glissade
