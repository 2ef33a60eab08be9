// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayKeys.h"

namespace perilymph::electrode {

const FieldMeanings& arrayKeyTable()
{
  static const FieldMeanings keys = {
      {"name", "", "Name for display."},
      {"maker", "", "Manufacturer."},
      {"note", "", "What the description rests on."},
      {"length.value_mm", "mm", "Length from the tip to where the tweezers hold."},
      {"insertable.value_mm", "mm", "Greatest insertion depth."},
      {"diameter.from_tip_mm", "mm", "Places of the widths, ascending from the tip."},
      {"diameter.diameter_mm", "mm", "Width of the carrier at each place."},
      {"diameter.thickness_mm", "mm", "Thickness at each place; without it the section is round."},
      {"tip.radius_mm", "mm", "Radius of the rounded tip."},
      {"tip.taper_mm", "mm", "Length over which the tip widens to the section."},
      {"bending.from_tip_mm", "mm", "Places of the stiffnesses, ascending from the tip."},
      {"bending.bending_N_m2", "N m2",
       "Bending stiffness of carrier and wires in the plane of the contacts, without stylet."},
      {"bending.bending_across_N_m2", "N m2", "The same across that plane; by default equal."},
      {"bending.twisting_N_m2", "N m2",
       "Torsional stiffness; by default from the bending stiffness."},
      {"rest_curvature.from_tip_mm", "mm", "Places of the curvatures, ascending from the tip."},
      {"rest_curvature.curvature_per_mm", "1/mm",
       "Curvature of the free carrier; positive curls toward the modiolus. Without the table the "
       "array is straight."},
      {"contacts.from_tip_mm", "mm", "Centers of the contacts, ascending from the tip."},
      {"contacts.contact_length_mm", "mm", "Length of a contact."},
      {"contacts.plates", "", "Platinum of a contact: single, pair or band; by default single."},
      {"contacts.single_plates", "",
       "Number of contacts from the tip with a single plate, in an array of pairs or bands."},
      {"contacts.maker_numbering", "",
       "End from which the maker's fitting software numbers the electrodes: from_tip or from_base; "
       "absent if not known."},
      {"taper.last_contact_mm", "mm",
       "Smallest and largest width that is possible at the most basal contact."},
      {"taper.carrier_MPa", "MPa",
       "Modulus of the silicone by which the taper changes the stiffness."},
      {"ribs.from_tip_mm", "mm", "Middles of the marker ribs, ascending from the tip."},
      {"ribs.height_mm", "mm", "Height of a rib above the carrier."},
      {"ribs.length_mm", "mm", "Length of a rib along the carrier."},
      {"wires.from_tip_mm", "mm", "Places of the numbers of wires, ascending from the tip."},
      {"wires.number", "", "Number of wires at each place."},
      {"wires.diameter_um", "um", "Diameter of a wire."},
      {"wires.modulus_GPa", "GPa", "Young's modulus of the wires."},
      {"wires.coupling", "",
       "How tightly they are packed: 0 if they slide freely, 1.2 if they are one solid rod."},
      {"wires.yield_range_MPa", "MPa", "Smallest and largest possible yield stress."},
      {"wires.yield_MPa", "MPa", "Yield stress within that range; without it they are elastic."},
      {"stylet.from_tip_mm", "mm", "Distance of the stylet's end from the tip."},
      {"stylet.bending_N_m2", "N m2", "Bending stiffness of the stylet."},
      {"stylet.residual_curvature_fraction", "",
       "Fraction of its rest curvature that the carrier keeps on the stylet."},
      {"stylet.hold_depth_mm", "mm",
       "Insertion depth at which the stylet is held still in the technique advance off-stylet."},
      {"stylet.diameter_mm", "mm", "Diameter of the stylet; by default that of its stiffness."},
      {"stylet.yield_range_MPa", "MPa", "Smallest and largest possible yield stress."},
      {"stylet.yield_MPa", "MPa",
       "Yield stress within that range; without it the stylet is elastic."}};
  return keys;
}

}  // namespace perilymph::electrode
