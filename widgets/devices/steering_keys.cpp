#include "widgets/devices/steering_keys.h"

#include <QCoreApplication>

namespace glissade {
namespace {

constexpr std::array<SteeringKey, 12> kSteeringKeys{{{'A', 0, -1, QT_TRANSLATE_NOOP("SteeringKeys", "left")},
                                                     {'D', 0, 1, QT_TRANSLATE_NOOP("SteeringKeys", "right")},
                                                     {'W', 1, 1, QT_TRANSLATE_NOOP("SteeringKeys", "up")},
                                                     {'S', 1, -1, QT_TRANSLATE_NOOP("SteeringKeys", "down")},
                                                     {'Q', 2, -1, QT_TRANSLATE_NOOP("SteeringKeys", "away from you")},
                                                     {'E', 2, 1, QT_TRANSLATE_NOOP("SteeringKeys", "towards you")},
                                                     {'J', 4, -1, QT_TRANSLATE_NOOP("SteeringKeys", "turn left")},
                                                     {'L', 4, 1, QT_TRANSLATE_NOOP("SteeringKeys", "turn right")},
                                                     {'I', 3, -1, QT_TRANSLATE_NOOP("SteeringKeys", "tip back")},
                                                     {'K', 3, 1, QT_TRANSLATE_NOOP("SteeringKeys", "tip forward")},
                                                     {'U', 5, 1, QT_TRANSLATE_NOOP("SteeringKeys", "roll left")},
                                                     {'O', 5, -1, QT_TRANSLATE_NOOP("SteeringKeys", "roll right")}}};

}  // namespace

const std::array<SteeringKey, 12>& steeringKeys() { return kSteeringKeys; }

QString motionText(const SteeringKey& key) { return QCoreApplication::translate("SteeringKeys", key.motion); }

}  // namespace glissade
