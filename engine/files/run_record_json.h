#pragma once

#include "engine/base/json_formats.h"
#include "engine/files/run_record.h"

namespace glissade {

/// A run record of version 2 as JSON. Private to the readers and writers of this folder. Reading throws JsonError.
extern template struct ObjectFormat<RunRecord>;
/// The events of a log, without its start: a line of a journal.
extern template struct ObjectFormat<RunLog>;
extern template struct ObjectFormat<RunRecord::Loss>;

/// Reads a record of version 1 or 2 and empties its stream of hand poses. Throws JsonError.
RunRecord readRecord(JsonCursor::Json& document, const std::string& file, const WorkWatch& watch);

/// isJournal() is true if a text is a journal. mergedJournal() returns its lines as one record. Damaged lines are left
/// out and counted as a loss; a damaged first line is an error, because the others depend on it.
bool isJournal(const std::string& text);
Result<JsonCursor::Json> mergedJournal(const std::string& text, const std::string& file, const WorkWatch& watch);

}  // namespace glissade
