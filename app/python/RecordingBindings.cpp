// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <cstdio>

#include "Bindings.h"
#include "NumberArrays.h"
#include "RecordColumns.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/session/RecordedInsertion.h"

namespace perilymph::python {

namespace {

using session::RecordedInsertion;

/// A recording as Python sees it.
struct Recording {
  py::dict columns, facts, highlights;
  std::string end, note;
  std::uint64_t lostTicks = 0;
  bool wasClosed = false;
};

py::dict factsOf(const session::RecordingFacts& facts)
{
  py::dict found;
  found["scenario_name"] = textOf(facts.scenarioName);
  found["scenario_text"] = textOf(facts.scenarioText);
  found["device"] = textOf(facts.device);
  found["time_step_s"] = facts.timeStep;
  found["device_delay_s"] = facts.deviceDelay;
  found["seed"] = facts.seed;
  found["model_fingerprint"] = fingerprintText(facts.modelFingerprint);
  found["version"] = textOf(facts.version);
  found["build_id"] = textOf(facts.buildId);
  found["started_utc"] = textOf(facts.startedUtc);
  return found;
}

py::dict highlightsOf(const session::Highlights& highlights)
{
  py::dict found;
  found["ticks"] = highlights.ticks;
  found["end"] = haptics::nameOf(highlights.end);
  found["duration_s"] = highlights.duration;
  found["deepest_mm"] = inMillimeters(meters(highlights.deepest));
  found["deepest_angle_deg"] = inDegrees(radians(highlights.deepestAngle));
  found["peak_force_N"] = highlights.peakForce;
  found["peak_travel_mm"] = inMillimeters(meters(highlights.peakTravel));
  found["peak_depth_mm"] = inMillimeters(meters(highlights.peakDepth));
  return found;
}

Recording readRecording(const py::object& given, double every_ms, bool check)
{
  constexpr double hour_ms = 3.6e6;
  constexpr std::uint64_t ticksPerLook = 1000;  // at signals
  const std::string file = nameOrFileOf(given, "file");
  numberOf(every_ms, "every_ms", "ms", 0.0, hour_ms);
  PendingException pending;
  RecordColumns columns(every_ms / 1e3);
  haptics::TickOutput last;
  Recording recording;
  session::Highlights highlights;
  session::RecordingFacts facts;
  const auto read = withoutLock([&]() -> Result<void> {
    const auto recorded = RecordedInsertion::open(file);
    if (!recorded) return recorded.error();
    if (check) {
      const auto checked = recorded->check();
      if (!checked) return checked.error();
      if (!checked->damage.empty())
        return Error{file + " does not contain what was recorded: " + checked->damage +
                     ". Use another copy of the recording."};
    }
    const auto done = recorded->forEach([&](const haptics::TickRecord& tick) {
      columns.add(tick);
      last = tick.output;
      return tick.tick % ticksPerLook != 0 || !pending.isRaised();
    });
    if (!done) return done.error();
    const auto found = recorded->highlights();
    if (!found) return found.error();
    highlights = *found;
    facts = recorded->facts();
    recording.note = recorded->note();
    recording.lostTicks = recorded->lostRecords();
    recording.wasClosed = recorded->wasClosed();
    return {};
  });
  pending.raise();
  valueOf(read);
  recording.columns = columns.result();
  recording.facts = factsOf(facts);
  recording.highlights = highlightsOf(highlights);
  recording.end = haptics::nameOf(haptics::endOf(last));
  return recording;
}

}  // namespace

std::string fingerprintText(std::uint64_t fingerprint)
{
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(fingerprint));
  return text;
}

void defineRecording(py::module_& module)
{
  py::class_<Recording>(module, "Recording", "A recorded insertion (.insertion).")
      .def_readonly("columns", &Recording::columns,
                    "Columns of shape (n,) by name with unit, as Simulation.columns.")
      .def(
          "__getitem__",
          [](const Recording& one, const std::string& name) -> py::object {
            return one.columns.attr("__getitem__")(name);
          },
          py::arg("name"), "A column by its name.")
      .def(
          "keys", [](const Recording& one) { return py::list(one.columns); },
          "Names of the columns.")
      .def(
          "__len__", [](const Recording& one) { return one.columns.size(); }, "Number of columns.")
      .def("__iter__", [](const Recording& one) { return py::iter(one.columns); })
      .def(
          "__contains__",
          [](const Recording& one, const py::object& name) { return one.columns.contains(name); },
          py::arg("name"))
      .def(
          "to_pandas", [](const Recording& one) { return dataFrameOf(one.columns); },
          "The columns as a pandas DataFrame.")
      .def_readonly("facts", &Recording::facts,
                    "What was recorded: 'scenario_name', 'scenario_text', 'device', 'time_step_s', "
                    "'device_delay_s', 'seed', 'model_fingerprint', 'version', 'build_id', "
                    "'started_utc'.")
      .def_readonly("highlights", &Recording::highlights,
                    "Key figures: 'ticks', 'duration_s', 'deepest_mm', 'deepest_angle_deg', "
                    "'peak_force_N', 'peak_travel_mm', 'peak_depth_mm'.")
      .def_readonly("end", &Recording::end, "How it ended, as Simulation.end.")
      .def_readonly("lost_ticks", &Recording::lostTicks, "Ticks that ran but are not in the file.")
      .def_readonly("was_closed", &Recording::wasClosed,
                    "False after a crash, or while it is recorded.")
      .def_property_readonly(
          "note", [](const Recording& one) { return textOf(one.note); },
          "A sentence about content that could not be read, or empty.");
  module.def("read_recording", &readRecording, py::arg("file"), py::kw_only(),
             py::arg("every_ms") = 0.0, py::arg("check") = false,
             "Reads a recording.\n\nevery_ms: interval between rows of the columns [ms]; 0: every "
             "tick.\ncheck: whether the whole file is compared with its hash first.\n\n"
             "The interpreter's lock is released while it reads; Ctrl+C ends it.");
}

}  // namespace perilymph::python
