#include <glissade/product.h>
#include <glissade/scenario.h>

#include "engine/api/values.h"

namespace glissade::api {

Result<Product> Product::make(const std::vector<Body>& bodies) {
  auto placed = engineBodies(bodies, Mobility::Mobile, "bodies");
  if (!placed) return placed.error();
  if (placed->size() < 2) return wrongArgument("bodies", "are less than two");
  return attempt<Product>("making a product", [&] {
    ProductFile made;
    made.product.bodies = aboutTheirMiddles(*placed);
    made.product.deflections.assign(placed->size(), 0.0);
    std::vector<ProductBody> tree;
    for (const RigidBody& body : *placed) tree.push_back({body.id, {body.name}});
    made.product.tree = glissade::Product(tree);
    made.product.fits.on = true;
    return Result<Product>(valueOf<Product>({std::move(made), ""}));
  });
}

std::vector<Body> Product::bodies() const { return publicBodies(impl().loaded.product.bodies); }
std::string Product::file() const { return impl().file; }
Warnings Product::warnings() const { return publicWarnings(impl().loaded.warnings); }

std::string Scenario::name() const { return impl().loaded->scenario.name; }
std::string Scenario::file() const { return impl().loaded->file; }
std::string Scenario::strategy() const { return impl().loaded->scenario.planner; }
std::uint64_t Scenario::seed() const { return impl().loaded->scenario.seed; }
Warnings Scenario::warnings() const { return publicWarnings(impl().loaded->warnings); }

Problem Scenario::problem() const { return valueOf<Problem>({impl().loaded->problem, impl().loaded->parameters}); }

Result<Product> Scenario::product() const {
  return attempt<Product>("reading a product", [&]() -> Result<Product> {
    auto loaded = productFileOf(*impl().loaded);
    if (!loaded) return publicDiagnostic(loaded.error());
    loaded->product.bodies = aboutTheirMiddles(std::move(loaded->product.bodies));
    return valueOf<Product>({std::move(*loaded), file()});
  });
}

}  // namespace glissade::api
