// SPDX-License-Identifier: BSD-3-Clause
#include "patient/PatientKeys.h"

namespace perilymph::anatomy {

const FieldMeanings& patientKeyTable()
{
  static const FieldMeanings keys = {
      {"label", "", "Code of the patient, no name; by default the name of the file."},
      {"side", "", "Ear; a left one is mirrored."},
      {"a_mm", "mm",
       "Diameter A of the basal turn, from the round window through the modiolus; with b_mm in "
       "place of the three lengths below."},
      {"b_mm", "mm", "Width B of the basal turn, across A."},
      {"h_mm", "mm", "Height H of the cochlea."},
      {"a_sd_mm", "mm", "Standard deviation of the error of A; with b_sd_mm."},
      {"b_sd_mm", "mm", "Standard deviation of the error of B."},
      {"h_sd_mm", "mm", "Standard deviation of the error of H."},
      {"ab_correlation", "", "Correlation of the errors of A and B."},
      {"ah_correlation", "", "Correlation of the errors of A and H."},
      {"bh_correlation", "", "Correlation of the errors of B and H."},
      {"measured_with", "", "Program and version that measured A, B and H in a CT."},
      {"series_sha256", "", "SHA-256 of the CT series."},
      {"landmarks_by_hand", "", "Landmarks that a person placed."},
      {"landmarks_proposed", "", "Landmarks that the program placed."},
      {"st_length_mm", "mm", "Length of the scala tympani along the organ of Corti."},
      {"rw_width_mm", "mm", "Width of its section at the round window."},
      {"rw_height_mm", "mm", "Height of its section at the round window."},
      {"content_sha256", "",
       "Seal over all these values, written by the program. Values that were changed after it are "
       "read and named as changed by hand."}};
  return keys;
}

}  // namespace perilymph::anatomy
