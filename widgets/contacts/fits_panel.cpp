#include "widgets/contacts/fits_panel.h"

#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "engine/fits/giving_way.h"
#include "widgets/controls/body_id_text.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/controls/row_search.h"

namespace glissade {
namespace {

enum Column { Kind, Amount, BodyA, BodyB, Thinning, Status, ColumnCount };

constexpr int kIndexRole = Qt::UserRole;  // index of the pair

QString statusText(FitStatus status) {
  switch (status) {
    case FitStatus::Clear: return FitsPanel::tr("clear");
    case FitStatus::Allowed: return FitsPanel::tr("allowed");
    case FitStatus::Accepted: return FitsPanel::tr("accepted");
    case FitStatus::Clash: break;
  }
  return FitsPanel::tr("clash");
}

void setLength(QTreeWidgetItem& item, int column, double sortedBy, const QString& text) {
  item.setText(column, text);
  item.setData(column, kSortRole, sortedBy);
  item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
}

/// The value by which gaps are sorted; an overlap is a negative gap.
double signedGap(const Contact& contact) { return contact.overlap > 0.0 ? -contact.overlap : contact.gap; }

QString amountText(const Contact& contact) {
  const QString amount = contact.overlap > 0.0 ? FitsPanel::tr("%1 overlap").arg(lengthText(contact.overlap))
                         : contact.gap > 0.0   ? FitsPanel::tr("%1 gap").arg(lengthText(contact.gap))
                                               : FitsPanel::tr("touches");
  return contact.uncertainty > 0.0 ? amount + QStringLiteral(" ± ") + lengthText(contact.uncertainty) : amount;
}

/// The bodies that give way, or the reason why none can pass.
QString wayText(const PairFit& fit) {
  if (!fit.way().refused.empty()) return engineText(fit.way().refused);
  QStringList lines;
  for (const Fit& taken : fit.way().taken) {
    if (!taken.thinned) continue;
    const std::string& thinner = fit.shown[taken.yields == fit.givesWayFirstIsA ? 1 : 0];
    if (taken.hollow) {
      lines << FitsPanel::tr("%1 without what overlaps, up to %2 deep")
                   .arg(QString::fromStdString(thinner), lengthText(taken.allowance));
      continue;
    }
    lines << FitsPanel::tr("Allowance of %1: %2").arg(QString::fromStdString(thinner), lengthText(taken.allowance));
  }
  return lines.isEmpty() ? FitsPanel::tr("No allowance for either body") : lines.join(QLatin1Char('\n'));
}

}  // namespace

QString contactKindText(ContactKind kind) {
  switch (kind) {
    case ContactKind::Clearance: return FitsPanel::tr("clearance");
    case ContactKind::Planar: return FitsPanel::tr("planar");
    case ContactKind::Cylindrical: return FitsPanel::tr("cylindrical");
    case ContactKind::Thread: return FitsPanel::tr("thread");
    case ContactKind::Press: return FitsPanel::tr("press fit");
    case ContactKind::Overlap: return FitsPanel::tr("overlap");
    case ContactKind::Contact: return FitsPanel::tr("contact");
    case ContactKind::Clash: break;
  }
  return FitsPanel::tr("clash");
}

FitsPanel::FitsPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      summary_(new QLabel(this)),
      filter_(new QLineEdit(this)),
      table_(new NameTable({{BodyA, 0.5}, {BodyB, 0.5}}, this)) {
  summary_->setWordWrap(true);
  filter_->setPlaceholderText(tr("Filter by kind, status or body"));
  filter_->setAccessibleName(filter_->placeholderText());
  filter_->setClearButtonEnabled(true);
  table_->setObjectName(QStringLiteral("fits-table"));
  table_->setColumnCount(ColumnCount);
  table_->setHeaderLabels({tr("Kind"), tr("Gap"), tr("Body A"), tr("Body B"), tr("Allowance"), tr("Status")});
  table_->headerItem()->setToolTip(Amount, tr("Negative where the bodies overlap"));
  table_->setAccessibleName(tr("Fits"));
  for (const char* id : {"fits.isolate", "fits.accept", "fits.thread", "fits.require-clearance", "fits.as-measured"}) {
    table_->addAction(actions[QLatin1String(id)]);
  }
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(makeActionFlow(actions, {"fits.find"}, this));
  layout->addWidget(summary_);
  layout->addWidget(filter_);
  layout->addWidget(table_, 1);
  layout->addLayout(makeActionFlow(actions, {"fits.isolate", "fits.accept"}, this));
  connect(filter_, &QLineEdit::textChanged, table_, &NameTable::filterRows);
  connect(table_, &QTreeWidget::currentItemChanged, this, &FitsPanel::chosenChanged);
  connect(table_, &QTreeWidget::itemActivated, this, &FitsPanel::activated);
  setFits(nullptr);
}

void FitsPanel::setFits(const PairFitsPtr& fits) {
  fits_ = fits;
  table_->setSortingEnabled(false);
  table_->clear();
  for (std::size_t i = 0; fits_ && i < fits_->size(); ++i) addRow(i);
  table_->setSortingEnabled(true);
  table_->fitColumns();
  summary_->setText(summary());
  table_->filterRows(filter_->text());
}

void FitsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) setFits(fits_);
}

void FitsPanel::addRow(std::size_t index) {
  const PairFit& fit = (*fits_)[index];
  auto* row = new SortedRow(table_);
  row->setText(Kind, contactKindText(fit.contact.kind));
  setLength(*row, Amount, signedGap(fit.contact), columnLengthText(signedGap(fit.contact)));
  row->setToolTip(Amount, amountText(fit.contact));
  const double allowance = fit.way().allowance();
  setLength(*row, Thinning, allowance, allowance > 0.0 ? columnLengthText(allowance) : QStringLiteral("–"));
  row->setToolTip(Thinning, wayText(fit));
  row->setText(Status, statusText(fit.status()));
  row->setToolTip(Status, wayText(fit));
  row->setText(BodyA, QString::fromStdString(fit.shown[0]));
  row->setText(BodyB, QString::fromStdString(fit.shown[1]));
  row->setToolTip(BodyA, toQString(fit.a));
  row->setToolTip(BodyB, toQString(fit.b));
  row->setData(Kind, kIndexRole, static_cast<qulonglong>(index));
  if (fit.status() != FitStatus::Clash) return;
  QFont bold = table_->font();
  bold.setBold(true);
  for (const int column : {Kind, Status}) row->setFont(column, bold);
}

QString FitsPanel::summary() const {
  if (!fits_) return tr("Not analysed yet.");
  if (fits_->empty()) return tr("No two bodies touch.");
  QStringList kinds;
  for (const auto& [name, count] : countsByKind(*fits_)) {
    kinds << QStringLiteral("%1 %2").arg(count).arg(contactKindText(*kContactKindNames.find(name)));
  }
  return tr("Pairs of bodies: %1 (%2)").arg(fits_->size()).arg(kinds.join(QStringLiteral(", ")));
}

const PairFit* FitsPanel::chosen() const {
  const QTreeWidgetItem* row = table_->currentItem();
  if (row == nullptr || !fits_) return nullptr;
  return &(*fits_)[static_cast<std::size_t>(row->data(Kind, kIndexRole).toULongLong())];
}

void FitsPanel::showBodies(const QSet<QString>& ids) {
  goToRow(*table_, [&](const QTreeWidgetItem& row) {
    const PairFit& fit = (*fits_)[static_cast<std::size_t>(row.data(Kind, kIndexRole).toULongLong())];
    return ids.contains(toQString(fit.a)) || ids.contains(toQString(fit.b));
  });
}

bool FitsPanel::choose(const QString& a, const QString& b) {
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = table_->topLevelItem(i);
    const PairFit& fit = (*fits_)[static_cast<std::size_t>(row->data(Kind, kIndexRole).toULongLong())];
    const std::pair ids{toQString(fit.a), toQString(fit.b)};
    const bool found = ids == std::pair(a, b) || ids == std::pair(b, a);
    if (!found) continue;
    table_->setCurrentItem(row);
    return true;
  }
  return false;
}

}  // namespace glissade
