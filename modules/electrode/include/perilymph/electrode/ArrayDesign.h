// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An electrode array as data: values published by its maker or measured, with source and
// confidence.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::electrode {

/// Confidence in a value.
enum class Confidence { high, medium, low };
/// Its name in files: "high".
std::string nameOf(Confidence confidence);

/// Source of a value.
struct TableSource {
  std::string source;
  Confidence confidence = Confidence::low;
};

/// A quantity along the array, by distance from the tip: linear between knots, constant beyond the
/// last one.
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

/// What is known of a yield stress: the range that is possible. A value within it is taken by whoever
/// lets the material yield; without one it is elastic.
struct YieldStress {
  Modulus value;  ///< 0: none was taken.
  Modulus minimum, maximum;
};

/// The element that keeps the array straight until it is withdrawn: a stylet in its lumen, or a
/// sheath.
struct Stylet {
  Length fromTip;                  ///< Distance of its tip from the array's tip when fully
                                   ///< inserted.
  BendingStiffness bending;        ///< Bending stiffness that it adds to the array's.
  double residualCurvature = 0.0;  ///< Fraction of the free curvature that remains along it.
  /// Advance off-stylet: depth of the tip past the opening from which the stylet is held still.
  std::optional<Length> holdDepth;
  TableSource provenance;
  YieldStress yieldStress = {};
  Length diameter = {};  ///< As stated; 0: that of a round platinum wire of its stiffness.

  /// Moment at which it yields fully, as a round wire [N.m]; 0 if it does not.
  double yieldMoment() const;
  /// The diameter as stated, or of a platinum wire (168 GPa) with its bending stiffness.
  Length wireDiameter() const;
};

/// Wires in the carrier, stated apart from its silicone, so that they can be let yield. Their stiffness is a
/// part of the array's bending stiffness:
///
///     each for itself   B = N E I          M = N s d^3 / 6              I = pi d^4 / 64
///     as a bundle       B = c N^2 E I      M = (N / 0.9)^1.5 s d^3 / 6
///
/// with the moment M at which they yield fully. The bundle is a round one, nine tenths of it wire.
struct Wires {
  AlongArray<double> number;  ///< N at a distance from the tip.
  Length diameter;            ///< d of one wire.
  Modulus modulus;            ///< E
  double coupling = 0.0;      ///< c: 0, they slide freely; about 1, they are packed.
  YieldStress yieldStress;    ///< s

  /// A stiffness of the wires and the moment at which it yields.
  struct Branch {
    BendingStiffness bending;
    double moment = 0.0;  ///< [N.m]
  };
  Branch singleAt(Length place) const;
  Branch bundleAt(Length place) const;
};

/// What is possible between tip and base of an array of which no drawing was read: the width of its section
/// at the most basal contact, and of what the section is made, because its stiffness changes with it.
struct TaperRange {
  Length thinnest, thickest;
  Modulus carrier;  ///< Young's modulus of the silicone.
};

/// Shape of the array's end: a cap of its own radius, behind which the carrier widens linearly. By
/// default the cap has half the carrier's width and there is no taper.
struct TipShape {
  Length radius;  ///< Radius of the cap; 0: half the smallest width at the tip.
  Length taper;   ///< Distance from the tip at which the carrier reaches its full section.
};

/// An elliptic cross-section: two diameters.
struct Section {
  Length across;  ///< Across the plane of curl: along the modiolar axis in the cochlea.
  Length within;  ///< Within the plane of curl: toward the modiolus.
};

/// The platinum of a contact.
enum class Plates {
  single,  ///< One plate, on the side of the carrier that faces the modiolus.
  pair,    ///< Two plates on opposite sides, across the plane of curl.
  band     ///< A ring around the carrier.
};
/// Their names in files.
inline constexpr std::array platesTable{Choice<Plates>{Plates::single, "single"},
                                        Choice<Plates>{Plates::pair, "pair"},
                                        Choice<Plates>{Plates::band, "band"}};

/// The end of the array from which its maker's fitting software numbers the electrodes, from 1.
enum class MakerNumbering { fromTip, fromBase };
/// Their names in files.
inline constexpr std::array makerNumberings{
    Choice<MakerNumbering>{MakerNumbering::fromTip, "from_tip"},
    Choice<MakerNumbering>{MakerNumbering::fromBase, "from_base"}};

/// An electrode array with all data that mechanics and visualization need.
struct ArrayDesign {
  std::string name;  ///< "Nucleus 24 Contour"
  std::string maker;
  std::string note;   ///< For the user: origin of the data; not device labeling.
  Length length;      ///< From the tip to the grip of the tweezers.
  Length insertable;  ///< Maximum depth past the opening.
  AlongArray<Length>
      diameter;  ///< Diameter; of an oval section, the width across the plane of curl.
  AlongArray<Length> thickness;  ///< Within the plane of curl; without knots: equal to the
                                 ///< diameter.
  TipShape tip;
  std::optional<TaperRange> taper;  ///< If it is stated.
  /// Bending stiffness of the carrier without stylet, within the plane of curl.
  AlongArray<BendingStiffness> bending;
  /// Bending stiffness across the plane of curl; without knots: equal to `bending`.
  AlongArray<BendingStiffness> bendingAcross;
  /// Torsional stiffness GJ, where known.
  std::optional<AlongArray<BendingStiffness>> twisting;
  AlongArray<Curvature>
      restCurvature;  ///< Curvature of the free carrier without stylet; 0: straight.
  std::vector<Length> contactsFromTip;  ///< Distance of the platinum contacts' centers from the
                                        ///< tip.
  Length contactLength;                 ///< Length of one contact along the array.
  /// What the contacts are, the most apical ones excepted that `singlePlates` counts.
  Plates plates = Plates::single;
  int singlePlates =
      0;  ///< Contacts from the tip with a single plate, of an array with pairs or bands.
  std::optional<MakerNumbering> makerNumbering;  ///< Absent: not known.
  std::vector<Length> ribsFromTip;  ///< Distance of the marker ribs' centers from the tip.
  Length ribHeight;                 ///< Above the carrier.
  Length ribLength;                 ///< Along the array.
  std::optional<Wires> wires;       ///< If they are stated.
  bool hasStylet = false;
  Stylet stylet;

  bool wiresYield() const { return wires && wires->yieldStress.value.si() > 0.0; }
  bool styletYields() const { return hasStylet && stylet.yieldStress.value.si() > 0.0; }
  bool yields() const { return wiresYield() || styletYields(); }
  std::vector<std::pair<std::string, TableSource>> provenance;  ///< For each table of the file.

  /// The platinum of a contact, counted from 0 at the tip.
  Plates platesOf(std::size_t contact) const
  {
    return contact < static_cast<std::size_t>(singlePlates) ? Plates::single : plates;
  }
  /// The maker's number of a contact that is counted from 1 at the tip, if the numbering is known.
  std::optional<int> makerElectrode(int contact) const
  {
    if (!makerNumbering) return std::nullopt;
    return *makerNumbering == MakerNumbering::fromTip
               ? contact
               : static_cast<int>(contactsFromTip.size()) + 1 - contact;
  }
  /// Radius of the tip cap.
  Length tipRadius() const;
  /// The section at a distance from the tip, including the taper but not the ribs.
  Section sectionAt(Length place) const;
  /// True if all sections are round.
  bool isRound() const;
  /// EI of the carrier across the plane of curl.
  BendingStiffness bendingAcrossAt(Length place) const;
  /// GJ: as given, else that of an ellipse of incompressible material with the two EI.
  BendingStiffness twistingAt(Length place) const;
};

/// The array with another taper within the range that it states, the same if it states none: its section
/// widens in a straight line from the tip to the most basal contact, and from there to the next knot as in
/// the file. The ratio of thickness to width at that contact is kept; the bending stiffness changes by that of the silicone,
/// E pi (w t^3 - w' t'^3) / 64 within the plane of curl, width w and thickness t.
///
/// @param fraction  0: the thinnest, 1: the thickest.
ArrayDesign withTaper(ArrayDesign array, double fraction);

/// Reads an array from its TOML file.
Result<ArrayDesign> loadArray(const std::filesystem::path& file);

}  // namespace perilymph::electrode
