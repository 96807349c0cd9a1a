#include "engine/python/session.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/python/arrays.h"
#include "engine/python/failure.h"
#include "engine/python/long_call.h"
#include "engine/python/operators.h"

namespace glissade::python {
namespace {

const char* nameOf(SessionState state) {
  switch (state) {
    case SessionState::Running: return "running";
    case SessionState::Solved: return "solved";
    case SessionState::Ended: break;
  }
  return "ended";
}

/// A session in Python, with the call of step() during which its operator may be asked.
struct StepwiseRun {
  Session session;
  std::shared_ptr<LongCall*> call;
};

template <class Task>
StepwiseRun runOf(const Task& task, const std::string& strategy, std::optional<std::uint64_t> seed,
                  const py::object& hand, const py::object& sampler, const Parameters& parameters) {
  const auto call = std::make_shared<LongCall*>(nullptr);
  PlanOptions options{strategy, seed};
  options.parameters = parameters;
  const auto during = [call]() -> LongCall& { return **call; };
  setOperator(hand, during, options);
  setSampler(sampler, during, options);
  return {valueOf(Session::make(task, options)), call};
}

template <class Task>
void addInit(py::class_<StepwiseRun>& session) {
  session.def(py::init(&runOf<Task>), py::arg("task"), py::kw_only(), py::arg("strategy") = "",
              py::arg("seed") = py::none(), py::arg("operator") = "none", py::arg("sampler") = py::none(),
              py::arg("parameters") = Parameters());
}

/// The numbers of enumerators as an array.
template <class Enumerator>
py::array_t<std::uint8_t> numbersOf(const std::vector<Enumerator>& values) {
  py::array_t<std::uint8_t> array(static_cast<py::ssize_t>(values.size()));
  std::transform(values.begin(), values.end(), array.mutable_data(),
                 [](Enumerator value) { return static_cast<std::uint8_t>(value); });
  return array;
}

py::array_t<std::uint32_t> pairsOf(const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  py::array_t<std::uint32_t> array({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::uint32_t* row = array.mutable_data();
  for (const auto& pair : pairs) row = std::copy(pair.begin(), pair.end(), row);
  return array;
}

}  // namespace

void addSession(py::module_& module) {
  py::class_<Roadmap>(module, "Roadmap", "The nodes and edges of a run so far, as arrays.")
      .def_property_readonly(
          "nodes", [](const Roadmap& roadmap) { return arrayOf(roadmap.nodes); },
          "Array of shape (n, 7): x y z, quaternion x y z w.")
      .def_property_readonly(
          "authors", [](const Roadmap& roadmap) { return numbersOf(roadmap.authors); },
          "Who drew each node: 0 computer, 1 operator, 2 contact.")
      .def_property_readonly(
          "trees", [](const Roadmap& roadmap) { return numbersOf(roadmap.trees); },
          "Tree of each node: 0 start, 1 goal, 2 hand.")
      .def_property_readonly(
          "edges", [](const Roadmap& roadmap) { return pairsOf(roadmap.edges); },
          "Indices of nodes, shape (m, 2). The papers count an edge twice.")
      .def_property_readonly(
          "dropped", [](const Roadmap& roadmap) { return pairsOf(roadmap.dropped); },
          "Edges whose proof has failed, shape (k, 2).")
      .def("__repr__", [](const Roadmap& roadmap) {
        return "<glissade.Roadmap of " + std::to_string(roadmap.nodes.size()) + " nodes, " +
               std::to_string(roadmap.edges.size()) + " edges>";
      });

  py::class_<StepwiseRun> session(module, "Session",
                                  "A run that the caller carries on step by step. For one thread at a time.");
  addInit<Scenario>(session);
  addInit<Problem>(session);
  session
      .def(
          "step",
          [](StepwiseRun& run, std::uint64_t steps) {
            LongCall call;
            *run.call = &call;
            return nameOf(call.result([&] { return run.session.step(steps, call.stop()); }));
          },
          py::arg("steps") = 1, "Carries out planner steps. Returns 'running', 'solved' or 'ended'.")
      .def(
          "set",
          [](StepwiseRun& run, const py::kwargs& values) { valueOf(run.session.set(values.cast<Parameters>())); },
          "Sets parameters by their keys from the next iteration on: session.set(alpha=0.5, contact_samples=20).")
      .def_property_readonly(
          "state", [](const StepwiseRun& run) { return nameOf(run.session.state()); }, "'running', 'solved' or 'ended'")
      .def_property_readonly(
          "failure",
          [](const StepwiseRun& run) -> std::optional<std::string> {
            const auto why = run.session.failure();
            return why ? std::optional(why->text()) : std::nullopt;
          },
          "Why it has ended without a path; None: it has not.")
      .def_property_readonly("counts", [](const StepwiseRun& run) { return run.session.counts(); })
      .def_property_readonly("parameters", [](const StepwiseRun& run) { return run.session.parameters(); })
      .def_property_readonly(
          "hand", [](const StepwiseRun& run) { return run.session.hand(); }, "The pose in the operator's hand.")
      .def_property_readonly("roadmap", [](const StepwiseRun& run) { return run.session.roadmap(); })
      .def_property_readonly(
          "path", [](const StepwiseRun& run) { return run.session.path(); },
          "The certified path; None until the run is solved.")
      .def("__repr__", [](const StepwiseRun& run) {
        return std::string("<glissade.Session, ") + nameOf(run.session.state()) + " after " +
               std::to_string(run.session.counts().steps) + " steps>";
      });
}

}  // namespace glissade::python
