#include "engine/files/path_exporter.h"

#include <algorithm>

#include "engine/base/file.h"
#include "engine/files/path_glb.h"
#include "engine/files/path_text.h"

namespace glissade {
namespace {

constexpr double kExact = 0.0;  // no error: numbers are written so that reading returns them bit by bit

template <class Choose>
Message inWords(const PathExporterRegistry& registry, const Choose& choose) {
  std::vector<Message> words;
  for (const PathExporter& exporter : registry.entries()) {
    if (!choose(exporter)) continue;
    std::string endings;
    for (const std::string& ending : exporter.endings) endings += (endings.empty() ? "." : ", .") + ending;
    words.push_back({GLISSADE_TEXT("%1 (%2)"), {exporter.label, endings}});
  }
  return joined(words, ", ");
}

}  // namespace

SaveResult PathExporter::write(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                               const std::string& file) const {
  if (path.points.empty()) {
    return notSaved(
        {ErrorKind::Usage, file, "", GLISSADE_TEXT("the path holds no configuration"), GLISSADE_TEXT("Give a path.")});
  }
  const auto text = content(path, scenario, provenance);
  if (!text) {
    Diagnostic why = text.error();
    why.file = file;
    return notSaved(why);
  }
  return saveFile(file, *text);
}

const PathExporter* PathExporterRegistry::find(std::string_view id) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.id == id; });
  return found == entries_.end() ? nullptr : &*found;
}

Result<PathExporter> PathExporterRegistry::forFile(const std::string& file) const {
  const std::string ending = endingOf(file);
  for (const PathExporter& exporter : entries_) {
    const auto& endings = exporter.endings;
    if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return exporter;
  }
  const Message reason = ending.empty()
                             ? GLISSADE_TEXT("has no ending that says in which format the path is to be written")
                             : Message(GLISSADE_TEXT("paths are not written as '.%1'"), {ending});
  return Diagnostic{ErrorKind::Usage, file, "", reason, {GLISSADE_TEXT("Choose one of: %1."), {formats()}}};
}

Message PathExporterRegistry::formats() const {
  return inWords(*this, [](const PathExporter&) { return true; });
}

Message PathExporterRegistry::readableFormats() const {
  return inWords(*this, [](const PathExporter& exporter) { return exporter.readBackError.has_value(); });
}

PathExporterRegistry makePathExporterRegistry() {
  PathExporterRegistry registry;
  registry.add({"csv", {"csv"}, GLISSADE_TEXT("Table"), true, kExact, pathAsCsv});
  registry.add({"json", {"json"}, GLISSADE_TEXT("With provenance"), true, kExact, pathAsJson});
  registry.add({"ompl", {"path"}, GLISSADE_TEXT("OMPL columns"), false, kExact, pathAsOmpl});
  registry.add({"glb", {"glb"}, GLISSADE_TEXT("Animation"), true, std::nullopt, pathAsGlb});
  return registry;
}

Result<PathExporter> pathExporterFor(const std::string& file) { return makePathExporterRegistry().forFile(file); }

SaveResult writePath(const Path& path, const LoadedScenario& scenario, const PathProvenance& provenance,
                     const std::string& file) {
  const auto exporter = pathExporterFor(file);
  if (!exporter) return notSaved(exporter.error());
  return exporter->write(path, scenario, provenance, file);
}

Message writablePathFormats() { return makePathExporterRegistry().formats(); }

Message readablePathFormats() { return makePathExporterRegistry().readableFormats(); }

}  // namespace glissade
