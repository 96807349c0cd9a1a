#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/check/placed_bodies.h"
#include "engine/collision/collision_query.h"
#include "engine/collision/thread_rule.h"
#include "engine/product/contact_report.h"

namespace glissade {

/// A thread that comes apart by turning only.
struct FitThread {
  ThreadRule rule;   ///< its obstacle is that of the fit
  std::string size;  ///< that the pitch was taken for, as "M10"; empty where a person gave it
};

/// How the object is taken against one obstacle that it fits.
struct Fit {
  enum class Role { Other, Shaft, Hole };  ///< the object's, where the two are coaxial

  std::size_t obstacle = 0;  ///< index
  ContactKind kind = ContactKind::Contact;
  Role role = Role::Other;
  double overlap = 0.0;  ///< as measured, metres
  /// Metres by which the object is taken thinner, of the face that moves farthest; of a refused clash, what it would
  /// take.
  double allowance = 0.0;
  check::Evidence evidence{};         ///< for the largest allowance that may be taken
  std::optional<FitThread> thread{};  ///< where a person has marked the pair as a thread
  MeshPtr thinned{};                  ///< the object taken so; null where it is whole
  /// What the evidence gives to both sides; null where nothing may be allowed.
  std::shared_ptr<const check::PairBounds> bounds{};
};

struct ObjectFits {
  std::vector<Fit> allowed;  ///< by obstacle
  std::vector<Fit> clashes;  ///< that nobody accepted, by obstacle: the whole object counts against these
  Warnings warnings;         ///< one for each clash, and where the object cannot be thinned
};

/// What a scenario asks about the fits of its object.
struct FitQuestion {
  const std::vector<RigidBody>& obstacles;
  const RigidBody& object;
  std::vector<Pose> ends;           ///< configurations in which the product may be assembled: start and goal
  std::vector<double> deflections;  ///< as of ContactBody, of each obstacle, and of the object last
  const FitSettings& settings;
  /// The contacts of the object at its only end, where they are known: `b` is the object, `a` the obstacle's index.
  const std::vector<Contact>* contacts = nullptr;
  /// A world of the obstacles: what it has prepared is not prepared again. Null: there is none.
  CollisionWorldPtr world{};
  std::vector<double> spacings{};         ///< of the coordinates, of each obstacle, and of the object last; or empty
  check::PlacedBodies* placed = nullptr;  ///< bodies that were prepared for being measured; null: there are none
};

/// The fits of the object with all obstacles that it touches at one of the ends. Nothing is allowed for others. A face
/// of the object is taken thinner by no more than the evidence for it (check::boundsOf()): the overlap as measured, the
/// deflections and the coordinate spacing that the files state, assembledGap(), and what a person says; by less where
/// the object has no place for that and less is enough. A clash is allowed where it is accepted. Where no allowance
/// makes the pair free at the ends, the pair is a clash. A pair that is marked as a thread is one although it does not
/// touch.
///
/// Errors: MalformedInput with "/fits/pairs/<index>" as place: a body that is not there, an allowance above what the
/// object's thickness can give, an allowance for a pair that does not touch, a thread without a common axis. After a
/// stop the fits are incomplete.
Result<ObjectFits> findObjectFits(const FitQuestion& question, const StopToken& stop = {});

/// The world where the object is thinned by each allowance against its own obstacle, and where threads come apart by
/// turning only.
CollisionWorldPtr withFits(const CollisionWorldPtr& world, const std::vector<Fit>& fits);

/// The rules of the fits that are threads.
std::vector<ThreadRule> threadRulesOf(const std::vector<Fit>& fits);

/// Each face by its allowance, and none by more than `most` (metres).
std::vector<double> limited(std::vector<double> allowances, double most);

/// What an allowance leaves between two bodies that touch, metres: a micrometre, or four of the clearances that a path
/// has to keep for an object of this radius, if that is more.
double assembledGap(double objectRadius);

/// "screw taken 0.41 mm thinner in the tapped hole of plate (thread)"; with the pitch, where the thread is known:
/// "..., pitch 1.5 mm (ISO coarse, M10)".
std::string inWords(const Fit& fit, const std::string& object, const std::string& obstacle);

/// ", 9.3 turns", to be added to the words; nothing where there are none.
std::string turnsInWords(double turns);

}  // namespace glissade
