#include "engine/python/operators.h"

#include <memory>
#include <string>

#include "engine/python/arrays.h"

namespace glissade::python {
namespace {

/// An object that threads without the interpreter's lock copy and destroy.
using KeptObject = std::shared_ptr<const py::object>;

KeptObject kept(const py::object& object) {
  return {new py::object(object), [](const py::object* last) {
            const py::gil_scoped_acquire lock;
            delete last;
          }};
}

}  // namespace

void addOperators(py::module_& module) {
  py::class_<HandView>(module, "HandView", "What an operator knows when it moves the object.")
      .def_readonly("hand", &HandView::hand, "pose of the object in the hand")
      .def_readonly("seconds", &HandView::seconds, "until the next call, by the operator's clock")
      .def_readonly("clearance", &HandView::clearance, "distance to the nearest obstacle, metres")
      .def_readonly("contact_nodes", &HandView::contactNodes, "nodes from contact sampling so far");
}

void setOperator(const py::object& hand, const std::function<LongCall&()>& during, PlanOptions& options) {
  if (py::isinstance<py::str>(hand)) {
    options.operatorName = hand.cast<std::string>();
    return;
  }
  if (PyCallable_Check(hand.ptr()) == 0) throw py::type_error("operator is no name and no function");
  options.operatorFunction = [kept = kept(hand), during](const HandView& view) {
    return during().callBack([&] { return poseOf((*kept)(view), "the operator's pose"); }, view.hand);
  };
}

void setSampler(const py::object& sampler, const std::function<LongCall&()>& during, PlanOptions& options) {
  if (sampler.is_none()) return;
  if (PyCallable_Check(sampler.ptr()) == 0) throw py::type_error("sampler is no function");
  options.sampler = [made = kept(sampler), during](const Problem& problem, std::uint64_t seed) -> DrawFunction {
    const Pose otherwise = problem.start();
    const KeptObject draw = during().callBack([&] { return kept((*made)(problem, seed)); }, KeptObject());
    if (!draw) return {};
    return [draw, during, otherwise] {
      return during().callBack([&] { return poseOf((*draw)(), "the sampler's pose"); }, otherwise);
    };
  };
}

}  // namespace glissade::python
