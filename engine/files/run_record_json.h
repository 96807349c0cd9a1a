#pragma once

#include "engine/base/json_reader.h"
#include "engine/files/run_record.h"

namespace glissade {

/// A run record as JSON. Private to the readers and writers of this folder. Reading throws JsonError. The head holds
/// the state before the run; the events are those of a log, or of a part of one.
JsonCursor::Json headToJson(const RunRecord& record);
void addEvents(const RunLog& log, JsonCursor::Json& json);
void addLoss(const std::optional<RunRecord::Loss>& loss, JsonCursor::Json& json);
RunRecord readRecord(const JsonCursor& root, const WorkWatch& watch);

/// isJournal() is true if a text is a journal. mergedJournal() returns its lines as one record. Damaged lines are left
/// out and counted as a loss; a damaged first line is an error, because the others depend on it.
bool isJournal(const std::string& text);
Result<JsonCursor::Json> mergedJournal(const std::string& text, const std::string& file, const WorkWatch& watch);

}  // namespace glissade
