// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "perilymph/archive/Exchange.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// What became of an object that was sent.
struct SentObject {
  std::string studyUid, seriesUid, instanceUid;
  std::string seriesNumber;  ///< The first number that no series of the study has.
  Sentence warning;          ///< What the server changed or left out; empty if nothing.
};

/// Stores an object that this program wrote (a report, a segmentation or a key image) in the study whose data it was made
/// of (C-STORE).
///
/// The server must have the study that the file states, under the patient number and birth date that
/// the file states; any other study is refused. The file is not changed.
///
/// @return  Refuses a file that is no DICOM object of this program. The error of a cancellation while the
///          object is under way says that the server may have it.
Result<SentObject> sendObject(const Server& server, const std::filesystem::path& file,
                              const Exchange& exchange = {});

}  // namespace perilymph::archive
