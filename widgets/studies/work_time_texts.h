#pragma once

#include <QString>

#include <optional>

#include "engine/sequence/work_times.h"

namespace glissade {

/// "Fetch a small part", in the language of the window.
QString workTimeName(const WorkTimeRow& row);
/// "s", "m" or "kg".
QString workTimeUnit(const WorkTimeRow& row);
/// "Default: 2.7 s", where it comes from, and the range.
QString workTimeHelp(const WorkTimeRow& row);

/// The number with the decimal sign of the language, without signs between thousands; all its digits.
QString workTimeText(double value);
/// The same back; a decimal point is understood in every language. Nothing: it is no number.
std::optional<double> workTimeIn(const QString& text);

}  // namespace glissade
