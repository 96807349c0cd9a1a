#pragma once

#include <QString>

#include <optional>

#include "engine/sequence/work_times.h"

namespace glissade {

/// Name in the language of the window, such as "Fetch a small part".
QString workTimeName(const WorkTimeRow& row);
/// Unit: "s", "m" or "kg".
QString workTimeUnit(const WorkTimeRow& row);
/// The default ("Default: 2.7 s"), its source, and the range.
QString workTimeHelp(const WorkTimeRow& row);

/// The number with all its digits and the decimal sign of the language, without signs between thousands.
QString workTimeText(double value);
/// The number that the text states; a decimal point is understood in every language. Nothing: it is no number.
std::optional<double> workTimeIn(const QString& text);

}  // namespace glissade
