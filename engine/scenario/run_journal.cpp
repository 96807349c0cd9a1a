#include "engine/scenario/run_journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "engine/scenario/run_record_json.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using Json = JsonCursor::Json;

constexpr const char* kEnding = ".journal";
/// Every journal begins with this, and no record does: its text begins with a line break after "{".
constexpr const char* kFirst = R"({"format":"glissade-run",)";

Diagnostic failed(const std::string& file, const std::string& what) {
  return {ErrorKind::Internal, file, "", what + ": " + std::strerror(errno), "The run is not recorded on disk."};
}

/// Nobody holds it open for writing.
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
  if (descriptor < 0) return failed(folder, "the folder refuses a new file");
  std::unique_ptr<RunJournal> journal(new RunJournal(descriptor, file));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return failed(file, "cannot be locked");
  Json head = headToJson(record);
  addEvents({}, head);
  const Outcome written = journal->write(head.dump());
  if (!written) return written.error();
  return journal;
}

RunJournal::~RunJournal() { ::close(descriptor_); }

Outcome RunJournal::append(const RunLog& part) {
  Json events;
  addEvents(part, events);
  return write(events.dump());
}

void RunJournal::discard() { ::unlink(file_.c_str()); }

Outcome RunJournal::write(const std::string& line) {
  const std::string text = line + "\n";
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(descriptor_, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return failed(file_, "cannot be written");
    done += static_cast<std::size_t>(count);
  }
  return Done{};
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

Outcome saveJournal(const std::string& journal, const std::string& target, const WorkWatch& watch) {
  const auto record = readRunRecord(journal, watch);
  if (!record) return record.error();
  const Outcome written = writeRunRecord(*record, target);
  if (written) ::unlink(journal.c_str());
  return written;
}

bool isJournal(const std::string& text) { return text.rfind(kFirst, 0) == 0; }

Result<Json> mergedJournal(const std::string& text, const std::string& file, const WorkWatch& watch) {
  Json record;
  for (std::size_t begin = 0; begin < text.size();) {
    if (watch.stop.stopRequested()) return notReadToItsEnd(file);
    watch.report(static_cast<double>(begin) / static_cast<double>(text.size()));
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos && !record.is_null()) break;  // cut off
    auto line = parseJson(text.substr(begin, end - begin), file);
    if (!line) return line.error();
    begin = end == std::string::npos ? text.size() : end + 1;
    if (record.is_null()) {
      record = std::move(*line);
      continue;
    }
    if (!line->is_object()) {
      return Diagnostic{ErrorKind::MalformedInput, file, "", "holds a line that is no object", "Correct the file."};
    }
    for (auto& item : line->items()) {
      Json& known = record[item.key()];
      if (known.is_array() && item.value().is_array()) {
        for (Json& entry : item.value()) known.push_back(std::move(entry));
      } else if (!item.value().is_null()) {
        known = std::move(item.value());
      }
    }
  }
  return record;
}

}  // namespace glissade
