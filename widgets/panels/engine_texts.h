#pragma once

#include <QCoreApplication>

namespace glissade {

/// The engine's texts that the window shows, for the translators: labels and help of the live
/// parameters, planners and devices. A test compares them with the engine's tables.
inline constexpr const char* kEngineTexts[] = {
    QT_TRANSLATE_NOOP("Parameters", "Authority"),
    QT_TRANSLATE_NOOP("Parameters", "Contact samples"),
    QT_TRANSLATE_NOOP("Parameters", "Contact distance"),
    QT_TRANSLATE_NOOP("Parameters", "Contact disc"),
    QT_TRANSLATE_NOOP(
        "Parameters",
        "The computer's share of the iterations: 1 is the automatic planner alone, 0 the operator alone."),
    QT_TRANSLATE_NOOP("Parameters", "Samples shot on the tangent plane each time contact mode is entered."),
    QT_TRANSLATE_NOOP("Parameters", "Closer than this to the nearest obstacle, contact mode begins."),
    QT_TRANSLATE_NOOP("Parameters", "Radius of the disc on the tangent plane in which contact samples are shot."),
    QT_TRANSLATE_NOOP("Planners", "Interactive BiRRT with contact"),
    QT_TRANSLATE_NOOP("Planners", "Interactive BiRRT"),
    QT_TRANSLATE_NOOP("Planners", "BiRRT"),
    QT_TRANSLATE_NOOP("Planners", "Interactive BiRRT, contact first"),
    QT_TRANSLATE_NOOP("Devices", "Keyboard and 6D mouse"),
    QT_TRANSLATE_NOOP("Devices", "Keyboard"),
    QT_TRANSLATE_NOOP("Devices", "Simulated expert"),
    QT_TRANSLATE_NOOP("Devices", "Simulated operator"),
    QT_TRANSLATE_NOOP("Devices", "Simulated novice"),
};

}  // namespace glissade
