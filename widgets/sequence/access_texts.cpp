#include "widgets/sequence/access_texts.h"

#include <QCoreApplication>

#include <cmath>

namespace glissade {
namespace {

class AccessTexts {
  Q_DECLARE_TR_FUNCTIONS(glissade::AccessTexts)

 public:
  static QString hand(const HandAnswer& hand, const std::vector<RigidBody>& bodies) {
    switch (hand.access) {
      case HandAccess::Free:
        return hand.pushed > 0 ? tr("The hand reaches the work, and pushes at the end")
                               : tr("The hand reaches the work");
      case HandAccess::NoGrip: return tr("No grasp by one hand was found");
      case HandAccess::NotAsked: return tr("Hand access was not checked");
      case HandAccess::Blocked: break;
    }
    const int percent = static_cast<int>(std::floor(100.0 * hand.share));
    if (!hand.blockedBy) return tr("The hand is blocked at %1 % of the motion").arg(percent);
    return tr("The hand is blocked by %1 at %2 % of the motion")
        .arg(QString::fromStdString(bodies[*hand.blockedBy].shown()))
        .arg(percent);
  }

  static QString sight(const SightAnswer& sight, const std::vector<RigidBody>& bodies) {
    const QString seen = tr("%1 % of the work is visible").arg(static_cast<int>(std::floor(100.0 * sight.share)));
    if (sight.isSeen() || !sight.blockedBy) return seen;
    return tr("%1, hidden by %2").arg(seen, QString::fromStdString(bodies[*sight.blockedBy].shown()));
  }

  static QString mark(const MotionAccess& motion) {
    if (motion.hand.access == HandAccess::NotAsked) return {};
    if (!motion.isReached()) return tr("no grasp");
    return motion.sight.isSeen() ? tr("reachable") : tr("not visible");
  }

  static QString size(HandSize size) {
    switch (size) {
      case HandSize::SmallWoman: return tr("5th percentile of women");
      case HandSize::LargeMan: return tr("95th percentile of men");
      case HandSize::Average: break;
    }
    return tr("average");
  }
};

}  // namespace

QString accessMark(const MotionAccess& motion) { return AccessTexts::mark(motion); }

QString accessText(const MotionAccess& motion, const std::vector<RigidBody>& bodies) {
  return AccessTexts::hand(motion.hand, bodies) + QStringLiteral("; ") + AccessTexts::sight(motion.sight, bodies);
}

QString handSizeText(HandSize size) { return AccessTexts::size(size); }

}  // namespace glissade
