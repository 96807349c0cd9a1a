#pragma once

#include <QAction>
#include <QHBoxLayout>
#include <QHash>
#include <QObject>
#include <QString>
#include <utility>
#include <vector>

namespace glissade {

/// One row of the catalogue. Every action has an id, for scripts and shortcuts.
struct ActionSpec {
  const char* id;        ///< "run.start"
  const char* text;      ///< English, with mnemonic; translated in the context "Actions"
  const char* shortcut;  ///< portable text; may be empty
  const char* tip;       ///< the effect, in one sentence
  bool checkable;
};

/// The text of an action without its mnemonic; "&&" stands for a '&'.
inline QString withoutMnemonic(QString text) {
  for (int at = text.indexOf(QLatin1Char('&')); at >= 0; at = text.indexOf(QLatin1Char('&'), at + 1)) {
    text.remove(at, 1);
  }
  return text;
}

/// The text of an action without its mnemonic and without the dots that announce a dialog.
inline QString commandName(QString text) {
  text = withoutMnemonic(std::move(text));
  if (text.endsWith(QStringLiteral("..."))) text.chop(3);
  return text;
}

/// All actions, in the order of the help page.
const std::vector<ActionSpec>& actionSpecs();

/// The actions of one window, by id.
class ActionCatalogue final : public QObject {
  Q_OBJECT

 public:
  explicit ActionCatalogue(QObject* parent);

  /// Precondition: the id is in actionSpecs().
  QAction* operator[](const QString& id) const { return actions_.value(id); }
  /// Null if no action has this id.
  QAction* find(const QString& id) const { return actions_.value(id, nullptr); }
  /// Sets another shortcut for an action, as long as the window exists; empty: none. Precondition: the id is in
  /// actionSpecs().
  void setShortcut(const QString& id, const QKeySequence& keys);
  /// The shortcut in actionSpecs().
  static QKeySequence usualShortcut(const QString& id);
  /// "Ctrl+O  Open a scenario" lines as HTML table rows, for the help page.
  QString shortcutTable() const;
  /// Temporary actions that are in no catalogue, such as the named views of a scenario. They are found by their name as
  /// the others are.
  void setPassing(const QList<QAction*>& actions) { passing_ = actions; }
  const QList<QAction*>& passing() const { return passing_; }

 private:
  QList<QAction*> passing_;
  QHash<QString, QAction*> actions_;
};

/// A row of flat buttons for actions, reached with Tab.
QHBoxLayout* makeActionRow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent);
/// The buttons of makeActionRow() in as many rows as the width of the panel needs.
QLayout* makeActionFlow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent);

}  // namespace glissade
