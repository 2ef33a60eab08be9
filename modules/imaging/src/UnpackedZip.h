// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A .zip as hospitals and portals send an examination.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <stop_token>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::imaging {

/// Whether a file begins as a .zip does.
bool isZip(const std::filesystem::path& file);

/// The files of a .zip in a folder that only this user can read, and that is removed with the object. The folder of a
/// program that was killed is removed when the next archive is unpacked.
class UnpackedZip {
public:
  /// Unpacks in a child process. Folders and names within the archive are not used: each file gets a number and what
  /// is plain of its own name. An archive in the archive stays packed.
  ///
  /// Refuses an archive that is damaged, encrypted, of more than `maxFiles` files or of more than 4 GB, one that was
  /// packed more than a hundredfold, and a full disk.
  static Result<std::shared_ptr<const UnpackedZip>> unpack(const std::filesystem::path& zip,
                                                           std::size_t maxFiles,
                                                           const std::stop_token& stop);

  explicit UnpackedZip(UnfinishedFolder folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_.path(); }

private:
  UnfinishedFolder folder_;
};

}  // namespace perilymph::imaging
