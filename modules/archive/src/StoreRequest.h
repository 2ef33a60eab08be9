// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Objects that a server stores here, during a get or a move.

#include <vector>

#include "Association.h"
#include "ReceivedSeries.h"

namespace perilymph::archive {

/// The kinds of objects that are received: images of a temporal bone, and documents.
const std::vector<const char*>& imageClasses();
const std::vector<const char*>& documentClasses();
/// Transfer syntaxes of compressed images.
const std::vector<const char*>& compressedSyntaxes();

/// Receives the object of a C-STORE request into the series' folder, and answers it. What does not
/// belong to the series is refused and deleted, and ReceivedSeries::obstacle() says why.
OFCondition receiveObject(T_ASC_Association* association, T_ASC_PresentationContextID context,
                          T_DIMSE_C_StoreRQ& request, ReceivedSeries& series, int seconds);

}  // namespace perilymph::archive
