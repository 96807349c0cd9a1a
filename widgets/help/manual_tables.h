#pragma once

#include <QString>

#include "widgets/help/manual_facts.h"

namespace glissade {

/// The tables that the manual takes from the program, as HTML: "actions", "steering", "panels", "parameters",
/// "strategies", "operators", "attributes", "path-formats". Null if there is no such table.
QString manualTable(const QString& name, const ManualFacts& facts);

}  // namespace glissade
