#include "app/window/application.h"

#include <glissade/version.h>
#include <signal.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QLocale>
#include <QRegularExpression>
#include <QScreen>
#include <QStandardPaths>
#include <QTimer>
#include <QTranslator>

#include <algorithm>
#include <clocale>
#include <cstring>
#include <iostream>

#include "app/window/guarded_application.h"
#include "app/window/main_window.h"
#include "app/window/screen_fit.h"
#include "app/window/theme.h"
#include "app/window/window_picture.h"
#include "engine/base/file.h"
#include "engine/base/memory_use.h"
#include "engine/base/number_text.h"
#include "engine/base/version_text.h"
#include "engine/files/part_files.h"
#include "widgets/controls/fresh_tips.h"
#include "widgets/controls/picture_file.h"
#include "widgets/help/manual_controller.h"
#include "widgets/help/manual_writer.h"
#include "widgets/scene3d/stereo_mode.h"
#include "widgets/studies/study_batch.h"
#include "widgets/workbench/scenario_pictures.h"
#include "widgets/workbench/script_runner.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {
namespace {

constexpr std::size_t kMostScriptBytes = 1U << 20;

int fail(const Diagnostic& why) {
  std::cerr << "glissade: " << toString(why) << "\n";
  return exitCode(why.kind);
}

int failUsage(const std::string& option, const Message& reason, const Message& advice) {
  return fail({ErrorKind::Usage, "", option, reason, advice});
}

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<int>(view.size())); }

/// "--alpha" as QCommandLineParser wants it: "alpha".
QString optionName(const ParameterSpec& spec) { return text(spec.option).mid(2); }

void addOptions(QCommandLineParser& parser) {
  parser.setApplicationDescription(QStringLiteral("Glissade: a workbench for virtual assembly"));
  parser.addPositionalArgument(
      QStringLiteral("SCENARIO"),
      QStringLiteral("Scenario file, OMPL.app .cfg, or on screen part files (STEP, mesh, URDF)"),
      QStringLiteral("[SCENARIO | PART...]"));
  parser.addOptions({
      {"offscreen", "Run without a display"},
      {"screenshot", "Save a picture of the whole window and quit", "FILE"},
      {"thumbnail", "Save a small picture of the scene as PNG and quit", "FILE"},
      {"thumbnail-pixels", "Width and height of the small picture", "PIXELS", "256"},
      {"size", "Size of the window in pixels", "WxH", "1280x720"},
      {"script", "Carry out a script and quit", "FILE"},
      {"study-pictures", "Take pictures of the typical roadmaps of the study in DIR, for its report", "DIR"},
      {"report-pdf", "Write the report of the study (or the page of the benchmarks) in DIR as PDF there", "DIR"},
      {"write-manual", "Write the manual as HTML into DIR, in a folder for the language, and quit", "DIR"},
      {"theme", "light or dark (default: as in the preferences, or the desktop's; light in scripts)", "THEME", "light"},
      {"stereo",
       "How the scene is drawn for two eyes: off, anaglyph, side-by-side, top-bottom, interlaced, checkerboard, "
       "quad-buffer, left-eye or right-eye (default: as it was left; off in scripts)",
       "MODE"},
      {"language", "en or fr (default: as in the preferences, or the desktop's; en in scripts)", "LANGUAGE"},
      {"seed", "Seed of everything random", "SEED"},
      {"help", "Show this help and quit"},
      {"version", "Show the version and quit"},
  });
  for (const ParameterSpec& spec : parameterTable()) {
    parser.addOption({optionName(spec), QString::fromUtf8(spec.help.english), QStringLiteral("VALUE")});
  }
}

std::optional<QSize> parseSize(const QString& value) {
  const QStringList parts = value.split(QLatin1Char('x'));
  bool widthOk = false;
  bool heightOk = false;
  if (parts.size() != 2) return std::nullopt;
  const QSize size(parts[0].toInt(&widthOk), parts[1].toInt(&heightOk));
  const bool sensible = size.width() >= 320 && size.height() >= 240 && size.width() <= 8192 && size.height() <= 8192;
  return widthOk && heightOk && sensible ? std::optional<QSize>(size) : std::nullopt;
}

std::optional<int> parseThumbnailPixels(const QCommandLineParser& parser) {
  bool ok = false;
  const int pixels = parser.value(QStringLiteral("thumbnail-pixels")).toInt(&ok);
  return ok && pixels >= 16 && pixels <= 2048 ? std::optional<int>(pixels) : std::nullopt;
}

/// Sets the parameters and the seed of the command line instead of the scenario's.
std::optional<Diagnostic> applyParameters(const QCommandLineParser& parser, MainWindow& window) {
  for (const ParameterSpec& spec : parameterTable()) {
    if (!parser.isSet(optionName(spec))) continue;
    const auto value = toNumber(parser.value(optionName(spec)).toStdString());
    ParameterValues trial = window.workbench().document.settings().parameters;
    if (!value)
      return Diagnostic{ErrorKind::Usage, "", std::string(spec.option), GLISSADE_TEXT("is not a number"),
                        GLISSADE_TEXT("Give a number.")};
    const Outcome outcome = trial.set(spec.id, *value);
    if (!outcome) return outcome.error();
    window.workbench().session.post(command::SetParameter{spec.id, *value});
  }
  if (!parser.isSet(QStringLiteral("seed"))) return std::nullopt;
  bool ok = false;
  const qulonglong seed = parser.value(QStringLiteral("seed")).toULongLong(&ok);
  if (!ok)
    return Diagnostic{ErrorKind::Usage, "", "--seed", GLISSADE_TEXT("is not a whole number"),
                      GLISSADE_TEXT("Give a number of 0 or more.")};
  window.workbench().session.post(command::SetSeed{seed});
  return std::nullopt;
}

int runScriptFile(const std::string& file, const Workbench& bench) {
  const auto script = readFile(file, kMostScriptBytes);
  if (!script) return fail(script.error());
  const auto lines = parseScript(*script, file, bench.scripts);
  if (!lines) return fail(lines.error());
  if (const auto why = runScript(*lines, file, bench.scripts, [&bench] { return bench.work.takeFailure(); }))
    return fail(*why);
  return 0;
}

Theme themeNamed(const QString& name) { return name == "dark" ? Theme::Dark : Theme::Light; }

std::optional<Diagnostic> applyStereo(const QCommandLineParser& parser, const ActionCatalogue& actions) {
  if (!parser.isSet("stereo")) return std::nullopt;
  const auto mode = stereoModeNamed(parser.value("stereo").toStdString());
  if (!mode) {
    return Diagnostic{ErrorKind::Usage, "", "--stereo", GLISSADE_TEXT("is not a mode of stereo"),
                      GLISSADE_TEXT("glissade --help names them.")};
  }
  QAction* action = actions[QLatin1String(entryOf(*mode).action)];
  if (!action->isEnabled())
    return Diagnostic{ErrorKind::Usage, "", "--stereo", GLISSADE_TEXT("is a mode that is not possible here"), {}};
  action->trigger();
  return std::nullopt;
}

/// Whether the program runs without a person.
bool isBatch(const QCommandLineParser& parser) {
  return parser.isSet("script") || parser.isSet("screenshot") || parser.isSet("thumbnail") ||
         parser.isSet("offscreen") || parser.isSet("study-pictures") || parser.isSet("report-pdf") ||
         parser.isSet("write-manual");
}

bool areParts(const QStringList& files) {
  return !files.isEmpty() &&
         std::all_of(files.begin(), files.end(), [](const QString& file) { return isPartFile(file.toStdString()); });
}

/// The command line opens one scenario. On screen it also takes several part files, because a person says how they are
/// taken.
std::optional<Diagnostic> tooManyFiles(const QCommandLineParser& parser) {
  const QStringList files = parser.positionalArguments();
  if (files.size() < 2 || (!isBatch(parser) && areParts(files))) return std::nullopt;
  return Diagnostic{
      ErrorKind::Usage, files[1].toStdString(), "", GLISSADE_TEXT("is a file too many: one scenario is opened"),
      GLISSADE_TEXT("Give one scenario, or on screen part files only. glissade-cli new makes a scenario of parts.")};
}

int runWindow(const QCommandLineParser& parser, const QStringList& files, MainWindow& window) {
  const bool batch = isBatch(parser);
  window.setBatch(batch);
  if (!batch && !parser.isSet("size")) {
    window.resize(window.size().boundedTo(QGuiApplication::primaryScreen()->availableSize()));
  }
  if (!batch) window.remember(std::make_unique<WindowMemory>(), !parser.isSet("size"));
  if (parser.isSet("theme")) window.setTheme(themeNamed(parser.value("theme")));
  if (const auto why = applyStereo(parser, window.workbench().actions)) return fail(*why);
  const QString file = files.value(0);
  const bool asksForParts = !batch && areParts(files);
  if (!file.isEmpty() && !asksForParts) {
    const auto why = window.openScenario(file, batch);
    if (why && batch) return fail(*why);
    if (!why) {
      if (const auto refused = applyParameters(parser, window)) return fail(*refused);
    }
  }
  const QSize asked = window.size().boundedTo(window.room());
  window.show();
  QApplication::processEvents();
  // Wrapped texts need less room after the layout. The window gets the requested size again, because small screens have
  // no more room.
  if (!window.isMaximized() && !window.isFullScreen()) window.resize(asked);
  QApplication::processEvents();
  if (!batch) {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    window.keepUnsavedEdits(data + QStringLiteral("/unsaved"));
    window.keepJournals(data + QStringLiteral("/recordings"));
  }
  if (asksForParts) QTimer::singleShot(0, &window, [&window, files] { window.importParts(files); });
  if (parser.isSet("script")) {
    const int status = runScriptFile(parser.value("script").toStdString(), window.workbench());
    if (status != 0) return status;
  }
  if (parser.isSet("study-pictures")) {
    const std::string folder = parser.value("study-pictures").toStdString();
    const Outcome taken = window.workbench().scripts.carryOut("study-pictures", {folder});
    if (!taken) return fail(taken.error());
  }
  if (parser.isSet("report-pdf")) {
    if (const auto why = writeFolderPdf(parser.value("report-pdf"))) return fail(*why);
  }
  if (parser.isSet("write-manual")) {
    const Outcome written = writeManual(manualFacts(window, window.workbench().actions), parser.value("write-manual"));
    if (!written) return fail(written.error());
  }
  if (parser.isSet("screenshot")) {
    const SaveResult saved = savePicture(pictureOf(window), parser.value("screenshot"));
    if (!saved) return fail(saved.why);
  }
  if (parser.isSet("thumbnail")) {
    const int pixels = *parseThumbnailPixels(parser);
    const QImage picture = smallScenePicture(window.workbench().scene, QSize(pixels, pixels));
    const SaveResult saved = savePicture(picture, parser.value("thumbnail"), "PNG");
    if (!saved) return fail(saved.why);
  }
  return batch ? 0 : QApplication::exec();
}

bool asksForText(int argc, char** argv) {
  return std::any_of(argv, argv + argc, [](const char* argument) {
    return std::strcmp(argument, "--help") == 0 || std::strcmp(argument, "--version") == 0;
  });
}

/// Help and version need no display.
int tell(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  QCommandLineParser parser;
  addOptions(parser);
  if (!parser.parse(QCoreApplication::arguments())) {
    return failUsage("", Message(parser.errorText().toStdString()), GLISSADE_TEXT("See glissade --help."));
  }
  if (parser.isSet("help")) {
    std::cout << parser.helpText().toStdString();
  } else {
    std::cout << "glissade " << versionText() << "\n";
  }
  return 0;
}

}  // namespace

void prepareProcess() {
  giveFreedMemoryBack();
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  QCoreApplication::setLibraryPaths(QCoreApplication::libraryPaths().filter(QRegularExpression(QStringLiteral("^/"))));
}

int runApplication(int argc, char** argv, const SceneWidgetFactory& makeScene, SessionClock clock) {
  if (asksForText(argc, argv)) return tell(argc, argv);
  QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  // PassThrough draws a desktop at 150 % at 150 %, not at 200 %.
  QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  GuardedApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // files hold decimal points, whatever the desktop's language
  QApplication::setApplicationName(QStringLiteral("Glissade"));
  QApplication::setApplicationVersion(QLatin1String(kVersion));

  QCommandLineParser parser;
  addOptions(parser);
  if (!parser.parse(QApplication::arguments())) {
    return failUsage("", Message(parser.errorText().toStdString()), GLISSADE_TEXT("See glissade --help."));
  }
  const auto size = parseSize(parser.value("size"));
  if (!size)
    return failUsage("--size", GLISSADE_TEXT("is not WIDTHxHEIGHT"), GLISSADE_TEXT("Give for example 1280x720."));
  if (!parseThumbnailPixels(parser)) {
    return failUsage("--thumbnail-pixels", GLISSADE_TEXT("is not a whole number from 16 to 2048"),
                     GLISSADE_TEXT("Give for example 256."));
  }
  if (const auto why = tooManyFiles(parser)) return fail(*why);
  const QString theme = parser.value("theme");
  if (theme != "light" && theme != "dark") return failUsage("--theme", GLISSADE_TEXT("is neither light nor dark"), {});
  const QString asked = parser.value("language");
  if (parser.isSet("language") && asked != "en" && asked != "fr") {
    return failUsage("--language", GLISSADE_TEXT("is neither en nor fr"), {});
  }
  const Preferences preferences = isBatch(parser) ? Preferences{"en"} : WindowMemory().preferences();
  const QString language = languageOf(asked, preferences, QLocale::system().name().section(QLatin1Char('_'), 0, 0));
  setFontPoints(preferences.fontPoints);
  if (preferences.lengthUnit) setLengthUnit(*preferences.lengthUnit);
  QTranslator translator;
  QLocale::setDefault(QLocale(language));
  if (language == "fr" && translator.load(QStringLiteral(":/i18n/glissade_fr.qm"))) {
    QApplication::installTranslator(&translator);
  }

  // A window without a display has no screen to fit.
  if (clock != SessionClock::Lockstep) {
    application.installEventFilter(new ScreenFit(&application));
    new FreshTips(&application);
  }
  for (QStringList files = parser.positionalArguments();; files.clear()) {
    MainWindow window(makeScene, clock);
    window.setTheme(themeNamed(theme));
    // Without a display the window has the size of the screen.
    window.resize(*size);
    window.fitInto(clock == SessionClock::Lockstep ? *size : roomOn(window));
    WorkController& work = window.workbench().work;
    application.setFailureHandler([&work](const Diagnostic& why) { work.reportFailure(why); });
    const int status = runWindow(parser, files, window);
    application.setFailureHandler({});
    if (window.closesToWelcomePage()) continue;
    // On screen the user has read the failure.
    const auto why = work.takeFailure();
    const bool batch = clock == SessionClock::Lockstep || parser.isSet("script");
    return status == 0 && why && batch ? fail(*why) : status;
  }
}

}  // namespace glissade
