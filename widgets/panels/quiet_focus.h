#pragma once

#include <QAbstractItemView>

namespace glissade {

/// A view without a current row makes its first row the current one when it gets the focus. With this it does so only
/// for a person who goes to the view with Tab or a shortcut, and not when a dialog or another window closes: nobody has
/// chosen a row then.
void keepUnchosen(QAbstractItemView& view);

}  // namespace glissade
