#include "engine/study/study_page.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "engine/base/child_process.h"
#include "engine/study/study_tables.h"

namespace glissade {
namespace {

namespace fs = std::filesystem;

/// Debian's Python, for which its packages are installed. The variable GLISSADE_PYTHON names another one.
constexpr const char* kPython = "/usr/bin/python3";
/// Folder of the scripts in an installation, from the programs (packaging/install).
constexpr const char* kInstalledScripts = "../../share/glissade/samples/studies";
/// Levels to search upwards: the program is in build/PRESET/bin of the source tree.
constexpr int kMostLevelsUp = 5;
/// Exit code of the scripts where a module of Python is not installed (samples/studies/script.py).
constexpr int kExitModuleMissing = 69;

/// The file of a script; empty where it is not found.
std::string fileOfScript(const std::string& script) {
  std::error_code ignored;
  fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const fs::path installed = (folder / kInstalledScripts / script).lexically_normal();
  if (fs::exists(installed, ignored)) return installed.string();
  for (int level = 0; level < kMostLevelsUp && folder.has_relative_path(); ++level) {
    folder = folder.parent_path();
    const fs::path inSources = folder / "samples/studies" / script;
    if (fs::exists(inSources, ignored)) return inSources.string();
  }
  return "";
}

/// The user's environment, with home, caches and module paths. Python leaves no compiled files beside the scripts.
std::vector<std::string> environmentOfPython() {
  std::vector<std::string> variables{"PYTHONDONTWRITEBYTECODE=1"};
  for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  return variables;
}

std::string lastLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

/// Adds the warnings that a script has printed; other lines are those of Python's modules.
void addWarnings(const std::string& errors, Warnings& warnings) {
  const std::string mark = "warning: ";
  std::istringstream lines(errors);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(mark)) continue;
    warnings.push_back({ErrorKind::MalformedInput, "", "", Message(line.substr(mark.size())), {}});
  }
}

/// The error of a script that has failed, in its own words.
Diagnostic failureOf(const std::string& script, const ChildEnd& end) {
  if (end.ending == ChildEnding::Stopped) {
    return {ErrorKind::Interrupted, script, "", GLISSADE_TEXT("was stopped"), {}};
  }
  const Message said(lastLine(end.errors));
  if (end.exitCode == kExitModuleMissing) {
    return {ErrorKind::MalformedInput,
            script,
            "",
            {GLISSADE_TEXT("needs a module of Python that is not installed: %1"), {said}},
            GLISSADE_TEXT("Install it, or name a Python that has it by GLISSADE_PYTHON.")};
  }
  if (end.exitCode == exitCode(ErrorKind::MalformedInput)) {
    return {ErrorKind::MalformedInput, "", "", said, {}};
  }
  return {ErrorKind::Internal, script, "", {GLISSADE_TEXT("has failed: %1"), {said}}, {}};
}

/// Runs a script for a folder. Returns the file that it wrote.
Result<std::string> runScript(const std::string& script, const std::string& folder, const PageOptions& options,
                              Warnings& warnings, const StopToken& stop) {
  const char* const chosen = std::getenv("GLISSADE_PYTHON");
  ChildCommand command;
  command.program = chosen != nullptr ? chosen : kPython;
  if (access(command.program.c_str(), X_OK) != 0) {
    return Diagnostic{ErrorKind::MalformedInput, command.program, "",
                      GLISSADE_TEXT("is not there; pages of studies are written by Python"),
                      GLISSADE_TEXT("Install it (apt install python3-matplotlib), or name it by GLISSADE_PYTHON.")};
  }
  const std::string file = fileOfScript(script);
  if (file.empty()) {
    return Diagnostic{ErrorKind::MalformedInput, script, "",
                      GLISSADE_TEXT("is not found in the samples/studies of the program"),
                      GLISSADE_TEXT("Install Glissade as a whole.")};
  }
  command.arguments = {file, "--language", code(options.language)};
  if (!options.out.empty()) command.arguments.insert(command.arguments.end(), {"--out", options.out});
  if (!options.pdf.empty()) command.arguments.insert(command.arguments.end(), {"--pdf", options.pdf});
  command.arguments.insert(command.arguments.end(), {"--", folder});
  command.environment = environmentOfPython();
  const auto end = runChild(command, stop);
  if (!end) return end.error();
  if (end->ending != ChildEnding::Exited || end->exitCode != 0) return failureOf(file, *end);
  addWarnings(end->errors, warnings);
  return lastLine(end->output);
}

}  // namespace

Result<std::string> writeStudyPage(const StudyFolder& folder, const PageOptions& options, Warnings& warnings,
                                   const StopToken& stop) {
  const std::string& out = options.out.empty() ? folder.path() : options.out;
  const Outcome written = writeTables(folder, out, warnings);
  if (!written) return written.error();
  return runScript("report.py", folder.path(), options, warnings, stop);
}

Result<std::string> writeBenchmarkPage(const std::string& folder, const PageOptions& options, Warnings& warnings,
                                       const StopToken& stop) {
  std::error_code ignored;
  std::set<std::string> studies;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (fs::exists(entry.path() / "plan.json", ignored)) studies.insert(entry.path().string());
  }
  for (const std::string& path : studies) {
    const auto study = StudyFolder::open(path);
    const Outcome written = study ? writeTables(*study, path, warnings) : Outcome(study.error());
    if (!written) warnings.push_back(written.error());
  }
  return runScript("benchmark_page.py", folder, options, warnings, stop);
}

}  // namespace glissade
