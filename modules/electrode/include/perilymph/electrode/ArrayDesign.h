#pragma once

// An electrode array as data: what its maker or its measurer published, with source and confidence.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::electrode {

/// How well a value is known.
enum class Confidence { high, medium, low };

/// Where a value comes from.
struct TableSource {
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

/// What keeps the array straight until it is drawn back: a stylet in its lumen, or a sheath.
struct Stylet {
  Length fromTip;                  ///< Where its own tip lies when it is fully in.
  BendingStiffness bending;        ///< What it adds to the array's stiffness.
  double residualCurvature = 0.0;  ///< Share of the free curvature that it leaves where it is.
  /// Advance off stylet: how deep past the opening its tip goes before it is held still.
  std::optional<Length> holdDepth;
  TableSource provenance;
};

/// The end of the carrier: a cap of its own radius, behind which the carrier widens in a straight
/// line. Round by default: the cap has half the carrier's width, and nothing tapers.
struct TipShape {
  Length radius;  ///< Radius of the cap; 0 stands for half the smallest width at the tip.
  Length taper;   ///< Length from the tip on over which the carrier reaches its own section.
};

/// The section at a place: two diameters of an ellipse.
struct Section {
  Length across;  ///< Across the plane of curl: along the turns' axis in the cochlea.
  Length within;  ///< Within the plane of curl: toward the modiolus.
};

/// An electrode array with everything the mechanics and the pictures need.
struct ArrayDesign {
  std::string name;  ///< "Nucleus 24 Contour"
  std::string maker;
  std::string note;   ///< For people: what this data is, and that it is no device labeling.
  Length length;      ///< From the tip to where the tweezers hold it.
  Length insertable;  ///< Greatest depth past the opening.
  AlongArray<Length>
      diameter;  ///< Diameter; of an oval section, the width across the plane of curl.
  AlongArray<Length> thickness;  ///< Within the plane of curl; without places: as the diameter.
  TipShape tip;
  /// Bending stiffness of the carrier without stylet, within the plane of curl.
  AlongArray<BendingStiffness> bending;
  /// The same across that plane; without places: as `bending`.
  AlongArray<BendingStiffness> bendingAcross;
  /// GJ against twisting, where it is known.
  std::optional<AlongArray<BendingStiffness>> twisting;
  AlongArray<Curvature>
      restCurvature;  ///< Curvature of the free carrier without stylet; 0: straight.
  std::vector<Length> contactsFromTip;  ///< Centers of the platinum contacts, from the tip on.
  Length contactLength;                 ///< Length of one contact along the array.
  std::vector<Length> ribsFromTip;      ///< Centers of the marker ribs.
  Length ribHeight;                     ///< Above the carrier.
  Length ribLength;                     ///< Along the array.
  bool hasStylet = false;
  Stylet stylet;
  std::vector<std::pair<std::string, TableSource>> provenance;  ///< Per table of the file.

  /// Radius of the rounded end.
  Length tipRadius() const;
  /// The section at a place, with the taper of the tip. Ribs are no part of it.
  Section sectionAt(Length place) const;
  /// True if the sections are round everywhere.
  bool isRound() const;
  /// EI of the carrier across the plane of curl.
  BendingStiffness bendingAcrossAt(Length place) const;
  /// GJ: as given, else that of an ellipse of incompressible material with the two EI.
  BendingStiffness twistingAt(Length place) const;
};

/// Reads an array from its TOML file.
Result<ArrayDesign> loadArray(const std::filesystem::path& file);

}  // namespace perilymph::electrode
