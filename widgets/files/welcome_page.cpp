#include "widgets/files/welcome_page.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kPageMargin = 24;
constexpr int kSectionGap = 18;
constexpr double kTitleScale = 1.8;
constexpr double kSectionScale = 1.15;

QLabel* makeTitle(const QString& text, double scale, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * scale);
  label->setFont(font);
  return label;
}

}  // namespace

WelcomePage::WelcomePage(const ActionCatalogue& actions, QWidget* parent)
    : QScrollArea(parent), content_(new QWidget(this)), buttons_(new QHBoxLayout), whyNoSamples_(new QLabel(content_)) {
  setObjectName(QStringLiteral("welcome"));
  setAccessibleName(tr("Welcome"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAutoFillBackground(true);
  setFocusPolicy(Qt::NoFocus);
  auto* column = new QVBoxLayout;
  column->setSpacing(8);
  column->addLayout(makeHead(actions));
  column->addSpacing(kSectionGap);
  recent_ = makeSection(tr("Recent files"), *column);
  samples_ = makeSection(tr("Samples"), *column);
  whyNoSamples_->setObjectName(QStringLiteral("why-no-samples"));
  whyNoSamples_->setTextFormat(Qt::PlainText);
  whyNoSamples_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  whyNoSamples_->setWordWrap(true);
  whyNoSamples_->setMinimumWidth(1);
  whyNoSamples_->hide();
  column->addWidget(whyNoSamples_);
  column->addStretch(1);
  auto* middle = new QHBoxLayout(content_);
  middle->setContentsMargins(kPageMargin, kPageMargin, kPageMargin, kPageMargin);
  middle->addLayout(column);
  content_->setMaximumWidth(samples_.grid->widest() + 2 * kPageMargin);
  // The page has no horizontal scroll bar, so the content must not be wider than the page.
  content_->setMinimumWidth(1);
  setWidget(content_);
  setAlignment(Qt::AlignHCenter | Qt::AlignTop);
}

QLayout* WelcomePage::makeHead(const ActionCatalogue& actions) {
  auto* head = new QVBoxLayout;
  head->setSpacing(10);
  head->addWidget(makeTitle(QStringLiteral("Glissade"), kTitleScale, content_));
  auto* hint = new QLabel(
      tr("Make a scenario of your parts, open one, or drop files here: scenarios, STEP, meshes, URDF."), content_);
  hint->setWordWrap(true);
  hint->setMinimumWidth(1);
  head->addWidget(hint);
  buttons_->setSpacing(8);
  for (const char* id : {"file.new", "file.open", "help.tour"}) {
    auto* button = new QToolButton(content_);
    button->setDefaultAction(actions[QLatin1String(id)]);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::StrongFocus);
    buttons_->addWidget(button);
    if (focusProxy() == nullptr) setFocusProxy(button);
  }
  buttons_->addStretch(1);
  head->addLayout(buttons_);
  return head;
}

void WelcomePage::arrangeButtons() {
  int row = 2 * kPageMargin;
  for (int i = 0; i < buttons_->count(); ++i) row += buttons_->itemAt(i)->sizeHint().width() + buttons_->spacing();
  buttons_->setDirection(row > viewport()->width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void WelcomePage::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  arrangeButtons();
  arrangeGrids();
}

void WelcomePage::arrangeGrids() {
  const int width = std::min(viewport()->width(), content_->maximumWidth()) - 2 * kPageMargin;
  for (const Section& section : {recent_, samples_}) section.grid->setFixedHeight(section.grid->heightForWidth(width));
}

WelcomePage::Section WelcomePage::makeSection(const QString& title, QLayout& column) {
  const Section section{makeTitle(title, kSectionScale, content_), new CardGrid(content_), new QWidget(content_)};
  section.gap->setFixedHeight(kSectionGap);
  section.grid->setAccessibleName(title);
  column.addWidget(section.title);
  column.addWidget(section.grid);
  column.addWidget(section.gap);
  connect(section.grid, &CardGrid::chosen, this, &WelcomePage::chosen);
  connect(section.grid, &CardGrid::focused, this, [this](QWidget* card) { ensureWidgetVisible(card); });
  return section;
}

void WelcomePage::fill(const Section& section, const std::vector<WelcomeEntry>& entries) {
  section.grid->setEntries(entries);
  section.title->setHidden(entries.empty());
  section.grid->setHidden(entries.empty());
  section.gap->setHidden(entries.empty());
  arrangeGrids();
}

void WelcomePage::setRecent(const std::vector<WelcomeEntry>& entries) { fill(recent_, entries); }

void WelcomePage::setSamples(const std::vector<WelcomeEntry>& entries) { fill(samples_, entries); }

void WelcomePage::setWhyNoSamples(const QString& text) {
  whyNoSamples_->setText(text);
  whyNoSamples_->show();
}

}  // namespace glissade
