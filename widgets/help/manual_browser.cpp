#include "widgets/help/manual_browser.h"

#include <QDesktopServices>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImageReader>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QStyle>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/controls/dark_palette.h"

namespace glissade {
namespace {

constexpr int kWidestPicture = 900;
constexpr int kPageMargin = 16;
constexpr int kResizePauseMs = 120;
constexpr int kContentsWidth = 230;
const QString kScheme = QStringLiteral("manual");

QUrl urlOf(const QString& page, const QString& anchor) {
  QUrl url(QStringLiteral("manual:///pages/%1.html").arg(page));
  if (!anchor.isEmpty()) url.setFragment(anchor);
  return url;
}

QString plainText(const ManualPage& page) { return QTextDocumentFragment::fromHtml(page.content.html).toPlainText(); }

}  // namespace

ManualView::ManualView(const QString& folder, QWidget* parent) : QTextBrowser(parent), folder_(folder) {
  setOpenLinks(false);  // there are no pages outside the manual
  setAccessibleName(tr("Page of the manual"));
  document()->setDocumentMargin(kPageMargin);
  connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    const QUrl target = source().resolved(url);
    if (target.scheme() == kScheme) setSource(target);
  });
  afterResize_.setSingleShot(true);
  afterResize_.setInterval(kResizePauseMs);
  connect(&afterResize_, &QTimer::timeout, this, &ManualView::layOutAgain);
  applyStyle();
}

void ManualView::setPages(std::vector<ManualPage> pages) { pages_ = std::move(pages); }

std::size_t ManualView::currentPage() const {
  const QString name = QFileInfo(source().path()).baseName();
  const auto found =
      std::find_if(pages_.begin(), pages_.end(), [&](const ManualPage& page) { return page.name == name; });
  return found == pages_.end() ? 0 : static_cast<std::size_t>(found - pages_.begin());
}

void ManualView::openPage(const QString& page, const QString& anchor) { setSource(urlOf(page, anchor)); }

QVariant ManualView::loadResource(int type, const QUrl& url) {
  const QString name = QFileInfo(url.path()).baseName();
  if (type == QTextDocument::ImageResource) return picture(name);
  if (type != QTextDocument::HtmlResource) return {};
  for (const ManualPage& page : pages_) {
    if (page.name != name) continue;
    // A zero-width space keeps the number of a list item from being as bold as the item's first word.
    return QString(page.content.html).replace(QStringLiteral("<li><"), QStringLiteral("<li>&#8203;<"));
  }
  return {};
}

/// Scales the picture, because the document draws scaled pictures without smoothing.
QVariant ManualView::picture(const QString& name) const {
  QImageReader reader(folder_ + QStringLiteral("/pictures/") + name + QStringLiteral(".png"));
  QImage image = reader.read();
  if (image.isNull()) return {};
  const double ratio = devicePixelRatioF();
  const int room =
      std::clamp(contentsRect().width() - style()->pixelMetric(QStyle::PM_ScrollBarExtent) - 2 * kPageMargin - 1, 1,
                 kWidestPicture);
  const int width = static_cast<int>(room * ratio);
  if (image.width() > width) image = image.scaledToWidth(width, Qt::SmoothTransformation);
  image.setDevicePixelRatio(ratio);
  return image;
}

/// Applies the part of manual.css that QTextDocument supports, in the colours of the theme.
void ManualView::applyStyle() {
  const QColor text = palette().color(QPalette::Text);
  const QColor ground = palette().color(QPalette::Base);
  const QColor link = palette().color(QPalette::Link).lighter(isDark(palette()) ? 140 : 100);
  const auto mixed = [&](double share) {
    const auto part = [share](int a, int b) { return static_cast<int>(a * share + b * (1.0 - share)); };
    return QColor(part(text.red(), ground.red()), part(text.green(), ground.green()), part(text.blue(), ground.blue()))
        .name();
  };
  document()->setDefaultStyleSheet(
      QStringLiteral(
          "a { color: %1; } code, pre, kbd { font-family: monospace; background-color: %2; }"
          "pre { white-space: pre-wrap; } .ui { font-weight: bold; } .caption { color: %4; }"
          "h2 { margin-top: 26px; } h3 { margin-top: 18px; } li { margin-bottom: 4px; }"
          "table { margin-top: 6px; margin-bottom: 10px; }"
          "th, td { padding: 4px; padding-right: 10px; border-bottom-style: solid; border-bottom-width: 1px; "
          "border-bottom-color: %3; }"
          "th { text-align: left; }")
          .arg(link.name(), mixed(0.08), mixed(0.25), mixed(0.65)));
}

void ManualView::layOutAgain() {
  if (source().isEmpty() || laidOutWidth_ == viewport()->width()) return;
  laidOutWidth_ = viewport()->width();
  const QScrollBar& bar = *verticalScrollBar();
  const double place = bar.maximum() > 0 ? static_cast<double>(bar.value()) / bar.maximum() : 0.0;
  reload();
  verticalScrollBar()->setValue(static_cast<int>(place * verticalScrollBar()->maximum()));
}

void ManualView::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  applyStyle();
  laidOutWidth_ = 0;
  afterResize_.start();
}

void ManualView::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  afterResize_.start();
}

ManualBrowser::ManualBrowser(const QString& folder, QWidget* parent)
    : QDialog(parent, Qt::Window),
      folder_(folder),
      contents_(new QTreeWidget(this)),
      view_(new ManualView(folder, this)),
      wanted_(new QLineEdit(this)) {
  setObjectName(QStringLiteral("manual"));
  setWindowTitle(tr("Glissade manual"));
  auto* row = new QHBoxLayout;
  back_ = addButton(row, tr("Back"), tr("The page before"), QKeySequence::Back);
  forward_ = addButton(row, tr("Forward"), tr("The page after it"), QKeySequence::Forward);
  QToolButton* smaller = addButton(row, tr("A−"), tr("Smaller text"), QKeySequence::ZoomOut);
  QToolButton* larger = addButton(row, tr("A+"), tr("Larger text"), QKeySequence::ZoomIn);
  row->addWidget(wanted_, 1);
  QToolButton* previous =
      addButton(row, tr("Previous"), tr("The place before"), QKeySequence(QStringLiteral("Shift+F3")));
  QToolButton* next = addButton(row, tr("Next"), tr("The next place"), QKeySequence(QStringLiteral("F3")));
  outside_ = addButton(row, tr("In the browser"), tr("Open the page on the disk with the web browser"), {});
  wanted_->setPlaceholderText(tr("Search the manual"));
  wanted_->setAccessibleName(wanted_->placeholderText());
  wanted_->setClearButtonEnabled(true);
  contents_->setHeaderHidden(true);
  contents_->setAccessibleName(tr("Contents"));
  auto* split = new QSplitter(this);
  split->addWidget(contents_);
  split->addWidget(view_);
  split->setStretchFactor(1, 1);
  split->setSizes({kContentsWidth, sizeHint().width() - kContentsWidth});
  auto* column = new QVBoxLayout(this);
  column->addLayout(row);
  column->addWidget(split, 1);
  connect(smaller, &QToolButton::clicked, view_, [this] { view_->zoomOut(); });
  connect(larger, &QToolButton::clicked, view_, [this] { view_->zoomIn(); });
  connect(next, &QToolButton::clicked, this, [this] { search(true); });
  connect(previous, &QToolButton::clicked, this, [this] { search(false); });
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, wanted_, [this] {
    wanted_->setFocus(Qt::ShortcutFocusReason);
    wanted_->selectAll();
  });
  connectView();
  view_->setFocus();
  resize(sizeHint().boundedTo(parent->window()->size()));
}

QToolButton* ManualBrowser::addButton(QLayout* row, const QString& text, const QString& tip, const QKeySequence& keys) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setAccessibleName(tip);
  button->setShortcut(keys);
  const QString native = keys.toString(QKeySequence::NativeText);
  button->setToolTip(native.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, native));
  row->addWidget(button);
  return button;
}

void ManualBrowser::connectView() {
  connect(back_, &QToolButton::clicked, view_, &QTextBrowser::backward);
  connect(forward_, &QToolButton::clicked, view_, &QTextBrowser::forward);
  connect(view_, &QTextBrowser::backwardAvailable, back_, &QToolButton::setEnabled);
  connect(view_, &QTextBrowser::forwardAvailable, forward_, &QToolButton::setEnabled);
  connect(view_, &QTextBrowser::historyChanged, this, &ManualBrowser::showPlaceInContents);
  back_->setEnabled(false);
  forward_->setEnabled(false);
  // The Return key continues the search, and the dialog must not press a button for it.
  for (QToolButton* button : findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
  connect(wanted_, &QLineEdit::returnPressed, this, [this] { search(true); });
  connect(wanted_, &QLineEdit::textChanged, wanted_, [this] {
    wanted_->setStyleSheet(QString());
    wanted_->setToolTip(QString());
  });
  connect(contents_, &QTreeWidget::itemActivated, view_,
          [this](QTreeWidgetItem* item) { view_->setSource(item->data(0, Qt::UserRole).toUrl()); });
  connect(contents_, &QTreeWidget::itemClicked, view_,
          [this](QTreeWidgetItem* item) { view_->setSource(item->data(0, Qt::UserRole).toUrl()); });
  connect(outside_, &QToolButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(fileOnDisk())); });
}

void ManualBrowser::setManual(const QString& language, std::vector<ManualPage> pages) {
  language_ = language;
  contents_->clear();
  for (const ManualPage& page : pages) {
    auto* item = new QTreeWidgetItem(contents_, {page.title});
    item->setData(0, Qt::UserRole, urlOf(page.name, {}));
    item->setToolTip(0, page.title);
    for (const MarkdownHeading& heading : page.content.headings) {
      if (heading.level != 2) continue;
      auto* section = new QTreeWidgetItem(item, {heading.title});
      section->setData(0, Qt::UserRole, urlOf(page.name, heading.anchor));
      section->setToolTip(0, heading.title);
    }
  }
  view_->setPages(std::move(pages));
  if (view_->source().isEmpty()) return;
  view_->reload();
  showPlaceInContents();
}

QString ManualBrowser::place() const {
  const QString page = QFileInfo(view_->source().path()).baseName();
  return view_->source().hasFragment() ? page + QLatin1Char('#') + view_->source().fragment() : page;
}

void ManualBrowser::showPlaceInContents() {
  outside_->setEnabled(QFileInfo::exists(fileOnDisk()));
  QTreeWidgetItem* page = contents_->topLevelItem(static_cast<int>(view_->currentPage()));
  if (page == nullptr) return;
  for (int i = 0; i < contents_->topLevelItemCount(); ++i) contents_->topLevelItem(i)->setExpanded(false);
  page->setExpanded(true);
  QTreeWidgetItem* current = page;
  for (int i = 0; i < page->childCount(); ++i) {
    if (page->child(i)->data(0, Qt::UserRole).toUrl() == view_->source()) current = page->child(i);
  }
  contents_->setCurrentItem(current);
}

QString ManualBrowser::fileOnDisk() const {
  return QStringLiteral("%1/%2/%3.html").arg(folder_, language_, QFileInfo(view_->source().path()).baseName());
}

bool ManualBrowser::find(const QString& text, bool forward) {
  if (text.isEmpty()) return false;
  const QTextDocument::FindFlags flags = forward ? QTextDocument::FindFlags{} : QTextDocument::FindBackward;
  if (view_->find(text, flags)) return true;
  const std::size_t count = view_->pages().size();
  const std::size_t here = view_->currentPage();
  for (std::size_t i = 1; i <= count; ++i) {
    const ManualPage& page = view_->pages()[(here + (forward ? i : count - i)) % count];
    if (!plainText(page).contains(text, Qt::CaseInsensitive)) continue;
    view_->openPage(page.name, {});
    view_->moveCursor(forward ? QTextCursor::Start : QTextCursor::End);
    return view_->find(text, flags);
  }
  return false;
}

void ManualBrowser::search(bool forward) {
  if (find(wanted_->text(), forward) || wanted_->text().isEmpty()) return;
  wanted_->setStyleSheet(QStringLiteral("color: #d55e00"));
  wanted_->setToolTip(tr("The manual does not have this text."));
}

}  // namespace glissade
