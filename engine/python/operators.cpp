#include "engine/python/operators.h"

#include <memory>
#include <string>

#include "engine/python/arrays.h"

namespace glissade::python {

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
  // The function is copied and destroyed by threads without the interpreter's lock.
  const std::shared_ptr<const py::object> kept(new py::object(hand), [](const py::object* last) {
    const py::gil_scoped_acquire lock;
    delete last;
  });
  options.operatorFunction = [kept, during](const HandView& view) {
    return during().callBack([&] { return poseOf((*kept)(view), "the operator's pose"); }, view.hand);
  };
}

}  // namespace glissade::python
