#pragma once

// What can be chosen: the arrays of all makers and the frictions, with what people should know.

#include <QString>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"

namespace perilymph::gui {

/// One array of the catalog.
struct CatalogArray {
  QString name;   ///< As scenarios name it.
  QString title;  ///< "FLEX28"
  QString maker;
  QString summary;  ///< "28.0 mm · straight · 12 contacts"
  QString note;
};

/// All arrays that ship or were added, by maker, shorter ones first. Files that cannot be read are
/// left out.
std::vector<CatalogArray> catalogArrays();

/// "22.0 mm · precurved · 22 contacts": how deep it may go, what it is, what it carries.
QString summaryOf(const electrode::ArrayDesign& array);

/// One friction of the catalog.
struct CatalogFriction {
  QString name;    ///< As scenarios name it.
  QString title;   ///< "Soap solution of 10 %: alike at every speed"
  QString source;  ///< Source of its coefficients.
};

std::vector<CatalogFriction> catalogFrictions();

}  // namespace perilymph::gui
