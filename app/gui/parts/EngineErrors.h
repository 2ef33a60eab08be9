// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Why a CT could not be read or measured, or a port not be listened at, which the engine says in
// English.

#include <QString>
#include <string>

namespace perilymph::gui {

/// Message of an error of the modules ct, imaging and broadcast, and of files with results, in the window's language; the name
/// of a file before it is kept. Unknown messages are returned unchanged.
QString engineError(const std::string& message);

/// A warning of a reader (imaging::CtSeries::warnings) in the window's language.
QString seriesWarning(const std::string& warning);

}  // namespace perilymph::gui
