#include "widgets/workbench/file_dialogs.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

/// The key of a purpose in the settings.
QString keyOf(FilePurpose purpose) {
  switch (purpose) {
    case FilePurpose::Scenario: return QStringLiteral("scenario");
    case FilePurpose::Parts: return QStringLiteral("parts");
    case FilePurpose::Path: return QStringLiteral("path");
    case FilePurpose::Export: return QStringLiteral("export");
    case FilePurpose::Report: return QStringLiteral("report");
    case FilePurpose::Film: return QStringLiteral("film");
    case FilePurpose::Recording: return QStringLiteral("recording");
    case FilePurpose::Sequence: return QStringLiteral("sequence");
    case FilePurpose::Times: return QStringLiteral("times");
    case FilePurpose::Study: break;
  }
  return QStringLiteral("study");
}

}  // namespace

QFileDialog::Options optionsFor(const QString& filter) {
  constexpr int kMostLetters = 60;
  const QStringList kinds = filter.split(QStringLiteral(";;"));
  const bool isLong =
      std::any_of(kinds.begin(), kinds.end(), [](const QString& kind) { return kind.size() > kMostLetters; });
  return isLong ? QFileDialog::HideNameFilterDetails : QFileDialog::Options();
}

FileDialogs::FileDialogs(QWidget& window, std::function<QString()> usualFolder)
    : window_(window), usualFolder_(std::move(usualFolder)) {}

QString FileDialogs::open(FilePurpose purpose, const QString& title, const QString& filter, QWidget* parent) {
  QWidget* owner = parent != nullptr ? parent : &window_;
  const QString file =
      QFileDialog::getOpenFileName(owner, title, folderOf(purpose), filter, nullptr, optionsFor(filter));
  noteFile(purpose, file);
  return file;
}

QString FileDialogs::openFolder(FilePurpose purpose, const QString& title) {
  const QString folder = QFileDialog::getExistingDirectory(&window_, title, folderOf(purpose));
  // Remembers the parent of the chosen folder, because its neighbours are often opened next.
  noteFile(purpose, folder);
  return folder;
}

QString FileDialogs::save(FilePurpose purpose, const QString& title, const QString& name, const QString& filter,
                          QWidget* parent) {
  const bool hasFolder = QFileInfo(name).path() != QStringLiteral(".");
  const QString proposed = hasFolder ? name : QDir(folderOf(purpose)).filePath(name);
  const QString file = QFileDialog::getSaveFileName(parent != nullptr ? parent : &window_, title, proposed, filter,
                                                    nullptr, optionsFor(filter));
  noteFile(purpose, file);
  return file;
}

/// The last folder of the purpose if it still exists; else the usual one.
QString FileDialogs::folderOf(FilePurpose purpose) const {
  const auto known = folders_.find(purpose);
  const QString last = known != folders_.end() ? known->second
                       : memory_ != nullptr    ? memory_->folder(keyOf(purpose))
                                               : QString();
  return !last.isEmpty() && QFileInfo(last).isDir() ? last : usualFolder_();
}

void FileDialogs::noteFile(FilePurpose purpose, const QString& file) {
  if (!file.isEmpty()) noteFolder(purpose, QFileInfo(file).absolutePath());
}

void FileDialogs::noteFolder(FilePurpose purpose, const QString& folder) {
  folders_[purpose] = folder;
  if (memory_ != nullptr) memory_->noteFolder(keyOf(purpose), folder);
}

}  // namespace glissade
