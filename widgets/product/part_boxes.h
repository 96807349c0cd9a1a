#pragma once

#include <QComboBox>
#include <string>

namespace glissade {

// Boxes of the rows of PartsDialog. `part` is the name that screen readers say. The wheel scrolls the table instead of
// changing the box under the pointer.

QComboBox* makeRoleBox(const QString& part, bool mayMove);
QComboBox* makeUnitBox(const QString& part);
QComboBox* makeUpBox(const QString& part);

/// Shows that the file itself states unit and axis, and disables the boxes. Each STEP file has its own unit.
void showUnitOfFile(const std::string& file, QComboBox& unit, QComboBox& up);

/// Puts the box into a widget with a margin, which must be filled: the column is measured with it.
QWidget* cellOf(QComboBox* box);

}  // namespace glissade
