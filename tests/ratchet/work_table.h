#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "tests/ratchet/work.h"

namespace glissade::ratchet {

/// The table as CSV: a row for each case, sorted by family, name and seed.
std::string writeTable(std::vector<WorkRow> rows);

/// Errors: MalformedInput with the line.
Result<std::vector<WorkRow>> readTable(const std::string& text, const std::string& file);

/// A family's geometric mean may rise by this factor, and a single case by the larger one.
inline constexpr double kMostOfFamily = 1.05;
inline constexpr double kMostOfCase = 1.5;

/// One sentence for each value that has risen by more than its limit, for each case of `now` without a row in `before`,
/// and for each row with other measures. Rows of `before` that were not carried out are ignored.
std::vector<std::string> risen(const std::vector<WorkRow>& before, const std::vector<WorkRow>& now);

/// The table after a change: rows whose values differ are replaced and carry the reason, new ones are added.
std::vector<WorkRow> recorded(const std::vector<WorkRow>& before, const std::vector<WorkRow>& now,
                              const std::string& reason);

}  // namespace glissade::ratchet
