// The whole window in this process, in a language, without drawing.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QLocale>
#include <QTabWidget>
#include <QTranslator>
#include <memory>

#include "app/window/main_window.h"
#include "app/window/theme.h"
#include "tests/engine/support/directories.h"
#include "tests/widgets/scene3d/unseen_scene.h"
#include "widgets/workbench/panel_docks.h"
#include "widgets/workbench/preferences.h"

namespace glissade::test {

/// Brings each panel of the window to the front, and visits its dock.
template <class Visit>
void forEachPanel(QMainWindow& window, Visit visit) {
  for (QDockWidget* dock : docksInOrder(window)) {
    auto* tabs = qobject_cast<QTabWidget*>(dock->widget());
    ASSERT_NE(tabs, nullptr);
    for (int tab = 0; tab < tabs->count(); ++tab) {
      tabs->setCurrentIndex(tab);
      dock->show();
      dock->raise();
      QApplication::processEvents();
      SCOPED_TRACE(tabs->widget(tab)->objectName().toStdString());
      visit(*dock);
    }
  }
}

/// The parameter is the language: "en" or "fr".
class WholeWindowTest : public testing::TestWithParam<const char*> {
 public:
  static QString sample(const char* name) {
    return QString::fromStdString(sourceDirectory()) + QStringLiteral("/samples/") + QLatin1String(name) +
           QStringLiteral("/scenario.json");
  }

 protected:
  WholeWindowTest() {
    QLocale::setDefault(QLocale(QLatin1String(GetParam())));
    if (QLatin1String(GetParam()) == QLatin1String("fr")) {
      EXPECT_TRUE(french_.load(QString::fromStdString(programDirectory()) + QStringLiteral("/../app/glissade_fr.qm")));
      QApplication::installTranslator(&french_);
    }
    usual_ = QApplication::palette();
  }
  ~WholeWindowTest() override {
    QApplication::removeTranslator(&french_);
    QLocale::setDefault(locale_);
    qApp->setStyleSheet(QString());
    QApplication::setPalette(usual_);
  }

  std::unique_ptr<MainWindow> makeWindow(SessionClock clock = SessionClock::Lockstep) {
    setFontPoints(Preferences{}.fontPoints);
    auto window = std::make_unique<MainWindow>([](QWidget*) { return std::make_unique<UnseenScene>(); }, clock);
    window->setBatch(true);
    window->setTheme(Theme::Light);
    window->resize(1280, 720);
    return window;
  }

 private:
  QLocale locale_;  ///< as it was before
  QTranslator french_;
  QPalette usual_;
};

}  // namespace glissade::test
