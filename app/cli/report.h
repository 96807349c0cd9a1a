#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/collision/motion_certificate.h"
#include "engine/files/scenario.h"
#include "engine/model/missing_shape.h"
#include "engine/session/session.h"

namespace glissade::cli {

/// Form of the output of a command: text for people in a language, or one JSON object on standard output and nothing
/// else.
struct Console {
  bool json = false;
  Language language = Language::English;

  /// The text in the language of the console.
  std::string text(const Message& message) const { return toString(message, language); }
  /// Prints a line of text to standard output.
  void print(const Message& line) const;
  /// Prints a line about the progress of the command to standard error.
  void note(const Message& line) const;
};

/// Exit code of a plan that is complete or valid except for flexible bodies that leave without a proof.
inline constexpr int kExitWithoutProof = 6;
/// Exit code of a path or a plan that is valid only under conditions.
inline constexpr int kExitUnderConditions = 7;
/// Exit code of a valid path or plan where these shapes are no bodies: they may be in the way.
inline int exitCodeWithout(const MissingShapes& missing) { return missing.empty() ? 0 : kExitUnderConditions; }

/// Prints one JSON document to stdout.
void printJson(const nlohmann::ordered_json& json);

/// Prints the error to stderr.
void noteError(const Diagnostic& error, const Console& console);
/// Prints the error to stderr (and as JSON to stdout) and returns its exit code.
int reportError(const Diagnostic& error, const Console& console);
void reportWarnings(const Warnings& warnings, const Console& console);
/// A warning that the forbidden places of a scenario hold only for the path of its object, not for a plan.
Diagnostic placesHoldForPathsOnly(const std::string& file);

/// Number of a JSON report; null where it is not finite.
nlohmann::ordered_json number(double value);
/// x, y and z; position and the quaternion x y z w.
nlohmann::ordered_json vectorJson(const Vector3& v);
nlohmann::ordered_json poseJson(const Pose& pose);
nlohmann::ordered_json toJson(const MotionCertificate& certificate, const CollisionWorld& world, bool edges = false);
/// Prints a line for every edge to stdout.
void printEdges(const MotionCertificate& certificate, const CollisionWorld& world, const Console& console);
/// Name of an obstacle; empty if the index is -1.
Message bodyName(const CollisionWorld& world, int body);
nlohmann::ordered_json toJson(const Diagnostic& error);

/// Adds to the certificate what limits its accuracy: the tessellation, the number format of the files, the allowances
/// of fits, the turns of the path in threads, and shapes that are no bodies.
void addUncertainties(const LoadedScenario& scenario, const std::vector<PathPoint>& path,
                      nlohmann::ordered_json& certificate);
/// The uncertainties of addUncertainties() in words, a message for each line.
std::vector<Message> uncertaintiesInWords(const LoadedScenario& scenario, const std::vector<PathPoint>& path);

/// The certificate in words, such as "certified: clearance 1.5 mm to 'wall_L1'".
Message inWords(const MotionCertificate& certificate, const CollisionWorld& world);

}  // namespace glissade::cli
