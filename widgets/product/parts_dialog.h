#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <optional>
#include <vector>

#include "engine/files/part_files.h"
#include "engine/files/unit_guess.h"
#include "widgets/controls/background_task.h"

namespace glissade {

/// Asks for the largest distance of triangles from the surfaces of STEP files; by default it follows the size of each
/// part.
class FinenessBox final : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit FinenessBox(QWidget* parent = nullptr);

  /// 0: the distance follows the size of each part.
  double metres() const { return value() / 1e3; }
};

/// Patterns of the names of part files, for file dialogs.
QString partFilePatterns();

/// Asks for unit, axis and role of the files of a product's parts. Files are measured in the background, so that a
/// wrong unit is seen at once; the parts of a STEP file become rows of their own.
class PartsDialog final : public QDialog {
  Q_OBJECT

 public:
  enum class Purpose { NewScenario, AddParts };
  enum Column { kPart, kRole, kUnit, kUp, kSize };

  /// `atOnce`: files are measured before the constructor and addFiles() return.
  PartsDialog(Purpose purpose, const QStringList& files, bool atOnce, QWidget* parent = nullptr);

  /// Folder in which the dialog that adds files begins if no file is listed.
  void setFolder(const QString& folder) { folder_ = folder; }
  /// Adds files; files that are listed already stay as they are.
  void addFiles(const QStringList& files);

  std::vector<PartFile> parts() const;
  /// Geometry that was read for measuring, and need not be read again.
  const GeometryCache& read() const { return read_; }
  /// Whether all files were read, and one part moves if one has to.
  bool isComplete() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    PartFile part;
    std::optional<Result<Box3>> inFile;  ///< nothing: not measured yet
    bool unitChosen = false;             ///< a person has chosen the unit
    double unitOfFile = 0.0;             ///< metres; 0: the file states none
    QIcon picture{};
  };

  void setUpTable();
  void fillTable();
  QString nameOf(const PartFile& part) const;
  void makeRow(int row);
  void makeBoxes(int row);
  void makeBoxesInSight();
  QLayout* makeFileButtons();
  QWidget* makeButtons();
  QComboBox* makeRole(const QString& name);
  QComboBox* makeUnit(const QString& name);
  QComboBox* makeUp(const QString& name);
  void takeApart(bool wanted);
  void chooseFiles();
  void removeSelected();
  void chooseRole(int row, PartRole role);
  std::vector<int> rowsWith(int row) const;
  int rowOf(const QObject* combo, Column column) const;
  int rowOf(const std::string& path) const;

  struct Measured {
    Result<std::vector<MeasuredPart>> parts;
    std::vector<QImage> pictures{};  ///< one for each part
  };
  static Measured measured(const std::string& path, bool apart, GeometryCache& read, const WorkWatch& watch);
  void measureNext();
  std::vector<std::string> filesToMeasure() const;
  void setMeasured(const std::string& path, const Measured& measured);
  bool isMeasured() const;
  bool hasMoving() const;
  void guessUnits();
  void guessMovingPart();
  void refresh();
  void showRow(int row);
  void showSize(int row);
  QString hint() const;

  Purpose purpose_;
  bool atOnce_;
  QString folder_;
  bool roleChosen_ = false;
  std::vector<Row> rows_;               ///< in the order of the table
  std::optional<UnitGuess> unitGuess_;  ///< guess for files that state no unit, if nobody has chosen
  GeometryCache read_;
  QTableWidget* table_;
  QPushButton* remove_;
  QCheckBox* closeHoles_;
  QCheckBox* apart_;  ///< groups of OBJ files and solids of CAD parts are parts
  FinenessBox* fineness_;
  QLabel* hint_;
  QPushButton* accept_ = nullptr;
  BackgroundTask measuring_;
  std::vector<std::string> measuredPaths_;  ///< the files that measuring_ reads
};

}  // namespace glissade
