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
    QT_TRANSLATE_NOOP("Planners", "G: geometry"),
    QT_TRANSLATE_NOOP("Planners", "GT: and topology"),
    QT_TRANSLATE_NOOP("Planners", "GTS1: and semantics, same shape"),
    QT_TRANSLATE_NOOP("Planners", "GTS2: and semantics, compatible"),
    QT_TRANSLATE_NOOP("Planners", "GTS: in a loop, with scores"),
    QT_TRANSLATE_NOOP("Planners", "Own rules"),
    QT_TRANSLATE_NOOP("Planners", "OMPL: RRT-Connect"),
    QT_TRANSLATE_NOOP("Planners", "OMPL: BKPIECE"),
    QT_TRANSLATE_NOOP("Planners", "OMPL: PRM"),
    QT_TRANSLATE_NOOP("Planners", "OMPL: EST"),
    QT_TRANSLATE_NOOP("Planners", "Automatic"),
    QT_TRANSLATE_NOOP("PlaceIdentifiers", "Region growing"),
    QT_TRANSLATE_NOOP("PlaceIdentifiers", "Watershed"),
    QT_TRANSLATE_NOOP("Attributes", "Complexity"),
    QT_TRANSLATE_NOOP("Attributes", "Cluttered"),
    QT_TRANSLATE_NOOP("Attributes", "Narrowness"),
    QT_TRANSLATE_NOOP("Attributes", "Shape"),
    QT_TRANSLATE_NOOP("Attributes", "Compatibility"),
    QT_TRANSLATE_NOOP("Attributes", "Forbidden"),
    QT_TRANSLATE_NOOP("Attributes", "Preference"),
    QT_TRANSLATE_NOOP("Attributes", "Mobility"),
    QT_TRANSLATE_NOOP("Attributes",
                      "How hard the place is to cross: 1 for the widest, one more each time the width halves."),
    QT_TRANSLATE_NOOP("Attributes", "Mobile bodies are in the place."),
    QT_TRANSLATE_NOOP("Attributes", "Diameter of the largest ball that fits at the widest spot."),
    QT_TRANSLATE_NOOP("Attributes", "Shape of the place's section, as the objects' shapes are called."),
    QT_TRANSLATE_NOOP("Attributes", "Whether the object goes through: 0 not at all, from 0.5 on it fits, 1 with ease."),
    QT_TRANSLATE_NOOP("Attributes", "No path may lead through the place."),
    QT_TRANSLATE_NOOP("Attributes", "Ways through the place count this many times shorter."),
    QT_TRANSLATE_NOOP("Attributes", "Static bodies shape the places; mobile ones clutter them."),
    QT_TRANSLATE_NOOP("Attributes", "What the body is shaped like."),
    QT_TRANSLATE_NOOP("Devices", "By hand"),
    QT_TRANSLATE_NOOP("Devices", "Keyboard"),
    QT_TRANSLATE_NOOP("Devices", "6D mouse"),
    QT_TRANSLATE_NOOP("Devices", "Gamepad"),
    QT_TRANSLATE_NOOP("Devices", "Simulated expert"),
    QT_TRANSLATE_NOOP("Devices", "Simulated operator"),
    QT_TRANSLATE_NOOP("Devices", "Simulated novice"),
    QT_TRANSLATE_NOOP("Presets", "Standard"),
    QT_TRANSLATE_NOOP("Presets", "As in CAD"),
    QT_TRANSLATE_NOOP("Presets", "Beginner"),
    QT_TRANSLATE_NOOP("Presets", "Precise"),
    QT_TRANSLATE_NOOP("Presets", "Flight"),
};

}  // namespace glissade
