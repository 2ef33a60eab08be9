// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace perilymph::study {

/// The views of a study's file: `CREATE VIEW` statements, one per question.
std::vector<std::string> studyViews();
/// Those of version 3 of the file that are others now.
std::vector<std::string> formerStudyViews();

/// The same of files that earlier versions wrote, where they differ.
std::vector<std::string> formerStudyViews();

}  // namespace perilymph::study
