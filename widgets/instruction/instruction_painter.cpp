#include "widgets/instruction/instruction_painter.h"

#include <QBuffer>
#include <QImageReader>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>

namespace glissade {
namespace {

constexpr int kDotsPerInch = 300;
constexpr double kPictureDotsPerInch = 200.0;
constexpr double kMillimetresPerInch = 25.4;
constexpr QSize kScreenPicture(1280, 800);
constexpr QSize kScreenPart(160, 160);
const QColor kInk(0x1d, 0x23, 0x29);
const QColor kSoft(0x5b, 0x64, 0x6e);
const QColor kFrame(0xc9, 0xd0, 0xd8);
const QColor kMark(0xf0, 0xe4, 0x42);

QRectF dots(const PageRect& rect) {
  constexpr double kScale = kDotsPerInch / kMillimetresPerInch;
  return {rect.x * kScale, rect.y * kScale, rect.width * kScale, rect.height * kScale};
}

QSize picturePixels(const PageRect& rect) {
  constexpr double kScale = kPictureDotsPerInch / kMillimetresPerInch;
  return {std::max(8, qRound(rect.width * kScale)), std::max(8, qRound(rect.height * kScale))};
}

class PagePainter {
 public:
  PagePainter(QPainter& painter, const WorkInstruction& instruction, const StepDrawer& drawer, const QImage& logo)
      : painter_(painter), instruction_(instruction), drawer_(drawer), logo_(logo) {}

  void paint(const InstructionPage& page) {
    for (const PagePicture& picture : page.pictures) {
      const QSize pixels = picturePixels(picture.rect);
      painter_.drawImage(dots(picture.rect), picture.panel
                                                 ? drawer_.panel(instruction_.panels[*picture.panel], pixels)
                                                 : drawer_.finished(instruction_.bodies, pixels, instruction_.up));
    }
    for (const PagePart& part : page.parts) {
      painter_.drawImage(dots(part.rect), drawer_.parts(part.bodies, picturePixels(part.rect)));
    }
    for (const PageRect& line : page.lines) painter_.fillRect(dots(line), kFrame);
    painter_.setPen(QPen(kFrame, 4.0));
    painter_.setBrush(Qt::NoBrush);
    for (const PageRect& frame : page.frames) painter_.drawRect(dots(frame));
    for (const PageText& text : page.texts) paint(text);
    if (page.logo && !logo_.isNull()) paintLogo(dots(*page.logo));
  }

 private:
  /// Paints a text. Letters become smaller, down to a least size, if the text needs it.
  void paint(const PageText& text) {
    const QRectF rect = dots(text.rect);
    const QString words = QString::fromStdString(text.text);
    const int across = text.align == PageText::Align::Right ? Qt::AlignRight : Qt::AlignLeft;
    const int flags = across | int{Qt::AlignTop} | int{Qt::TextWordWrap};
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setBold(text.bold);
    QRectF bounds;
    for (double points = text.points; points >= kLeastPoints; points -= 0.5) {
      font.setPointSizeF(points);
      painter_.setFont(font);
      bounds = painter_.boundingRect(rect, flags, words);
      if (bounds.height() <= rect.height() && bounds.width() <= rect.width()) break;
    }
    if (text.marked) painter_.fillRect(bounds.adjusted(-8.0, -4.0, 8.0, 4.0), kMark);
    painter_.setPen(text.soft ? kSoft : kInk);
    painter_.drawText(rect, flags | int{Qt::TextDontClip}, words);
  }

  void paintLogo(const QRectF& rect) {
    const QSizeF size = QSizeF(logo_.size()).scaled(rect.size(), Qt::KeepAspectRatio);
    painter_.drawImage(QRectF(QPointF(rect.right() - size.width(), rect.top()), size), logo_);
  }

  QPainter& painter_;
  const WorkInstruction& instruction_;
  const StepDrawer& drawer_;
  const QImage& logo_;
};

std::string pngOf(const QImage& picture) {
  QBuffer content;
  content.open(QIODevice::WriteOnly);
  picture.save(&content, "PNG");
  return content.data().toStdString();
}

}  // namespace

SaveResult writeInstructionPdf(const WorkInstruction& instruction, const InstructionTemplate& look, Paper paper,
                               const StepDrawer& drawer, const QString& file, const WorkWatch& watch) {
  QImage logo;
  if (!look.logo.empty()) {
    QImageReader reader(QString::fromStdString(look.logo));
    logo = reader.read();
    if (logo.isNull()) {
      return notSaved({ErrorKind::MalformedInput, look.logo, "", GLISSADE_TEXT("is a picture that cannot be read"),
                       GLISSADE_TEXT("Save the logo as PNG again.")});
    }
  }
  QBuffer content;
  content.open(QIODevice::WriteOnly);
  QPdfWriter writer(&content);
  writer.setTitle(QString::fromStdString(instruction.title));
  writer.setCreator(QStringLiteral("Glissade"));
  writer.setResolution(kDotsPerInch);
  writer.setPageSize(QPageSize(paper == Paper::A4 ? QPageSize::A4 : QPageSize::Letter));
  writer.setPageMargins(QMarginsF(0.0, 0.0, 0.0, 0.0));
  const std::vector<InstructionPage> pages = instructionPages(instruction, look, paper);
  QPainter painter(&writer);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  PagePainter pagePainter(painter, instruction, drawer, logo);
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (watch.stop.stopRequested()) {
      return notSaved(
          {ErrorKind::Interrupted, file.toStdString(), "", GLISSADE_TEXT("the document was cancelled"), {}});
    }
    if (i > 0) writer.newPage();
    pagePainter.paint(pages[i]);
    watch.report(static_cast<double>(i + 1) / static_cast<double>(pages.size()));
  }
  painter.end();
  return saveFile(file.toStdString(), content.data().toStdString());
}

InstructionPictures instructionPictures(const WorkInstruction& instruction, const StepDrawer& drawer,
                                        const WorkWatch& watch) {
  InstructionPictures pictures;
  pictures.finished = pngOf(drawer.finished(instruction.bodies, kScreenPicture, instruction.up));
  const auto addPart = [&](const std::vector<BodyId>& bodies) {
    std::string& picture = pictures.parts[bodies];
    if (picture.empty()) picture = pngOf(drawer.parts(bodies, kScreenPart));
  };
  for (const PartsListRow& row : instruction.parts) addPart({row.bodies.front()});
  for (const InstructionPanel& panel : instruction.panels) {
    if (watch.stop.stopRequested()) break;
    for (const FetchedPart& part : panel.fetched) addPart(part.bodies);
    pictures.panels.push_back(pngOf(drawer.panel(panel, kScreenPicture)));
    watch.report(static_cast<double>(pictures.panels.size()) / static_cast<double>(instruction.panels.size()));
  }
  return pictures;
}

}  // namespace glissade
