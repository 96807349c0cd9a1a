#pragma once

#include <QAction>
#include <QHBoxLayout>
#include <QHash>
#include <QObject>
#include <QString>
#include <utility>
#include <vector>

namespace glissade {

/// One row of the catalogue: everything that can be done has an id, for scripts and shortcuts.
struct ActionSpec {
  const char* id;        ///< "run.start"
  const char* text;      ///< English, with mnemonic; translated in the context "Actions"
  const char* shortcut;  ///< portable text; may be empty
  const char* tip;       ///< what it does, one sentence
  bool checkable;
};

/// The text of an action without its mnemonic; "&&" stands for a '&'.
inline QString withoutMnemonic(QString text) {
  for (int at = text.indexOf(QLatin1Char('&')); at >= 0; at = text.indexOf(QLatin1Char('&'), at + 1)) {
    text.remove(at, 1);
  }
  return text;
}

/// The same without the dots of "opens a dialog": as people name the command.
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
  /// Null where there is none.
  QAction* find(const QString& id) const { return actions_.value(id, nullptr); }
  /// Another shortcut for an action, as long as the window is there; empty: none. Precondition: as above.
  void setShortcut(const QString& id, const QKeySequence& keys);
  /// The one that it has in actionSpecs().
  static QKeySequence usualShortcut(const QString& id);
  /// "Ctrl+O  Open a scenario" lines as HTML table rows, for the help page.
  QString shortcutTable() const;
  /// Actions that are there for a while and in no catalogue, such as the named views of a scenario. They are found by
  /// their name as the others are.
  void setPassing(const QList<QAction*>& actions) { passing_ = actions; }
  const QList<QAction*>& passing() const { return passing_; }

 private:
  QList<QAction*> passing_;
  QHash<QString, QAction*> actions_;
};

/// A row of flat buttons for actions, reached with Tab.
QHBoxLayout* makeActionRow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent);
/// The same in as many rows as the width of the panel asks for.
QLayout* makeActionFlow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent);

}  // namespace glissade
