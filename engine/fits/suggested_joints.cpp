#include "engine/fits/suggested_joints.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "engine/fits/snap_ways.h"
#include "engine/model/designation.h"

namespace glissade {
namespace {

struct HintWord {
  std::string_view word;
  JointKind kind;
};

/// The last word of an English or German name, or its end, says what a thing is.
constexpr std::array kLastWords{HintWord{"belt", JointKind::Flexible},
                                HintWord{"cable", JointKind::Flexible},
                                HintWord{"hose", JointKind::Flexible},
                                HintWord{"wire", JointKind::Flexible},
                                HintWord{"wires", JointKind::Flexible},
                                HintWord{"wiring", JointKind::Flexible},
                                HintWord{"harness", JointKind::Flexible},
                                HintWord{"spring", JointKind::Flexible},
                                HintWord{"seal", JointKind::Flexible},
                                HintWord{"gasket", JointKind::Flexible},
                                HintWord{"oring", JointKind::Flexible},
                                HintWord{"label", JointKind::Flexible},
                                HintWord{"sticker", JointKind::Flexible},
                                HintWord{"strap", JointKind::Flexible},
                                HintWord{"cord", JointKind::Flexible},
                                HintWord{"riemen", JointKind::Flexible},
                                HintWord{"kabel", JointKind::Flexible},
                                HintWord{"schlauch", JointKind::Flexible},
                                HintWord{"feder", JointKind::Flexible},
                                HintWord{"dichtung", JointKind::Flexible},
                                HintWord{"dichtring", JointKind::Flexible},
                                HintWord{"etikett", JointKind::Flexible},
                                HintWord{"torique", JointKind::Flexible},
                                HintWord{"clip", JointKind::Snap},
                                HintWord{"schnapphaken", JointKind::Snap},
                                HintWord{"snap", JointKind::Snap},
                                HintWord{"latch", JointKind::Snap},
                                HintWord{"weld", JointKind::Permanent},
                                HintWord{"solder", JointKind::Permanent},
                                HintWord{"glue", JointKind::Permanent},
                                HintWord{"adhesive", JointKind::Permanent},
                                HintWord{"epoxy", JointKind::Permanent},
                                HintWord{"schweissnaht", JointKind::Permanent}};

/// Last words of rings that are opened.
constexpr std::array<std::string_view, 3> kRingWords{"circlip", "seegerring", "sicherungsring"};

/// The first word of a French name does.
constexpr std::array kFirstWords{HintWord{"courroie", JointKind::Flexible}, HintWord{"c\u00e2ble", JointKind::Flexible},
                                 HintWord{"tuyau", JointKind::Flexible},    HintWord{"ressort", JointKind::Flexible},
                                 HintWord{"soudure", JointKind::Permanent}, HintWord{"colle", JointKind::Permanent},
                                 HintWord{"loquet", JointKind::Snap}};

/// Words of purchased assemblies, at any place in a name.
constexpr std::array<std::string_view, 25> kUnitWords{
    "motor", "servo",    "stepper", "nema",    "bearing",         "lager",   "roulement",    "moteur",   "gearmotor",
    "fan",   "sensor",   "switch",  "relay",   "camera",          "battery", "display",      "actuator", "encoder",
    "pump",  "solenoid", "bldc",    "speaker", "microcontroller", "vesc",    "potentiometer"};

/// Largest distance between a board and a part that is soldered to it, metres.
constexpr double kSolderGap = 3e-4;

/// Words of populated circuit boards.
constexpr std::array<std::string_view, 7> kBoardWords{"pcb",          "pcba",    "board",    "platine",
                                                      "leiterplatte", "arduino", "raspberry"};

/// Suppliers of units. Their name with a number of the article is that of a unit.
constexpr std::array<std::string_view, 14> kSuppliers{"schunk",    "festo",   "smc",     "zimmer",     "igus",
                                                      "maxon",     "hiwin",   "nanotec", "robotis",    "dynamixel",
                                                      "faulhaber", "rexroth", "norgren", "wittenstein"};

/// Words that name no part.
constexpr std::array<std::string_view, 14> kUnits{"mm",  "cm",   "in",     "od",       "id",      "long",  "wide",
                                                  "rev", "copy", "mirror", "mirrored", "default", "solid", "body"};

bool endsWith(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// True if the word is the hint, its plural, or a German compound that ends with a hint of five letters or more.
bool isLastWord(const std::string& word, std::string_view hint) {
  return word == hint || word == std::string(hint) + "s" || (hint.size() >= 5 && endsWith(word, hint));
}

/// The words of a retaining ring or a snap ring.
bool sayRetainingRing(const std::vector<std::string>& words) {
  if (words.empty()) return false;
  const auto isLast = [&](std::string_view ring) { return isLastWord(words.back(), ring); };
  if (std::any_of(kRingWords.begin(), kRingWords.end(), isLast)) return true;
  if (words.size() < 2 || words.back() != "ring") return false;
  const std::string& before = words[words.size() - 2];
  return before == "retaining" || before == "snap" || before == "locking";
}

std::optional<JointKind> hintOf(const std::vector<std::string>& words) {
  if (words.empty()) return std::nullopt;
  if (sayRetainingRing(words)) return JointKind::Flexible;
  for (const HintWord& hint : kLastWords) {
    if (isLastWord(words.back(), hint.word)) return hint.kind;
  }
  for (const HintWord& hint : kFirstWords) {
    if (words.front() == hint.word) return hint.kind;
  }
  return std::nullopt;
}

bool isOneOf(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The joint that the words of a class suggest.
std::optional<JointKind> hintOfClass(const std::string& name) {
  const std::vector<std::string> words = wordsOfName(name);
  if (isOneOf("flexible", words)) return JointKind::Flexible;
  return hintOf(words);
}

/// Words for parts that hold, cover or accompany a unit.
constexpr std::array<std::string_view, 20> kNoUnitWords{
    "mount", "bracket", "holder", "housing", "tube",  "plate", "cover",   "case",     "box",    "block",
    "cap",   "support", "shaft",  "gear",    "wheel", "frame", "coupler", "coupling", "spacer", "pulley"};

/// Words that follow the name of a part.
constexpr std::array<std::string_view, 7> kAssemblyWords{"assembly", "subassembly", "assy",    "asm",
                                                         "asy",      "baugruppe",   "ensemble"};

/// "battery tube assembly" is the name of a tube.
std::vector<std::string> withoutAssemblyWords(std::vector<std::string> words) {
  const auto isAssembly = [](const std::string& word) {
    return std::find(kAssemblyWords.begin(), kAssemblyWords.end(), word) != kAssemblyWords.end();
  };
  while (!words.empty() && isAssembly(words.back())) words.pop_back();
  return words;
}

template <std::size_t Count>
bool hasOneOf(const std::vector<std::string>& words, const std::array<std::string_view, Count>& wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

bool isUnitName(const std::string& name) {
  const std::vector<std::string> words = withoutAssemblyWords(wordsOfName(name));
  if (words.empty() || std::find(kNoUnitWords.begin(), kNoUnitWords.end(), words.back()) != kNoUnitWords.end()) {
    return false;
  }
  return hasOneOf(words, kUnitWords) || hasOneOf(words, kBoardWords);
}

/// A supplier and the number of an article: "SCHUNK-1343465".
bool isArticleName(const std::string& name) {
  constexpr int kLeastDigits = 5;
  int digits = 0;
  for (const char c : name) {
    digits = std::isdigit(static_cast<unsigned char>(c)) != 0 ? digits + 1 : 0;
    if (digits == kLeastDigits) return hasOneOf(wordsOfName(name), kSuppliers);
  }
  return false;
}

constexpr CatalogueText kAssemblyName = GLISSADE_TEXT("the assembly is called '%1'");

/// True if every face belongs to one torus: a ring of round section.
bool isTorus(const TriangleMesh& mesh) {
  return !mesh.faces.empty() && std::all_of(mesh.faces.begin(), mesh.faces.end(), [](const SurfaceFace& face) {
    return face.kind == SurfaceFace::Kind::Torus;
  });
}

class SuggestedJointFinder {
 public:
  SuggestedJointFinder(const ProductShapes& shapes, const std::vector<std::string>& classes, const Joints& found,
                       const StopToken& stop)
      : shapes_(shapes),
        classes_(classes),
        stop_(stop),
        isTaken_(shapes.size(), false),
        isInUnit_(shapes.size(), false) {
    for (const Joint& joint : found) {
      isTaken_[joint.body] = true;
      if (joint.kind != JointKind::Unit) continue;
      isInUnit_[joint.body] = true;
      for (const std::size_t other : joint.others) isTaken_[other] = isInUnit_[other] = true;
    }
  }

  Joints find() {
    Joints joints;
    addUnits(joints);
    for (std::size_t body = 0; body < shapes_.size() && !stop_.stopRequested(); ++body) {
      if (!isTaken_[body]) addByBody(body, joints);
    }
    std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.body < b.body; });
    return joints;
  }

 private:
  /// Adds the outermost assemblies with such a name, except the whole product.
  void addUnits(Joints& joints) {
    const Product& tree = shapes_.product().tree;
    std::map<std::size_t, std::vector<std::size_t>> units;
    for (std::size_t body = 0; body < shapes_.size(); ++body) {
      const auto own = tree.find(shapes_.body(body).id.text());
      if (!own) continue;
      const std::vector<std::size_t> above = tree.assembliesAbove(*own);
      const auto unit = std::find_if(above.begin(), above.end(), [&](std::size_t node) {
        const std::string& name = tree.nodes()[node].names.product;
        return isUnitName(name) || isArticleName(name);
      });
      if (unit != above.end()) units[*unit].push_back(body);
    }
    for (const auto& [node, bodies] : units) {
      const bool isKnown = std::all_of(bodies.begin(), bodies.end(), [&](std::size_t body) { return isInUnit_[body]; });
      if (bodies.size() < 2 || bodies.size() == shapes_.size() || isKnown) continue;
      if (addBoard(node, bodies, joints)) continue;
      Joint joint;
      joint.kind = JointKind::Unit;
      const std::string& name = tree.nodes()[node].names.product;
      joint.state = isArticleName(name) ? JointState::Recognised : JointState::Suggested;
      joint.body = bodies.front();
      joint.others.assign(bodies.begin() + 1, bodies.end());
      joint.point = shapes_.box(joint.body).center();
      joint.evidence.push_back({kAssemblyName, {name}});
      if (isArticleName(name))
        joint.evidence.emplace_back(GLISSADE_TEXT("it is a purchased unit with the number of its article"));
      for (const std::size_t body : bodies) isTaken_[body] = true;
      joints.push_back(std::move(joint));
    }
  }

  /// Adds a populated circuit board: a thin plate in an assembly with such a name, and the parts of the assembly that
  /// are on it. Each part or assembly below counts as a whole. Screws and what is not on the board are no members. The
  /// gap of the solder is not in CAD files as a body, so that parts are drawn a little above their board.
  bool addBoard(std::size_t node, const std::vector<std::size_t>& bodies, Joints& joints) {
    const Product& tree = shapes_.product().tree;
    const std::string& name = tree.nodes()[node].names.product;
    if (!hasOneOf(wordsOfName(name), kBoardWords)) return false;
    const auto board = std::max_element(bodies.begin(), bodies.end(),
                                        [&](std::size_t a, std::size_t b) { return faceOf(a) < faceOf(b); });
    if (!isBoard(*board)) return false;
    Joint joint;
    joint.kind = JointKind::Unit;
    joint.state = JointState::Recognised;
    joint.body = *board;
    std::map<std::size_t, std::vector<std::size_t>> members;  // by the node below the assembly
    for (const std::size_t body : bodies) {
      if (body != *board && !isTaken_[body]) members[belowOf(node, body)].push_back(body);
    }
    for (const auto& [below, part] : members) {
      const bool isOn = std::any_of(part.begin(), part.end(), [&](std::size_t body) {
        return shapes_.apart(*board, body, kSolderGap) <= kSolderGap;
      });
      if (isOn) joint.others.insert(joint.others.end(), part.begin(), part.end());
    }
    if (joint.others.empty()) return false;
    std::sort(joint.others.begin(), joint.others.end());
    joint.point = shapes_.box(joint.body).center();
    joint.evidence = {{kAssemblyName, {name}}, GLISSADE_TEXT("the other parts are on its board, as if soldered")};
    isTaken_[joint.body] = true;
    for (const std::size_t other : joint.others) isTaken_[other] = true;
    joints.push_back(std::move(joint));
    return true;
  }

  /// Area of the largest side of the body's box, square metres.
  double faceOf(std::size_t body) const {
    const Vector3 size = boundingBox(*shapes_.body(body).mesh).sizes();
    return size.prod() / size.minCoeff();
  }

  bool isBoard(std::size_t body) const {
    constexpr double kThickest = 3.2e-3;
    constexpr double kLeastWidth = 5.0;  // in thicknesses
    Vector3 size = boundingBox(*shapes_.body(body).mesh).sizes();
    std::sort(size.data(), size.data() + 3);
    return size[0] <= kThickest && size[1] >= kLeastWidth * size[0];
  }

  /// The node that is directly below the assembly and contains the body.
  std::size_t belowOf(std::size_t assembly, std::size_t body) const {
    const Product& tree = shapes_.product().tree;
    std::size_t node = *tree.find(shapes_.body(body).id.text());
    while (tree.nodes()[node].parent != assembly) node = *tree.nodes()[node].parent;
    return node;
  }

  void addByBody(std::size_t body, Joints& joints) const {
    Message reason;
    const auto kind = kindOf(body, &reason);
    if (!kind) return;
    Joint joint;
    joint.kind = *kind;
    joint.state = JointState::Suggested;
    joint.body = body;
    joint.others = touching(body);
    joint.point = shapes_.box(body).center();
    joint.evidence = {reason};
    if (*kind == JointKind::Flexible && isRetainingRing(shapes_.product().nameInFile(body)) && isFlatRing(body)) {
      joint.state = JointState::Recognised;
      joint.direction = shapes_.body(body).X_WB.orientation * thinAxisOf(body);
      joint.evidence.emplace_back(GLISSADE_TEXT("it is a flat ring, which is assumed to be opened out of its groove"));
    }
    if (*kind == JointKind::Flexible) {
      std::erase_if(joint.others, [&](std::size_t other) { return isFlexible(other); });
    } else if (joint.others.empty()) {
      return;
    }
    if (*kind == JointKind::Snap) {
      addBend(joint);
      if (!(joint.bend > 0.0) && !isSnapByClass(body)) return;
    }
    joints.push_back(std::move(joint));
  }

  /// The axis of the body's frame along which it is thinnest.
  Vector3 thinAxisOf(std::size_t body) const {
    const Vector3 size = boundingBox(*shapes_.body(body).mesh).sizes();
    Eigen::Index thin = 0;
    size.minCoeff(&thin);
    return Vector3::Unit(thin);
  }

  /// True if nothing of the body is on the line through its middle along the axis on which it is thin.
  bool isFlatRing(std::size_t body) const {
    constexpr double kFlat = 0.3;
    const Box3 box = boundingBox(*shapes_.body(body).mesh);
    const Vector3 axis = thinAxisOf(body);
    const double thickness = box.sizes().dot(axis);
    Vector3 sizes = box.sizes();
    std::sort(sizes.data(), sizes.data() + 3);
    if (thickness > kFlat * sizes[1]) return false;
    const Vector3 outside = box.center() - thickness * axis;
    return !std::isfinite(shapes_.axial(body).tree().firstHit(outside, axis, 0.0));
  }

  bool isSnapByClass(std::size_t body) const {
    return body < classes_.size() && hintOfClass(classes_[body]) == JointKind::Snap;
  }

  /// Belts side by side touch. Neither goes around the other one.
  bool isFlexible(std::size_t body) const {
    Message reason;
    return kindOf(body, &reason) == JointKind::Flexible;
  }

  std::optional<JointKind> kindOf(std::size_t body, Message* reason) const {
    const RigidBody& rigid = shapes_.body(body);
    if (body < classes_.size() && !classes_[body].empty()) {
      *reason = {GLISSADE_TEXT("its class is '%1'"), {classes_[body]}};
      if (const auto hint = hintOfClass(classes_[body])) return hint;
    }
    const std::string& name = shapes_.product().nameInFile(body);
    *reason = {GLISSADE_TEXT("the name says '%1'"), {name}};
    if (isRetainingRing(name)) return JointKind::Flexible;
    if (const auto hint = hintOf(wordsOfName(name))) return hint;
    *reason = GLISSADE_TEXT("it is a ring of round section");
    if (isTorus(*rigid.mesh)) return JointKind::Flexible;
    return std::nullopt;
  }

  /// Along an axis of the world: the way on which the hooks bend least. Where they would bend by more than hooks do on
  /// each, away from what it is on, and no bend is suggested: then nothing but the name speaks for a snap.
  void addBend(Joint& joint) const {
    const std::vector<SnapWay> ways = snapWays(shapes_.product(), joint.body, joint.others, stop_);
    const auto least =
        std::min_element(ways.begin(), ways.end(), [](const SnapWay& a, const SnapWay& b) { return a.bend < b.bend; });
    joint.direction = least == ways.end() ? wayOut(joint) : least->direction;
    if (least == ways.end() || !(least->bend > 0.0)) return;
    joint.bend = least->bend;
    joint.evidence.push_back(
        {GLISSADE_TEXT("its hooks bend by %1 when it is removed along a line"), {Length{least->bend}}});
  }

  /// Direction away from the centre of the bodies that it is on.
  Vector3 wayOut(const Joint& joint) const {
    Box3 box;
    for (const std::size_t other : joint.others) box.extend(shapes_.box(other));
    const Vector3 way = shapes_.box(joint.body).center() - box.center();
    Eigen::Index axis = 0;
    if (!(way.cwiseAbs().maxCoeff(&axis) > 0.0)) return Vector3::UnitZ();
    return std::copysign(1.0, way[axis]) * Vector3::Unit(axis);
  }

  /// Bodies in contact, within the tolerance of tessellation.
  std::vector<std::size_t> touching(std::size_t body) const {
    std::vector<std::size_t> found;
    for (std::size_t other = 0; other < shapes_.size() && !stop_.stopRequested(); ++other) {
      if (other != body && shapes_.apart(body, other, kTouchReach) <= kTouchReach) found.push_back(other);
    }
    return found;
  }

  static constexpr double kTouchReach = 5e-5;

  const ProductShapes& shapes_;
  const std::vector<std::string>& classes_;
  const StopToken& stop_;
  std::vector<bool> isTaken_;
  std::vector<bool> isInUnit_;  ///< for each body, whether it is in a recognised bearing
};

}  // namespace

std::vector<std::string> wordsOfName(const std::string& name) {
  std::vector<std::string> words(1);
  bool wasLower = false;
  for (const char c : name) {
    const auto u = static_cast<unsigned char>(c);
    const bool isLetter = std::isalpha(u) != 0 || u >= 0x80U;
    const bool isUpper = std::isupper(u) != 0;
    if ((!isLetter || (isUpper && wasLower)) && !words.back().empty()) words.emplace_back();
    if (isLetter) words.back() += static_cast<char>(std::tolower(u));
    wasLower = std::islower(u) != 0;
  }
  const auto isNothing = [](const std::string& word) {
    return word.size() < 2 || std::find(kUnits.begin(), kUnits.end(), word) != kUnits.end();
  };
  words.erase(std::remove_if(words.begin(), words.end(), isNothing), words.end());
  return words;
}

bool isRetainingRing(const std::string& name) {
  const auto said = designationIn(name);
  return (said && said->part == StandardPart::Ring) || sayRetainingRing(wordsOfName(name));
}

Joints findSuggestedJoints(const ProductShapes& shapes, const std::vector<std::string>& classes, const Joints& found,
                           const StopToken& stop) {
  return SuggestedJointFinder(shapes, classes, found, stop).find();
}

}  // namespace glissade
