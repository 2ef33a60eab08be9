// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <charconv>
#include <set>
#include <stop_token>

#include "Bindings.h"
#include "NumberArrays.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/study/StudyColumns.h"
#include "perilymph/study/StudyReport.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::python {

namespace {

using study::StudyColumns;

std::shared_ptr<StudyColumns> readStudy(const py::object& given)
{
  std::filesystem::path place = nameOrFileOf(given, "path");
  return std::make_shared<StudyColumns>(valueOf(withoutLock([&] {
    std::error_code ignored;
    if (std::filesystem::is_directory(place, ignored)) place /= study::mergedFile;
    return StudyColumns::read(place, {});
  })));
}

/// Values of a setting: numbers if all of them are.
py::array settingColumn(const std::vector<std::string>& texts)
{
  std::vector<double> numbers;
  for (const std::string& text : texts) {
    double number = 0.0;
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
  std::vector<std::int64_t> numbers;
  std::vector<std::string> cochleae, endings;
  std::set<std::string> keys;
  for (std::size_t row = 0; row < study.size(); ++row) {
    const study::StudyResult& result = study.result(row);
    numbers.push_back(static_cast<std::int64_t>(result.number));
    cochleae.push_back(result.cochlea);
    endings.emplace_back(haptics::nameOf(result.insertion.end));
    for (const auto& [key, value] : result.settings) keys.insert(key);
  }
  columns["number"] = arrayOf(std::move(numbers));
  columns["cochlea"] = arrayOf(cochleae);
  columns["ending"] = arrayOf(endings);
  for (const study::StudyQuantity& each : study.quantities())
    columns[textOf(each.key)] = arrayOf(each.values);
  for (const std::string& key : keys) {
    if (study.quantity(key) != nullptr) continue;
    std::vector<std::string> texts;
    for (std::size_t row = 0; row < study.size(); ++row)
      texts.push_back(study::settingOf(study.result(row), key));
    columns[textOf(key)] = settingColumn(texts);
  }
  return columns;
}

/// Runs a study's file to its end in the folder, or goes on, and reads its results.
std::shared_ptr<StudyColumns> runStudy(const py::object& file, const py::object& folder, long jobs,
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
  py::class_<StudyColumns, std::shared_ptr<StudyColumns>>(
      module, "Study", "The results of a study of many insertions.")
      .def_property_readonly(
          "title", [](const StudyColumns& one) { return textOf(one.facts().title); },
          "Title of the study.")
      .def_property_readonly(
          "text", [](const StudyColumns& one) { return textOf(one.facts().text); },
          "The study's file (TOML).")
      .def_property_readonly(
          "fingerprint", [](const StudyColumns& one) { return textOf(one.facts().fingerprint); },
          "SHA-256 of the study and of all files it names; empty if its results were changed after "
          "the program wrote them.")
      .def_property_readonly(
          "seal", [](const StudyColumns& one) { return nameOf(one.facts().seal); },
          "'intact', 'absent' (of a version without seals) or 'changed' (by hand, after the "
          "program "
          "wrote it).")
      .def_property_readonly(
          "notes",
          [](const StudyColumns& one) {
            std::vector<py::str> notes;
            for (const std::string& note : one.facts().notes) notes.push_back(textOf(note));
            return notes;
          },
          "A sentence for each patient whose measures were changed by hand or carry no seal.")
      .def_property_readonly(
          "program", [](const StudyColumns& one) { return textOf(one.facts().program); },
          "Version of the program that ran it.")
      .def(
          "columns", &columnsOf,
          "A row per insertion, shape (n,): 'number', 'cochlea', 'ending', 'A_mm', 'B_mm', "
          "'st_length_mm', 'angle_deg', 'coverage_percent', 'depth_mm', 'max_depth_mm', 'peak_mN', "
          "'peak_depth_mm', 'end_mN', 'partition_mN', and every setting of the study by its key.")
      .def(
          "to_pandas", [](const StudyColumns& one) { return dataFrameOf(columnsOf(one)); },
          "columns() as a pandas DataFrame.")
      .def("__len__", &StudyColumns::size)
      .def("__repr__", [](const StudyColumns& one) {
        return textOf("<perilymph.Study '" + one.facts().title +
                      "': " + std::to_string(one.size()) + " insertions>");
      });
  // for perilymph/_study.py
  module.def("_run_study", &runStudy, py::arg("file"), py::arg("folder"), py::arg("jobs"),
             py::arg("progress"), "Runs a study's file and reads its results.");
  module.def(
      "_array_name", [](const py::object& given) { return arrayNameOf(given, "array"); },
      py::arg("array"), "Name or path of an array.");
  module.def("_scenario_name", &scenarioNameOf, py::arg("scenario"), "Name or path of a scenario.");
  module.def("_friction_name", &frictionNameOf, py::arg("friction"), "Name or path of a friction.");
  module.def("read_study", &readStudy, py::arg("path"),
             "Reads the results of a study: its folder, its study.sqlite, or a shard.");
}

}  // namespace perilymph::python
