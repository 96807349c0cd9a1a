#pragma once

#include <QFileDialog>
#include <QWidget>

#include <functional>
#include <map>

namespace glissade {

class WindowMemory;

/// The purpose of a file that is chosen. Each purpose has its own last folder.
enum class FilePurpose { Scenario, Parts, Path, Export, Report, Film, Recording, Sequence, Times, Study };

/// How a dialog shows the kinds of files: without their patterns where these would be cut.
QFileDialog::Options optionsFor(const QString& filter);

/// The dialogs that ask for files. Each begins in the last folder of its purpose, which the window's memory keeps
/// between sessions; without one, in the folder of the scenario.
class FileDialogs final {
 public:
  /// `usualFolder` returns the folder for purposes without a remembered one; it may return an empty name.
  FileDialogs(QWidget& window, std::function<QString()> usualFolder);

  /// Sets the memory of folders. Null: folders are remembered until the window closes.
  void setMemory(WindowMemory* memory) { memory_ = memory; }

  /// Asks for a file to open. All functions that ask return an empty name if the person cancels.
  QString open(FilePurpose purpose, const QString& title, const QString& filter, QWidget* parent = nullptr);
  QString openFolder(FilePurpose purpose, const QString& title);
  /// Asks for a file to save. It proposes `name`, in that name's folder if it has one.
  QString save(FilePurpose purpose, const QString& title, const QString& name, const QString& filter,
               QWidget* parent = nullptr);

  QString folderOf(FilePurpose purpose) const;
  /// Remembers the folder of a file that was chosen without this class.
  void noteFile(FilePurpose purpose, const QString& file);

 private:
  void noteFolder(FilePurpose purpose, const QString& folder);

  QWidget& window_;
  std::function<QString()> usualFolder_;
  WindowMemory* memory_ = nullptr;
  std::map<FilePurpose, QString> folders_;  ///< last folders of this session
};

}  // namespace glissade
