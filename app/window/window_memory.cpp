#include "app/window/window_memory.h"

#include <QFileInfo>

#include <vector>

namespace glissade {
namespace {

constexpr int kMostFiles = 10;
/// Grows when panels are added or renamed: an older layout would hide them.
constexpr int kLayoutVersion = 2;

const QLatin1String kFiles("recent-files");
const QLatin1String kState("layout/panels");
const QLatin1String kGeometry("layout/window");

const QLatin1String kLanguage("preferences/language");
const QLatin1String kFontPoints("preferences/font-points");
const QLatin1String kChoices("choices/");
const QLatin1String kShortcuts("shortcuts/");

/// Checkable actions that are a user's choice for all scenarios.
std::vector<QLatin1String> choiceIds() {
  std::vector<QLatin1String> ids;
  for (const ActionSpec& spec : actionSpecs()) {
    const QLatin1String id(spec.id);
    if (id.startsWith(QLatin1String("navigation.")) || id == QLatin1String("view.dark") ||
        id == QLatin1String("view.orthographic") || id == QLatin1String("display.depth-shading") ||
        id == QLatin1String("path.follow")) {
      ids.push_back(id);
    }
  }
  return ids;
}

/// Name, focus, quaternion x y z w, distance, orthographic.
constexpr int kViewFields = 10;

/// A file name has characters that a key cannot have.
QString viewsKey(const QString& file) {
  const QByteArray path = QFileInfo(file).absoluteFilePath().toUtf8();
  return QStringLiteral("views/") + QString::fromLatin1(path.toBase64(QByteArray::Base64UrlEncoding));
}

}  // namespace

WindowMemory::WindowMemory()
    : settings_(QSettings::NativeFormat, QSettings::UserScope, QStringLiteral("glissade"), QStringLiteral("window")) {}

WindowMemory::WindowMemory(const QString& file) : settings_(file, QSettings::IniFormat) {}

QStringList WindowMemory::recentFiles() const { return settings_.value(kFiles).toStringList().mid(0, kMostFiles); }

void WindowMemory::noteFile(const QString& file) {
  const QString absolute = QFileInfo(file).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(absolute);
  files.prepend(absolute);
  settings_.setValue(kFiles, QStringList(files.mid(0, kMostFiles)));
}

void WindowMemory::forgetFiles() { settings_.remove(kFiles); }

void WindowMemory::saveLayout(const QMainWindow& window) {
  settings_.setValue(kState, window.saveState(kLayoutVersion));
  settings_.setValue(kGeometry, window.saveGeometry());
}

void WindowMemory::restoreLayout(QMainWindow& window, bool sizeToo) const {
  if (sizeToo) window.restoreGeometry(settings_.value(kGeometry).toByteArray());
  window.restoreState(settings_.value(kState).toByteArray(), kLayoutVersion);
}

NamedViews WindowMemory::views(const QString& file) const {
  NamedViews views;
  for (const QVariant& entry : settings_.value(viewsKey(file)).toList()) {
    const QVariantList fields = entry.toList();
    if (fields.size() != kViewFields) continue;
    const auto number = [&](int i) { return fields[i].toDouble(); };
    CameraPose pose;
    pose.focus = {number(1), number(2), number(3)};
    pose.R_WV = Quaternion(number(7), number(4), number(5), number(6));
    pose.distance = number(8);
    pose.orthographic = fields[9].toBool();
    if (pose.R_WV.norm() > 0.5 && pose.distance > 0.0) views.push_back({fields[0].toString(), pose});
  }
  return views;
}

void WindowMemory::saveViews(const QString& file, const NamedViews& views) {
  QVariantList entries;
  for (const NamedView& view : views) {
    const Vector3& p = view.pose.focus;
    const Quaternion& R = view.pose.R_WV;
    const QVariantList fields{
        view.name, p.x(), p.y(), p.z(), R.x(), R.y(), R.z(), R.w(), view.pose.distance, view.pose.orthographic};
    entries.push_back(QVariant(fields));
  }
  if (file.isEmpty()) return;
  if (entries.isEmpty()) {
    settings_.remove(viewsKey(file));
  } else {
    settings_.setValue(viewsKey(file), entries);
  }
}

Preferences WindowMemory::preferences() const {
  Preferences preferences;
  preferences.language = settings_.value(kLanguage).toString();
  const double points = settings_.value(kFontPoints, preferences.fontPoints).toDouble();
  if (points >= kLeastFontPoints && points <= kMostFontPoints) preferences.fontPoints = points;
  return preferences;
}

void WindowMemory::savePreferences(const Preferences& preferences) {
  settings_.setValue(kLanguage, preferences.language);
  settings_.setValue(kFontPoints, preferences.fontPoints);
}

void WindowMemory::saveChoices(const ActionCatalogue& actions) {
  for (const QLatin1String id : choiceIds()) settings_.setValue(kChoices + id, actions[id]->isChecked());
  settings_.remove(QStringLiteral("shortcuts"));
  for (const ActionSpec& spec : actionSpecs()) {
    const QLatin1String id(spec.id);
    const QKeySequence keys = actions[id]->shortcut();
    if (keys != ActionCatalogue::usualShortcut(id)) settings_.setValue(kShortcuts + id, keys.toString());
  }
}

void WindowMemory::restoreChoices(ActionCatalogue& actions) const {
  for (const ActionSpec& spec : actionSpecs()) {
    const QLatin1String id(spec.id);
    if (settings_.contains(kShortcuts + id)) {
      actions.setShortcut(id, QKeySequence(settings_.value(kShortcuts + id).toString()));
    }
  }
  for (const QLatin1String id : choiceIds()) {
    QAction* action = actions[id];
    const bool chosen = settings_.value(kChoices + id, action->isChecked()).toBool();
    const bool isOneOfSeveral = action->actionGroup() != nullptr;
    if (chosen || !isOneOfSeveral) action->setChecked(chosen);
  }
}

}  // namespace glissade
