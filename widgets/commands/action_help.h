#pragma once

#include <QString>

namespace glissade {

/// What "What's this?" says of an action: its name, its shortcut, its tip, and more where the tip is not enough. Rich
/// text.
QString actionHelp(const QString& id, const QString& text, const QString& keys, const QString& tip);

}  // namespace glissade
