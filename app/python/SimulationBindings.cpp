// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <cmath>
#include <limits>

#include "Bindings.h"
#include "ContactColumns.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "RecordColumns.h"
#include "perilymph/analysis/SimulatedInsertion.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::python {

namespace {

using session::Insertion;

/// Result of simulate(), as Python sees it.
struct Simulation {
  py::dict columns, summary, contacts;
  std::string end, endClause;
  py::array nodes_mm, shapes_mm, shapeDepths_mm;
  session::Scenario scenario;
};

/// Shapes of the array where the tip first passes the depths.
class Shapes {
public:
  explicit Shapes(std::vector<double> depths_mm) : depths_mm_(std::move(depths_mm))
  {
    taken_.resize(depths_mm_.size());
  }

  /// Takes the shape of this tick for each depth that it is the first to reach.
  void add(Insertion& insertion, const haptics::TickOutput& now)
  {
    bool isFresh = false;
    for (std::size_t i = 0; i < depths_mm_.size(); ++i) {
      if (taken_[i] || !(inMillimeters(meters(now.depth)) >= depths_mm_[i])) continue;
      if (!isFresh) insertion.refresh();
      isFresh = true;
      taken_[i] = Shape{now.depth, nodesOf(insertion.latest())};
    }
  }

  /// Node coordinates [mm], base first.
  static std::vector<double> nodesOf(const haptics::Snapshot& now)
  {
    std::vector<double> nodes;
    for (std::uint32_t i = 0; i < now.nodes; ++i)
      for (const float value : now.node_W[i])
        nodes.push_back(inMillimeters(meters(static_cast<double>(value))));
    return nodes;
  }

  /// Shapes (depths, nodes, 3) and depths (depths,) [mm]; NaN where a depth was not reached.
  std::pair<py::array, py::array> result(std::size_t nodes) const
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> shapes, depths;
    for (const auto& shape : taken_) {
      depths.push_back(shape ? inMillimeters(meters(shape->depth)) : none);
      if (shape)
        shapes.insert(shapes.end(), shape->nodes.begin(), shape->nodes.end());
      else
        shapes.insert(shapes.end(), 3 * nodes, none);
    }
    const auto count = static_cast<py::ssize_t>(taken_.size());
    return {arrayOf(std::move(shapes), {count, static_cast<py::ssize_t>(nodes), 3}),
            arrayOf(std::move(depths))};
  }

private:
  struct Shape {
    double depth;
    std::vector<double> nodes;
  };
  std::vector<double> depths_mm_;
  std::vector<std::optional<Shape>> taken_;
};

// Ticks between two looks at Python's signals: some milliseconds of work (choice, high).
constexpr std::uint64_t ticksPerLook = 64;

Simulation simulate(const py::object& given, const py::object& overrides, const py::object& record,
                    double every_ms, const py::object& depths_mm)
{
  constexpr double hour_ms = 3.6e6;
  constexpr double deepest_mm = 100.0;  // beyond every array
  const session::Scenario scenario = scenarioOf(given, overrides);
  numberOf(every_ms, "every_ms", "ms", 0.0, hour_ms);
  Shapes shapes(numbersOf(depths_mm, "depths_mm", "mm", 0.0, deepest_mm).values);
  std::optional<std::filesystem::path> file;
  if (!record.is_none()) file = nameOrFileOf(record, "record");

  std::unique_ptr<Insertion> insertion = valueOf(withoutLock([&] {
    auto device =
        std::make_unique<device::ScriptedDevice>(scenario.speed().si(), scenario.timeStep().si());
    return Insertion::prepare(scenario, std::move(device), file);
  }));
  RecordColumns columns(every_ms / 1e3);
  PendingException pending;
  std::uint64_t ticks = 0;
  const auto simulated = withoutLock([&] {
    return analysis::simulate(*insertion, [&](const haptics::TickRecord& tick) {
      columns.add(tick);
      shapes.add(*insertion, tick.output);
      return ++ticks % ticksPerLook != 0 || !pending.isRaised();
    });
  });
  pending.raise();
  const analysis::SimulatedInsertion result = valueOf(simulated);

  Simulation simulation;
  simulation.scenario = scenario;
  simulation.columns = columns.result();
  const haptics::InsertionEnd end = endOf(result.last);
  simulation.end = nameOf(end);
  simulation.endClause = clauseOf(end);
  simulation.summary =
      fromJson(analysis::simulationJson(scenario, result, insertion->loop().statistics()));
  insertion->refresh();
  const haptics::Snapshot& last = insertion->latest();
  simulation.nodes_mm = arrayOf(Shapes::nodesOf(last), {static_cast<py::ssize_t>(last.nodes), 3});
  std::tie(simulation.shapes_mm, simulation.shapeDepths_mm) = shapes.result(last.nodes);
  simulation.contacts = contactColumns(
      analysis::contactPositions(insertion->anatomy(), insertion->parameters().array, last));
  valueOf(withoutLock([&] { return insertion->closeRecording(); }));
  return simulation;
}

py::tuple simulationState(const Simulation& one)
{
  return py::make_tuple(one.columns, one.summary, one.contacts, one.end, one.endClause,
                        one.nodes_mm, one.shapes_mm, one.shapeDepths_mm, one.scenario);
}

/// Key figures with their units.
std::vector<std::pair<std::string, std::string>> figuresOf(const Simulation& one)
{
  std::vector<std::pair<std::string, std::string>> rows;
  const auto add = [&](const char* name, const char* key, double factor, int digits,
                       const char* unit) {
    rows.emplace_back(name,
                      figures::fixed(one.summary[key].cast<double>() * factor, digits) + unit);
  };
  add("depth", "final_depth_mm", 1.0, 2, " mm");
  add("angular insertion depth", "angular_insertion_depth_deg", 1.0, 0, " deg");
  add("peak insertion force", "peak_force_N", 1e3, 1, " mN");
  return rows;
}

py::str htmlOf(const Simulation& one)
{
  auto rows = figuresOf(one);
  rows.emplace(rows.begin(), "end", one.end);
  return htmlTable(one.scenario.name(), rows);
}

}  // namespace

void defineSimulation(py::module_& module)
{
  py::class_<Simulation> kind(
      module, "Simulation", "A simulated insertion: columns, key figures and shapes of the array.");
  kind.def_property_readonly(
          "columns", [](const Simulation& one) { return ownDict(locked(one.columns)); },
          "Columns of shape (n,) by name with unit, those of 'perilymph-cli simulate "
          "--csv': 'time_s', 'depth_mm', 'force_axial_N', ...")
      .def(
          "to_pandas", [](const Simulation& one) { return dataFrameOf(one.columns); },
          "The columns as a pandas DataFrame.")
      .def(
          "contacts_to_pandas", [](const Simulation& one) { return dataFrameOf(one.contacts); },
          "The contacts as a pandas DataFrame, a row each.")
      .def(py::pickle([](const Simulation& one) { return simulationState(one); },
                      [](const py::tuple& state) {
                        Simulation one;
                        one.columns = state[0].cast<py::dict>();
                        one.summary = state[1].cast<py::dict>();
                        one.contacts = state[2].cast<py::dict>();
                        one.end = state[3].cast<std::string>();
                        one.endClause = state[4].cast<std::string>();
                        one.nodes_mm = state[5].cast<py::array>();
                        one.shapes_mm = state[6].cast<py::array>();
                        one.shapeDepths_mm = state[7].cast<py::array>();
                        one.scenario = state[8].cast<session::Scenario>();
                        return one;
                      }))
      .def(
          "_repr_html_", [](const Simulation& one) { return htmlOf(one); },
          "A table of its key figures for notebooks.")
      .def_readonly("end", &Simulation::end,
                    "How it ended: 'finished', 'stopped_by_resistance', 'buckled', "
                    "'out_of_opening', 'folded_tip', 'jammed' or 'none'.")
      .def_readonly("end_clause", &Simulation::endClause,
                    "The same as a clause without a subject: 'buckled in front of the opening'.")
      .def_property_readonly(
          "summary", [](const Simulation& one) { return copied(one.summary); },
          "Key figures and the scenario as run, as in 'perilymph-cli simulate --json'.")
      .def_property_readonly(
          "nodes_mm", [](const Simulation& one) { return locked(one.nodes_mm); },
          "The array at the end, shape (nodes, 3) [mm], base first, tip last.")
      .def_property_readonly(
          "shapes_mm", [](const Simulation& one) { return locked(one.shapes_mm); },
          "The array where the tip first passed each of the depths asked for, shape "
          "(depths, nodes, 3) [mm]; NaN where it did not.")
      .def_property_readonly(
          "shape_depths_mm", [](const Simulation& one) { return locked(one.shapeDepths_mm); },
          "Depths of those shapes, shape (depths,) [mm].")
      .def_property_readonly(
          "contacts", [](const Simulation& one) { return ownDict(locked(one.contacts)); },
          "The contacts at the end, from the tip, as columns of shape (contacts,): "
          "'number', 'is_inserted', 'depth_mm', 'angle_deg', 'coverage_percent', "
          "'frequency_Hz', 'to_modiolus_mm'; NaN for contacts that are not inserted.")
      .def_property_readonly(
          "scenario", [](const Simulation& one) { return one.scenario; }, "The scenario as run.")
      .def("__repr__", [](const Simulation& one) {
        std::string text = "<perilymph.Simulation of '" + one.scenario.name() + "': " + one.end;
        for (const auto& [name, value] : figuresOf(one)) text += ", " + name + ' ' + value;
        return textOf(text + '>');
      });
  defineMapping(kind, [](const Simulation& one) { return locked(one.columns); });
  defineIdentity(kind,
                 [](const Simulation& one) { return std::string(bytesOf(simulationState(one))); });

  module.def("simulate", &simulate, py::arg("scenario"), py::arg("overrides") = py::none(),
             py::kw_only(), py::arg("record") = py::none(), py::arg("every_ms") = 0.0,
             py::arg("depths_mm") = py::tuple(),
             "Runs an insertion at the scenario's speed to its end, in virtual time.\n\n"
             "scenario: a Scenario, or the name or path of one; overrides: values by key, as with "
             "'--set', with objects too: a Patient, an Array, a Friction, and a Cochlea as "
             "'cochlea'.\nrecord: file of the recording (.insertion), which must not exist.\n"
             "every_ms: interval between rows of the columns [ms]; 0: every time step.\n"
             "depths_mm: depths of the tip past the opening at which the array's shape is kept "
             "[mm].\n\nThe interpreter's lock is released while it computes; Ctrl+C ends it.");
}

}  // namespace perilymph::python
