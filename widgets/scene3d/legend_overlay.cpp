#include "widgets/scene3d/legend_overlay.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

#include "widgets/scene3d/scale_bar.h"

namespace glissade {
namespace {

constexpr int kLegendMargin = 10;  ///< to the border of the scene
constexpr int kLegendPadding = 6;  ///< inside the legend
constexpr double kMostOfWidth = 0.45;
constexpr double kMostOfHeight = 0.6;
constexpr double kLineHeight = 3.0;
constexpr double kGroundOpacity = 0.75;

QColor toQt(const Colour& colour) { return QColor::fromRgbF(colour[0], colour[1], colour[2]); }

QString textOf(LegendItem item) {
  switch (item) {
    case LegendItem::Object: return LegendOverlay::tr("Moving part");
    case LegendItem::Start: return LegendOverlay::tr("Start");
    case LegendItem::Goal: return LegendOverlay::tr("Goal");
    case LegendItem::Workspace: return LegendOverlay::tr("Workspace");
    case LegendItem::StartTree: return LegendOverlay::tr("Searched from the start");
    case LegendItem::GoalTree: return LegendOverlay::tr("Searched from the goal");
    case LegendItem::OperatorNodes: return LegendOverlay::tr("By the operator");
    case LegendItem::ContactNodes: return LegendOverlay::tr("In contact");
    case LegendItem::Path: return LegendOverlay::tr("Path");
    case LegendItem::PathByClearance: return LegendOverlay::tr("Path, from tight to wide");
    case LegendItem::PathByStep: return LegendOverlay::tr("Path, by step");
    case LegendItem::PathOfComputer: return LegendOverlay::tr("Path of the computer");
    case LegendItem::PathOfOperator: return LegendOverlay::tr("Path of the operator");
    case LegendItem::PathOfContact: return LegendOverlay::tr("Path in contact");
    case LegendItem::ObjectOnPath: return LegendOverlay::tr("Object along the path");
    case LegendItem::RefusedPath: return LegendOverlay::tr("Path no longer valid");
    case LegendItem::Blocked: return LegendOverlay::tr("Blocked part of the path");
    case LegendItem::Nearest: return LegendOverlay::tr("To the nearest obstacle");
    case LegendItem::Contact: return LegendOverlay::tr("Contact with an obstacle");
    case LegendItem::Guidance: return LegendOverlay::tr("Guiding force");
    case LegendItem::Hand: return LegendOverlay::tr("Your hand");
    case LegendItem::Sweep: return LegendOverlay::tr("Swept volume");
    case LegendItem::FreeCells: return LegendOverlay::tr("Free cells");
    case LegendItem::MobileCells: return LegendOverlay::tr("Cells with mobile bodies");
    case LegendItem::StaticCells: return LegendOverlay::tr("Cells with static bodies");
    case LegendItem::Places: return LegendOverlay::tr("Places, from easy to narrow");
    case LegendItem::ClutteredPlaces: return LegendOverlay::tr("Places with a mobile body");
    case LegendItem::Borders: return LegendOverlay::tr("Borders of places");
    case LegendItem::Graph: return LegendOverlay::tr("Graph, with costs");
    case LegendItem::CoarsePath: return LegendOverlay::tr("Coarse path");
    case LegendItem::Milestones: return LegendOverlay::tr("Milestones");
    case LegendItem::Region: return LegendOverlay::tr("Region of the step");
    case LegendItem::InTheWay: return LegendOverlay::tr("Blocking body");
    case LegendItem::TightestPlace: return LegendOverlay::tr("Tightest place");
    case LegendItem::TreeGap: return LegendOverlay::tr("Gap of the search");
    case LegendItem::Help: return LegendOverlay::tr("Where your hand helps");
    case LegendItem::Overlap: return LegendOverlay::tr("Overlapped body");
    case LegendItem::RefusedEnd: return LegendOverlay::tr("Object where it overlaps");
    case LegendItem::ForbiddenDirection: return LegendOverlay::tr("Ruled-out direction");
    case LegendItem::Selected: return LegendOverlay::tr("Selected");
    case LegendItem::MovingPart: return LegendOverlay::tr("Part of the step");
    case LegendItem::WayOfPart: return LegendOverlay::tr("Removal path");
    case LegendItem::Reach: return LegendOverlay::tr("Hand with access");
    case LegendItem::ReachBlocked: return LegendOverlay::tr("Hand that is blocked");
  }
  return {};
}

}  // namespace

LegendOverlay::LegendOverlay(const SceneView& view, QWidget* scene) : SceneOverlay(view, scene) {
  setObjectName(QStringLiteral("legend"));
}

int LegendOverlay::rowHeight() const { return fontMetrics().height() + 2; }

int LegendOverlay::swatchWidth() const { return 2 * fontMetrics().height(); }

/// The lower limit, above texts and bars at the lower border. The scale is in the other corner and does not count.
int LegendOverlay::floor() const {
  int lowest = height();
  for (const QWidget* other : parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const QRect at = other->geometry();
    const bool covers = other->isVisible() && at != geometry() && qobject_cast<const ScaleBar*>(other) == nullptr;
    const bool atCorner = at.bottom() > height() * 3 / 4 && at.right() > width() / 2;
    if (covers && atCorner) lowest = std::min(lowest, at.top());
  }
  return lowest - kLegendMargin;
}

/// The upper limit, below messages and the view cube at the upper border.
int LegendOverlay::ceiling() const {
  int highest = 0;
  for (const QWidget* other : parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const QRect at = other->geometry();
    if (other->isVisible() && at != geometry() && at.top() < height() / 4 && at.right() > width() / 2) {
      highest = std::max(highest, at.bottom());
    }
  }
  return highest + kLegendMargin;
}

QRect LegendOverlay::boxOf(const std::vector<LegendRow>& rows) const {
  if (rows.empty()) return {};
  int widest = 0;
  for (const LegendRow& row : rows) widest = std::max(widest, fontMetrics().horizontalAdvance(textOf(row.item)));
  const QSize size(swatchWidth() + widest + 3 * kLegendPadding,
                   rowHeight() * static_cast<int>(rows.size()) + 2 * kLegendPadding);
  return {QPoint(width() - size.width() - kLegendMargin, floor() - size.height()), size};
}

std::vector<LegendRow> LegendOverlay::rows() const {
  std::vector<LegendRow> rows = view().legend();
  const int room = std::min(static_cast<int>(kMostOfHeight * height()), floor() - ceiling()) - 2 * kLegendPadding;
  const auto most = static_cast<std::size_t>(std::max(0, room / rowHeight()));
  if (rows.size() > most) rows.resize(most);
  if (boxOf(rows).width() > kMostOfWidth * width()) rows.clear();
  return rows;
}

QRect LegendOverlay::box() const { return isHidden() ? QRect() : boxOf(rows()); }

QStringList LegendOverlay::texts() const {
  QStringList texts;
  for (const LegendRow& row : rows()) texts << textOf(row.item);
  return texts;
}

void LegendOverlay::paintEvent(QPaintEvent* /*event*/) {
  const std::vector<LegendRow> shown = rows();
  if (shown.empty()) return;
  const QRect box = boxOf(shown);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().color(QPalette::Base);
  ground.setAlphaF(kGroundOpacity);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 4, 4);
  QRect line(box.left() + kLegendPadding, box.top() + kLegendPadding, box.width() - 2 * kLegendPadding, rowHeight());
  for (const LegendRow& row : shown) {
    paintSwatch(painter, row, QRectF(line.topLeft(), QSizeF(swatchWidth(), line.height())).adjusted(0, 2, 0, -2));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(line.adjusted(swatchWidth() + kLegendPadding, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     textOf(row.item));
    line.translate(0, rowHeight());
  }
}

void LegendOverlay::paintSwatch(QPainter& painter, const LegendRow& row, const QRectF& box) const {
  QRectF mark = box;
  if (row.mark == LegendMark::Line) mark.setHeight(kLineHeight);
  if (row.mark == LegendMark::Dot) mark.setSize(QSizeF(2 * kLineHeight, 2 * kLineHeight));
  mark.moveCenter(box.center());
  if (row.mark == LegendMark::Fill) {
    painter.setPen(QPen(palette().color(QPalette::Text), 0.5));
  } else {
    painter.setPen(Qt::NoPen);
  }
  if (row.mark == LegendMark::Dot) {
    painter.setBrush(toQt(row.colours.front()));
    painter.drawEllipse(mark);
    return;
  }
  QLinearGradient colours(mark.topLeft(), mark.topRight());
  const auto last = static_cast<double>(std::max<std::size_t>(1, row.colours.size() - 1));
  for (std::size_t i = 0; i < row.colours.size(); ++i) {
    colours.setColorAt(static_cast<double>(i) / last, toQt(row.colours[i]));
  }
  painter.setBrush(colours);
  painter.drawRect(mark);
}

}  // namespace glissade
