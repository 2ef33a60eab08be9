// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>
#include <stop_token>

#include "Bindings.h"
#include "NumberArrays.h"
#include "ObjectText.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/study/StudyColumns.h"
#include "perilymph/study/StudyReport.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::python {

namespace {

using study::StudyColumns;

/// A study as Python sees it.
struct Study {
  std::string title, text, fingerprint, seal, program;
  std::vector<std::string> notes;
  py::dict columns;
};

/// Values of a setting: numbers if all of them are.
py::array settingColumn(const std::vector<std::string>& texts)
{
  std::vector<double> numbers;
  const bool areAllEmpty = std::ranges::all_of(texts, &std::string::empty);
  for (const std::string& text : texts) {
    double number = std::numeric_limits<double>::quiet_NaN();
    if (text.empty() && !areAllEmpty) {
      numbers.push_back(number);
      continue;
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return arrayOf(texts);
    numbers.push_back(number);
  }
  return arrayOf(std::move(numbers));
}

/// Numbers by insertion first, then settings that are text or have one value only.
py::dict columnsOf(const StudyColumns& study)
{
  py::dict columns;
  std::vector<std::int64_t> numbers, ticks, notConverged;
  std::vector<std::string> cochleae, endings, reasons;
  std::set<std::string> keys;
  for (std::size_t row = 0; row < study.size(); ++row) {
    const study::StudyResult& result = study.result(row);
    numbers.push_back(static_cast<std::int64_t>(result.number));
    cochleae.push_back(result.cochlea);
    endings.emplace_back(haptics::nameOf(result.insertion.end));
    reasons.push_back(result.insertion.reason);
    ticks.push_back(static_cast<std::int64_t>(result.insertion.ticks));
    notConverged.push_back(static_cast<std::int64_t>(result.insertion.ticksNotConverged));
    for (const auto& [key, value] : result.settings) keys.insert(key);
  }
  columns["number"] = arrayOf(std::move(numbers));
  columns["cochlea"] = arrayOf(cochleae);
  columns["ending"] = arrayOf(endings);
  columns["reason"] = arrayOf(reasons);
  for (const study::StudyQuantity& each : study.quantities())
    columns[textOf(each.key)] = arrayOf(each.values);
  columns["ticks"] = arrayOf(std::move(ticks));
  columns["ticks_not_converged"] = arrayOf(std::move(notConverged));
  for (const std::string& key : keys) {
    if (study.quantity(key) != nullptr) continue;
    std::vector<std::string> texts;
    for (std::size_t row = 0; row < study.size(); ++row)
      texts.push_back(study::settingOf(study.result(row), key));
    columns[textOf(key)] = settingColumn(texts);
  }
  for (const std::string& name : study.fileColumns()) {
    std::vector<std::string> texts;
    for (std::size_t row = 0; row < study.size(); ++row)
      texts.push_back(study.fileValueOf(study.result(row), name));
    columns[textOf(name)] = name == "array_name" ? arrayOf(texts) : settingColumn(texts);
  }
  return columns;
}

Study readStudy(const py::object& given)
{
  std::filesystem::path place = nameOrFileOf(given, "path");
  const StudyColumns read = valueOf(withoutLock([&] {
    std::error_code ignored;
    if (std::filesystem::is_directory(place, ignored)) place /= study::mergedFile;
    return StudyColumns::read(place, {});
  }));
  Study study;
  const auto& facts = read.facts();
  study.title = facts.title;
  study.text = facts.text;
  study.fingerprint = facts.fingerprint;
  study.seal = nameOf(facts.seal);
  study.program = facts.program;
  study.notes = facts.notes;
  if (const std::string note = noteOn(facts.seal); !note.empty())
    study.notes.insert(study.notes.begin(), note);
  study.columns = columnsOf(read);
  return study;
}

py::tuple studyState(const Study& one)
{
  py::list notes;
  for (const std::string& note : one.notes) notes.append(py::bytes(note));
  return py::make_tuple(py::bytes(one.title), py::bytes(one.text), one.fingerprint, one.seal,
                        py::bytes(one.program), notes, one.columns);
}

Study studyOf(const py::tuple& state)
{
  Study one;
  one.title = state[0].cast<std::string>();
  one.text = state[1].cast<std::string>();
  one.fingerprint = state[2].cast<std::string>();
  one.seal = state[3].cast<std::string>();
  one.program = state[4].cast<std::string>();
  for (const py::handle note : state[5]) one.notes.push_back(note.cast<std::string>());
  one.columns = state[6].cast<py::dict>();
  return one;
}

/// Number of insertions.
std::size_t sizeOf(const Study& one) { return py::len(one.columns["number"]); }

/// Numbers of insertions by their ending, the most frequent first.
std::vector<std::pair<std::string, std::string>> endingsOf(const Study& one)
{
  const py::object counts =
      py::module_::import("collections").attr("Counter")(one.columns["ending"].attr("tolist")());
  std::vector<std::pair<std::string, std::string>> rows;
  for (const py::handle each : counts.attr("most_common")()) {
    const auto row = each.cast<std::pair<std::string, std::size_t>>();
    rows.emplace_back(row.first, std::to_string(row.second));
  }
  return rows;
}

/// Runs a study's file to its end in the folder, or goes on, and reads its results.
Study runStudy(const py::object& file, const py::object& folder, long jobs,
               const py::object& progress)
{
  constexpr double maxJobs = 256;
  const std::filesystem::path place = nameOrFileOf(file, "study"),
                              results = nameOrFileOf(folder, "folder");
  numberOf(static_cast<double>(jobs), "jobs", "(whole numbers)", 0.0, maxJobs);
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress must be a function of two numbers, or None");
  PendingException pending;
  std::stop_source stop;
  const auto report = [&](std::size_t done, std::size_t all) {
    const bool isRaised = pending.isRaisedBy([&] {
      if (!progress.is_none()) progress(done, all);
    });
    if (isRaised) stop.request_stop();
  };
  const auto ran = withoutLock([&]() -> Result<bool> {
    const auto study = study::loadStudy(place);
    if (!study) return study.error();
    std::error_code error;
    std::filesystem::create_directories(results, error);
    if (error)
      return Error{"The folder %1 cannot be made: %2. Name one that can be written.",
                   results.string(), error.message()};
    const auto isComplete = study::runShard(*study, study::shardOf(study->size(), 1, 1), results,
                                            static_cast<unsigned>(jobs), report, stop.get_token());
    if (!isComplete || !*isComplete) return isComplete;
    if (const auto merged = study::mergeShards(results); !merged) return merged.error();
    return true;
  });
  pending.raise();
  if (!valueOf(ran))
    throw EngineError("The study was stopped before its end. Run it again: it goes on.");
  return readStudy(folder);
}

}  // namespace

void defineStudy(py::module_& module)
{
  py::class_<Study> kind(module, "Study", "The results of a study of many insertions.");
  kind.def_property_readonly(
          "title", [](const Study& one) { return textOf(one.title); }, "Title of the study.")
      .def_property_readonly(
          "text", [](const Study& one) { return textOf(one.text); }, "The study's file (TOML).")
      .def_readonly(
          "fingerprint", &Study::fingerprint,
          "SHA-256 of the study and of all files it names; empty if its results were changed after "
          "the program wrote them.")
      .def_readonly("seal", &Study::seal,
                    "'intact', 'absent' (of a version without seals) or 'changed' (by hand, after "
                    "the program wrote it).")
      .def_property_readonly(
          "notes",
          [](const Study& one) {
            std::vector<py::str> notes;
            for (const std::string& note : one.notes) notes.push_back(textOf(note));
            return notes;
          },
          "A sentence for each patient whose measures were changed by hand or carry no seal.")
      .def_property_readonly(
          "program", [](const Study& one) { return textOf(one.program); },
          "Version of the program that ran it.")
      .def(
          "columns", [](const Study& one) { return copied(one.columns); },
          "A row per insertion, shape (n,): 'number', 'cochlea' ('patients/1.toml' is the first "
          "one "
          "that was given), 'ending', 'reason' (why it is 'fault' or 'refused'), 'A_mm', 'B_mm', "
          "'cdl_oc_mm', 'st_length_mm', 'angle_deg', "
          "'coverage_percent', 'depth_mm', 'max_depth_mm', 'peak_mN', 'peak_depth_mm', 'end_mN', "
          "'partition_mN', 'ticks' and 'ticks_not_converged' (time steps, and those without "
          "equilibrium), every setting of the study by its key; of the files that settings name "
          "'array_name', 'friction_static' and 'friction_dynamic', as they were when it ran.")
      .def(
          "to_pandas", [](const Study& one) { return dataFrameOf(one.columns); },
          "columns() as a pandas DataFrame.")
      .def(
          "__len__", [](const Study& one) { return sizeOf(one); }, "Number of insertions.")
      .def(py::pickle([](const Study& one) { return studyState(one); },
                      [](const py::tuple& state) { return studyOf(state); }))
      .def("__repr__",
           [](const Study& one) {
             std::string text = "<perilymph.Study '" + one.title +
                                "': " + std::to_string(sizeOf(one)) + " insertions";
             for (const auto& [ending, count] : endingsOf(one)) text += ", " + count + ' ' + ending;
             if (one.seal == nameOf(Seal::changed)) text += ", changed by hand";
             return textOf(text + '>');
           })
      .def(
          "_repr_html_", [](const Study& one) { return htmlTable(one.title, endingsOf(one)); },
          "A table of its endings for notebooks.");
  defineIdentity(kind, [](const Study& one) { return std::string(bytesOf(studyState(one))); });
  // for perilymph/_study.py
  module.def("_run_study", &runStudy, py::arg("file"), py::arg("folder"), py::arg("jobs"),
             py::arg("progress"), "Runs a study's file and reads its results.");
  module.def(
      "_array_name", [](const py::object& given) { return arrayNameOf(given, "array"); },
      py::arg("array"), "Name or path of an array.");
  module.def(
      "_array_file", &arrayFileOf, py::arg("array"),
      "Name or path of the file that an array was read from, as long as it has its content; else "
      "empty.");
  module.def("read_study", &readStudy, py::arg("path"),
             "Reads the results of a study: its folder, its study.sqlite, or a shard.");
}

}  // namespace perilymph::python
