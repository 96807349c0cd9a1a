#pragma once

#include <QString>
#include <QStringList>

#include "widgets/help/manual_facts.h"

namespace glissade {

/// Makes the HTML of terms in the sources of the manual. A term that does not exist is a problem, not a text.
/// - `{action:run.start}`: its menu, name and keys; `{name:run.start}` its name, `{keys:run.start}` its keys
/// - `{panel:run}`: its title, a link to its section
/// - `{parameter:alpha}`: its label, a link to its row
/// - `{strategy:auto}`, `{operator:hand}`: its name
/// - `{ui:PathPanel/Speed}`: another text of the window, by its context and English text
/// - `{table:parameters}`: see manualTable()
class ManualTerms {
 public:
  explicit ManualTerms(const ManualFacts& facts) : facts_(facts) {}

  QString html(const QString& kind, const QString& argument);
  /// The terms that do not exist, as the sources write them.
  const QStringList& problems() const { return problems_; }

 private:
  QString known(const QString& kind, const QString& argument) const;
  QString actionHtml(const QString& kind, const QString& id) const;

  const ManualFacts& facts_;
  QStringList problems_;
};

}  // namespace glissade
