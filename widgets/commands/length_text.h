#pragma once

#include <QString>

namespace glissade {

/// The unit in which the window writes lengths. "Fitting" is µm, mm or m, as it fits each length.
enum class LengthUnit { Fitting, Millimetres, Inches, Metres };

/// The unit of all lengths that the program writes. It is one for the program, as Qt's default locale is: a text of a
/// length must not depend on who writes it. Read on any thread. Widgets learn of a change by QEvent::LocaleChange
/// (announceLengthUnit()).
LengthUnit lengthUnit();
void setLengthUnit(LengthUnit unit);
/// Lets all widgets write their lengths again. GUI thread only.
void announceLengthUnit();

/// Metres: round lengths are round numbers of this. An inch where lengths are in inches, else a metre.
double roundLengthUnit();

/// A length in the unit that was chosen, with three significant digits, as the user's language writes numbers:
/// "3.21 µm", "0.150 mm", "24.0 mm", "1.52 m". Every length that people read is written by this function, so that two
/// texts of one length never differ.
QString lengthText(double metres);

/// The same for a column of lengths, which are compared: all are in one unit. Where the unit is chosen as it fits, that
/// is millimetres.
QString columnLengthText(double metres);

/// How a field shows a length that people type.
struct LengthField {
  QString unit;     ///< "mm"
  double perMetre;  ///< what is shown of a length of one metre
  int decimals;
};

/// For a field in which a difference of `finest` metres is seen.
LengthField lengthField(double finest);

}  // namespace glissade
