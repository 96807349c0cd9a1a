#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSet>
#include <QWidget>

#include <memory>
#include <vector>

#include "engine/fits/fit_table.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/name_table.h"

namespace glissade {

using PairFitsPtr = std::shared_ptr<const std::vector<PairFit>>;

/// The pairs of bodies that touch or overlap as loaded: kind, gap or overlap, allowance, status. The table can be
/// sorted by every column and filtered by a text.
class FitsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit FitsPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Null: not analysed yet, or not valid any more.
  void setFits(const PairFitsPtr& fits);
  const PairFitsPtr& fits() const { return fits_; }
  /// The pair of the current row; null: none.
  const PairFit* chosen() const;
  /// Makes the row of this pair the current one. False if there is none.
  bool choose(const QString& a, const QString& b);
  /// Goes to the first row about one of these bodies, which were selected elsewhere; emits no signal.
  void showBodies(const QSet<QString>& ids);

 signals:
  void chosenChanged();
  /// A row was double-clicked, or Enter was pressed on it.
  void activated();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void addRow(std::size_t index);
  QString summary() const;

  PairFitsPtr fits_;
  QLabel* summary_;
  QLineEdit* filter_;
  NameTable* table_;
};

/// The kind of a contact in the user's language.
QString contactKindText(ContactKind kind);

}  // namespace glissade
