// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The rows of a query, as DCMTK's items.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstddef>
#include <functional>
#include <string>

#include "perilymph/archive/Exchange.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// Sends a query and gives each row to `take`, converted to UTF-8. @return Whether the server had more
/// than `maxRows`, at which the query is canceled.
Result<bool> queryRows(const Server& server, DcmDataset& keys, std::size_t maxRows,
                       const Exchange& exchange, const std::function<void(DcmItem&)>& take);

/// A text of an item without padding, valid UTF-8; empty if absent.
std::string textIn(DcmItem& item, const DcmTagKey& tag);

/// Success for a UID of PS3.5: digits and dots, at most 64. The error calls it `what`.
Result<void> checkUid(const std::string& uid, const Sentence& what);

/// A query of a level below the study: "SERIES" or "IMAGE".
void setLevel(DcmDataset& keys, const char* level, const std::string& studyUid);

}  // namespace perilymph::archive
