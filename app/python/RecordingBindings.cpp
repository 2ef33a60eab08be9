// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <cstdio>

#include "Bindings.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "RecordColumns.h"
#include "perilymph/figures/Strings.h"
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
                     ". Use another copy of the recording, or read this one as it is with "
                     "check=False."};
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

py::tuple recordingState(const Recording& one)
{
  return py::make_tuple(one.columns, one.facts, one.highlights, one.end, py::bytes(one.note),
                        one.lostTicks, one.wasClosed);
}

/// Key figures with their units.
std::vector<std::pair<std::string, std::string>> figuresOf(const Recording& one)
{
  const auto figure = [&](const char* key, double factor, int digits, const char* unit) {
    return figures::fixed(one.highlights[key].cast<double>() * factor, digits) + unit;
  };
  return {{"deepest", figure("deepest_mm", 1.0, 2, " mm")},
          {"angle of the tip", figure("deepest_angle_deg", 1.0, 0, " deg")},
          {"peak insertion force", figure("peak_force_N", 1e3, 1, " mN")}};
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
  py::class_<Recording> kind(module, "Recording", "A recorded insertion (.insertion).");
  kind.def_property_readonly(
          "columns", [](const Recording& one) { return ownDict(locked(one.columns)); },
          "Columns of shape (n,) by name with unit, as Simulation.columns.")
      .def(
          "to_pandas", [](const Recording& one) { return dataFrameOf(one.columns); },
          "The columns as a pandas DataFrame.")
      .def_property_readonly(
          "facts", [](const Recording& one) { return copied(one.facts); },
          "What was recorded: 'scenario_name', 'scenario_text', 'device', 'time_step_s', "
          "'device_delay_s', 'seed', 'model_fingerprint', 'version', 'build_id', "
          "'started_utc'.")
      .def_property_readonly(
          "highlights", [](const Recording& one) { return copied(one.highlights); },
          "Key figures: 'ticks', 'duration_s', 'deepest_mm', 'deepest_angle_deg', "
          "'peak_force_N', 'peak_travel_mm', 'peak_depth_mm'.")
      .def_readonly("end", &Recording::end, "How it ended, as Simulation.end.")
      .def_readonly("lost_ticks", &Recording::lostTicks, "Ticks that ran but are not in the file.")
      .def_readonly("was_closed", &Recording::wasClosed,
                    "False after a crash, or while it is recorded.")
      .def_property_readonly(
          "note", [](const Recording& one) { return textOf(one.note); },
          "A sentence about content that could not be read, or empty.")
      .def(py::pickle([](const Recording& one) { return recordingState(one); },
                      [](const py::tuple& state) {
                        Recording one;
                        one.columns = state[0].cast<py::dict>();
                        one.facts = state[1].cast<py::dict>();
                        one.highlights = state[2].cast<py::dict>();
                        one.end = state[3].cast<std::string>();
                        one.note = std::string(state[4].cast<py::bytes>());
                        one.lostTicks = state[5].cast<std::uint64_t>();
                        one.wasClosed = state[6].cast<bool>();
                        return one;
                      }))
      .def("__repr__",
           [](const Recording& one) {
             std::string text = "<perilymph.Recording of '" +
                                one.facts["scenario_name"].cast<std::string>() + "': " + one.end;
             for (const auto& [name, value] : figuresOf(one)) text += ", " + name + ' ' + value;
             return textOf(text + '>');
           })
      .def(
          "_repr_html_",
          [](const Recording& one) {
            auto rows = figuresOf(one);
            rows.emplace(rows.begin(), "end", one.end);
            rows.emplace_back("started (UTC)", one.facts["started_utc"].cast<std::string>());
            return htmlTable(one.facts["scenario_name"].cast<std::string>(), rows);
          },
          "A table of its key figures for notebooks.");
  defineMapping(kind, [](const Recording& one) { return locked(one.columns); });
  defineIdentity(kind,
                 [](const Recording& one) { return std::string(bytesOf(recordingState(one))); });

  module.def(
      "read_recording", &readRecording, py::arg("file"), py::kw_only(), py::arg("every_ms") = 0.0,
      py::arg("check") = true,
      "Reads a recording.\n\nevery_ms: interval between rows of the columns [ms]; 0: every "
      "tick.\ncheck: whether the whole file is compared with its seal first; one that was changed "
      "after it was recorded is an error. Without it, values that anybody changed are "
      "returned as they are.\n\n"
      "The interpreter's lock is released while it reads; Ctrl+C ends it.");
}

}  // namespace perilymph::python
