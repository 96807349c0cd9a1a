#pragma once

#include <QString>

#include <array>
#include <cstddef>

namespace glissade {

/// A key that deflects an axis of the keyboard: 0-2 translation x y z, 3-5 rotation x y z.
struct SteeringKey {
  char letter;  ///< also its Qt::Key
  std::size_t axis;
  double direction;
  const char* motion;  ///< motion in the axes of the view, in English
};

/// All of them; the two keys of an axis follow each other.
const std::array<SteeringKey, 12>& steeringKeys();

/// The motion of a key in the user's language.
QString motionText(const SteeringKey& key);

}  // namespace glissade
