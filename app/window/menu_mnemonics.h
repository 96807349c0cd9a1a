#pragma once

#include <QMenu>

namespace glissade {

/// The letter after the '&' of a text, in lower case; null where there is none.
QChar mnemonicOf(const QString& text);

/// Gives the entries without a mnemonic the first letter of theirs that no other entry of the menu has.
void addMnemonics(const QMenu& menu);

}  // namespace glissade
