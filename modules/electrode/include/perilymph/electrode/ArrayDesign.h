#pragma once

// An electrode array as data: what its maker or its measurer published, with source and confidence.

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::electrode {

/// How well a value is known.
enum class Confidence { high, medium, low };

/// Where a value comes from.
struct Provenance {
  std::string source;
  Confidence confidence = Confidence::low;
};

/// A value at a place along the array, counted from the tip. Between places: straight lines; beyond
/// the last one: the last value.
template <class Value>
struct AlongArray {
  std::vector<Length> fromTip;
  std::vector<Value> value;

  Value at(Length place) const
  {
    if (place <= fromTip.front()) return value.front();
    for (std::size_t i = 1; i < fromTip.size(); ++i)
      if (place <= fromTip[i])
        return value[i - 1] + ((place - fromTip[i - 1]) / (fromTip[i] - fromTip[i - 1])) *
                                  (value[i] - value[i - 1]);
    return value.back();
  }
};

/// A stylet in the lumen of the array.
struct Stylet {
  Length fromTip;                  ///< Where its own tip lies when it is fully in.
  BendingStiffness bending;        ///< What it adds to the array's stiffness.
  double residualCurvature = 0.0;  ///< Share of the free curvature that it leaves where it is.
  Provenance provenance;
};

/// An electrode array with everything the mechanics and the pictures need.
struct ArrayDesign {
  std::string name;  ///< "Nucleus 24 Contour"
  std::string maker;
  std::string note;   ///< For people: what this data is, and that it is no device labeling.
  Length length;      ///< From the tip to where the tweezers hold it.
  Length insertable;  ///< Greatest depth past the opening.
  AlongArray<Length> diameter;
  AlongArray<BendingStiffness> bending;  ///< Of the carrier without stylet.
  AlongArray<Curvature> restCurvature;   ///< Of the free carrier without stylet; 0 where straight.
  std::vector<Length> contactsFromTip;   ///< Centers of the platinum contacts, from the tip on.
  Length contactLength;                  ///< Of one contact along the array.
  std::vector<Length> ribsFromTip;       ///< Marker ribs.
  bool hasStylet = false;
  Stylet stylet;
  std::vector<std::pair<std::string, Provenance>> provenance;  ///< Per table of the file.
};

/// Reads an array from its TOML file.
Result<ArrayDesign> loadArray(const std::filesystem::path& file);

}  // namespace perilymph::electrode
