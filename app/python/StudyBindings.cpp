// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

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
    columns[textOf(key)] = arrayOf(texts);
  }
  return columns;
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
      .def("__len__", &StudyColumns::size)
      .def("__repr__", [](const StudyColumns& one) {
        return textOf("<perilymph.Study '" + one.facts().title +
                      "': " + std::to_string(one.size()) + " insertions>");
      });
  module.def("read_study", &readStudy, py::arg("path"),
             "Reads the results of a study: its folder, its study.sqlite, or a shard.");
}

}  // namespace perilymph::python
