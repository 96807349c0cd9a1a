#pragma once

#include <QAction>
#include <QHBoxLayout>
#include <QHash>
#include <QObject>
#include <QString>
#include <utility>
#include <vector>

namespace glissade {

/// The place of an action or of a submenu in the menus. Entries are sorted by group and order; a separator stands
/// between groups.
struct MenuPlace {
  const char* menu = "";  ///< "menu.file"; empty: none, because a controller fills the menu
  int group = 0;
  int order = 0;
};

/// One row of the catalogue. Every action has an id, for scripts and shortcuts. Texts are English; they are translated
/// in the context "Actions", the help in "ActionHelp".
struct ActionSpec {
  const char* id;           ///< "run.start"; the icon has the same name
  const char* text;         ///< with mnemonic
  const char* key = "";     ///< shortcut as portable text; may be empty
  const char* tip;          ///< the effect, in one sentence
  MenuPlace place = {};     ///< where it is in the menus
  const char* button = "";  ///< short text of buttons whose panel or icon gives the context; empty: the whole text
  const char* help = "";    ///< further help, for a person who sees the action for the first time; may be empty
  bool checkable = false;
  bool remembered = false;  ///< the check mark is a choice for all scenarios, which the settings keep
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

/// The actions of one window, by id.
class ActionCatalogue final : public QObject {
  Q_OBJECT

 public:
  /// `specs`: the actions of all features, in the order of the help page.
  ActionCatalogue(std::vector<ActionSpec> specs, QObject* parent);

  const std::vector<ActionSpec>& specs() const { return specs_; }
  /// Precondition: the id is in specs().
  QAction* operator[](const QString& id) const { return actions_.value(id); }
  /// Null if no action has this id.
  QAction* find(const QString& id) const { return actions_.value(id, nullptr); }
  /// Sets another shortcut for an action, as long as the window exists; empty: none. Precondition: the id is in
  /// specs().
  void setShortcut(const QString& id, const QKeySequence& keys);
  /// The shortcut in specs().
  QKeySequence usualShortcut(const QString& id) const;
  /// "Ctrl+O  Open a scenario" lines as HTML table rows, for the help page.
  QString shortcutTable() const;
  /// Temporary actions that are in no catalogue, such as the named views of a scenario. They are found by their name as
  /// the others are.
  void setPassing(const QList<QAction*>& actions) { passing_ = actions; }
  const QList<QAction*>& passing() const { return passing_; }

 private:
  const ActionSpec& specOf(const QString& id) const;

  std::vector<ActionSpec> specs_;
  QList<QAction*> passing_;
  QHash<QString, QAction*> actions_;
};

/// A row of flat buttons for actions, reached with Tab.
QHBoxLayout* makeActionRow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent);
/// The buttons of makeActionRow() in as many rows as the width of the panel needs.
QLayout* makeActionFlow(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent);

}  // namespace glissade
