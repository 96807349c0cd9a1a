// The window and its dialogs on screens of 1280 x 720 and 1920 x 1080, scaled to 200 % by the desktop, or with texts of
// twice the usual size.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStyleOptionButton>
#include <QTabBar>
#include <QToolBar>
#include <QToolButton>

#include "app/window/screen_fit.h"
#include "tests/app/every_dialog.h"
#include "tests/app/whole_window.h"
#include "widgets/controls/plain_message_box.h"
#include "widgets/files/welcome_page.h"

namespace glissade {
namespace {

struct Screen {
  QSize room;    ///< logical pixels
  double texts;  ///< size of texts as a multiple of the usual size
};
const Screen kScreens[] = {{{640, 360}, 1.0}, {{960, 540}, 1.0}, {{1280, 720}, 2.0}, {{1920, 1080}, 2.0}};
constexpr QSize kFrame{8, 32};  ///< size of a window's frame

std::string widgetPath(const QWidget& widget) {
  std::string name;
  for (const QWidget* one = &widget; one != nullptr; one = one->parentWidget()) {
    const auto* button = qobject_cast<const QAbstractButton*>(one);
    name += one->metaObject()->className() + std::string(" '") +
            (button != nullptr ? button->text() : one->objectName()).toStdString() + "' < ";
    if (one->isWindow() || qobject_cast<const QDockWidget*>(one) != nullptr) break;
  }
  return name;
}

/// Expects that buttons have room for their text, tabs for their names, and fields for their numbers.
void expectNothingCut(QWidget& root) {
  for (QAbstractButton* button : root.findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || button->text().isEmpty()) continue;
    const auto* tool = qobject_cast<QToolButton*>(button);
    if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) continue;
    const QString text = QString(button->text()).remove(QLatin1Char('&'));
    EXPECT_GE(button->width(), button->fontMetrics().size(0, text).width()) << widgetPath(*button);
  }
  for (QTabBar* tabs : root.findChildren<QTabBar*>()) {
    if (!tabs->isVisible()) continue;
    EXPECT_EQ(tabs->elideMode(), Qt::ElideNone) << widgetPath(*tabs);
  }
  for (QAbstractSpinBox* box : root.findChildren<QAbstractSpinBox*>()) {
    const auto* field = box->findChild<QLineEdit*>();
    if (!box->isVisible() || field == nullptr) continue;
    EXPECT_GE(field->width(), box->fontMetrics().horizontalAdvance(box->text())) << widgetPath(*box);
  }
}

class SmallScreenTest : public test::WholeWindowTest {
 protected:
  ~SmallScreenTest() override { setFontPoints(Preferences{}.fontPoints); }

  std::unique_ptr<MainWindow> makeWindowOn(const Screen& screen) {
    auto window = makeWindow();
    setFontPoints(screen.texts * Preferences{}.fontPoints);
    window->fitInto(screen.room - kFrame);
    return window;
  }
};

TEST_P(SmallScreenTest, TheWindowAndItsPanelsHaveRoom) {
  for (const Screen& screen : kScreens) {
    SCOPED_TRACE(std::to_string(screen.room.width()) + " pixels");
    const auto window = makeWindowOn(screen);
    const QSize room = screen.room - kFrame;
    window->show();
    QApplication::processEvents();
    window->fitInto(room);  // wrapped texts need less room after the layout
    QApplication::processEvents();
    auto* welcome = window->findChild<WelcomePage*>();
    ASSERT_TRUE(welcome->isVisible());
    expectNothingCut(*welcome);
    ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
    QApplication::processEvents();
    window->fitInto(room);
    test::forEachPanel(*window, [&](QDockWidget& dock) {
      QApplication::processEvents();  // a window that has grown shrinks again
      EXPECT_LE(window->minimumSizeHint().width(), room.width());
      EXPECT_LE(window->minimumSizeHint().height(), room.height());
      EXPECT_LE(window->width(), room.width());
      EXPECT_LE(window->height(), room.height());
      expectNothingCut(dock);
    });
    expectNothingCut(*window);
  }
}

TEST_P(SmallScreenTest, NoDialogIsLargerThanTheScreen) {
  for (const Screen& screen : kScreens) {
    SCOPED_TRACE(std::to_string(screen.room.width()) + " pixels");
    const auto window = makeWindowOn(screen);
    ASSERT_EQ(window->openScenario(sample("teaching"), true), std::nullopt);
    const test::EveryDialog every(*window);
    const QSize room = screen.room - kFrame;
    for (const auto& dialog : every.dialogs()) {
      SCOPED_TRACE(dialog->metaObject()->className());
      dialog->adjustSize();
      fitWindow(*dialog, room);
      dialog->show();
      QApplication::processEvents();
      EXPECT_LE(dialog->width(), room.width());
      EXPECT_LE(dialog->height(), room.height());
      expectNothingCut(*dialog);
      dialog->hide();
    }
  }
}

TEST_P(SmallScreenTest, TheButtonsOfMessagesAreWhole) {
  const auto tr = [](const char* context, const char* text) { return QCoreApplication::translate(context, text); };
  for (const Screen& screen : kScreens) {
    SCOPED_TRACE(std::to_string(screen.room.width()) + " pixels");
    setFontPoints(screen.texts * Preferences{}.fontPoints);
    const QSize room = screen.room - kFrame;
    PlainMessageBox left(QMessageBox::Question, QStringLiteral("title"), QStringLiteral("text"),
                         QStringLiteral("details"), nullptr);
    for (const char* text : {"&Open them", "&Discard them", "Ask &later"}) {
      left.addButton(tr("UnsavedEditsDialog", text), QMessageBox::AcceptRole);
    }
    PlainMessageBox changed(QMessageBox::Warning, QStringLiteral("title"), QStringLiteral("text"),
                            QStringLiteral("details"), nullptr);
    for (const char* text : {"&Overwrite", "Open the other &version", "Save &as..."}) {
      changed.addButton(tr("SaveConflict", text), QMessageBox::AcceptRole);
    }
    changed.addButton(QMessageBox::Cancel);
    for (PlainMessageBox* box : {&left, &changed}) {
      fitWindow(*box, room);
      box->show();
      QApplication::processEvents();
      EXPECT_LE(box->width(), room.width());
      EXPECT_LE(box->height(), room.height());
      expectNothingCut(*box);
    }
  }
}

/// A reason with names and advice, as long as the engine's longest, can be read by scrolling; its button stays visible.
TEST_P(SmallScreenTest, TheLongestMessageIsScrolledAboveItsButtons) {
  const QString details =
      QStringLiteral("/home/somebody/products/an-assembly-with-a-long-name/scenario.json\n") +
      QStringLiteral("The bodies of this product touch, and overlap by more than is usual for fits. ").repeated(12);
  for (const Screen& screen : kScreens) {
    SCOPED_TRACE(std::to_string(screen.room.width()) + " pixels");
    setFontPoints(screen.texts * Preferences{}.fontPoints);
    const QSize room = screen.room - kFrame;
    PlainMessageBox box(QMessageBox::Warning, QStringLiteral("The scenario cannot be opened"),
                        QStringLiteral("The scenario cannot be opened"), details, nullptr);
    QAbstractButton* ok = box.addButton(QMessageBox::Ok);
    fitWindow(box, room);
    box.show();
    QApplication::processEvents();
    EXPECT_LE(box.width(), room.width());
    EXPECT_LE(box.height(), room.height());
    EXPECT_TRUE(box.rect().contains(ok->geometry().translated(ok->parentWidget()->mapTo(&box, QPoint()))));
    if (auto* scroll = box.findChild<QScrollArea*>()) {
      EXPECT_GT(scroll->viewport()->height(), 2 * box.fontMetrics().lineSpacing());
      EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width()) << "it is scrolled in one direction";
    }
    expectNothingCut(box);
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, SmallScreenTest, testing::Values("en", "fr"));

}  // namespace
}  // namespace glissade
