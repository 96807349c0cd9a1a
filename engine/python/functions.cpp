#include "engine/python/functions.h"

#include <pybind11/stl.h>

#include <map>
#include <memory>

#include "engine/python/arrays.h"
#include "engine/python/failure.h"
#include "engine/python/long_call.h"
#include "engine/python/operators.h"

namespace glissade::python {
namespace {

/// The callback of progress for a call; empty for None.
Progress progressOf(const py::object& callback, LongCall& call) {
  if (callback.is_none()) return {};
  return [&callback, &call](double share) { call.callBack([&] { return callback(share), true; }, false); };
}

LoadOptions loadOptionsOf(double deflection, std::optional<bool> fits, std::optional<double> acceptedClash,
                          const std::vector<std::string>& open, const std::vector<std::string>& without) {
  LoadOptions options;
  options.deflection = deflection;
  options.fits = fits;
  options.acceptedClash = acceptedClash;
  options.open = open;
  options.without = without;
  return options;
}

template <class Value>
Value loadAs(const std::string& file, LoadOptions options) {
  LongCall call;
  options.stop = call.stop();
  return valueOf(call.result([&] { return load<Value>(file, options); }));
}

/// Adds load_scenario() and load_product(), which have the same arguments.
template <class Value>
void addLoad(py::module_& module, const char* name, const char* text) {
  module.def(
      name,
      [](const std::string& file, double deflection, std::optional<bool> fits, std::optional<double> acceptedClash,
         const std::vector<std::string>& open, const std::vector<std::string>& without) {
        return loadAs<Value>(file, loadOptionsOf(deflection, fits, acceptedClash, open, without));
      },
      py::arg("file"), py::kw_only(), py::arg("deflection") = 0.0, py::arg("fits") = py::none(),
      py::arg("accepted_clash") = py::none(), py::arg("open") = std::vector<std::string>(),
      py::arg("without") = std::vector<std::string>(), text);
}

/// The argument of a planner in Python. A planner may keep it, but it works during one call only.
struct Context {
  std::weak_ptr<PlannerContext> inside;
};

/// A planner of a function context -> poses.
PlannerFunction plannerOf(const py::object& search, LongCall& call) {
  return [&search, &call](PlannerContext& inside) {
    return call.callBack(
        [&] {
          const std::shared_ptr<PlannerContext> during(&inside, [](PlannerContext*) {});
          const py::object way = search(Context{during});
          return way.is_none() ? std::vector<Pose>() : posesOf(way, "the planner's path");
        },
        std::vector<Pose>());
  };
}

/// The context of a planner that is running. Error: RuntimeError after the planner has returned.
PlannerContext& running(const Context& context) {
  const auto inside = context.inside.lock();
  if (!inside) throw std::runtime_error("the planner's run has ended");
  return *inside;
}

template <class Task>
Run planned(const Task& task, const std::string& strategy, std::optional<std::uint64_t> seed, const py::object& hand,
            const py::object& sampler, const Parameters& parameters, const std::map<std::string, py::object>& planners,
            const py::object& progress) {
  LongCall call;
  Planners outside;
  for (const auto& [id, search] : planners) valueOf(outside.add(id, plannerOf(search, call)));
  PlanOptions options{strategy, seed};
  const auto during = [&call]() -> LongCall& { return call; };
  setOperator(hand, during, options);
  setSampler(sampler, during, options);
  options.parameters = parameters;
  options.planners = &outside;
  options.stop = call.stop();
  if (!progress.is_none()) {
    options.progress = [&](const RunCounts& counts) { call.callBack([&] { return progress(counts), true; }, false); };
  }
  Run run = call.result([&] { return plan(task, options); });
  if (!run.path) fail(run.path.error());
  return run;
}

template <class Task>
void addPlan(py::module_& module) {
  module.def(
      "plan", &planned<Task>, py::arg("task"), py::kw_only(), py::arg("strategy") = "", py::arg("seed") = py::none(),
      py::arg("operator") = "none", py::arg("sampler") = py::none(), py::arg("parameters") = Parameters(),
      py::arg("planners") = std::map<std::string, py::object>(), py::arg("progress") = py::none(),
      "Plans a Scenario or a Problem and returns a Run with a certified path. `planners`: functions of a\n"
      "PlannerContext that return the poses of a path, by their ids. `operator`: the name of a simulated one, or a\n"
      "function of a HandView that returns the next pose. `sampler`: a function (problem, seed) that returns a "
      "function\n"
      "which draws a pose. `progress` gets RunCounts.");
}

void addPlanning(py::module_& module) {
  py::class_<Context>(module, "PlannerContext", "What a planner in Python works with, while it runs.")
      .def_property_readonly("problem", [](const Context& context) { return running(context).problem(); })
      .def_property_readonly("query", [](const Context& context) { return running(context).query(); })
      .def_property_readonly("seed", [](const Context& context) { return running(context).seed(); })
      .def(
          "parameter", [](const Context& context, const std::string& key) { return running(context).parameter(key); },
          py::arg("key"))
      .def(
          "step",
          [](const Context& context) {
            const py::gil_scoped_release withoutLock;
            return running(context).step();
          },
          "To be called once for each configuration that is drawn. False: the planner has to return.");
  addPlan<Scenario>(module);
  addPlan<Problem>(module);
}

const char* nameOf(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::Valid: return "valid";
    case VerdictKind::WithoutProof: return "without_proof";
    case VerdictKind::Conditional: return "conditional";
    case VerdictKind::Incomplete: return "incomplete";
    case VerdictKind::Undecided: return "undecided";
    case VerdictKind::Invalid: break;
  }
  return "invalid";
}

template <class Subject, class Answer>
void addCheck(py::module_& module) {
  module.def(
      "check",
      [](const Subject& subject, const Answer& answer, std::optional<double> required, bool trustPlan,
         const py::object& progress) {
        LongCall call;
        CheckOptions options;
        options.requiredClearance = required;
        options.trustPlan = trustPlan;
        options.progress = progressOf(progress, call);
        options.stop = call.stop();
        return valueOf(call.result([&] { return check(subject, answer, options); }));
      },
      py::arg("subject"), py::arg("answer"), py::kw_only(), py::arg("required_clearance") = py::none(),
      py::arg("trust_plan") = false, py::arg("progress") = py::none(),
      "Judges a path or a plan independently of the planners: two files, or two values.");
}

void addChecks(py::module_& module) {
  py::class_<Verdict>(module, "Verdict", "The verdict of the judge.")
      .def_property_readonly(
          "kind", [](const Verdict& verdict) { return nameOf(verdict.kind); },
          "'valid', 'without_proof', 'conditional', 'incomplete', 'undecided' or 'invalid'")
      .def_property_readonly("valid", &Verdict::valid)
      .def_readonly("text", &Verdict::text)
      .def_readonly("json", &Verdict::json)
      .def("__repr__",
           [](const Verdict& verdict) { return std::string("<glissade.Verdict ") + nameOf(verdict.kind) + ">"; });
  addCheck<Scenario, Path>(module);
  addCheck<Problem, Path>(module);
  addCheck<Product, AssemblyPlan>(module);
  addCheck<std::string, std::string>(module);
}

/// A list that notebooks show as a table. `type`: a class of glissade/_tables.py.
template <class Value>
py::object listOf(const char* type, const std::vector<Value>& values) {
  return py::module_::import("glissade._tables").attr(type)(values);
}

void addFinding(py::module_& module) {
  py::class_<Fit>(module, "Fit", "Two bodies that touch, overlap or are near each other.")
      .def_readonly("a", &Fit::a)
      .def_readonly("b", &Fit::b)
      .def_readonly("kind", &Fit::kind)
      .def_readonly("gap", &Fit::gap, "metres")
      .def_readonly("overlap", &Fit::overlap, "metres")
      .def_readonly("uncertainty", &Fit::uncertainty, "metres")
      .def_readonly("allowance", &Fit::allowance, "metres")
      .def_readonly("status", &Fit::status, "'clear', 'allowed', 'accepted' or 'clash'")
      .def("__repr__", [](const Fit& fit) {
        return "<glissade.Fit '" + fit.a + "', '" + fit.b + "': " + fit.kind + ", " + fit.status + ">";
      });
  py::class_<Joint>(module, "Joint", "How bodies of a product are joined.")
      .def_readonly("kind", &Joint::kind)
      .def_readonly("state", &Joint::state, "'recognised', 'suggested' or 'confirmed'")
      .def_readonly("body", &Joint::body)
      .def_readonly("others", &Joint::others)
      .def_readonly("clamped", &Joint::clamped)
      .def_property_readonly("point", [](const Joint& joint) { return arrayOf(joint.point); })
      .def_property_readonly("direction", [](const Joint& joint) { return arrayOf(joint.direction); })
      .def_readonly("diameter", &Joint::diameter, "metres; 0: no thread")
      .def_readonly("pitch", &Joint::pitch, "metres a turn; 0: no thread")
      .def_readonly("designation", &Joint::designation)
      .def_readonly("evidence", &Joint::evidence)
      .def("__repr__",
           [](const Joint& joint) { return "<glissade.Joint " + joint.kind + " of '" + joint.body + "'>"; });
  module.def(
      "fits",
      [](const Product& product, double clearanceUpTo, double clashAbove, std::size_t threads,
         const py::object& progress) {
        LongCall call;
        FindOptions options;
        options.clearanceUpTo = clearanceUpTo;
        options.clashAbove = clashAbove;
        options.threads = threads;
        options.progress = progressOf(progress, call);
        options.stop = call.stop();
        return listOf("Fits", valueOf(call.result([&] { return fits(product, options); })));
      },
      py::arg("product"), py::kw_only(), py::arg("clearance_up_to") = 0.0, py::arg("clash_above") = 1e-3,
      py::arg("threads") = 0, py::arg("progress") = py::none(), "The fits of a product.");
  module.def(
      "joints",
      [](const Product& product, bool confirmsSuggested) {
        LongCall call;
        FindOptions options;
        options.confirmsSuggested = confirmsSuggested;
        options.stop = call.stop();
        return listOf("Joints", valueOf(call.result([&] { return joints(product, options); })));
      },
      py::arg("product"), py::kw_only(), py::arg("confirms_suggested") = false, "The joints of a product.");
}

/// The curve of clearances as arrays.
py::dict curveOf(const std::vector<ClearanceSample>& samples) {
  const auto count = static_cast<py::ssize_t>(samples.size());
  py::array_t<double> share(count);
  py::array_t<double> distance(count);
  std::vector<std::string> bodies;
  std::vector<Pose> poses;
  for (py::ssize_t i = 0; i < count; ++i) {
    const ClearanceSample& sample = samples[static_cast<std::size_t>(i)];
    share.mutable_at(i) = sample.share;
    distance.mutable_at(i) = sample.nearest.distance;
    bodies.push_back(sample.nearest.body);
    poses.push_back(sample.X_WB);
  }
  py::dict curve;
  curve["share"] = share;
  curve["distance"] = distance;
  curve["body"] = bodies;
  curve["configurations"] = arrayOf(poses);
  return curve;
}

void addMeasuring(py::module_& module) {
  py::class_<SweptVolume>(module, "SweptVolume", "The volume that a body covers while it moves.")
      .def_readonly("surface", &SweptVolume::surface, "closed mesh in the world")
      .def_readonly("bound", &SweptVolume::bound, "largest distance of the surface from the sweep, metres")
      .def_readonly("volume", &SweptVolume::volume, "cubic metres")
      .def_readonly("excess", &SweptVolume::excess, "estimated share by which the volume is too large");
  module.def(
      "sweep",
      [](const Mesh& body, const py::object& poses, std::optional<double> bound, const py::object& progress) {
        LongCall call;
        const std::vector<Pose> way =
            py::isinstance<Path>(poses) ? poses.cast<const Path&>().configurations() : posesOf(poses, "poses");
        const SweepOptions options{bound, progressOf(progress, call), call.stop()};
        return valueOf(call.result([&] { return sweep(body, way, options); }));
      },
      py::arg("body"), py::arg("poses"), py::kw_only(), py::arg("bound") = py::none(), py::arg("progress") = py::none(),
      "The swept volume of a mesh along a Path or poses.");
  module.def(
      "clearance",
      [](const World& world, const Path& path, std::size_t samples) {
        LongCall call;
        FindOptions options;
        options.samples = samples;
        options.stop = call.stop();
        return curveOf(valueOf(call.result([&] { return clearance(world, path, options); })));
      },
      py::arg("world"), py::arg("path"), py::kw_only(), py::arg("samples") = 200,
      "Samples of the clearance along a path: a dict of arrays share, distance, configurations and a list body.");
}

void addSequence(py::module_& module) {
  module.def(
      "sequence",
      [](const Product& product, const std::string& strategy, std::uint64_t seed,
         const std::vector<std::string>& staying, double timeLimit, std::size_t threads, const py::object& progress) {
        LongCall call;
        SequenceOptions options{strategy, seed, staying, timeLimit, threads, {}, call.stop()};
        if (!progress.is_none()) {
          options.progress = [&](const AssemblyPlan& plan) {
            call.callBack([&] { return progress(plan), true; }, false);
          };
        }
        return valueOf(call.result([&] { return sequence(product, options); }));
      },
      py::arg("product"), py::kw_only(), py::arg("strategy") = "", py::arg("seed") = 1,
      py::arg("staying") = std::vector<std::string>(), py::arg("time_limit") = 0.0, py::arg("threads") = 0,
      py::arg("progress") = py::none(),
      "Plans in which order the bodies of a product leave. `progress` gets the plan so far.");
}

}  // namespace

void addFunctions(py::module_& module) {
  module.def("program_file", &programFile, py::arg("name"),
             "The file of one of Glissade's programs, such as 'glissade-offscreen'. It may be missing.");
  addLoad<Scenario>(module, "load_scenario", "Reads a scenario or an OMPL.app file.");
  addLoad<Product>(module, "load_product", "Reads the bodies of a scenario, STEP, IGES, BREP, URDF or mesh file.");
  module.def(
      "load_mesh", [](const std::string& file) { return loadAs<Mesh>(file, {}); }, py::arg("file"),
      "Reads a mesh file in its own unit.");
  module.def(
      "load_path", [](const std::string& file) { return loadAs<Path>(file, {}); }, py::arg("file"),
      "Reads a path file. Nothing is proved of it.");
  module.def(
      "load_plan", [](const std::string& file) { return loadAs<AssemblyPlan>(file, {}); }, py::arg("file"),
      "Reads an assembly plan.");
  addPlanning(module);
  addChecks(module);
  addFinding(module);
  addSequence(module);
  addMeasuring(module);
}

}  // namespace glissade::python
