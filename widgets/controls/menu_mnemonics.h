#pragma once

#include <QMenu>

namespace glissade {

/// The letter after the '&' of a text, in lower case; null if there is none.
QChar mnemonicOf(const QString& text);

/// Adds a mnemonic to each entry without one: its first letter that no other entry of the menu uses.
void addMnemonics(const QMenu& menu);

}  // namespace glissade
