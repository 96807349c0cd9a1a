#include "widgets/run/hand_lead.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/se3_metric.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

/// Shortest move and turn that are named, in radii of the object and in radians.
constexpr double kLeastWay = 0.01;
/// Share of the longest one below which another move or turn is left out.
constexpr double kLeastShare = 0.3;
constexpr std::size_t kFirstTurn = 3;  ///< axis

bool isTurn(const SteeringKey& key) { return key.axis >= kFirstTurn; }

double along(const Vector3& way, const Vector3& velocity) {
  const double speed = velocity.norm();
  return speed > 0.0 ? way.dot(velocity) / speed : 0.0;
}

/// The keys of one kind whose motion is long enough, the longest first.
void keepLongest(std::vector<KeyToHold>& keys, double least) {
  const auto longer = [](const KeyToHold& a, const KeyToHold& b) { return a.way > b.way; };
  std::stable_sort(keys.begin(), keys.end(), longer);
  const double shortest = keys.empty() ? least : std::max(least, kLeastShare * keys.front().way);
  const auto isShort = [shortest](const KeyToHold& key) { return key.way < shortest; };
  keys.erase(std::find_if(keys.begin(), keys.end(), isShort), keys.end());
}

/// The number with its first digits only.
double withDigits(double value, int digits) {
  if (value <= 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) + 1 - digits);
  return std::round(value / unit) * unit;
}

QString turnText(double radians, int digits) {
  const double degrees = withDigits(radians * 180.0 / std::numbers::pi, digits);
  return QLocale().toString(degrees, 'g', 3) + QStringLiteral("°");
}

QString wayText(const KeyToHold& key) {
  return isTurn(*key.key) ? turnText(key.way, 1) : lengthText(withDigits(key.way, 1));
}

QString keyText(const SteeringKey& key, const QString& motion, bool withLetter) {
  return withLetter ? QCoreApplication::translate("HandLead", "%1: %2").arg(QLatin1Char(key.letter)).arg(motion)
                    : motion;
}

QString joined(const QStringList& keys) { return keys.join(QStringLiteral(" · ")); }

}  // namespace

Twist twistOf(const SteeringKey& key, const DeviceShaping& shaping, const OperatorFrame& frame) {
  RawAxes raw{};
  raw[key.axis] = key.direction;
  DominantAxis dominant;
  return toTwist(shape(shaping, raw, dominant), frame);
}

std::vector<KeyToHold> keysToHold(const Pose& from, const Pose& to, const DeviceShaping& shaping,
                                  const OperatorFrame& frame, double objectRadius) {
  const OperatorFrame shaped = shapedFrame(shaping, {from, frame, {}, 0, {}, {}});
  const Vector3 move = to.position - from.position;
  const Vector3 turn = rotationVector(from.orientation, to.orientation);
  std::vector<KeyToHold> moves;
  std::vector<KeyToHold> turns;
  for (const SteeringKey& key : steeringKeys()) {
    const Twist twist = twistOf(key, shaping, shaped);
    moves.push_back({&key, along(move, twist.linear_W)});
    turns.push_back({&key, along(turn, twist.angular_W)});
  }
  keepLongest(moves, kLeastWay * objectRadius);
  keepLongest(turns, kLeastWay);
  moves.insert(moves.end(), turns.begin(), turns.end());
  return moves;
}

QString distanceText(const Pose& from, const Pose& to) {
  constexpr int kDigits = 2;
  return lengthText(withDigits((to.position - from.position).norm(), kDigits)) + QStringLiteral(", ") +
         turnText(angleBetween(from.orientation, to.orientation), kDigits);
}

QString textOf(const std::vector<KeyToHold>& keys, bool withLetters) {
  QStringList texts;
  for (const KeyToHold& key : keys) {
    texts << keyText(*key.key, motionText(*key.key) + QLatin1Char(' ') + wayText(key), withLetters);
  }
  return joined(texts);
}

QString textOf(const std::vector<const SteeringKey*>& keys, bool withLetters) {
  QStringList texts;
  for (const SteeringKey* key : keys) texts << keyText(*key, motionText(*key), withLetters);
  return joined(texts);
}

}  // namespace glissade
