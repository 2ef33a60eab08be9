// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "perilymph/archive/Exchange.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// Tests whether a server answers (C-ECHO). The error states what failed: name resolution, the
/// connection, TLS, an AE title that is not known, a refusal, or the time.
Result<void> echo(const Server& server, const Exchange& exchange = {});

}  // namespace perilymph::archive
