#include "engine/check/stated_json.h"

#include <algorithm>

#include "engine/base/limits.h"
#include "engine/geometry/pose_json.h"

namespace glissade::check {
namespace {

constexpr std::size_t kMostPoints = 5'000'000;

double metres(const JsonCursor& at) {
  const double value = at.coordinate();
  if (value < 0.0) at.fail(GLISSADE_TEXT("is below zero"));
  return value;
}

std::vector<std::string> readTexts(const JsonCursor& at) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) texts.push_back(at.element(i).nonEmptyText());
  return texts;
}

std::vector<BodyId> readIds(const JsonCursor& at) {
  const std::vector<std::string> texts = readTexts(at);
  return {texts.begin(), texts.end()};
}

/// The other bodies of a joint.
std::vector<BodyId> othersOf(const JsonCursor& joint) {
  const auto others = joint.find("others");
  return others ? readIds(*others) : std::vector<BodyId>();
}

BodyId bodyOf(const JsonCursor& joint) { return BodyId(joint.at("body").nonEmptyText()); }

/// One bend for each edge that a statement names; empty if it states no bend.
std::vector<SnapWord> bendsIn(const JsonCursor& joint) {
  std::vector<SnapWord> snaps;
  const auto made = joint.find("made");
  const auto bend = made ? made->find("bend_m") : std::nullopt;
  const auto direction = made ? made->find("direction") : std::nullopt;
  const auto others = joint.find("others");
  if (!bend || !direction || !others || metres(*bend) == 0.0) return snaps;
  const Vector3 way = readVector(*direction);
  if (!(way.norm() > 0.0)) direction->fail(GLISSADE_TEXT("has no direction"));
  for (const BodyId& edge : readIds(*others)) {
    snaps.push_back({bodyOf(joint), edge, metres(*bend), way.normalized()});
  }
  return snaps;
}

Evidence readEvidence(const JsonCursor& at) {
  at.allowOnly({"overlap_m", "deflection_m", "spacing_m", "margin_m", "by_person_m"});
  Evidence evidence{metres(at.at("overlap_m")), metres(at.at("deflection_m")), metres(at.at("spacing_m")),
                    metres(at.at("margin_m"))};
  if (const auto person = at.find("by_person_m")) evidence.byPerson = metres(*person);
  return evidence;
}

/// The body and the other bodies of a joint.
std::vector<BodyId> bodiesOfJoint(const JsonCursor& joint) {
  std::vector<BodyId> bodies = othersOf(joint);
  bodies.insert(bodies.begin(), bodyOf(joint));
  return bodies;
}

/// Signed pitch that a statement gives for the thread of a joint, metres a turn; 0: none.
double pitchIn(const JsonCursor& joint) {
  const auto made = joint.find("made");
  const auto thread = made ? made->find("thread") : std::nullopt;
  return thread ? thread->at("pitch_m").coordinate() : 0.0;
}

}  // namespace

StatedThread readThread(const JsonCursor& at) {
  StatedThread thread;
  thread.point = readVector(at.at("point_m"));
  thread.direction = readVector(at.at("direction"));
  if (!(thread.direction.norm() > 0.0)) at.at("direction").fail(GLISSADE_TEXT("has no direction"));
  thread.pitch = at.at("pitch_m").coordinate();
  thread.radiusMoving = at.at("radius_moving_m").length();
  thread.radiusOther = at.at("radius_other_m").length();
  return thread;
}

std::vector<StatedAllowance> readAllowances(const JsonCursor& at) {
  std::vector<StatedAllowance> allowances;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor each = at.element(i);
    StatedAllowance allowance;
    if (const auto moving = each.find("moving")) allowance.moving = BodyId(moving->text());
    if (const auto object = each.find("object"))
      allowance.moving = BodyId(object->text());  // paths of earlier versions
    allowance.body = bodyOf(each);
    allowance.allowance = metres(each.at("allowance_m"));
    if (const auto yields = each.find("yields")) allowance.yields = yields->boolean();
    if (const auto kind = each.find("kind")) allowance.isThread = kind->text() == "thread";
    if (const auto pitch = each.find("pitch_m")) allowance.pitch = pitch->coordinate();
    if (const auto thread = each.find("thread")) allowance.thread = readThread(*thread);
    if (const auto hollow = each.find("hollow")) allowance.hollow = hollow->boolean();
    if (const auto core = each.find("core")) allowance.core = readThread(*core);
    if (const auto overlap = each.find("overlap_m")) allowance.overlap = metres(*overlap);
    if (const auto evidence = each.find("evidence")) allowance.evidence = readEvidence(*evidence);
    if (const auto turns = each.find("turns")) allowance.turns = turns->number();
    allowances.push_back(std::move(allowance));
  }
  return allowances;
}

std::vector<Point> readPoints(const JsonCursor& at) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < at.sizeUpTo(kMostPoints); ++i) {
    const JsonCursor point = at.element(i);
    const JsonCursor::Json pose{{"position", point.at("position").json()},
                                {"orientation", point.at("orientation").json()}};
    const std::string author = point.at("author").text();
    if (author != "computer" && author != "operator" && author != "contact") {
      point.at("author").fail(GLISSADE_TEXT("is not computer, operator or contact"));
    }
    points.push_back({readPose(JsonCursor(pose, at.file(), point.pointer())), author == "contact"});
  }
  if (points.empty()) at.fail(GLISSADE_TEXT("is empty"), GLISSADE_TEXT("Give a path."));
  return points;
}

PartingWords readPartings(const JsonCursor& joints, PartingWords words) {
  for (std::size_t i = 0; i < joints.sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor joint = joints.element(i);
    const std::string word = joint.at("word").text();
    const BodyId body = bodyOf(joint);
    for (const BodyId& other : othersOf(joint)) {
      const std::pair<BodyId, BodyId> pair = std::minmax(body, other);
      std::erase(words.pairs, pair);
      if (word == "dissolved" || word == "pressed_out") words.pairs.push_back(pair);
    }
  }
  return words;
}

PartingWords readPartingsOfSequence(const JsonCursor& sequence, PartingWords words) {
  if (const auto use = sequence.find("joint_use")) words.anyPair = use->text() == "off";
  const auto joints = sequence.find("joints");
  return joints ? readPartings(*joints, std::move(words)) : words;
}

std::vector<SnapWord> readSnaps(const JsonCursor& at) {
  std::vector<SnapWord> snaps;
  for (std::size_t i = 0; i < at.sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor joint = at.element(i);
    if (joint.at("kind").text() != "snap") continue;
    const BodyId hook = bodyOf(joint);
    const std::vector<BodyId> edges = othersOf(joint);
    std::erase_if(snaps, [&](const SnapWord& earlier) {
      return earlier.hook == hook && std::find(edges.begin(), edges.end(), earlier.edge) != edges.end();
    });
    if (joint.at("word").text() != "confirmed") continue;
    for (SnapWord& word : bendsIn(joint)) snaps.push_back(std::move(word));
  }
  return snaps;
}

JointWords readJointWords(const JsonCursor& joints, JointWords words) {
  for (std::size_t i = 0; i < joints.sizeUpTo(limits::kMostBodies); ++i) {
    const JsonCursor joint = joints.element(i);
    const std::string kind = joint.at("kind").text();
    const bool isConfirmed = joint.at("word").text() == "confirmed";
    const std::vector<BodyId> bodies = bodiesOfJoint(joint);
    if (kind == "flexible") {
      std::erase(words.flexible, bodies.front());
      if (isConfirmed) words.flexible.push_back(bodies.front());
    } else if (kind == "insert" || kind == "permanent" || kind == "unit") {
      std::erase(words.units, bodies);
      if (isConfirmed) words.units.push_back(bodies);
    } else if (isConfirmed && pitchIn(joint) != 0.0) {
      for (std::size_t k = 1; k < bodies.size(); ++k) words.pitches.push_back({bodies[0], bodies[k], pitchIn(joint)});
    }
  }
  return words;
}

Demands readDemands(const JsonCursor& at) {
  Demands demands;
  const auto each = [&](const char* key, const auto& take) {
    const auto list = at.find(key);
    for (std::size_t i = 0; list && i < list->sizeUpTo(limits::kMostBodies); ++i) take(list->element(i));
  };
  each("together", [&](const JsonCursor& names) { demands.together.push_back(readTexts(names)); });
  each("before", [&](const JsonCursor& names) {
    const std::vector<std::string> pair = readTexts(names);
    if (pair.size() != 2) names.fail(GLISSADE_TEXT("is not two names"));
    demands.before.emplace_back(pair[0], pair[1]);
  });
  each("places", [&](const JsonCursor& place) {
    demands.places.push_back(
        {readTexts(place.at("bodies")), static_cast<std::size_t>(place.at("place").wholeNumber())});
  });
  each("motions", [&](const JsonCursor& motion) {
    Demands::Motion demanded{readTexts(motion.at("bodies")), {}};
    for (const Point& point : readPoints(motion.at("path"))) demanded.path.push_back(point.q);
    demands.motions.push_back(std::move(demanded));
  });
  each("forbidden", [&](const JsonCursor& direction) {
    const Vector3 way = readVector(direction.at("direction"));
    if (!(way.norm() > 0.0)) direction.at("direction").fail(GLISSADE_TEXT("has no direction"));
    demands.forbidden.emplace_back(direction.at("body").nonEmptyText(), way);
  });
  if (const auto stay = at.find("stay")) demands.stay = readTexts(*stay);
  return demands;
}

}  // namespace glissade::check
