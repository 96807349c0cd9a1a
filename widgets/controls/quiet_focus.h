#pragma once

#include <QAbstractItemView>

namespace glissade {

/// A view without a current row makes its first row current when it gets the focus. This function prevents that if the
/// view gets the focus because a dialog, a popup or another window has closed.
void keepUnchosen(QAbstractItemView& view);

}  // namespace glissade
