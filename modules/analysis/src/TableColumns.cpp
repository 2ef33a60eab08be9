// SPDX-License-Identifier: BSD-3-Clause
#include "TableColumns.h"

namespace perilymph::analysis {

const FieldMeanings& comparisonColumns()
{
  static const FieldMeanings columns = {
      {"name", "", "name of the recording as shown, with a number if two were equal"},
      {"scenario", "", "name of the scenario"},
      {"peak_N", "N", "peak insertion force: largest axial force on the hand"},
      {"peak_travel_mm", "mm", "travel at the peak"},
      {"peak_depth_mm", "mm", "insertion depth at the peak"},
      {"work_mJ", "mJ", "work of the hand on the array"},
      {"reversals", "", "withdrawals of 0.1 mm or more"},
      {"duration_s", "s", "insertion time: from the first to the last motion, pauses included"},
      {"final_depth_mm", "mm", "length of the array past the opening at the end"},
      {"final_angle_deg", "deg", "tip angle at the end"},
      {"rupture_angle_deg", "deg", "where the partition ruptured; empty if it held"},
      {"rupture_N", "N", "force on the partition at its rupture"},
      {"above_mm", "mm", "largest length of the array in the scala vestibuli"},
      {"array", "", "name of the array"},
      {"technique", "", "'standard' or 'aos', advance off-stylet"},
      {"patient", "", "code of the patient, or the anatomy"},
      {"side", "", "'left' or 'right' ear"},
      {"array_peak_N", "N", "peak with no marker rib at the opening"},
      {"array_peak_depth_mm", "mm", "insertion depth at that peak"},
      {"rib_peak_N", "N", "peak with a marker rib at the opening; empty if none came there"},
      {"rib_peak_depth_mm", "mm", "insertion depth at that peak"},
      {"end_N", "N", "force where the insertion ends: line through the last 0.5 s of motion"},
      {"deepest_angle_deg", "deg", "largest tip angle"},
      {"score", "", "technique score of 100; empty if it cannot be computed"},
      {"score_definition", "", "version of the definition of the score"},
      {"mean_speed_mm_s", "mm/s",
       "inward motion up to the maximum depth by its time, pauses included"},
      {"recording", "", "file of the recording"},
      {"friction", "", "name of the friction; 'own' if its values are in no file"},
      {"friction_coefficient", "", "static coefficient, or the range over speeds"},
      {"speed_set_mm_s", "mm/s", "speed of the script; empty of an insertion by hand"},
      {"opening", "", "'none' (wide), 'round-window' or 'cochleostomy'"},
      {"approach_tilt_deg", "deg", "approach from the axis of the opening, tilt"},
      {"approach_turn_deg", "deg", "approach from the axis of the opening, rotation"},
      {"seed", "", "random seed of the scenario"},
      {"stop_travel_mm", "mm", "travel at which the insertion stops; 0 if not known"},
      {"stop_force_N", "N", "force at which the hand stops; 0 without a limit"},
      {"end", "", "how the insertion ended: 'finished', 'stopped_by_resistance', 'buckled', ..."}};
  return columns;
}

const FieldMeanings& curveColumns()
{
  static const FieldMeanings columns = {
      {"travel_mm", "mm", "Travel; or the axis that is chosen, one of the two below."},
      {"depth_mm", "mm", "Insertion depth of the tip."},
      {"angle_deg", "deg", "Tip angle."},
      {"<name>_N", "N",
       "Axial force of the recording with this name; empty where it has no point."}};
  return columns;
}

const FieldMeanings& eventColumns()
{
  static const FieldMeanings columns = {
      {"name", "", "Name of the recording."},
      {"event", "",
       "first_resistance, rib_at_opening, stylet_withdrawal, rupture, translocation, peak, an "
       "ending, end or withdrawal."},
      {"rib", "", "Number of the marker rib from the tip; else empty."},
      {"time_s", "s", "Time since the first motion."},
      {"travel_mm", "mm", "Travel."},
      {"depth_mm", "mm", "Insertion depth."},
      {"angle_deg", "deg", "Tip angle."},
      {"force_N", "N", "Axial force on the hand."}};
  return columns;
}

const FieldMeanings& groupColumns()
{
  static const FieldMeanings columns = {
      {"group", "", "Value by which recordings are grouped."},
      {"quantity", "", "Quantity, a column of comparison.csv in its unit."},
      {"n", "", "Number of recordings that have it."},
      {"mean", "of the quantity", "Mean."},
      {"sd", "of the quantity", "Standard deviation; empty for fewer than two."},
      {"low95", "of the quantity", "Lower limit of the 95 % interval of the mean (Student)."},
      {"high95", "of the quantity", "Upper limit."}};
  return columns;
}

const FieldMeanings& differenceColumns()
{
  static const FieldMeanings columns = {
      {"group", "", "First group."},
      {"other", "", "Second group."},
      {"quantity", "", "Quantity, a column of comparison.csv in its unit."},
      {"n", "", "Number of recordings of the first group that have it."},
      {"n_other", "", "The same of the second group."},
      {"difference", "of the quantity", "Mean of the first group less that of the second."},
      {"low95", "of the quantity", "Lower limit of its 95 % interval (Welch)."},
      {"high95", "of the quantity", "Upper limit."},
      {"degrees_of_freedom", "", "Degrees of freedom of that interval."}};
  return columns;
}

const FieldMeanings& sectionMeanings()
{
  static const FieldMeanings columns = {
      {"angle_deg", "deg", "Angle of the section from the round window."},
      {"center_r_mm", "mm", "Distance of the center from the modiolar axis."},
      {"center_z_mm", "mm", "Height of the center along that axis."},
      {"inner_r_mm", "mm", "Distance of the inner wall (modiolus) from the axis."},
      {"outer_r_mm", "mm", "Distance of the lateral wall from the axis."},
      {"width_mm", "mm", "Width between these walls."},
      {"floor_z_mm", "mm", "Height of the lower end of the section."},
      {"roof_z_mm", "mm", "Height of the upper end, at the cochlear partition."},
      {"height_mm", "mm", "Height between these ends."},
      {"area_mm2", "mm2", "Area of the section."},
      {"outer_wall_length_mm", "mm", "Length along the lateral wall from the round window."},
      {"center_length_mm", "mm", "Length along the centers from the round window."},
      {"inner_wall_length_mm", "mm", "Length along the inner wall from the round window."},
      {"organ_of_corti_mm", "mm", "Length along the organ of Corti from the round window."},
      {"greenwood_Hz", "Hz", "Frequency of the place on the organ of Corti (Greenwood 1990)."},
      {"spiral_ganglion_Hz", "Hz",
       "Frequency of the spiral ganglion at the angle (Stakhovskaya et al. 2007)."}};
  return columns;
}

}  // namespace perilymph::analysis
