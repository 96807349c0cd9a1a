#pragma once

#include <QAbstractItemView>

namespace glissade {

/// A view without a current row makes its first row current when it gets the focus. This function limits that to a
/// person who goes to the view with Tab or a shortcut. When a dialog or another window closes, no row becomes current.
void keepUnchosen(QAbstractItemView& view);

}  // namespace glissade
