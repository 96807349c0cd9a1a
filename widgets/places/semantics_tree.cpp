#include "widgets/places/semantics_tree.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>

#include "engine/model/body_path.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/colour_swatch.h"
#include "widgets/controls/complexity_colour.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kKeyRole = Qt::UserRole;         // number of the place, or id of the body
constexpr int kSearchRole = Qt::UserRole + 1;  // text that the filter searches

QIcon swatch(const Colour& colour) { return colourSwatch(QColor::fromRgbF(colour[0], colour[1], colour[2])); }

QTreeWidgetItem* makeGroup(QTreeWidget* tree) {
  auto* group = new QTreeWidgetItem(tree);
  group->setExpanded(true);
  group->setFlags(Qt::ItemIsEnabled);
  QFont font = group->font(0);
  font.setBold(true);
  group->setFont(0, font);
  group->setFont(1, font);
  return group;
}

/// A sign beside a place's complexity, with its meaning.
struct Mark {
  QString sign;
  QString meaning;
};

std::vector<Mark> marksOf(const SemanticModel& semantics, std::size_t place) {
  std::vector<Mark> marks;
  const auto holds = [&](const char* attribute) { return std::get<bool>(semantics.ofPlace(place, attribute).value); };
  if (holds("cluttered")) marks.push_back({QStringLiteral("⚠"), SemanticsTree::tr("Cluttered by mobile bodies")});
  if (holds("forbidden")) marks.push_back({QStringLiteral("⊘"), SemanticsTree::tr("Forbidden: no path leads through")});
  const double preference = std::get<double>(semantics.ofPlace(place, "preference").value);
  if (preference > 1.0) {
    marks.push_back(
        {QStringLiteral("★"),
         SemanticsTree::tr("Preferred: paths through count %1 times shorter").arg(QLocale().toString(preference))});
  }
  return marks;
}

QTreeWidgetItem* child(QTreeWidgetItem& group, int index) {
  return index < group.childCount() ? group.child(index) : new QTreeWidgetItem(&group);
}

void cut(QTreeWidgetItem& group, int count) {
  while (group.childCount() > count) delete group.takeChild(group.childCount() - 1);
}

}  // namespace

SemanticsTree::SemanticsTree(SemanticDocument& document, QWidget* parent)
    : QTreeWidget(parent),
      document_(document),
      places_(makeGroup(this)),
      assemblies_(makeGroup(this)),
      bodies_(makeGroup(this)) {
  setObjectName(QStringLiteral("semantics-tree"));
  setColumnCount(3);
  setHeaderLabels({tr("Name"), tr("Complexity"), tr("Width")});
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  places_->setFirstColumnSpanned(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  connect(&document_, &SemanticDocument::changed, this, &SemanticsTree::refresh);
  connect(&document_, &SemanticDocument::selectionChanged, this, &SemanticsTree::showSelection);
  connect(this, &QTreeWidget::itemSelectionChanged, this, &SemanticsTree::takeSelection);
  connect(this, &QTreeWidget::itemChanged, this, &SemanticsTree::rename);
  refresh();
}

void SemanticsTree::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) refresh();
}

void SemanticsTree::refresh() {
  updating_ = true;
  showPlaces();
  showAssemblies();
  showBodies();
  updating_ = false;
  hideFilteredRows();
  showSelection();
}

void SemanticsTree::showPlaces() {
  const SemanticModel* semantics = document_.semantics();
  const int count = semantics == nullptr ? 0 : static_cast<int>(semantics->placeCount());
  places_->setText(0, semantics == nullptr ? tr("Places (not looked for yet)") : tr("Places (%1)").arg(count));
  cut(*places_, count);
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i);
    const int complexity = static_cast<int>(std::get<double>(semantics->ofPlace(place, "complexity").value));
    const bool cluttered = std::get<bool>(semantics->ofPlace(place, "cluttered").value);
    const double width = std::get<double>(semantics->ofPlace(place, "narrowness").value);
    QTreeWidgetItem* item = child(*places_, i);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
    item->setText(0, QString::fromStdString(semantics->placeName(place)));
    item->setIcon(0, swatch(complexityColour(complexity, cluttered)));
    QStringList texts(QString::number(complexity));
    QStringList meanings;
    for (const Mark& mark : marksOf(*semantics, place)) {
      texts << mark.sign;
      meanings << mark.meaning;
    }
    item->setText(1, texts.join(QLatin1Char(' ')));
    item->setToolTip(1, meanings.join(QLatin1Char('\n')));
    item->setText(2, lengthText(width));
    item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    item->setData(0, kKeyRole, i);
    QString search = item->text(0);
    for (const AttributeDefinition& definition : document_.table().definitions()) {
      if (definition.owner != AttributeOwner::Place) continue;
      const ProvenValue value = semantics->ofPlace(place, definition.name);
      search += QString::fromStdString(" " + definition.name + " " + toText(value.value));
    }
    item->setData(0, kSearchRole, search);
  }
}

void SemanticsTree::showBodies() {
  const auto& bodies = document_.bodies();
  bodies_->setText(0, tr("Bodies (%1)").arg(bodies.size()));
  bodies_->setText(1, tr("Mobility"));
  cut(*bodies_, static_cast<int>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    QTreeWidgetItem* item = child(*bodies_, static_cast<int>(i));
    const QString id = toQString(bodies[i].id);
    item->setText(0, QString::fromStdString(bodies[i].shown()));
    item->setIcon(0, swatch(bodies[i].colour));
    item->setText(1, document_.isMoved(i) ? tr("moving part")
                                          : QString::fromStdString(toText(document_.bodyValue(id, "mobility").value)));
    describe(*item, id);
  }
}

/// Sets the row's id and the text that the filter searches.
void SemanticsTree::describe(QTreeWidgetItem& item, const QString& id) {
  item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item.setData(0, kKeyRole, id);
  QString search = item.text(0) + QLatin1Char(' ') + item.text(1);
  for (const AttributeDefinition& definition : document_.table().definitions()) {
    if (definition.owner != AttributeOwner::Body) continue;
    search +=
        QString::fromStdString(" " + definition.name + " " + toText(document_.bodyValue(id, definition.name).value));
  }
  item.setData(0, kSearchRole, search);
}

/// Attributes of an assembly hold for its bodies.
void SemanticsTree::showAssemblies() {
  std::vector<const Product::Node*> nodes;
  std::vector<std::string> ids;
  std::vector<std::string> paths;
  for (const Product::Node& node : document_.product().nodes()) {
    if (!node.isAssembly) continue;
    nodes.push_back(&node);
    ids.push_back(node.id);
    paths.push_back(node.path);
  }
  const std::vector<std::string> shown = document_.product().labels(ids);
  assemblies_->setText(0, tr("Assemblies (%1)").arg(nodes.size()));
  assemblies_->setHidden(nodes.empty());
  cut(*assemblies_, static_cast<int>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    QTreeWidgetItem* item = child(*assemblies_, static_cast<int>(i));
    item->setText(0, QString::fromStdString(shown[i]));
    item->setToolTip(0, QString::fromStdString(paths[i]));
    describe(*item, QString::fromStdString(ids[i]));
  }
}

/// Deselects rows that become hidden, so that nobody edits hidden rows.
void SemanticsTree::setFilter(const QString& text) {
  filter_ = text;
  hideFilteredRows();
  takeSelection();
}

void SemanticsTree::hideFilteredRows() {
  for (QTreeWidgetItem* group : {places_, assemblies_, bodies_}) {
    for (int i = 0; i < group->childCount(); ++i) {
      const QString search = group->child(i)->data(0, kSearchRole).toString();
      group->child(i)->setHidden(!search.contains(filter_, Qt::CaseInsensitive));
    }
  }
}

void SemanticsTree::takeSelection() {
  if (updating_) return;
  SemanticSelection selection;
  for (const QTreeWidgetItem* item : selectedItems()) {
    if (item->isHidden()) continue;
    if (item->parent() == places_) selection.places.insert(item->data(0, kKeyRole).toInt());
    if (item->parent() == assemblies_ || item->parent() == bodies_)
      selection.bodies.insert(item->data(0, kKeyRole).toString());
  }
  document_.select(selection);
}

void SemanticsTree::showSelection() {
  updating_ = true;
  const SemanticSelection& selection = document_.selection();
  QTreeWidgetItem* first = nullptr;
  for (int i = 0; i < places_->childCount(); ++i) {
    places_->child(i)->setSelected(selection.places.contains(i));
    if (first == nullptr && places_->child(i)->isSelected()) first = places_->child(i);
  }
  for (const QTreeWidgetItem* group : {assemblies_, bodies_}) {
    for (int i = 0; i < group->childCount(); ++i) {
      QTreeWidgetItem* item = group->child(i);
      item->setSelected(selection.bodies.contains(item->data(0, kKeyRole).toString()));
      if (first == nullptr && item->isSelected()) first = item;
    }
  }
  if (first != nullptr) scrollToItem(first);
  updating_ = false;
}

void SemanticsTree::rename(QTreeWidgetItem* item) {
  if (updating_ || item->parent() != places_) return;
  const int place = item->data(0, kKeyRole).toInt();
  const Outcome outcome = document_.renamePlace(place, item->text(0));
  if (outcome) return;
  emit refused(outcome.error());
  refresh();
}

}  // namespace glissade
