#pragma once

#include <map>
#include <vector>

#include "engine/base/thread_team.h"
#include "engine/product/contact_report.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/fastener_kind.h"
#include "engine/sequence/order_rules.h"
#include "engine/sequence/static_equilibrium.h"

namespace glissade {

/// What stands of a product while bodies leave it: static equilibrium of all bodies that are there, with friction.
/// Bodies that stay are held. Threads, press fits, other overlaps and nuts on their shafts hold in every direction,
/// other contacts push. Bodies that are connected by contacts, but not through a body that is held, are one linear
/// program, which is solved once. Used by one thread at a time.
class Standing {
 public:
  /// Of steel on steel, not lubricated.
  static constexpr double kFriction = 0.3;

  /// What the product's bodies are, beside their geometry.
  struct Bodies {
    const std::vector<Contact>& contacts;
    const std::vector<FastenerKind>& fasteners;
    const BodySet& staying;
    std::vector<double> densities;  ///< kg/m^3
    Vector3 gravity;                ///< any length
    std::vector<double> masses{};   ///< kg, of each body; 0, or empty: by volume and density
  };
  /// Contact points are found here.
  Standing(const AssembledProduct& product, const Bodies& bodies, ThreadTeam& team);

  /// Bodies that stand while all of `present` are there, and would tip or fall when the group has left; ascending.
  BodyGroup newlyFalling(const BodySet& present, const BodyGroup& group);
  /// Kilograms.
  double massOf(std::size_t body) const { return bodies_[body].weight; }

 private:
  BodyGroup fallingWith(const BodySet& present, const BodyGroup& seeds);
  BodyGroup connectedTo(std::size_t seed, const BodySet& present) const;
  const BodyGroup& fallingOf(const BodyGroup& connected, const BodySet& present);

  /// Where two bodies touch.
  struct Touch {
    std::size_t a;
    std::size_t b;
    std::vector<SupportPoint> points;
  };
  std::vector<SupportedBody> bodies_;
  std::vector<Touch> touches_;
  std::vector<std::vector<std::size_t>> touchesOf_;  ///< of each body
  Vector3 gravity_;
  std::map<std::pair<BodyGroup, BodyGroup>, BodyGroup> known_;  ///< by connected bodies and those that hold them
};

/// Of each body: what is known, else 0. Names that no body has are ignored.
std::vector<double> massesOf(const SequenceDemands& demands, const AssembledProduct& product);

/// Of each body: what is demanded, else kUsualDensity. Names that no body has are ignored.
std::vector<double> densitiesOf(const SequenceDemands& demands, const AssembledProduct& product);

}  // namespace glissade
