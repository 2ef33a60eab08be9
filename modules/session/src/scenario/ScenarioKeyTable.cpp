// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioKeyTable.h"

namespace perilymph::session {

const FieldMeanings& scenarioKeyTable()
{
  static const FieldMeanings keys = {
      {"title", "", "Name for lists and reports."},
      {"patient", "", "Patient: a shipped name or a TOML file."},
      {"patient_numbers", "",
       "Table of the patient's values in a recorded scenario; read in place of the file."},
      {"side", "", "Ear; the other one is mirrored."},
      {"anatomy", "", "Source of the cochlea; by default the one that the patient's values build."},
      {"lead_in_mm", "mm", "Straight stretch between the opening and the spiral."},
      {"array", "", "Electrode array: a shipped name or a TOML file."},
      {"array_fingerprint", "",
       "Hash of the array's file in a recorded scenario; another file is reported."},
      {"calibration", "", "Calibration of the array's stiffness: a shipped name or a TOML file."},
      {"stiffness_scale", "", "Factor of all stiffnesses of the array."},
      {"residual_curvature_fraction", "",
       "Fraction of its rest curvature that the array keeps on the stylet."},
      {"wire_packing", "",
       "How tightly the wires of a straight array are packed: 0 if they slide freely, 1.2 if they "
       "are one solid rod; by default as in its file."},
      {"taper_fraction", "",
       "Width of the array at its most basal contact, from the smallest (0) to the largest (1) of "
       "its file."},
      {"wire_yield_MPa", "MPa", "Yield stress of the wires; without the key they are elastic."},
      {"stylet_yield_MPa", "MPa", "Yield stress of the stylet; without the key it is elastic."},
      {"relaxation_fraction", "",
       "Fractions of the bending stiffness that relax, one per term, at most two."},
      {"relaxation_time_s", "s", "Time constant of each of these terms."},
      {"technique", "", "What happens to the stylet."},
      {"speed_mm_s", "mm/s", "Speed of an automatic insertion."},
      {"start_inside_mm", "mm", "Insertion depth of the tip at the start."},
      {"stop_travel_mm", "mm", "Travel from the start at which the insertion is complete."},
      {"withdraw", "", "Withdraw the array after the stop travel."},
      {"stylet_pull_mm_s", "mm/s", "Speed at which the stylet is pulled out."},
      {"approach_tilt_deg", "deg", "Direction of the array at the opening, up from its axis."},
      {"approach_turn_deg", "deg", "The same, sideways."},
      {"free_length_mm", "mm",
       "Length between opening and forceps; without the key a clamp holds the end of the array."},
      {"friction", "", "Coefficients of friction: a shipped name or a TOML file."},
      {"friction_static", "", "Coefficient at rest; not below friction_dynamic."},
      {"friction_dynamic", "", "Coefficient in motion, in place of a table by speed."},
      {"friction_stopping", "",
       "Ratio of tangential to normal force below which sliding stops; not above "
       "friction_dynamic."},
      {"friction_stribeck_mm_s", "mm/s", "Speed over which the coefficient at rest fades."},
      {"friction_speed_mm_s", "mm/s", "Speeds of a table by speed, ascending."},
      {"friction_coefficient", "", "Coefficient in motion at each of these speeds."},
      {"friction_shared_sd_log", "",
       "Standard deviation of the logarithm of what all ears share; plans draw it."},
      {"friction_ear_sd_log", "", "The same between ears."},
      {"film_relaxation_fraction", "", "Fraction of the friction that fades at rest."},
      {"film_relaxation_time_s", "s", "Time constant in which it fades."},
      {"opening", "", "Opening into the scala tympani."},
      {"cochleostomy_diameter_mm", "mm", "Diameter of a cochleostomy."},
      {"opening_outward_mm", "mm",
       "Position of the opening beside the axis of the scala, outward."},
      {"opening_vertical_mm", "mm", "The same, up."},
      {"passage_mm", "mm",
       "Length of a cochleostomy through the bone; not above lead_in_mm; 0 for an edge."},
      {"passage_modulus_MPa", "MPa", "Modulus by which ribs yield in the passage."},
      {"passage_friction", "",
       "Coefficient of friction in the passage; by default that of the wall."},
      {"rib_exit_loss", "",
       "Fraction of a marker rib's elastic energy that is lost where it leaves a passage."},
      {"rim_stiffness_N_m", "N/m",
       "Stiffness of the rim of the opening, under each sample point; by default that of the wall "
       "where wall_stiffness_N_m is given."},
      {"wall_stiffness_N_m", "N/m",
       "Stiffness of the wall under each sample point; 441 in the published cochlea, else that of "
       "bone."},
      {"wall_lining_mm", "mm", "Depth of the soft lining over which the wall stiffens."},
      {"wall_tangential_stiffness_N_m", "N/m", "Stiffness of a sticking contact along the wall."},
      {"wall_section_delay_ms", "ms",
       "Time in which the reach of an oval section of the array follows the wall."},
      {"wall_edge_mm", "mm", "Depth behind the opening over which the wall stiffens."},
      {"membrane", "", "Roof of the scala tympani: bone or a basilar membrane."},
      {"membrane_stiffness_N_m", "N/m", "Stiffness of a soft membrane under each sample point."},
      {"partition_strength_N", "N",
       "Force within one contact at which the cochlear partition ruptures; without the key it "
       "holds."},
      {"coupling", "", "How the hand holds the array: as it moves or by a spring."},
      {"coupling_stiffness_N_m", "N/m", "Stiffness of the spring."},
      {"coupling_damping_N_s_m", "N s/m", "Damping of the spring."},
      {"force_scale", "", "Factor of the force that the device renders."},
      {"stop_force_N", "N",
       "Axial force at which the surgeon stops; 0: only above 2 N, where the array is jammed."},
      {"model", "", "Elastic rod, or the published model of points."},
      {"nodes", "", "Nodes of the rod; of the published model 2 to 18 points."},
      {"dt_ms", "ms", "Time step."},
      {"seed", "",
       "Number of the random sequence with which validate varies insertions; recorded, and without "
       "effect on one "
       "insertion."},
  };
  return keys;
}

}  // namespace perilymph::session
