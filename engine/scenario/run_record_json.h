#pragma once

#include "engine/base/json_reader.h"
#include "engine/scenario/run_record.h"

namespace glissade {

/// A run record as JSON. Private to the readers and writers of this room. Reading throws JsonError.
/// What a record says before anything happened; then what happened (of a log, or a part of one).
JsonCursor::Json headToJson(const RunRecord& record);
void addEvents(const RunLog& log, JsonCursor::Json& json);
void addLoss(const std::optional<RunRecord::Loss>& loss, JsonCursor::Json& json);
RunRecord readRecord(const JsonCursor& root, const WorkWatch& watch);

/// Whether a text is a journal, and its lines as one record. Damaged lines are left out and counted as a loss;
/// without the first line the others say nothing.
bool isJournal(const std::string& text);
Result<JsonCursor::Json> mergedJournal(const std::string& text, const std::string& file, const WorkWatch& watch);

}  // namespace glissade
