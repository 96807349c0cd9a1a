#include "engine/files/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "engine/base/file.h"
#include "engine/base/limits.h"
#include "engine/files/asset_path.h"
#include "engine/files/scenario_io.h"
#include "engine/import/json_checksum.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using Json = JsonCursor::Json;

constexpr const char* kLockEnding = ".lock";
constexpr const char* kEditsEnding = ".edits";
constexpr const char* kEditsFormat = "glissade-unsaved-edits";

Diagnostic unusable(const std::string& folder, CatalogueText what) {
  return {ErrorKind::Unwritable,
          folder,
          "",
          {GLISSADE_TEXT("%1: %2"), {what, std::strerror(errno)}},
          GLISSADE_TEXT("Edits are not saved automatically.")};
}

/// True if the file still exists. Another program may have removed it as abandoned before it was locked.
bool isThere(const Descriptor& file) {
  struct stat status {};
  return ::fstat(file.get(), &status) == 0 && status.st_nlink > 0;
}

void removeFiles(const std::string& base) {
  ::unlink((base + kEditsEnding).c_str());
  ::unlink((base + kLockEnding).c_str());
}

std::string textOf(const UnsavedEdits& edits, const std::string& base) {
  const Scenario here = movedTo(base + kEditsEnding, edits.scenario, edits.file.empty() ? "./x" : edits.file);
  Json json{{"format", kEditsFormat}, {"version", 1}, {"file", edits.file}, {"sha256", edits.sha256}};
  json["scenario"] = Json::parse(writeScenario(here));
  addChecksum(json);
  return jsonText(json) + "\n";
}

}  // namespace

Result<std::unique_ptr<AutosaveSlot>> AutosaveSlot::make(const std::string& folder) {
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  constexpr int kMostTries = 100;
  for (int tries = 0; tries < kMostTries; ++tries) {
    std::string name = (fs::path(folder) / "edits-XXXXXX").string() + kLockEnding;
    const auto endingLength = std::strlen(kLockEnding);
    Descriptor lock(::mkostemps(name.data(), static_cast<int>(endingLength), O_CLOEXEC));
    if (!lock.valid()) return unusable(folder, GLISSADE_TEXT("the folder takes no new file"));
    if (::flock(lock.get(), LOCK_EX | LOCK_NB) == 0 && isThere(lock)) {
      name.resize(name.size() - endingLength);
      return std::unique_ptr<AutosaveSlot>(new AutosaveSlot(std::move(lock), std::move(name)));
    }
  }
  return unusable(folder, GLISSADE_TEXT("the new file cannot be locked"));
}

AutosaveSlot::~AutosaveSlot() { removeFiles(base_); }

Outcome AutosaveSlot::write(const UnsavedEdits& edits) {
  return writeFileAtomically(base_ + kEditsEnding, textOf(edits, base_));
}

void AutosaveSlot::clear() { ::unlink((base_ + kEditsEnding).c_str()); }

std::string AbandonedEdits::file() const { return base_ + kEditsEnding; }

Result<UnsavedEdits> AbandonedEdits::read() const {
  const auto text = readFile(file(), limits::kMostScenarioBytes);
  if (!text) return text.error();
  auto document = parseJson(*text, file());
  if (!document) return document.error();
  if (takeChecksum(*document) != ChecksumState::Right) {
    return wrongChecksum(file(), GLISSADE_TEXT("The edits cannot be restored."));
  }
  try {
    const JsonCursor root(*document, file(), "");
    if (root.at("format").text() != kEditsFormat)
      root.at("format").fail(GLISSADE_TEXT("is not unsaved edits of Glissade"));
    if (root.at("version").wholeNumber() != 1)
      root.at("version").fail(GLISSADE_TEXT("is not 1"), GLISSADE_TEXT("Use a newer Glissade."));
    auto scenario = parseScenario(root.at("scenario").json().dump(), file());
    if (!scenario) return scenario.error();
    UnsavedEdits edits{root.at("file").text(), root.at("sha256").text(), {}};
    edits.scenario = movedTo(edits.file.empty() ? "./x" : edits.file, std::move(*scenario), file());
    return edits;
  } catch (const JsonError& error) {
    return error.diagnostic;
  }
}

std::time_t AbandonedEdits::time() const {
  struct stat status {};
  return ::stat(file().c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

void AbandonedEdits::remove() { removeFiles(base_); }

std::vector<AbandonedEdits> findAbandonedEdits(const std::string& folder) {
  std::vector<AbandonedEdits> found;
  std::error_code trouble;
  for (fs::directory_iterator at(folder, trouble), end; !trouble && at != end; at.increment(trouble)) {
    if (at->path().extension() != kLockEnding) continue;
    const std::string base = (at->path().parent_path() / at->path().stem()).string();
    Descriptor lock(::open(at->path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!lock.valid() || ::flock(lock.get(), LOCK_EX | LOCK_NB) != 0) continue;
    if (::access((base + kEditsEnding).c_str(), F_OK) == 0) {
      found.emplace_back(std::move(lock), base);
    } else {
      removeFiles(base);  // left by a killed program that had no unsaved edits
    }
  }
  std::sort(found.begin(), found.end(),
            [](const AbandonedEdits& a, const AbandonedEdits& b) { return a.time() > b.time(); });
  return found;
}

}  // namespace glissade
