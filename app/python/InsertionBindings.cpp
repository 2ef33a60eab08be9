// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "Bindings.h"
#include "ContactColumns.h"
#include "NumberArrays.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Recording.h"

namespace perilymph::python {

namespace {

using haptics::Command;
using haptics::InsertionEngine;

/// What one tick gives, as Python sees it.
struct Reading {
  std::uint64_t tick = 0;  ///< Number of the tick, from 1; 0 before the first.
  haptics::TickOutput output;
  double work = 0.0;  ///< Work of the hand since the start [J].
};

/// Everything the next tick depends on. Copies go their own ways.
struct Content {
  InsertionEngine engine;
  analysis::ForceProfiler profiler;
  device::DeviceSample sample;
  haptics::CommandList commands;
  Reading reading;
};

/// The state of an insertion, kept by Python.
struct InsertionSnapshot {
  std::shared_ptr<const session::Scenario> scenario;
  std::shared_ptr<const anatomy::ScalaTympani> scala;
  std::shared_ptr<const Content> content;
};

/// An insertion that Python moves, tick by tick: the engine of the programs without a thread and
/// without a device.
class SteppedInsertion {
public:
  explicit SteppedInsertion(const session::Scenario& scenario)
      : scenario_(std::make_shared<const session::Scenario>(scenario))
  {
    auto device = std::make_shared<device::ScriptedDevice>(scenario_->speed().si(),
                                                           scenario_->timeStep().si());
    const auto prepared = valueOf(withoutLock(
        [&] { return session::Insertion::prepare(*scenario_, std::move(device), std::nullopt); }));
    scala_ = prepared->sharedAnatomy();
    Content content{prepared->loop().engine(), {}, {}, {}, {}};
    content.sample.isValid = 1;
    addCommand(content, Command::Kind::arm, 0.0);
    start_ = std::make_shared<const Content>(std::move(content));
    content_ = std::make_unique<Content>(*start_);
  }
  /// A branch: both go on from the same state.
  explicit SteppedInsertion(const InsertionSnapshot& from, std::shared_ptr<const Content> start)
      : scenario_(from.scenario),
        scala_(from.scala),
        start_(std::move(start)),
        content_(std::make_unique<Content>(*from.content))
  {
  }

  const session::Scenario& scenario() const { return *scenario_; }
  const anatomy::ScalaTympani& scala() const { return *scala_; }
  const std::shared_ptr<const Content>& start() const { return start_; }
  Content& content() { return *checked(); }
  const mechanics::InsertionState& state() { return checked()->engine.state(); }

  /// Calls `work` with the content and without the interpreter's lock; another thread that comes
  /// meanwhile is refused.
  template <class Work>
  void advance(const Work& work)
  {
    Content& content = *checked();
    isBusy_ = true;
    {
      const py::gil_scoped_release released;
      work(content);
    }
    isBusy_ = false;
  }

  InsertionSnapshot snapshot()
  {
    return {scenario_, scala_, std::make_shared<const Content>(*checked())};
  }
  void restore(const InsertionSnapshot& kept)
  {
    const std::uint64_t ours = start_->engine.model().fingerprint;
    if (kept.content->engine.model().fingerprint != ours ||
        kept.scenario->text() != scenario_->text())
      throw EngineError("The snapshot is of '" + kept.scenario->name() +
                        "' with other values than this insertion has. Restore it in an insertion "
                        "of the same scenario.");
    *checked() = *kept.content;
  }
  void reset() { *checked() = *start_; }

  static void addCommand(Content& content, Command::Kind kind, double value)
  {
    haptics::CommandList& list = content.commands;
    if (list.count >= haptics::maxCommandsPerTick)
      throw EngineError("Eight requests wait for the next time step. Advance the insertion first.");
    list.items[list.count].kind = kind;
    list.items[list.count].value = value;
    ++list.count;
  }

private:
  Content* checked()
  {
    if (isBusy_)
      throw EngineError("Another thread advances this insertion. Give each thread its own copy.");
    return content_.get();
  }

  std::shared_ptr<const session::Scenario> scenario_;
  std::shared_ptr<const anatomy::ScalaTympani> scala_;
  std::shared_ptr<const Content> start_;
  std::unique_ptr<Content> content_;
  bool isBusy_ = false;  ///< Read and written with the interpreter's lock.
};

/// One tick with the hand as it is in `content.sample`.
void tick(Content& content)
{
  ++content.sample.sequence;
  haptics::TickRecord record;
  record.sample = content.sample;
  record.commands = content.commands;
  content.commands = {};
  record.output = content.engine.tick(record.sample, record.commands);
  ++content.reading.tick;
  content.reading.output = record.output;
  if ((record.output.status & haptics::resting) != 0) return;
  content.profiler.add(record);
  content.reading.work = content.profiler.work();
}

bool hasEnded(const Content& content)
{
  const haptics::Workflow now = content.reading.output.workflow;
  return now == haptics::Workflow::finished || now == haptics::Workflow::fault;
}

// Ticks between two looks at Python's signals (choice, high): some milliseconds.
constexpr long ticksPerLook = 64;
constexpr double maxTicks = 1e7;

Reading advance(SteppedInsertion& one, const std::optional<double>& speed_mm_s, long ticks)
{
  constexpr double fastest_mm_s = 1000.0;
  const double speed = speed_mm_s ? millimetersPerSecond(numberOf(*speed_mm_s, "speed_mm_s", "mm/s",
                                                                  -fastest_mm_s, fastest_mm_s))
                                        .si()
                                  : one.scenario().speed().si();
  numberOf(static_cast<double>(ticks), "ticks", "(whole numbers)", 1.0, maxTicks);
  const double way = speed * one.scenario().timeStep().si();
  for (long left = ticks; left > 0;) {
    const bool hadEnded = hasEnded(one.content());
    bool ends = false;
    one.advance([&](Content& content) {
      for (long i = 0; i < ticksPerLook && left > 0 && !ends; ++i, --left) {
        // As a script does: a hand that grasps is at rest in that tick and moves from the next on.
        if ((content.sample.buttons & device::graspButton) != 0)
          content.sample.position_D[2] -= way;
        content.sample.buttons = device::graspButton;
        tick(content);
        ends = !hadEnded && hasEnded(content);
      }
    });
    if (ends) break;
    if (left > 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return one.content().reading;
}

Reading step(SteppedInsertion& one, const py::object& hand_mm, const py::object& rotation,
             bool grasp)
{
  constexpr double farthest_mm = 1000.0;
  const NumberArray hand = numbersOf(hand_mm, "hand_mm", "mm", -farthest_mm, farthest_mm);
  if (hand.values.size() != 3 || hand.shape.size() != 1)
    throw EngineError("hand_mm must have the shape (3,): x, y and z in mm. Give three values.");
  device::DeviceSample& sample = one.content().sample;
  std::array<double, 4> turn{1.0, 0.0, 0.0, 0.0};
  if (!rotation.is_none()) {
    const NumberArray given = numbersOf(rotation, "rotation", "(parts of a quaternion)", -1e3, 1e3);
    double square = 0.0;
    for (const double each : given.values) square += each * each;
    if (given.values.size() != 4 || given.shape.size() != 1 || !(square > 1e-12))
      throw EngineError(
          "rotation must be a quaternion w, x, y, z, not all zero. Give four values.");
    for (std::size_t i = 0; i < 4; ++i) turn[i] = given.values[i] / std::sqrt(square);
  }
  for (std::size_t i = 0; i < 3; ++i) sample.position_D[i] = millimeters(hand.values[i]).si();
  sample.rotation_D = turn;
  sample.buttons = grasp ? static_cast<std::uint32_t>(device::graspButton) : 0u;
  one.advance(tick);
  return one.content().reading;
}

double asMillimeters(double length) { return inMillimeters(meters(length)); }

py::array threeOf(const std::array<double, 3>& vector, double factor)
{
  return vectorOf(Eigen::Vector3d(vector[0], vector[1], vector[2]), factor);
}

/// Vectors of the nodes (n, 3).
py::array rowsOf(const std::vector<Eigen::Vector3d>& vectors, double factor)
{
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const Eigen::Vector3d& each : vectors)
    for (int axis = 0; axis < 3; ++axis) values.push_back(each[axis] * factor);
  return arrayOf(std::move(values), {static_cast<py::ssize_t>(vectors.size()), 3});
}

py::list eventsOf(const Reading& one)
{
  py::list events;
  std::istringstream words(session::statusText(one.output.status));
  for (std::string word; words >> word;) events.append(word);
  return events;
}

py::dict columnsOf(const Reading& one)
{
  haptics::TickRecord record;
  record.output = one.output;
  const auto values = session::columnValues(record);
  py::dict found = dictOfRenamed();
  for (std::size_t i = 0; i < values.size(); ++i) found[session::columnNames[i]] = values[i];
  return found;
}

/// A property that is a member of the output, times a factor.
template <class Class>
void defineNumber(Class& kind, const char* name, double haptics::TickOutput::*member, double factor,
                  const char* text)
{
  kind.def_property_readonly(
      name, [member, factor](const Reading& one) { return one.output.*member * factor; }, text);
}

void defineReading(py::module_& module)
{
  using haptics::TickOutput;
  py::class_<Reading> kind(module, "Reading",
                           "What one time step of an insertion gives. Vectors are in the cochlea's "
                           "frame.");
  kind.def_readonly("tick", &Reading::tick, "Number of the time step, from 1; 0: before the first.")
      .def_property_readonly(
          "time_s", [](const Reading& one) { return one.output.time; },
          "Time since the first motion [s].")
      .def_property_readonly(
          "travel_mm", [](const Reading& one) { return asMillimeters(one.output.travel); },
          "Depth less the depth at the start [mm].")
      .def_property_readonly(
          "depth_mm", [](const Reading& one) { return asMillimeters(one.output.depth); },
          "Length of the array past the opening [mm].")
      .def_property_readonly(
          "speed_mm_s",
          [](const Reading& one) {
            return inMillimetersPerSecond(metersPerSecond(one.output.speed));
          },
          "Speed of the base into the cochlea [mm/s].")
      .def_property_readonly(
          "tip_angle_deg",
          [](const Reading& one) { return inDegrees(radians(one.output.angularDepth)); },
          "Angle of the tip from the round window [deg]; 0 before it.")
      .def_property_readonly(
          "tip_mm", [](const Reading& one) { return threeOf(one.output.tip_W, 1e3); },
          "The tip, shape (3,) [mm].")
      .def_property_readonly(
          "force_N", [](const Reading& one) { return threeOf(one.output.force_W, 1.0); },
          "Force of the array on the hand, shape (3,) [N].")
      .def_readonly("work_J", &Reading::work, "Work of the hand on the array since the start [J].")
      .def_property_readonly(
          "contacts", [](const Reading& one) { return one.output.contacts; },
          "Number of nodes that touch the wall.")
      .def_property_readonly(
          "iterations", [](const Reading& one) { return one.output.iterations; },
          "Iterations of the solver.")
      .def_property_readonly(
          "stylet_withdrawal_mm",
          [](const Reading& one) { return asMillimeters(one.output.styletWithdrawal); },
          "Length by which the stylet is withdrawn [mm].")
      .def_property_readonly(
          "state", [](const Reading& one) { return session::workflowWord(one.output.workflow); },
          "'idle', 'armed', 'inserting', 'paused', 'finished' or 'fault'.")
      .def_property_readonly(
          "end", [](const Reading& one) { return haptics::nameOf(endOf(one.output)); },
          "How the insertion ended, as Simulation.end; 'none' while it has not.")
      .def_property_readonly("events", &eventsOf,
                             "Names of the conditions of this time step, as a recording lists "
                             "them: 'notSettled', 'endedBuckled', 'partitionRuptured', ...")
      .def("values", &columnsOf,
           "The row of 'perilymph-cli simulate --csv' of this time step: values by column.")
      .def("__repr__", [](const Reading& one) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "<perilymph.Reading at %.3f s: %s, depth %.2f mm, axial force %.4f N>",
                      one.output.time, session::workflowWord(one.output.workflow).c_str(),
                      asMillimeters(one.output.depth), one.output.axialForce);
        return std::string(text);
      });
  defineNumber(kind, "force_axial_N", &TickOutput::axialForce, 1.0,
               "Force on the hand along the axis of the opening, positive while pushing in [N].");
  defineNumber(kind, "wall_force_max_N", &TickOutput::wallForceMax, 1.0,
               "Largest normal force on one node [N].");
  defineNumber(kind, "membrane_force_N", &TickOutput::membraneForce, 1.0,
               "Normal force on the basilar membrane in all [N].");
  defineNumber(kind, "partition_force_N", &TickOutput::partitionForce, 1.0,
               "Largest force on the cochlear partition within one contact [N].");
  defineNumber(kind, "plastic_work_J", &TickOutput::plasticWork, 1.0,
               "Work that wires and stylet took by yielding [J]; NaN where none can.");
  defineNumber(kind, "residual_N", &TickOutput::residual, 1.0,
               "Largest unbalanced force on a node [N].");
}

}  // namespace

void defineInsertion(py::module_& module)
{
  defineReading(module);
  py::class_<InsertionSnapshot>(module, "InsertionSnapshot",
                                "The whole state of an insertion, kept by Insertion.snapshot().")
      .def_property_readonly(
          "reading", [](const InsertionSnapshot& one) { return one.content->reading; },
          "The reading of its last time step.")
      .def_property_readonly(
          "fingerprint",
          [](const InsertionSnapshot& one) {
            return fingerprintText(one.content->engine.fingerprint());
          },
          "As Insertion.fingerprint.");

  const auto branch = [](SteppedInsertion& one) {
    return std::make_unique<SteppedInsertion>(one.snapshot(), one.start());
  };
  using Stepped = SteppedInsertion;
  py::class_<Stepped>(module, "Insertion",
                      "An insertion that the caller moves, one time step at a time, in virtual "
                      "time: the engine of the "
                      "programs with the same bits. Each thread needs its own copy.")
      .def(py::init([](const py::object& scenario, const py::object& overrides) {
             return std::make_unique<Stepped>(scenarioOf(scenario, overrides));
           }),
           py::arg("scenario"), py::arg("overrides") = py::none(),
           "Prepares the insertion of a scenario, given as for simulate(). Takes some tenths of a "
           "second.")
      .def("advance", &advance, py::arg("speed_mm_s") = py::none(), py::kw_only(),
           py::arg("ticks") = 1,
           "Moves the hand along the approach and returns the Reading of the last time step.\n\n"
           "speed_mm_s: into the cochlea, negative out of it, 0 holds [mm/s]; None: the "
           "scenario's.\nticks: time steps with this speed; the step in which the insertion ends "
           "is the last.\n\nThe interpreter's lock is released while it computes; Ctrl+C ends it "
           "between two steps.")
      .def("step", &step, py::arg("hand_mm"), py::arg("rotation") = py::none(), py::kw_only(),
           py::arg("grasp") = true,
           "One time step with the hand at a pose; returns its Reading.\n\nhand_mm: position (3,) "
           "in the device's frame: x right, y up, z toward the user; the hand pushes along -z "
           "[mm]. The array follows from where the hand grasps.\nrotation: quaternion w, x, y, z "
           "in the same frame; None: not turned.\ngrasp: whether the hand holds the array. A hand "
           "that is farther than it could move takes a new hold (event 'handJumped').")
      .def(
          "withdraw",
          [](Stepped& one) { Stepped::addCommand(one.content(), Command::Kind::withdraw, 0.0); },
          "Lets the array be withdrawn from the next time step on, after an end too; then advance "
          "with a negative speed.")
      .def(
          "pull_stylet",
          [](Stepped& one, double to_mm) {
            constexpr double longest_mm = 100.0;  // beyond every array
            numberOf(to_mm, "to_mm", "mm", 0.0, longest_mm);
            const electrode::ArrayDesign& array = one.scenario().array();
            if (!array.hasStylet)
              throw EngineError("The array " + array.name + " has no stylet to be pulled.");
            Stepped::addCommand(one.content(), Command::Kind::pullStylet, millimeters(to_mm).si());
          },
          py::arg("to_mm"),
          "Withdraws the stylet to a length, at the scenario's speed, from the next time step on "
          "[mm].")
      .def("reset", &Stepped::reset, "Back to the start, without preparing the insertion again.")
      .def("snapshot", &Stepped::snapshot, "Keeps the whole state, for restore().")
      .def("restore", &Stepped::restore, py::arg("snapshot"),
           "Returns to a state that snapshot() kept; what follows has the same bits.")
      .def("__copy__", branch, "Another insertion that goes on from this state.")
      .def(
          "__deepcopy__", [branch](Stepped& one, const py::object&) { return branch(one); },
          py::arg("memo"), "Another insertion that goes on from this state.")
      .def_property_readonly(
          "reading", [](Stepped& one) { return one.content().reading; },
          "The reading of the last time step; before the first its tick and all values are 0.")
      .def_property_readonly(
          "has_ended", [](Stepped& one) { return hasEnded(one.content()); },
          "Whether the insertion has ended; Reading.end says how.")
      .def_property_readonly(
          "scenario", [](Stepped& one) { return one.scenario(); }, "The scenario as run.")
      .def_property_readonly(
          "time_step_s", [](Stepped& one) { return one.scenario().timeStep().si(); },
          "Duration of a time step [s].")
      .def_property_readonly(
          "nodes_mm", [](Stepped& one) { return rowsOf(one.state().position_W, 1e3); },
          "The array now, shape (nodes, 3) [mm], base first, tip last.")
      .def_property_readonly(
          "velocities_mm_s", [](Stepped& one) { return rowsOf(one.state().velocity_W, 1e3); },
          "Velocity of each node, shape (nodes, 3) [mm/s].")
      .def_property_readonly(
          "node_forces_N", [](Stepped& one) { return rowsOf(one.state().wallForce_W, 1.0); },
          "Force of the wall on each node, normal and friction, shape (nodes, 3) [N].")
      .def_property_readonly(
          "normal_forces_N", [](Stepped& one) { return arrayOf(one.state().normalForce); },
          "Normal force of the wall on each node, shape (nodes,) [N].")
      .def(
          "contacts",
          [](Stepped& one) {
            haptics::Snapshot now;
            one.content().engine.fill(now);
            return contactColumns(
                analysis::contactPositions(one.scala(), one.scenario().array(), now));
          },
          "The electrode contacts now, as Simulation.contacts. Takes some milliseconds.")
      .def_property_readonly(
          "fingerprint",
          [](Stepped& one) { return fingerprintText(one.content().engine.fingerprint()); },
          "16 hexadecimal digits of everything the next time step depends on: equal states have "
          "the same.")
      .def("__repr__", [](Stepped& one) {
        const Reading& now = one.content().reading;
        char text[120];
        std::snprintf(text, sizeof text, "': %s, depth %.2f mm, time step %llu>",
                      session::workflowWord(now.output.workflow).c_str(),
                      asMillimeters(now.output.depth), static_cast<unsigned long long>(now.tick));
        return textOf("<perilymph.Insertion of '" + one.scenario().name() + text);
      });
}

}  // namespace perilymph::python
