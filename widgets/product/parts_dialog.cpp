#include "widgets/product/parts_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QScrollBar>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <utility>

#include "engine/import/geometry_loader.h"
#include "engine/import/mesh_import.h"
#include "engine/import/step_import.h"
#include "widgets/controls/cell_delegates.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/length_text.h"
#include "widgets/product/part_boxes.h"
#include "widgets/product/part_pictures.h"
#include "widgets/workbench/file_dialogs.h"

namespace glissade {
namespace {

/// Sizes of copies of one part differ by rounding.
constexpr double kSmaller = 1.0 - 1e-6;

constexpr int kWidth = 760;
constexpr int kHeight = 400;
constexpr int kPicturePixels = 28;

/// Rows that get their boxes even if fewer are in sight, for example before the table is shown.
constexpr int kFirstRows = 16;
/// Number of rows by which the widths of columns are measured.
constexpr int kMeasuredRows = 50;
/// Files that are read together; the list shows progress after each group.
constexpr std::size_t kFilesAtOnce = 128;

QString sizeText(const Box3& box, LengthUnit unit) {
  const Vector3 size = box.sizes();
  return lengthsText({size.x(), size.y(), size.z()}, QStringLiteral(" × "), unit);
}

/// The reason without the file's folder, which the row's tooltip states.
QString reasonText(Diagnostic why) {
  why.file = QFileInfo(QString::fromStdString(why.file)).fileName().toStdString();
  return diagnosticLine(why);
}

}  // namespace

FinenessBox::FinenessBox(QWidget* parent) : QDoubleSpinBox(parent) {
  constexpr double kMostMillimetres = 5.0;
  setObjectName(QStringLiteral("fineness"));
  setAccessibleName(tr("Mesh tolerance of STEP files"));
  setToolTip(
      tr("How far triangles may be off the surfaces of STEP files. A finer tolerance allows smaller gaps and takes "
         "longer; automatic: a thousandth of the diagonal of each part, from 0.01 to 0.5 mm"));
  setRange(0.0, kMostMillimetres);
  setDecimals(3);
  setSingleStep(0.01);
  setSuffix(tr(" mm"));
  setPrefix(tr("Mesh tolerance: "));
  setSpecialValueText(tr("Mesh tolerance: automatic"));
}

PartsDialog::PartsDialog(Purpose purpose, const QStringList& files, bool atOnce, QWidget* parent)
    : QDialog(parent),
      purpose_(purpose),
      atOnce_(atOnce),
      table_(new QTableWidget(0, 5, this)),
      remove_(new QPushButton(tr("&Remove"), this)),
      closeHoles_(new QCheckBox(tr("Close planar &holes"), this)),
      apart_(new QCheckBox(tr("Split OBJ &groups and solids"), this)),
      fineness_(new FinenessBox(this)),
      hint_(new QLabel(this)) {
  setObjectName(QStringLiteral("parts"));
  setWindowTitle(purpose == Purpose::NewScenario ? tr("New scenario from parts") : tr("Add parts"));
  setUpTable();
  hint_->setObjectName(QStringLiteral("hint"));
  hint_->setWordWrap(true);
  hint_->setTextFormat(Qt::PlainText);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(table_, 1);
  layout->addLayout(makeFileButtons());
  layout->addWidget(hint_);
  layout->addWidget(makeButtons());
  resize(kWidth, kHeight);
  connect(table_->verticalScrollBar(), &QScrollBar::valueChanged, this, &PartsDialog::makeBoxesInSight);
  connect(&measuring_, &BackgroundTask::failed, this, [this](const Diagnostic& why) {
    for (const std::string& path : measuredPaths_) setMeasured(path, {why});
    fillTable();
    refresh();
    measureNext();
  });
  addFiles(files);
}

void PartsDialog::setUpTable() {
  table_->setObjectName(QStringLiteral("parts-table"));
  table_->setAccessibleName(tr("Parts"));
  table_->setHorizontalHeaderLabels({tr("Part"), tr("Role"), tr("Unit"), tr("Up"), tr("Size")});
  table_->horizontalHeaderItem(kSize)->setToolTip(tr("Width × depth × height: shows whether the unit is right"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kPart, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
  table_->verticalHeader()->setVisible(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setItemDelegateForColumn(kPart, new NameDelegate(kPart, table_));
  table_->setTabKeyNavigation(false);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->setIconSize({kPicturePixels, kPicturePixels});
}

void PartsDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  makeBoxesInSight();
}

QLayout* PartsDialog::makeFileButtons() {
  auto* add = new QPushButton(tr("Add &files…"), this);
  add->setObjectName(QStringLiteral("add-files"));
  for (QPushButton* button : {add, remove_}) button->setAutoDefault(false);  // Return accepts
  add->setToolTip(tr("Meshes (STL, OBJ, Collada, glTF), STEP or URDF files"));
  remove_->setObjectName(QStringLiteral("remove"));
  remove_->setEnabled(false);
  remove_->setToolTip(tr("Takes the selected rows out of the list (Del)"));
  auto* row = new FlowLayout;
  for (QWidget* each : std::initializer_list<QWidget*>{add, remove_, fineness_, apart_, closeHoles_}) {
    row->addWidget(each);
  }
  apart_->setObjectName(QStringLiteral("apart"));
  apart_->setToolTip(
      tr("Takes each group of an OBJ file, and each solid of a CAD part of several, as a part of its own"));
  connect(apart_, &QCheckBox::toggled, this, &PartsDialog::takeApart);
  closeHoles_->setObjectName(QStringLiteral("close-holes"));
  closeHoles_->setToolTip(tr("Closes holes of meshes whose edge lies in a plane; a warning says how many"));
  const auto* del = new QShortcut(QKeySequence::Delete, table_, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
  connect(del, &QShortcut::activated, this, &PartsDialog::removeSelected);
  connect(add, &QPushButton::clicked, this, &PartsDialog::chooseFiles);
  connect(remove_, &QPushButton::clicked, this, &PartsDialog::removeSelected);
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(table_->selectionModel()->hasSelection()); });
  return row;
}

QWidget* PartsDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  accept_ = buttons->button(QDialogButtonBox::Ok);
  accept_->setText(purpose_ == Purpose::NewScenario ? tr("&Create") : tr("&Add"));
  buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  return buttons;
}

void PartsDialog::addFiles(const QStringList& files) {
  for (const QString& file : files) {
    const std::string path = QFileInfo(file).absoluteFilePath().toStdString();
    if (rowOf(path) >= 0) continue;
    rows_.push_back({usualPart(path), std::nullopt, false});
    rows_.back().part.groups = apart_->isChecked() && mayHaveGroups(path);
  }
  fillTable();
  refresh();
  if (!measuring_.isBusy()) measureNext();
}

/// Makes the rows that the table does not have yet.
void PartsDialog::fillTable() {
  const int first = table_->rowCount();
  table_->setRowCount(static_cast<int>(rows_.size()));
  for (int row = first; row < table_->rowCount(); ++row) makeRow(row);
  makeBoxesInSight();
}

/// Makes the boxes of rows that are in sight for the first time: the boxes of a thousand rows take a second.
void PartsDialog::makeBoxesInSight() {
  const QHeaderView& rows = *table_->verticalHeader();
  const int first = std::max(0, rows.visualIndexAt(0));
  const int last = rows.visualIndexAt(table_->viewport()->height());
  const int inSight = last < 0 ? table_->rowCount() : last + 1;
  const int end = std::clamp(inSight, std::min(first + kFirstRows, table_->rowCount()), table_->rowCount());
  for (int row = first; row < end; ++row) {
    if (table_->cellWidget(row, kRole) == nullptr) makeBoxes(row);
  }
}

QString PartsDialog::nameOf(const PartFile& part) const {
  const QString file = QFileInfo(QString::fromStdString(part.path)).fileName();
  const QString name = QString::fromStdString(part.part);
  if (name.isEmpty()) return file;
  const bool oneFile = rows_.front().part.path == rows_.back().part.path;  // the rows of a file are together
  return oneFile ? name : file + QStringLiteral(": ") + name;
}

void PartsDialog::makeRow(int row) {
  const PartFile& part = rows_[row].part;
  for (const Column column : {kPart, kSize}) table_->setItem(row, column, new QTableWidgetItem);
  table_->item(row, kPart)->setToolTip(QDir::toNativeSeparators(QString::fromStdString(part.path)));
  showSize(row);
}

void PartsDialog::makeBoxes(int row) {
  const PartFile& part = rows_[row].part;
  const QString name = nameOf(part);
  QComboBox* role = makeRole(name);
  QComboBox* unit = makeUnit(name);
  QComboBox* up = makeUp(name);
  for (const auto& [column, combo] : {std::pair(kRole, role), std::pair(kUnit, unit), std::pair(kUp, up)}) {
    table_->setCellWidget(row, column, cellOf(combo));
  }
  if (saysItsUnit(part.path)) showUnitOfFile(part.path, *unit, *up);
  showRow(row);
  if (row > 0) return;
  table_->resizeRowToContents(row);
  table_->verticalHeader()->setDefaultSectionSize(table_->rowHeight(row));
}

QComboBox* PartsDialog::makeRole(const QString& name) {
  QComboBox* role = makeRoleBox(name, purpose_ == Purpose::NewScenario);
  connect(role, QOverload<int>::of(&QComboBox::activated), this,
          [this, role] { chooseRole(rowOf(role, kRole), static_cast<PartRole>(role->currentData().toInt())); });
  return role;
}

QComboBox* PartsDialog::makeUnit(const QString& name) {
  QComboBox* unit = makeUnitBox(name);
  connect(unit, QOverload<int>::of(&QComboBox::activated), this, [this, unit] {
    for (const int i : rowsWith(rowOf(unit, kUnit))) {
      if (saysItsUnit(rows_[i].part.path)) continue;
      rows_[i].part.unit = unit->currentData().toDouble();
      rows_[i].unitChosen = true;
    }
    refresh();
  });
  return unit;
}

QComboBox* PartsDialog::makeUp(const QString& name) {
  QComboBox* up = makeUpBox(name);
  connect(up, QOverload<int>::of(&QComboBox::activated), this, [this, up] {
    for (const int i : rowsWith(rowOf(up, kUp))) {
      if (!saysItsUnit(rows_[i].part.path)) rows_[i].part.up = static_cast<UpAxis>(up->currentData().toInt());
    }
    refresh();
  });
  return up;
}

QString partFilePatterns() {
  return QStringLiteral(
      "*.step *.stp *.p21 *.STEP *.STP *.P21 *.igs *.iges *.IGS *.IGES *.brep *.brp *.stl *.obj *.ply *.dae *.gltf "
      "*.glb *.urdf");
}

/// Makes one row of each OBJ and CAD file again, which is measured anew.
void PartsDialog::takeApart(bool wanted) {
  std::vector<Row> rows;
  for (Row& row : rows_) {
    const bool another = mayHaveGroups(row.part.path) || isCadFile(row.part.path);
    if (another && !rows.empty() && rows.back().part.path == row.part.path) continue;
    rows.push_back(std::move(row));
    if (!another) continue;
    rows.back().part.groups = wanted && mayHaveGroups(rows.back().part.path);
    rows.back().part.part.clear();
    rows.back().inFile.reset();
  }
  rows_ = std::move(rows);
  measuring_.cancel();
  table_->setRowCount(0);
  fillTable();
  refresh();
  measureNext();
}

void PartsDialog::chooseFiles() {
  const QString folder =
      rows_.empty() ? folder_ : QFileInfo(QString::fromStdString(rows_.back().part.path)).absolutePath();
  const QString filter = tr("Parts (%1);;All files (*)").arg(partFilePatterns());
  addFiles(
      QFileDialog::getOpenFileNames(this, tr("Add the files of parts"), folder, filter, nullptr, optionsFor(filter)));
}

void PartsDialog::removeSelected() {
  for (int row = table_->rowCount() - 1; row >= 0; --row) {
    if (!table_->selectionModel()->isRowSelected(row, QModelIndex())) continue;
    table_->removeRow(row);
    rows_.erase(rows_.begin() + row);
  }
  makeBoxesInSight();
  refresh();
}

/// Sets the role of all selected rows together; other parts that moved before become static.
void PartsDialog::chooseRole(int row, PartRole role) {
  if (role == PartRole::Moves) {
    for (Row& other : rows_) {
      if (other.part.role == role) other.part.role = PartRole::Static;
    }
  }
  for (const int i : rowsWith(row)) rows_[i].part.role = role;
  roleChosen_ = true;
  refresh();
}

/// The row alone, or all selected rows if it is one of them.
std::vector<int> PartsDialog::rowsWith(int row) const {
  const QItemSelectionModel& selection = *table_->selectionModel();
  if (!selection.isRowSelected(row, QModelIndex())) return {row};
  std::vector<int> rows;
  for (int i = 0; i < table_->rowCount(); ++i) {
    if (selection.isRowSelected(i, QModelIndex())) rows.push_back(i);
  }
  return rows;
}

int PartsDialog::rowOf(const QObject* combo, Column column) const {
  int row = 0;
  while (table_->cellWidget(row, column) != combo->parent()) ++row;
  return row;
}

/// -1 if the file is not listed.
int PartsDialog::rowOf(const std::string& path) const {
  const auto same = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.part.path == path; });
  return same == rows_.end() ? -1 : static_cast<int>(same - rows_.begin());
}

/// The next files that were not measured yet; a CAD file alone, because it takes long.
std::vector<std::string> PartsDialog::filesToMeasure() const {
  std::vector<std::string> paths;
  for (const Row& row : rows_) {
    if (row.inFile) continue;
    const bool alone = !isMeshFile(row.part.path);
    if (alone && !paths.empty()) break;
    paths.push_back(row.part.path);
    if (alone || paths.size() == kFilesAtOnce) break;
  }
  return paths;
}

PartsDialog::Measured PartsDialog::measured(const std::string& path, bool apart, GeometryCache& read,
                                            const WorkWatch& watch) {
  Measured measured{partsInFile(path, read, watch.stop, apart)};
  if (!measured.parts) return measured;
  const UpAxis up = usualPart(path).up;
  for (const MeasuredPart& part : *measured.parts) {
    RigidBody body;
    body.mesh = part.solid.mesh == nullptr ? std::make_shared<const TriangleMesh>() : part.solid.mesh;
    body.X_WB = uprightPose(up) * part.solid.X_FP;
    measured.pictures.push_back(watch.stop.stopRequested() ? QImage() : partPicture(body, kPicturePixels));
  }
  return measured;
}

void PartsDialog::measureNext() {
  measuredPaths_ = filesToMeasure();
  if (measuredPaths_.empty()) return;
  const auto measure = [this, paths = measuredPaths_,
                        apart = apart_->isChecked()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    GeometryCache read;
    readSmallFiles(paths, read, watch.stop);
    const auto measured = std::make_shared<std::vector<Measured>>();
    for (const std::string& path : paths) {
      measured->push_back(PartsDialog::measured(path, apart, read, watch));
    }
    return [this, paths, measured, read] {
      read_.insert(read.begin(), read.end());
      for (std::size_t i = 0; i < paths.size(); ++i) setMeasured(paths[i], (*measured)[i]);
      fillTable();
      refresh();
      measureNext();
    };
  };
  measuring_.start(GLISSADE_TEXT("reading the parts"), measure, atOnce_);
}

/// Replaces the row of the file by one row for each of its parts.
void PartsDialog::setMeasured(const std::string& path, const Measured& measured) {
  const int row = rowOf(path);
  if (row < 0) return;
  if (!measured.parts) {
    rows_[row].inFile = measured.parts.error();
    return;
  }
  if (measured.parts->size() == 1) {
    rows_[row].inFile = measured.parts->front().inFile;
    rows_[row].unitOfFile = measured.parts->front().solid.unit;
    rows_[row].picture = iconOf(measured.pictures.front());
    return;
  }
  table_->setRowCount(row);
  const Row whole = rows_[row];
  rows_.erase(rows_.begin() + row);
  std::vector<Row> parts;
  for (std::size_t i = 0; i < measured.parts->size(); ++i) {
    const MeasuredPart& part = (*measured.parts)[i];
    parts.push_back(whole);
    parts.back().part.part = part.part;
    parts.back().inFile = part.inFile;
    parts.back().unitOfFile = part.solid.unit;
    parts.back().picture = iconOf(measured.pictures[i]);
  }
  rows_.insert(rows_.begin() + row, parts.begin(), parts.end());
}

bool PartsDialog::isMeasured() const {
  return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.inFile.has_value(); });
}

bool PartsDialog::hasMoving() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.part.role == PartRole::Moves; });
}

/// Guesses the unit of files that state none, as long as nobody has chosen.
void PartsDialog::guessUnits() {
  unitGuess_.reset();
  if (!isMeasured()) return;
  std::vector<Row*> guessed;
  std::vector<Box3> boxes;
  for (Row& row : rows_) {
    if (row.unitChosen || !row.inFile->ok() || !saysNoUnit(row.part.path)) continue;
    guessed.push_back(&row);
    boxes.push_back(**row.inFile);
  }
  if (guessed.empty()) return;
  unitGuess_ = guessUnit(boxes);
  for (Row* row : guessed) row->part.unit = unitGuess_->unit;
}

/// Lets the first of the smallest parts move, as long as nobody has chosen.
void PartsDialog::guessMovingPart() {
  if (purpose_ != Purpose::NewScenario || roleChosen_ || !isMeasured()) return;
  Row* smallest = nullptr;
  const auto diagonal = [](const Row& row) { return boxOfPart(row.part, **row.inFile).diagonal().norm(); };
  for (Row& row : rows_) {
    row.part.role = PartRole::Static;
    if (!row.inFile->ok()) continue;
    if (smallest == nullptr || diagonal(row) < kSmaller * diagonal(*smallest)) smallest = &row;
  }
  if (smallest != nullptr) smallest->part.role = PartRole::Moves;
}

void PartsDialog::refresh() {
  guessUnits();
  guessMovingPart();
  for (int row = 0; row < table_->rowCount(); ++row) {
    showRow(row);
    showSize(row);
  }
  hint_->setText(hint());
  accept_->setEnabled(isComplete());
}

/// Shows the part's name and the state of its boxes.
void PartsDialog::showRow(int row) {
  const PartFile& part = rows_[row].part;
  QTableWidgetItem& item = *table_->item(row, kPart);
  if (const QString name = nameOf(part); item.text() != name) item.setText(name);
  const QIcon& picture = rows_[row].picture;
  if (item.icon().cacheKey() != picture.cacheKey()) item.setIcon(picture);
  const auto show = [this, row](Column column, const QVariant& value) {
    if (table_->cellWidget(row, column) == nullptr) return;
    auto* combo = table_->cellWidget(row, column)->findChild<QComboBox*>();
    combo->setCurrentIndex(combo->findData(value));
  };
  show(kRole, static_cast<int>(part.role));
  show(kUnit, part.unit);
  show(kUp, static_cast<int>(part.up));
  QFont font = table_->font();
  font.setBold(part.role == PartRole::Moves);
  if (item.font() != font) item.setFont(font);
}

void PartsDialog::showSize(int row) {
  const auto& inFile = rows_[row].inFile;
  QTableWidgetItem& item = *table_->item(row, kSize);
  if (!inFile) {
    item.setText(QStringLiteral("…"));
  } else if (inFile->ok()) {
    const LengthUnit unit = purpose_ == Purpose::AddParts ? lengthUnit() : lengthUnitFor(rows_[row].unitOfFile);
    item.setText(sizeText(boxOfPart(rows_[row].part, **inFile), unit));
  } else {
    item.setText(tr("cannot be read"));
    item.setToolTip(reasonText(inFile->error()));
    item.setForeground(palette().brush(QPalette::BrightText));
  }
}

/// The next thing that is missing, in one sentence.
QString PartsDialog::hint() const {
  if (rows_.empty()) return tr("Add the files of the parts.");
  for (const Row& row : rows_) {
    if (row.inFile && !row.inFile->ok()) return reasonText(row.inFile->error());
  }
  if (!isMeasured()) {
    const auto read = std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.inFile.has_value(); });
    return tr("The files are being read: %1 of %2.").arg(read).arg(rows_.size());
  }
  if (purpose_ == Purpose::NewScenario && !hasMoving()) return tr("Choose the moving part.");
  if (unitGuess_ && unitGuess_->inDoubt) {
    return tr("Is the unit right? The files do not state it, and their size does not decide it. Choose the unit.");
  }
  if (unitGuess_ && unitGuess_->unit == 1.0)
    return tr("The files do not say their unit: by their size it is the metre.");
  return rows_.size() > 1 ? tr("Roles are for the path of one part; an assembly plan moves every part. Select several "
                               "rows to choose their role, unit or axis together.")
                          : QString();
}

std::vector<PartFile> PartsDialog::parts() const {
  std::vector<PartFile> parts;
  for (const Row& row : rows_) {
    parts.push_back(row.part);
    parts.back().deflection = isCadFile(row.part.path) ? fineness_->metres() : 0.0;
    parts.back().closeHoles = closeHoles_->isChecked() && isMeshFile(row.part.path);
  }
  return parts;
}

bool PartsDialog::isComplete() const {
  const bool readable =
      std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.inFile && row.inFile->ok(); });
  return !rows_.empty() && readable && (purpose_ == Purpose::AddParts || hasMoving());
}

}  // namespace glissade
