#pragma once

#include <QCoreApplication>

namespace glissade {

/// Conditions that a verdict on a plan rests on (engine/check); see diagnostic_sentences.h.
inline constexpr const char* kCheckSentences[] = {
    QT_TRANSLATE_NOOP("Diagnostics", "clashes up to %1 are accepted (--accept-clashes %2)"),
    QT_TRANSLATE_NOOP("Diagnostics", "the hook of '%1' in '%2' bends by %3"),
    QT_TRANSLATE_NOOP("Diagnostics", "'%1' is flexible, so that its motion needs no proof"),
    QT_TRANSLATE_NOOP("Diagnostics", "no joints are used"),
    QT_TRANSLATE_NOOP("Diagnostics", "the joint of '%1' and '%2' is dissolved or pressed out"),
    QT_TRANSLATE_NOOP("Diagnostics", "%1 are one unit"),
    QT_TRANSLATE_NOOP("Diagnostics", "%1 stay as the base"),
    QT_TRANSLATE_NOOP("Diagnostics", "'%1' may leave before '%2', although the reverse is demanded"),
    QT_TRANSLATE_NOOP("Diagnostics", "'%1' may leave as number %2, although it is demanded as number %3"),
    QT_TRANSLATE_NOOP("Diagnostics",
                      "the thread of '%1' in '%2' has a pitch of %3, which no standard thread of %4 has"),
    QT_TRANSLATE_NOOP("Diagnostics", "the thread of '%1' in '%2' has a pitch of %3, although a person says %4"),
    QT_TRANSLATE_NOOP("Diagnostics", "the thread of '%1' in '%2' is left-handed"),
    QT_TRANSLATE_NOOP("Diagnostics", "the thread of '%1' in '%2' is right-handed, although a name says left-handed"),
};

}  // namespace glissade
