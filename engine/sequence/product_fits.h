#pragma once

#include "engine/base/thread_team.h"
#include "engine/product/object_fits.h"
#include "engine/sequence/assembled_product.h"

namespace glissade {

/// What each body of a product is taken to be against each other one, when it moves. Immutable, shared by threads.
class ProductFits {
 public:
  /// Compares each pair of bodies once. Errors: as of findObjectFits(); Interrupted.
  static Result<ProductFits> find(const AssembledProduct& product, ThreadTeam& team, const StopToken& stop);

  /// Of the body with others; `obstacle` is an index in the product.
  const std::vector<Fit>& fitsOf(std::size_t body) const { return moving_[body].allowed; }
  /// Those among them with bodies of the set.
  std::vector<Fit> fitsOf(std::size_t body, const BodySet& present) const;
  /// The body thinned as its fit with the other one allows; the body itself where there is none.
  const MeshPtr& meshAgainst(std::size_t body, std::size_t other) const;
  /// The two are screwed together: the body leaves the other one by turning only.
  bool isThread(std::size_t body, std::size_t other) const;
  /// Axes of shafts and holes that the body has in common with others, unit, world frame, no two alike.
  const std::vector<Vector3>& axesOf(std::size_t body) const { return moving_[body].axes; }
  /// Clashes that nobody accepted, each once, and bodies that cannot be thinned.
  const Warnings& warnings() const { return warnings_; }

 private:
  struct Moving {
    std::vector<Fit> allowed;
    std::vector<MeshPtr> thinned;  ///< for each of `allowed`
    std::vector<Vector3> axes;
    MeshPtr whole;
  };

  std::vector<Moving> moving_;  ///< of each body
  Warnings warnings_;
};

/// The fits of one body with bodies of the product. `contacts`: of the product, where they are known; or null.
/// Errors: as of findObjectFits().
Result<ObjectFits> fitsOfBody(const AssembledProduct& product, std::size_t body, const ContactReport* contacts,
                              const StopToken& stop);

}  // namespace glissade
