#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QString>

namespace glissade {

/// The unit in which the window writes lengths.
enum class LengthUnit { Millimetres, Inches, Metres };

/// The unit of all lengths that the program writes. The program has one, as it has one default locale of Qt: the text
/// of a length must not depend on its writer. Read on any thread. Widgets learn of a change by QEvent::LocaleChange
/// (announceLengthUnit()).
LengthUnit lengthUnit();
void setLengthUnit(LengthUnit unit);
/// The unit that the user has chosen for all scenarios; nothing: it follows the scenario. Called on the GUI thread
/// only.
void setPreferredLengthUnit(std::optional<LengthUnit> unit);
/// The unit in which lengths of a file are shown before a scenario is made of it. `unitOfFile`: metres; 0: the file
/// states none. Called on the GUI thread only.
LengthUnit lengthUnitFor(double unitOfFile);
/// Lets all widgets write their lengths again. Called on the GUI thread only.
void announceLengthUnit();

/// The unit, in metres, of which round lengths are multiples: an inch if lengths are in inches, else a metre.
double roundLengthUnit();

/// A length in the unit of the program, with three significant digits, as the user's language writes numbers:
/// "0.150 mm", "24.0 mm". A length that would need many decimals is in the next smaller unit: "3.21 µm". Every length
/// that people read is written by this function, so that two texts of one length never differ.
QString lengthText(double metres);

/// Lengths of one thing in one unit, with the decimals that lengthText() gives the largest: "40.0 × 12.5 × 3.0 mm".
QString lengthsText(const std::vector<double>& metres, const QString& separator, LengthUnit unit = lengthUnit());

/// The text of a small length (gap, clearance, allowance, thread) in a column, where all are in one unit: inches if the
/// program's unit is inches, else millimetres. A length that would be written as 0 is a limit: "<0.0001 mm".
QString columnLengthText(double metres);

/// Writes the lengths of one plot in one unit: the largest one, not above that of the program, in which the least
/// length is no less than a thousandth.
class PlotLengths {
 public:
  explicit PlotLengths(double least);

  /// With three significant digits, if they need no more than four decimals.
  QString text(double metres) const;
  /// The text of a power of ten of the unit, without zeros at the end: "0.01 mm", "10 mm".
  QString mark(double metres) const;

 private:
  QString written(double metres, int decimals) const;

  QString unit_;
  double metres_;  ///< of the unit
};

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

/// The unit of a field whose usual length is shown in the unit of lengthText(), with one more digit if it has room.
LengthField usualLengthField(double usual);

}  // namespace glissade
