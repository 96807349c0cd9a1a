#include "widgets/contacts/joint_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/fits/thread_pitch.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr double kSamePitchShare = 0.01;

struct Joined {
  Q_DECLARE_TR_FUNCTIONS(Joints)
};

/// The size of a thread: "M5"; "M5 x 0.500 mm" if the pitch is not the coarse one; "Ø 5.30 mm" if it is no nominal
/// size.
QString threadSizeText(const JointThread& thread) {
  const std::string nominal = nominalSize(thread.diameter);
  const double coarse = coarsePitch(0.5 * thread.diameter).pitch;
  const QString size =
      nominal.empty() ? QStringLiteral("Ø ") + columnLengthText(thread.diameter) : QString::fromStdString(nominal);
  const double pitch = std::abs(thread.pitch);
  if (!nominal.empty() && std::abs(pitch - coarse) <= kSamePitchShare * coarse) return size;
  return QStringLiteral("%1 × %2").arg(size, columnLengthText(pitch));
}

QString turnsText(const JointThread& thread) {
  return Joined::tr("%1 turns").arg(QLocale().toString(thread.turns(), 'f', 1));
}

QStringList shownOf(const std::vector<BodyId>& ids, const JointTable& table) {
  QStringList names;
  for (const BodyId& id : ids) names << table.shown(id);
  return names;
}

}  // namespace

QString jointKindText(JointKind kind) {
  switch (kind) {
    case JointKind::Screw: return Joined::tr("screw");
    case JointKind::Nut: return Joined::tr("nut");
    case JointKind::Thread: return Joined::tr("thread");
    case JointKind::Insert: return Joined::tr("insert");
    case JointKind::Pin: return Joined::tr("pin");
    case JointKind::Snap: return Joined::tr("snap");
    case JointKind::Flexible: return Joined::tr("flexible");
    case JointKind::Permanent: return Joined::tr("permanent");
    case JointKind::Unit: break;
  }
  return Joined::tr("unit");
}

QString jointStateText(JointRowState state) {
  switch (state) {
    case JointRowState::Recognised: return Joined::tr("recognised");
    case JointRowState::Suggested: return Joined::tr("suggested");
    case JointRowState::Confirmed: return Joined::tr("confirmed");
    case JointRowState::Made: return Joined::tr("user-defined");
    case JointRowState::PressedOut: return Joined::tr("pressed out");
    case JointRowState::Dissolved: return Joined::tr("dissolved");
    case JointRowState::Opened: return Joined::tr("opened");
    case JointRowState::Refused: break;
  }
  return Joined::tr("not possible");
}

QString joinedWithText(const JointRow& row, const JointTable& table) {
  const QString others = shownOf(row.key.others, table).join(QStringLiteral(", "));
  QStringList clamped;
  for (const std::size_t body : row.joint.clamped)
    clamped << QString::fromStdString(table.product().bodies[body].shown());
  if (clamped.isEmpty()) return others;
  return Joined::tr("%1; clamps %2").arg(others, clamped.join(QStringLiteral(", ")));
}

QString jointSizeText(const Joint& joint) {
  QStringList parts;
  if (!joint.designation.empty()) {
    parts << QString::fromStdString(joint.designation);
  } else if (joint.thread) {
    parts << threadSizeText(*joint.thread);
  }
  if (joint.thread) parts << turnsText(*joint.thread);
  if (joint.kind == JointKind::Snap && joint.bend > 0.0) parts << Joined::tr("bends %1").arg(lengthText(joint.bend));
  return parts.join(QStringLiteral(", "));
}

QString driveText(const Joint& joint) {
  QString drive;
  switch (joint.drive) {
    case DriveKind::None: return {};
    case DriveKind::HexOutside: drive = Joined::tr("outer hexagon"); break;
    case DriveKind::HexSocket: drive = Joined::tr("hexagon socket"); break;
    case DriveKind::Cross: drive = Joined::tr("cross recess"); break;
    case DriveKind::Slot: drive = Joined::tr("slot"); break;
    case DriveKind::SixLobe: drive = Joined::tr("six lobes"); break;
  }
  return joint.driveSize > 0.0 ? drive + QLatin1Char(' ') + lengthText(joint.driveSize) : drive;
}

QStringList jointEvidence(const JointRow& row) {
  QStringList lines;
  if (row.refusal) lines << diagnosticText(*row.refusal);
  for (const Message& each : row.joint.evidence) lines << engineText(each);
  return lines;
}

QString jointsSummary(const JointTable& table) {
  std::map<JointKind, int> counts;
  int all = 0;
  for (const JointRow& row : table.rows()) {
    if (!row.counts()) continue;
    ++counts[row.key.kind];
    ++all;
  }
  if (all == 0) return Joined::tr("No joint was found.");
  QStringList kinds;
  for (const auto& [kind, count] : counts) kinds << QStringLiteral("%1 × %2").arg(count).arg(jointKindText(kind));
  QString text = Joined::tr("Joints: %1 (%2)").arg(all).arg(kinds.join(QStringLiteral(", ")));
  const std::size_t suggested = table.count(JointRowState::Suggested);
  if (suggested > 0) text += Joined::tr("; suggested: %1").arg(suggested);
  const auto count = [&](bool (*is)(const JointRow&)) {
    return std::count_if(table.rows().begin(), table.rows().end(), is);
  };
  const auto doubtful = count([](const JointRow& row) { return row.counts() && row.joint.isDoubtful; });
  const auto holes = count([](const JointRow& row) { return row.counts() && row.joint.makesHole; });
  if (doubtful > 0) text += Joined::tr("; for you to decide (?): %1").arg(doubtful);
  if (holes > 0) text += Joined::tr("; screws without a hole in the file: %1").arg(holes);
  return text;
}

}  // namespace glissade
