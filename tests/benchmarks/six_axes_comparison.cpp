// Prints a row for each product: the parts that straight lines along six axes with sampled penetration remove, and
// those that Glissade removes. Usage: six_axes_comparison FILE...   (STEP files or scenarios)
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>

#include "engine/scenario/judged_product.h"
#include "engine/scenario/product_file.h"
#include "engine/sequence/sequence_run.h"
#include "tests/benchmarks/six_axes.h"

namespace glissade {
namespace {

/// Time limit of the straight lines for a product.
constexpr double kSecondsOfAProduct = 3600.0;

/// Processor time of this process.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class SilentHost final : public SequenceHost {
 public:
  explicit SilentHost(StopToken stop) : stop_(std::move(stop)) {}
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(std::size_t, int) override {}
  void stepFound(const AssemblyPlan&) override {}

 private:
  StopToken stop_;
  ThreadTeam team_{0};
};

StopToken limit() {
  return StopToken().withDeadline(std::chrono::steady_clock::now() +
                                  std::chrono::seconds(static_cast<long>(kSecondsOfAProduct)));
}

void sixAxesCells(const AssembledProduct& product, const BodySet& staying) {
  const double begin = seconds();
  const auto steps = sixAxesSequence(product, staying, limit());
  const double took = seconds() - begin;
  double deepest = 0.0;
  std::size_t unproved = 0;
  for (const SixAxesStep& step : steps) {
    const double depth = penetrationOf(product, step, {});
    if (std::isfinite(depth)) {
      deepest = std::max(deepest, depth);
    } else {
      ++unproved;
    }
  }
  std::cout << steps.size() << " | " << took << " | " << deepest * 1e3;
  if (unproved > 0) std::cout << ", of " << unproved << " more than 3";
}

Outcome ourCells(const AssembledProduct& product, const BodySet& staying) {
  const double begin = seconds();
  SilentHost host(limit());
  const auto fits = ProductFits::find(product, host.team(), {});
  if (!fits) return fits.error();
  SequenceRequest request;
  request.staying = staying;
  const auto plan = planSequence(product, *fits, request, host);
  if (!plan) return plan.error();
  const double took = seconds() - begin;
  const std::size_t valid = judgePlan(*plan, product, std::nullopt).validSteps();
  std::cout << plan->removed() << " | " << took << " | " << valid << " of " << plan->steps.size();
  return Done{};
}

Outcome compare(const std::string& file) {
  auto loaded = loadProduct(file);
  if (!loaded) return loaded.error();
  AssembledProduct& product = loaded->product;
  product.fits.on = true;
  BodySet staying(product.bodies.size(), false);
  staying[largestBody(product)] = true;
  std::cout << "| " << file.substr(file.rfind('/') + 1) << " | " << product.bodies.size() - 1 << " | " << std::flush;
  sixAxesCells(product, staying);
  std::cout << " | " << std::flush;
  const Outcome ours = ourCells(product, staying);
  std::cout << " |" << std::endl;
  return ours;
}

}  // namespace
}  // namespace glissade

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: six_axes_comparison FILE...\n";
    return 2;
  }
  std::cout
      << "| product | parts | six axes, 400 samples: leave | s | penetration, mm | Glissade: leave | s | steps that "
         "the check agrees with |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (int i = 1; i < argc; ++i) {
    const glissade::Outcome compared = glissade::compare(argv[i]);
    if (compared) continue;
    std::cerr << argv[i] << ": " << compared.error().reason << "\n";
    return 1;
  }
  return 0;
}
