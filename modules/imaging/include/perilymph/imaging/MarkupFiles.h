// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Distances, angles, notes and structures of a CT as files of other programs: markups of 3D Slicer, JSON and CSV,
// in LPS [mm].

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/ct/Markups.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// The text of a markups file of 3D Slicer (.mrk.json): lines, angles, and points of notes and structures, curves where
/// a structure has several. Values are its measurements. Without points it has no lists.
std::string slicerMarkups(const ct::CtMarkups& markups);

/// The markups as JSON, with values, standard deviations and 95 % intervals: resources/schemas/ct-markups.schema.json.
std::string markupsJson(const ct::CtMarkups& markups);

/// A row for each point, with the value of its markup; columns as markupsDictionaryCsv() states.
std::string markupsCsv(const ct::CtMarkups& markups);
/// `column, unit, meaning`: a row for each column of the table, in their order.
std::string markupsDictionaryCsv();

/// Reads the lines, angles, points and curves of a markups file in LPS or RAS. Points named `facial_nerve`,
/// `chorda_tympani` and `canal_wall`, with a number behind it or not, are structures, those with names of landmarks
/// are left out, and others are notes. Refuses a file without any of them, a line or an angle with another number of
/// points, what ct::checkMarkup() refuses, and points that this program placed in another series.
///
/// @param seriesKey  SHA-256 of the series in which they are used.
Result<std::vector<ct::Markup>> readMarkups(const std::filesystem::path& file,
                                            const std::string& seriesKey);

}  // namespace perilymph::imaging
