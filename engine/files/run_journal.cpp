#include "engine/files/run_journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "engine/base/descriptor.h"
#include "engine/files/run_record_json.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using Json = JsonCursor::Json;

constexpr const char* kEnding = ".journal";
/// Every journal begins with this text, and no record does: a record has a line break after "{".
constexpr const char* kFirst = R"({"format":"glissade-run",)";

Diagnostic failed(const std::string& file, CatalogueText what) {
  return {ErrorKind::Unwritable,
          file,
          "",
          {GLISSADE_TEXT("%1: %2"), {what, std::strerror(errno)}},
          GLISSADE_TEXT("The run is not recorded on disk.")};
}

std::string withChecksum(Json line) {
  addChecksum(line);
  return jsonText(line) + "\n";
}

/// The largest step that occurs in a record.
std::uint64_t lastStepOf(const Json& record) {
  std::uint64_t last = 0;
  const auto look = [&](const Json& step) {
    if (step.is_number_unsigned()) last = std::max(last, step.get<std::uint64_t>());
  };
  for (const auto& item : record.items()) {
    if (!item.value().is_array() || item.value().empty()) continue;
    const Json& entry = item.value().back();
    if (entry.is_array() && !entry.empty()) look(entry.front());
    if (entry.is_object() && entry.contains("step")) look(entry["step"]);
  }
  return last;
}

/// Merges the lines of a journal. Lines of earlier versions have no checksum.
class JournalMerger {
 public:
  explicit JournalMerger(std::string file) : file_(std::move(file)) {}

  /// Errors: the first line is damaged, or the reading was stopped.
  Outcome add(const std::string& text, const StopToken& stop) {
    auto line = parseJson(text, file_, {stop}, valuesLeft_);
    if (!line && line.error().kind == ErrorKind::Interrupted) return line.error();
    const ChecksumState checksum = line ? takeChecksum(*line) : ChecksumState::Wrong;
    const bool whole =
        line && line->is_object() && checksum != ChecksumState::Wrong && (record_.is_null() || checksum == ofHead_);
    if (record_.is_null()) return begin(line, whole, checksum);
    if (whole && hasOnlyKnownKeys(*line)) {
      append(*line);
    } else {
      if (!loss_) loss_ = RunRecord::Loss{0, lastStepOf(record_)};
      ++loss_->lines;
    }
    return Done{};
  }

  Json record() && {
    if (loss_) record_["lost"] = kObject<RunRecord::Loss>.write(*loss_);
    return std::move(record_);
  }

 private:
  Outcome begin(Result<Json>& line, bool whole, ChecksumState checksum) {
    if (!whole) {
      return Diagnostic{ErrorKind::MalformedInput,
                        file_,
                        {GLISSADE_TEXT("line %1"), {1}},
                        GLISSADE_TEXT("is damaged, and names the scenario and the settings of the run"),
                        GLISSADE_TEXT("Use an undamaged copy.")};
    }
    record_ = std::move(*line);
    ofHead_ = checksum;
    return Done{};
  }

  /// False for a line with other keys, which no journal has even if its checksum is correct. Merging many such keys
  /// would take hours.
  bool hasOnlyKnownKeys(const Json& line) const {
    const auto items = line.items();
    return std::all_of(items.begin(), items.end(), [this](const auto& item) { return record_.contains(item.key()); });
  }

  void append(Json& line) {
    for (auto& item : line.items()) {
      Json& known = record_[item.key()];
      if (known.is_array() && item.value().is_array()) {
        for (Json& entry : item.value()) known.push_back(std::move(entry));
      } else if (!item.value().is_null()) {
        known = std::move(item.value());
      }
    }
  }

  std::string file_;
  std::size_t valuesLeft_ = kMostJsonValues;
  Json record_;
  ChecksumState ofHead_ = ChecksumState::Missing;
  std::optional<RunRecord::Loss> loss_;
};

/// True if no program holds the file open for writing.
bool isAbandoned(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return free;
}

}  // namespace

Result<std::unique_ptr<RunJournal>> RunJournal::begin(const RunRecord& record, const std::string& folder) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  std::string file = (fs::path(folder) / "run-XXXXXX").string() + kEnding;
  const int descriptor = ::mkostemps(file.data(), static_cast<int>(std::strlen(kEnding)), O_CLOEXEC | O_APPEND);
  if (descriptor < 0) return failed(folder, GLISSADE_TEXT("the folder refuses a new file"));
  std::unique_ptr<RunJournal> journal(new RunJournal(descriptor, file));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return failed(file, GLISSADE_TEXT("cannot be locked"));
  RunRecord head = record;
  head.log = RunLog{};
  head.log.start = record.log.start;
  head.loss.reset();
  const Outcome written = journal->writeLine(withChecksum(kObject<RunRecord>.write(head)));
  if (!written) return written.error();
  return journal;
}

RunJournal::~RunJournal() { ::close(descriptor_); }

Outcome RunJournal::append(const RunLog& part) { return writeLine(withChecksum(kObject<RunLog>.write(part))); }

void RunJournal::discard() { ::unlink(file_.c_str()); }

Outcome RunJournal::writeLine(const std::string& line) {
  const bool written = writeAll(descriptor_, line) && ::fdatasync(descriptor_) == 0;
  if (written) {
    size_ += static_cast<long>(line.size());
    return Done{};
  }
  const Diagnostic why = failed(file_, GLISSADE_TEXT("cannot be written"));
  (void)::ftruncate(descriptor_, size_);  // removes the partial line, so that the next line does not continue it
  return why;
}

std::vector<std::string> abandonedJournals(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code trouble;
  for (const auto& entry : fs::directory_iterator(folder, trouble)) {
    const bool journal = entry.path().extension() == kEnding && entry.is_regular_file(trouble);
    if (journal && isAbandoned(entry.path())) found.emplace_back(entry.last_write_time(trouble), entry.path().string());
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> files;
  for (auto& [time, file] : found) files.push_back(std::move(file));
  return files;
}

SaveResult saveJournal(const std::string& journal, const std::string& target, const WorkWatch& watch) {
  const auto record = readRunRecord(journal, watch);
  if (!record) return notSaved(record.error());
  SaveResult saved = writeRunRecord(*record, target);
  if (saved) ::unlink(journal.c_str());
  return saved;
}

bool isJournal(const std::string& text) { return text.rfind(kFirst, 0) == 0; }

Result<Json> mergedJournal(const std::string& text, const std::string& file, const WorkWatch& watch) {
  JournalMerger merger(file);
  for (std::size_t begin = 0; begin < text.size();) {
    if (watch.stop.stopRequested()) return readingStopped(file);
    watch.report(static_cast<double>(begin) / static_cast<double>(text.size()));
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const Outcome added = merger.add(text.substr(begin, end - begin), watch.stop);
    if (!added) return added.error();
    begin = end + 1;
  }
  return std::move(merger).record();
}

}  // namespace glissade
