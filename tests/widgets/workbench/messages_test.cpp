#include "widgets/workbench/messages.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <functional>
#include <vector>

#include "widgets/files/save_conflict.h"

namespace glissade {
namespace {

/// A text of a dialog's label, and whether it is shown as plain text.
struct ShownText {
  QString text;
  bool plain;
};
std::vector<ShownText> textsOfDialog(const std::function<void()>& open) {
  std::vector<ShownText> texts;
  QTimer::singleShot(0, qApp, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    for (const QLabel* label : box->findChildren<QLabel*>()) {
      if (!label->text().isEmpty()) texts.push_back({label->text(), label->textFormat() == Qt::PlainText});
    }
    box->reject();
  });
  open();
  return texts;
}

bool holds(const std::vector<ShownText>& texts, const char* part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const ShownText& shown) { return shown.text.contains(QLatin1String(part)); });
}

const Diagnostic kHtml{ErrorKind::MalformedInput, "<b>a</b>.json", "<img src=/etc/passwd>",
                       Message("body <i>x</i> is <u>odd</u>"), Message("Give <s>another</s>.")};

TEST(Messages, WhatFilesSayIsNeverTakenForHtml) {
  QMainWindow window;
  Messages messages(window);
  const auto texts = textsOfDialog([&] { messages.showError(QStringLiteral("<b>No</b>"), kHtml); });
  ASSERT_GE(texts.size(), 2U);
  for (const ShownText& shown : texts) EXPECT_TRUE(shown.plain) << shown.text.toStdString();
  for (const char* part : {"<b>No</b>", "<img src=", "body <i>x</i>", "<s>another</s>"}) {
    EXPECT_TRUE(holds(texts, part)) << part;
  }
}

TEST(Messages, ADocumentThatWasSavedCanBeOpenedUntilAnotherMessageComes) {
  QMainWindow window;
  auto* standing = new QLabel(QStringLiteral("Ready."));
  window.statusBar()->addWidget(standing, 1);
  Messages messages(window);
  window.show();
  messages.showSaved(QStringLiteral("a.html was saved"), QStringLiteral("/elsewhere/a.html"));
  messages.showSaved(QStringLiteral("a.html was saved"), QStringLiteral("/folder/a.html"));
  EXPECT_EQ(window.findChildren<QAbstractButton*>(QStringLiteral("open-saved")).size(), 1);
  const auto* open = window.findChild<QAbstractButton*>(QStringLiteral("open-saved"));
  ASSERT_NE(open, nullptr);
  QApplication::processEvents();
  EXPECT_FALSE(standing->isVisible()) << "it would be drawn over the message";
  EXPECT_TRUE(open->isVisible());
  EXPECT_TRUE(open->toolTip().contains(QStringLiteral("/folder/a.html")));
  messages.showStatus(QStringLiteral("another"));
  EXPECT_FALSE(open->isVisible());
}

TEST(Messages, WhatWasSavedIsShownUntilTheNextAction) {
  QMainWindow window;
  Messages messages(window, 0);
  window.show();
  messages.showSaved(QStringLiteral("/folder/a.pdf was saved"), QStringLiteral("/folder/a.pdf"));
  QTest::mousePress(window.findChild<QAbstractButton*>(QStringLiteral("open-saved")), Qt::LeftButton);
  EXPECT_EQ(window.statusBar()->currentMessage(), QStringLiteral("/folder/a.pdf was saved"));
  QTest::keyPress(&window, Qt::Key_Space);
  EXPECT_TRUE(window.statusBar()->currentMessage().isEmpty());
}

TEST(Messages, AFilesNameIsShownAsItIsWhereASaveIsRefused) {
  QMainWindow window;
  const auto texts = textsOfDialog([&] { askAboutConflict({SaveStatus::ChangedByOthers, kHtml, {}, {}}, &window); });
  ASSERT_GE(texts.size(), 2U);
  for (const ShownText& shown : texts) EXPECT_TRUE(shown.plain) << shown.text.toStdString();
  EXPECT_TRUE(holds(texts, "<b>a</b>.json"));
}

/// Only the button Cancel had an icon once.
TEST(Messages, ButtonsHaveNoIcons) {
  QMainWindow window;
  int buttons = 0;
  QTimer::singleShot(0, qApp, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    for (const QAbstractButton* button : box->buttons()) {
      ++buttons;
      EXPECT_TRUE(button->icon().isNull()) << button->text().toStdString();
    }
    box->reject();
  });
  askAboutConflict({SaveStatus::ChangedByOthers, kHtml, {}, {}}, &window);
  EXPECT_EQ(buttons, 4);
}

TEST(Messages, WhatIsNotThereTakesNoLine) {
  QMainWindow window;
  Messages messages(window);
  const auto texts = textsOfDialog([&] {
    messages.showError(QStringLiteral("No"), {ErrorKind::Usage, "", "", Message("the reason"), {}});
  });
  ASSERT_EQ(texts.size(), 2U);
  for (const ShownText& shown : texts) EXPECT_FALSE(shown.text.startsWith(QLatin1Char('\n')));
}

TEST(Messages, WhereNobodyReadsNoDialogOpens) {
  QMainWindow window;
  Messages messages(window);
  messages.setQuiet(true);
  messages.showError(QStringLiteral("No"), kHtml);
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

}  // namespace
}  // namespace glissade
