#pragma once

#include <cstdint>

#include <QString>

namespace glissade {

/// The unit in which the window writes lengths. "Fitting" is µm, mm or m, as it fits each length.
enum class LengthUnit { Fitting, Millimetres, Inches, Metres };

/// The unit of all lengths that the program writes. The program has one, as it has one default locale of Qt: the text
/// of a length must not depend on its writer. Read on any thread. Widgets learn of a change by QEvent::LocaleChange
/// (announceLengthUnit()).
LengthUnit lengthUnit();
void setLengthUnit(LengthUnit unit);
/// Lets all widgets write their lengths again. Called on the GUI thread only.
void announceLengthUnit();

/// The unit, in metres, of which round lengths are multiples: an inch if lengths are in inches, else a metre.
double roundLengthUnit();

/// A length in the selected unit, with three significant digits, as the user's language writes numbers: "3.21 µm",
/// "0.150 mm", "24.0 mm", "1.52 m". Every length that people read is written by this function, so that two texts of one
/// length never differ.
QString lengthText(double metres);

/// The text of a length in a column of lengths that are compared: all are in one unit. The fitting unit is millimetres
/// there.
QString columnLengthText(double metres);

/// A count, as the user's language writes numbers.
QString countText(std::uint64_t count);

/// The unit of a field for lengths that people type.
struct LengthField {
  QString unit;     ///< "mm"
  double perMetre;  ///< the number that the field shows for a length of one metre
  int decimals;
};

/// The unit of a field that has to show a difference of `finest` metres.
LengthField lengthField(double finest);

}  // namespace glissade
