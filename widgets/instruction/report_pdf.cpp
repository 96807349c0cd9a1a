#include "widgets/instruction/report_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextOption>
#include <QTextTable>
#include <QUrl>

#include <algorithm>
#include <cmath>

#include "widgets/instruction/plot_object.h"

namespace glissade {
namespace {

constexpr int kReportDotsPerInch = 300;
constexpr double kMarginMm = 16.0;
constexpr double kFooterMm = 8.0;
constexpr double kBodyPoints = 8.5;
constexpr double kTablePoints = 6.8;
constexpr double kWideTablePoints = 5.6;
constexpr double kHighestPicture = 0.55;  ///< share of the height of a page
constexpr double kBelowHeadingMm = 35.0;  ///< least room on a page for a heading and its content
constexpr std::size_t kManyColumns = 10;  ///< tables with more have smaller letters
constexpr int kLongestLabel = 28;         ///< characters of a row's label that stay on one line

QString text(const std::string& words) { return QString::fromStdString(words); }
double dots(double millimetres) { return millimetres / 25.4 * kReportDotsPerInch; }
/// Text formats use pixels of a screen, which are scaled to the paper.
constexpr double kScreenDotsPerInch = 96.0;
double pixels(double millimetres) { return millimetres / 25.4 * kScreenDotsPerInch; }

/// Adds the blocks of a report to a text document.
class Composer {
 public:
  explicit Composer(QTextDocument& document) : cursor_(&document), width_(document.pageSize().width()) {}

  void title(const std::string& words) {
    cursor_.setCharFormat(font(17.0, QFont::Bold));
    cursor_.insertText(text(words));
  }

  /// The heading of a figure begins a page, because the large figure could leave it alone at the end of the page
  /// before.
  void onNewPage(const ReportHeading& heading) {
    insertHeading(heading);
    QTextBlockFormat format = cursor_.blockFormat();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    cursor_.setBlockFormat(format);
  }

  void operator()(const ReportHeading& heading) {
    // The block behind a table ignores its top margin. Almost empty text fills it.
    if (cursor_.block().length() <= 1) cursor_.insertText(QStringLiteral(" "), font(1.0));
    insertHeading(heading);
    // If little room is left, a top margin moves the heading to the next page. A page break of QTextDocument behind a
    // table would leave an empty page.
    const double left = millimetresLeft();
    if (left > kBelowHeadingMm) return;
    QTextBlockFormat format = cursor_.blockFormat();
    format.setTopMargin(format.topMargin() + pixels(left));
    cursor_.setBlockFormat(format);
  }

  void operator()(const ReportText& words) {
    newBlock(pixels(1.0), pixels(2.0));
    cursor_.insertText(text(words.text), font(kBodyPoints));
  }

  void operator()(const ReportTable& table) {
    const bool titled = hasTitles(table);
    const int rows = static_cast<int>(table.rows.size()) + (titled ? 1 : 0);
    const double points = table.columns.size() > kManyColumns ? kWideTablePoints : kTablePoints;
    newBlock(0.0, 0.0);
    cursor_.setBlockCharFormat(font(1.0));  // the block before the table has to be low
    QTextTableFormat format;
    format.setHeaderRowCount(titled ? 1 : 0);
    format.setCellPadding(pixels(0.7));
    format.setCellSpacing(0.0);
    format.setBorder(1.0);
    format.setBottomMargin(pixels(table.caption.empty() ? 4.0 : 0.0));
    format.setBorderCollapse(true);
    format.setBorderBrush(QColor(0xc9, 0xd0, 0xd8));
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    if (titled) format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    QTextTable* grid = cursor_.insertTable(rows, static_cast<int>(table.columns.size()), format);
    for (int column = 0; titled && column < grid->columns(); ++column) {
      const ReportColumn& what = table.columns[static_cast<std::size_t>(column)];
      QTextTableCellFormat shade;
      shade.setBackground(QColor(0xf4, 0xf6, 0xf9));
      grid->cellAt(0, column).setFormat(shade);
      fill(grid->cellAt(0, column), what.title, what.kind == ReportColumn::Kind::Number, font(points, QFont::Bold));
    }
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      for (std::size_t column = 0; column < table.rows[row].size(); ++column) {
        fill(grid->cellAt(static_cast<int>(row) + (titled ? 1 : 0), static_cast<int>(column)), table.rows[row][column],
             table.columns[column].kind == ReportColumn::Kind::Number, font(points));
      }
    }
    cursor_.movePosition(QTextCursor::End);
    caption(table.caption);
  }

  void operator()(const ReportDrawing& drawing) {
    newBlock(pixels(2.0), 0.0);
    QTextCharFormat object;
    object.setObjectType(PlotObject::kType);
    object.setProperty(PlotObject::kSvg, QByteArray::fromStdString(drawing.svg));
    cursor_.insertText(QString(QChar::ObjectReplacementCharacter), object);
    caption(drawing.title + ". " + drawing.caption);
  }

  void operator()(const ReportPicture& picture) {
    const QImage image(text(picture.file));
    if (image.isNull()) return;
    newBlock(pixels(2.0), 0.0);
    QTextImageFormat format;
    const QString name = QStringLiteral("picture:") + text(picture.file);
    cursor_.document()->addResource(QTextDocument::ImageResource, QUrl(name), image);
    format.setName(name);
    const double highest = kHighestPicture * cursor_.document()->pageSize().height();
    const double width = std::min(picture.share * width_, highest * image.width() / image.height());
    format.setWidth(width * kScreenDotsPerInch / kReportDotsPerInch);
    format.setHeight(format.width() * image.height() / image.width());
    cursor_.insertImage(format);
    caption(picture.caption);
  }

 private:
  static QTextCharFormat font(double points, int weight = QFont::Normal) {
    QTextCharFormat format;
    format.setFontPointSize(points);
    format.setFontWeight(weight);
    return format;
  }

  void insertHeading(const ReportHeading& heading) {
    newBlock(pixels(6.0), pixels(2.0));
    cursor_.insertText(text(heading.text), font(12.0, QFont::Bold));
  }

  /// Height left on the page, from the top of the present block.
  double millimetresLeft() const {
    const double height = cursor_.document()->pageSize().height();
    const double top = cursor_.document()->documentLayout()->blockBoundingRect(cursor_.block()).top();
    return (height - std::fmod(top, height)) / kReportDotsPerInch * 25.4;
  }

  static bool hasTitles(const ReportTable& table) {
    return std::any_of(table.columns.begin(), table.columns.end(),
                       [](const ReportColumn& column) { return !column.title.empty(); });
  }

  /// Continues in the empty block that follows a table, or else in a new block.
  void newBlock(double above, double below) {
    QTextBlockFormat format;
    format.setTopMargin(above);
    format.setBottomMargin(below);
    if (cursor_.block().length() > 1) cursor_.insertBlock();
    cursor_.setBlockFormat(format);
    cursor_.setBlockCharFormat(font(kBodyPoints));
  }

  /// Fills a cell. A number stays on one line, its spread in brackets on the next.
  static void fill(const QTextTableCell& cell, const std::string& words, bool number, const QTextCharFormat& letters) {
    QTextCursor cursor = cell.firstCursorPosition();
    QTextBlockFormat block;
    block.setAlignment(number ? Qt::AlignRight : Qt::AlignLeft);
    QString content = text(words);
    const bool isLabel = cell.column() == 0 && content.size() <= kLongestLabel;
    const bool isTitle = letters.fontWeight() != QFont::Normal;
    if (!isTitle && (number || isLabel)) block.setNonBreakableLines(true);
    if (!isTitle && number) {
      content.replace(QStringLiteral(" ("), QString(QChar::LineSeparator) + QLatin1Char('('));
    }
    cursor.setBlockFormat(block);
    cursor.insertText(content, letters);
  }

  void caption(const std::string& words) {
    if (words.empty()) return;
    newBlock(pixels(1.0), pixels(3.0));
    QTextCharFormat soft = font(7.0);
    soft.setForeground(QColor(0x5b, 0x64, 0x6e));
    cursor_.insertText(text(words), soft);
  }

  QTextCursor cursor_;
  double width_;
};

bool isFigure(const ReportBlock& block) {
  return std::holds_alternative<ReportDrawing>(block) || std::holds_alternative<ReportPicture>(block);
}

void drawPages(QTextDocument& document, const QString& title, QPdfWriter& writer) {
  const QSizeF page = document.pageSize();
  QPainter painter(&writer);
  for (int i = 0; i < document.pageCount(); ++i) {
    if (i > 0) writer.newPage();
    painter.save();
    painter.translate(0.0, -i * page.height());
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = QRectF(QPointF(0.0, i * page.height()), page);
    context.palette.setColor(QPalette::Text, Qt::black);
    painter.setClipRect(context.clip);
    document.documentLayout()->draw(&painter, context);
    painter.restore();
    QFont small = document.defaultFont();
    small.setPointSizeF(7.0);
    painter.setFont(small);
    painter.setPen(QColor(0x5b, 0x64, 0x6e));
    const QRectF footer(0.0, page.height() + dots(2.0), page.width(), dots(kFooterMm - 2.0));
    painter.drawText(footer, Qt::AlignLeft | Qt::AlignBottom, title);
    painter.drawText(footer, Qt::AlignRight | Qt::AlignBottom,
                     QStringLiteral("%1 / %2").arg(i + 1).arg(document.pageCount()));
  }
}

}  // namespace

SaveResult writeReportPdf(const Report& report, const QString& file) {
  QBuffer content;
  content.open(QIODevice::WriteOnly);
  QPdfWriter writer(&content);
  writer.setTitle(text(report.title));
  writer.setCreator(QStringLiteral("Glissade"));
  writer.setResolution(kReportDotsPerInch);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);

  PlotObject plots;
  QTextDocument document;
  document.documentLayout()->setPaintDevice(&writer);
  document.documentLayout()->registerHandler(PlotObject::kType, &plots);
  document.setDocumentMargin(0.0);
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPointSizeF(kBodyPoints);
  document.setDefaultFont(font);
  QTextOption wrapping;
  wrapping.setWrapMode(QTextOption::WordWrap);  // words are not broken, in narrow columns either
  document.setDefaultTextOption(wrapping);
  document.setPageSize({static_cast<double>(writer.width()), writer.height() - dots(kFooterMm)});
  Composer composer(document);
  composer.title(report.title);
  for (std::size_t i = 0; i < report.blocks.size(); ++i) {
    const auto* heading = std::get_if<ReportHeading>(&report.blocks[i]);
    const bool beforeFigure = i + 1 < report.blocks.size() && isFigure(report.blocks[i + 1]);
    if (heading != nullptr && (heading->newPage || beforeFigure)) {
      composer.onNewPage(*heading);
    } else {
      std::visit(composer, report.blocks[i]);
    }
  }
  drawPages(document, text(report.title), writer);
  return saveFile(file.toStdString(), content.data().toStdString());
}

}  // namespace glissade
