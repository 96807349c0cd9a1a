#pragma once

#include <map>
#include <vector>

#include "engine/base/thread_team.h"
#include "engine/fits/contact_report.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/static_equilibrium.h"

namespace glissade {

/// Checks which bodies of a product are supported while others leave it: static equilibrium of all bodies that are
/// there, with friction. Bodies that stay are held. Threads, press fits, other overlaps and nuts on their shafts hold
/// in every direction; other contacts only push. Bodies that are connected by contacts, but not through a held body,
/// form one linear program, which is solved once. Used by one thread at a time.
class Standing {
 public:
  /// Friction coefficient of steel on steel, not lubricated.
  static constexpr double kFriction = 0.3;

  /// Properties of the product's bodies, in addition to their geometry.
  struct Bodies {
    const std::vector<Contact>& contacts;
    const std::vector<FastenerKind>& fasteners;
    const BodySet& staying;
    std::vector<double> densities;  ///< kg/m^3
    Vector3 gravity;                ///< any length
    std::vector<double> masses{};   ///< kg, one entry for each body; 0, or empty: by volume and density
  };
  /// Computes the contact points with the threads of the team.
  Standing(const AssembledProduct& product, const Bodies& bodies, ThreadTeam& team);

  /// Bodies that are supported while all of `present` are there, and would tip or fall after the group has left;
  /// ascending.
  BodyGroup newlyFalling(const BodySet& present, const BodyGroup& group);
  /// Bodies that would tip or fall while all of `present` are there; ascending.
  BodyGroup falling(const BodySet& present);
  /// Mass of the body, kilograms.
  double massOf(std::size_t body) const { return bodies_[body].weight; }

 private:
  BodyGroup fallingWith(const BodySet& present, const BodyGroup& seeds);
  BodyGroup connectedTo(std::size_t seed, const BodySet& present) const;
  const BodyGroup& fallingOf(const BodyGroup& connected, const BodySet& present);

  /// The points at which two bodies touch.
  struct Touch {
    std::size_t a;
    std::size_t b;
    std::vector<SupportPoint> points;
  };
  std::vector<SupportedBody> bodies_;
  std::vector<Touch> touches_;
  std::vector<std::vector<std::size_t>> touchesOf_;  ///< touches of each body
  Vector3 gravity_;
  std::map<std::pair<BodyGroup, BodyGroup>, BodyGroup> known_;  ///< falling bodies, by connected and held bodies
};

/// Mass of each body, kg: the stated one, else 0. Names that no body has are ignored.
std::vector<double> massesOf(const SequenceDemands& demands, const AssembledProduct& product);

/// Density of each body, kg/m^3: the stated one, else kUsualDensity. Names that no body has are ignored.
std::vector<double> densitiesOf(const SequenceDemands& demands, const AssembledProduct& product);

}  // namespace glissade
