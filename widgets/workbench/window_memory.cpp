#include "widgets/workbench/window_memory.h"

#include <QColor>
#include <QFileInfo>

#include <array>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/files/work_times_json.h"

namespace glissade {
namespace {

constexpr int kMostFiles = 10;

const QLatin1String kFiles("recent-files");
const QLatin1String kFolders("folders/");
const QLatin1String kLayout("layout/");
const QLatin1String kGeometry("layout/window");

const QLatin1String kLanguage("preferences/language");
const QLatin1String kFontPoints("preferences/font-points");
const QLatin1String kLengthUnit("preferences/length-unit");
const QLatin1String kAutosave("preferences/autosave-seconds");
const QLatin1String kTheme("preferences/theme");
const QLatin1String kColours("preferences/colours/");
const QLatin1String kGhosts("path/ghosts-");
const QLatin1String kInstructionTemplate("instruction-template");
const QLatin1String kWorkTimes("work-times/");
const QLatin1String kStereo("stereo/");
const QLatin1String kChoices("choices/");
const QLatin1String kShortcuts("shortcuts/");

constexpr EnumNames<LengthUnit, 3> kUnitNames{{"mm", "in", "m"}};
constexpr EnumNames<ThemeChoice, 3> kThemeNames{{"desktop", "light", "dark"}};

/// Visits each colour with its key in the settings.
template <class Colours, class Visit>
void forEachColour(Colours& colours, Visit visit) {
  visit("background", colours.background);
  visit("path", colours.path);
  visit("start", colours.start);
  visit("goal", colours.goal);
}

/// Keys in the settings of lengths in metres.
constexpr std::array<std::pair<const char*, double ScreenGeometry::*>, 3> kScreenLengths{
    {{"screen-width", &ScreenGeometry::width},
     {"distance", &ScreenGeometry::distance},
     {"eye-separation", &ScreenGeometry::eyeSeparation}}};

/// Number of fields of a view: name, focus, quaternion x y z w, distance, orthographic.
constexpr int kViewFields = 10;

/// The key for a file's views, with the path in base64, because a file name can have characters that a key cannot have.
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

QString WindowMemory::folder(const QString& purpose) const { return settings_.value(kFolders + purpose).toString(); }

void WindowMemory::noteFolder(const QString& purpose, const QString& folder) {
  settings_.setValue(kFolders + purpose, folder);
}

QByteArray WindowMemory::windowGeometry() const { return settings_.value(kGeometry).toByteArray(); }

PanelDocks::Layouts WindowMemory::layouts() const {
  PanelDocks::Layouts layouts;
  for (const Workspace workspace : kWorkspaces) {
    const QByteArray layout = settings_.value(kLayout + QLatin1String(kWorkspaceActions.of(workspace))).toByteArray();
    if (!layout.isEmpty()) layouts[workspace] = layout;
  }
  return layouts;
}

void WindowMemory::saveLayouts(const PanelDocks::Layouts& layouts, const QByteArray& geometry) {
  for (auto layout = layouts.begin(); layout != layouts.end(); ++layout) {
    settings_.setValue(kLayout + QLatin1String(kWorkspaceActions.of(layout.key())), layout.value());
  }
  settings_.setValue(kGeometry, geometry);
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

PathSpacing WindowMemory::ghosts() const {
  PathSpacing spacing;
  const int by = settings_.value(kGhosts + QLatin1String("by"), static_cast<int>(spacing.by)).toInt();
  if (by >= 0 && by <= static_cast<int>(PathSpacing::By::Distance)) spacing.by = static_cast<PathSpacing::By>(by);
  const int number = settings_.value(kGhosts + QLatin1String("number"), spacing.number).toInt();
  if (number >= 1 && number <= kMostPathPoses) spacing.number = number;
  const double distance = settings_.value(kGhosts + QLatin1String("distance"), spacing.distance).toDouble();
  if (distance > 0.0) spacing.distance = distance;
  return spacing;
}

void WindowMemory::saveGhosts(const PathSpacing& spacing) {
  settings_.setValue(kGhosts + QLatin1String("by"), static_cast<int>(spacing.by));
  settings_.setValue(kGhosts + QLatin1String("number"), spacing.number);
  settings_.setValue(kGhosts + QLatin1String("distance"), spacing.distance);
}

WorkTimes WindowMemory::workTimes() const {
  WorkTimes times;
  for (const WorkTimeRow& row : workTimeRows()) {
    bool isNumber = false;
    const double value = settings_.value(kWorkTimes + QLatin1String(row.id)).toDouble(&isNumber);
    if (isNumber && checkWorkTime(row, value)) times.*row.value = value;
  }
  return times;
}

void WindowMemory::saveWorkTimes(const WorkTimes& times) {
  for (const WorkTimeRow& row : workTimeRows()) {
    const QString key = kWorkTimes + QLatin1String(row.id);
    if (isEdited(times, row)) {
      settings_.setValue(key, times.*row.value);
    } else {
      settings_.remove(key);
    }
  }
}

QString WindowMemory::instructionTemplate() const { return settings_.value(kInstructionTemplate).toString(); }

void WindowMemory::saveInstructionTemplate(const QString& file) { settings_.setValue(kInstructionTemplate, file); }

ThemeChoice WindowMemory::theme() const {
  if (const auto known = kThemeNames.find(settings_.value(kTheme).toString().toStdString())) return *known;
  // Earlier versions kept the theme as the state of an action.
  const QVariant dark = settings_.value(kChoices + QLatin1String("view.dark"));
  if (dark.isNull()) return ThemeChoice::Desktop;
  return dark.toBool() ? ThemeChoice::Dark : ThemeChoice::Light;
}

StereoSettings WindowMemory::stereo() const {
  StereoSettings settings;
  const QString mode = settings_.value(kStereo + QLatin1String("mode")).toString();
  settings.mode = stereoModeNamed(mode.toStdString()).value_or(StereoMode::Off);
  settings.swapped = settings_.value(kStereo + QLatin1String("swapped")).toBool();
  const std::string convergence = settings_.value(kStereo + QLatin1String("convergence")).toString().toStdString();
  settings.convergence = kConvergenceNames.find(convergence).value_or(settings.convergence);
  for (const auto& [name, length] : kScreenLengths) {
    const double metres = settings_.value(kStereo + QLatin1String(name), settings.screen.*length).toDouble();
    if (metres >= kLeastScreen.*length && metres <= kMostScreen.*length) settings.screen.*length = metres;
  }
  settings.display = settings_.value(kStereo + QLatin1String("display")).toString();
  return settings;
}

void WindowMemory::saveStereo(const StereoSettings& settings) {
  settings_.setValue(kStereo + QLatin1String("mode"), QLatin1String(entryOf(settings.mode).name));
  settings_.setValue(kStereo + QLatin1String("swapped"), settings.swapped);
  settings_.setValue(kStereo + QLatin1String("convergence"), QLatin1String(kConvergenceNames.of(settings.convergence)));
  for (const auto& [name, length] : kScreenLengths) {
    settings_.setValue(kStereo + QLatin1String(name), settings.screen.*length);
  }
  settings_.setValue(kStereo + QLatin1String("display"), settings.display);
}

Preferences WindowMemory::preferences() const {
  Preferences preferences;
  preferences.language = settings_.value(kLanguage).toString();
  const double points = settings_.value(kFontPoints, preferences.fontPoints).toDouble();
  if (points >= kLeastFontPoints && points <= kMostFontPoints) preferences.fontPoints = points;
  preferences.lengthUnit = kUnitNames.find(settings_.value(kLengthUnit).toString().toStdString());
  const int seconds = settings_.value(kAutosave, preferences.autosaveSeconds).toInt();
  if (seconds >= kLeastAutosaveSeconds && seconds <= kMostAutosaveSeconds) preferences.autosaveSeconds = seconds;
  preferences.theme = theme();
  forEachColour(preferences.colours, [this](const char* name, std::optional<Colour>& colour) {
    const QColor kept(settings_.value(kColours + QLatin1String(name)).toString());
    if (kept.isValid()) colour = Colour{kept.redF(), kept.greenF(), kept.blueF()};
  });
  return preferences;
}

void WindowMemory::savePreferences(const Preferences& preferences) {
  settings_.setValue(kLanguage, preferences.language);
  settings_.setValue(kFontPoints, preferences.fontPoints);
  settings_.setValue(kLengthUnit, preferences.lengthUnit ? kUnitNames.of(*preferences.lengthUnit) : "fitting");
  settings_.setValue(kAutosave, preferences.autosaveSeconds);
  settings_.setValue(kTheme, QLatin1String(kThemeNames.of(preferences.theme)));
  forEachColour(preferences.colours, [this](const char* name, const std::optional<Colour>& colour) {
    const QString key = kColours + QLatin1String(name);
    if (colour) {
      settings_.setValue(key, QColor::fromRgbF((*colour)[0], (*colour)[1], (*colour)[2]).name());
    } else {
      settings_.remove(key);
    }
  });
}

void WindowMemory::saveChoices(const ActionCatalogue& actions) {
  settings_.remove(QStringLiteral("shortcuts"));
  for (const ActionSpec& spec : actions.specs()) {
    const QLatin1String id(spec.id);
    if (spec.remembered) settings_.setValue(kChoices + id, actions[id]->isChecked());
    const QKeySequence keys = actions[id]->shortcut();
    if (keys != actions.usualShortcut(id)) settings_.setValue(kShortcuts + id, keys.toString());
  }
}

void WindowMemory::restoreChoices(ActionCatalogue& actions) const {
  for (const ActionSpec& spec : actions.specs()) {
    const QLatin1String id(spec.id);
    if (settings_.contains(kShortcuts + id)) {
      actions.setShortcut(id, QKeySequence(settings_.value(kShortcuts + id).toString()));
    }
  }
  for (const ActionSpec& spec : actions.specs()) {
    if (!spec.remembered) continue;
    const QLatin1String id(spec.id);
    QAction* action = actions[id];
    const bool chosen = settings_.value(kChoices + id, action->isChecked()).toBool();
    const bool isOneOfSeveral = action->actionGroup() != nullptr;
    if (chosen || !isOneOfSeveral) action->setChecked(chosen);
  }
}

}  // namespace glissade
