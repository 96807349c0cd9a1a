#pragma once

#include <QCoreApplication>

namespace glissade {

/// Sentences on the evidence for joints, and on refused statements about joints (engine/product); see
/// diagnostic_sentences.h.
inline constexpr const char* kJointSentences[] = {
    QT_TRANSLATE_NOOP("Diagnostics", "a person says so"),
    QT_TRANSLATE_NOOP("Diagnostics", "a person says that it is pressed out"),
    QT_TRANSLATE_NOOP("Diagnostics", "a shaft of %1 with a head"),
    QT_TRANSLATE_NOOP("Diagnostics", "a shaft of %1 with a recess"),
    QT_TRANSLATE_NOOP("Diagnostics", "a shaft of %1"),
    QT_TRANSLATE_NOOP("Diagnostics", "with a head"),
    QT_TRANSLATE_NOOP("Diagnostics", "with a recess"),
    QT_TRANSLATE_NOOP("Diagnostics", "the shaft is thicker than the hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "a nut is on the shaft"),
    QT_TRANSLATE_NOOP("Diagnostics", "the sizes do not agree: a shaft of %1 in a nut %2"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says that it is a nut"),
    QT_TRANSLATE_NOOP("Diagnostics", "it has the width of a nut %1"),
    QT_TRANSLATE_NOOP("Diagnostics", "the file has no hole there, so the screw makes it"),
    QT_TRANSLATE_NOOP("Diagnostics", "it is thicker by as much as a thread"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says a left-hand thread"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says a left-hand thread, the shape is a right-hand one"),
    QT_TRANSLATE_NOOP("Diagnostics", "the hole is as wide as the shaft, and the farthest from the head"),
    QT_TRANSLATE_NOOP("Diagnostics", "the hole is the narrowest, and the farthest from the head"),
    QT_TRANSLATE_NOOP("Diagnostics", "the nut is free to be turned"),
    QT_TRANSLATE_NOOP("Diagnostics", "a nut with a hole of %1"),
    QT_TRANSLATE_NOOP("Diagnostics", "a shaft is in the hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "a ring in a hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "it is %1 thicker than its hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "a shaft of %1 is %2 thicker than the hole around it, as a thread is"),
    QT_TRANSLATE_NOOP("Diagnostics", "neither body is a screw or a nut by its shape"),
    QT_TRANSLATE_NOOP("Diagnostics", "a helix is modelled on it"),
    QT_TRANSLATE_NOOP("Diagnostics", "it is as wide as its hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "a thread is in it"),
    QT_TRANSLATE_NOOP("Diagnostics", "a pin in a hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "a shaft of %1 in a hole"),
    QT_TRANSLATE_NOOP("Diagnostics", "two rings with %1 balls between them"),
    QT_TRANSLATE_NOOP("Diagnostics", "two rings with %1 rollers between them"),
    QT_TRANSLATE_NOOP("Diagnostics", "two rings with %1 between them"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says '%1'"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says a thread of %1, the shape is %2"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says the drive '%1', the shape is '%2'"),
    QT_TRANSLATE_NOOP("Diagnostics", "the name says a drive of %1, the shape has %2"),
    QT_TRANSLATE_NOOP("Diagnostics", "the drive is that of the name"),
    QT_TRANSLATE_NOOP("Diagnostics", "the head has the proportions of ISO 4762"),
    QT_TRANSLATE_NOOP("Diagnostics", "the assembly is called '%1'"),
    QT_TRANSLATE_NOOP("Diagnostics", "its class is '%1'"),
    QT_TRANSLATE_NOOP("Diagnostics", "it is a ring of round section"),
    QT_TRANSLATE_NOOP("Diagnostics", "its hooks bend by %1 when it leaves along a line"),
    QT_TRANSLATE_NOOP("Diagnostics", "joints hold each other in a circle: %1"),
    QT_TRANSLATE_NOOP("Diagnostics", "'%1' names a standard that is not known"),
    QT_TRANSLATE_NOOP("Diagnostics", "'%1' is no designation of a standard part that is known"),
    QT_TRANSLATE_NOOP("Diagnostics", "Give one as 'ISO 4762 M3x8', 'DIN 934 M5' or 'M3x8 SHCS'."),
};

}  // namespace glissade
