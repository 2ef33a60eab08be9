// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A .zip as hospitals and portals send an examination.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Whether a file begins as a .zip does.
bool isZip(const std::filesystem::path& file);

/// The files of a .zip in a folder that only this user can read, and that is removed with the object. The folder of a
/// program that was killed is removed when the next archive is unpacked: no process holds its lock any more.
class UnpackedZip {
public:
  /// Unpacks in a child process. Folders and names within the archive are not used: each file gets a number and what
  /// is plain of its own name. An archive in the archive stays packed.
  ///
  /// Refuses an archive that is damaged, encrypted, of more than `maxFiles` files or of more than 4 GB, one that was
  /// packed more than a hundredfold, and a full disk.
  static Result<std::shared_ptr<const UnpackedZip>> unpack(const std::filesystem::path& zip,
                                                           std::size_t maxFiles,
                                                           const std::function<bool()>& isCanceled);

  explicit UnpackedZip(std::filesystem::path folder);
  ~UnpackedZip();
  UnpackedZip(const UnpackedZip&) = delete;
  UnpackedZip& operator=(const UnpackedZip&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

private:
  std::filesystem::path folder_;
  int lock_ = -1;  ///< Descriptor of the folder, locked.
};

}  // namespace perilymph::imaging
