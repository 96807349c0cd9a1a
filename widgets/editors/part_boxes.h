#pragma once

#include <QComboBox>
#include <string>

namespace glissade {

// Boxes of the rows of PartsDialog. `part` is for who hears them. The wheel scrolls the table instead of changing what
// it happens to be over.

QComboBox* makeRoleBox(const QString& part, bool mayMove);
QComboBox* makeUnitBox(const QString& part);
QComboBox* makeUpBox(const QString& part);

/// Says that the file itself states both; nobody may choose them. Each STEP file has a unit of its own.
void leaveToFile(const std::string& file, QComboBox& unit, QComboBox& up);

/// Room about a box, which has to be filled: the column is measured with it.
QWidget* cellOf(QComboBox* box);

}  // namespace glissade
