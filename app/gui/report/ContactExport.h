// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The table of contacts as files, for whoever programs the sound processor.

#include <filesystem>
#include <optional>
#include <string>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

class QWidget;

namespace perilymph::gui {

/// Writes a table and, beside it, "<name>-dictionary.csv", which states what its columns are.
Result<void> writeContactTable(const std::filesystem::path& file, const std::string& csv);

/// Whose contacts a table has.
struct ContactSubject {
  bool isPlanned = false;  ///< From the simulations of a plan, else from one insertion.
  anatomy::Patient patient;
  std::string array;
  std::string utc;  ///< When the plan was made, or the insertion began: "2026-11-20T09:30:00Z".
};

/// "P-017-left-flex28-planned-contacts-2026-11-20", with the local date; of an insertion "inserted".
std::string contactFileStem(const ContactSubject& subject);

/// Lets the user choose a file in the folder of documents. Empty if the user cancels.
///
/// @param subject  For the proposed name.
std::optional<std::filesystem::path> chooseContactFile(QWidget* parent,
                                                       const ContactSubject& subject);

}  // namespace perilymph::gui
