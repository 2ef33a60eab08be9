// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The available arrays and frictions, with descriptions.

#include <QString>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"

namespace perilymph::gui {

/// One array of the catalog.
struct CatalogArray {
  QString name;   ///< Name in scenarios.
  QString title;  ///< "FLEX28"
  QString maker;
  QString summary;  ///< "28.0 mm · straight · 12 contacts"
  QString note;
};

/// All shipped and added arrays, by maker, shorter ones first. Unreadable files are omitted.
std::vector<CatalogArray> catalogArrays();

/// "22.0 mm · precurved · 22 contacts": maximum depth, shape, number of contacts.
QString summaryOf(const electrode::ArrayDesign& array);

/// One friction of the catalog.
struct CatalogFriction {
  QString name;    ///< Name in scenarios.
  QString title;   ///< "Soap 10 %: speed-independent"
  QString source;  ///< Source of its coefficients.
};

std::vector<CatalogFriction> catalogFrictions();

}  // namespace perilymph::gui
