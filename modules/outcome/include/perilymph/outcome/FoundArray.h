// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The implanted array found in a CT after surgery: every contact with its error, the depth, what is doubtful.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::outcome {

/// What is doubtful about a found array. Each has a name and a sentence.
enum class Flag {
  secondAssignment,  ///< Another assignment of the contacts explains the metal nearly as well.
  missingContacts,   ///< Contacts of the array were not seen.
  extraMetal,        ///< Metal beside the array: more contacts than the array has, or an old lead.
  arrayDoesNotFit,  ///< Spacing, number or place of contacts contradict the array named or the ear.
  notSeenSingly,    ///< The contacts merge at this resolution: placed by the array's spacings.
  fold,             ///< The angle turns back: a tip fold-over.
  kink,             ///< The curve bends more sharply than the array can without damage.
  possibleTranslocation,  ///< A part of the array lies above the basilar membrane, as far as both fits tell.
  contactsOutside,   ///< Contacts lie outside the cochlea.
  registrationPoor,  ///< Both CTs agree badly around the cochlea.
  earFitPoor,        ///< The cochlea itself was fitted badly, as beside metal.
  earFromThisCt,     ///< The ear was measured beside the metal, with wider errors.
  anotherEar,        ///< A, B or the side differ from the patient's by more than their errors.
  clipped,           ///< A part of the array is outside the volume.
  coarseVoxels,      ///< Voxels beyond those that were tested.
};
/// Name of a flag as in files: "second_assignment".
const char* nameOf(Flag flag);
/// One sentence with the meaning and the recommended action.
Sentence sentenceOf(Flag flag);
/// All flags, for help texts.
std::vector<Flag> allFlags();

/// A value with its standard deviation and 95 % interval.
struct Uncertain {
  double value = 0.0, sd = 0.0;
  std::array<double, 2> interval95() const { return {value - 1.96 * sd, value + 1.96 * sd}; }
};

/// One contact. Lengths in mm, P is the patient's frame (LPS) of the CT after surgery.
struct FoundContact {
  int number = 0;  ///< 1 at the tip.
  Eigen::Vector3d position_P = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_P = Eigen::Matrix3d::Zero();  ///< Covariance of the position [mm^2].
  bool isSeenSingly = true;  ///< Its own brightness was seen; else it was placed by the spacings.
  std::optional<int> makerElectrode;  ///< Its number in the maker's fitting software, if known.
  bool isByHand = false;              ///< A person placed it.
  bool isInside = false;              ///< Past the opening. If not, nothing below is set.
  Uncertain angle_deg;                ///< From the round window, full turns included.
  double modiolus_mm =
      0.0;  ///< Distance to the inner wall, toward the modiolar axis; may be negative.
  double outerWall_mm = 0.0;  ///< Distance to the outer wall, away from the axis; may be negative.
  /// Probability that it lies below the basilar membrane, errors of both fits included.
  double inScalaTympani = 1.0;
  std::array<double, 3> greenwood_Hz{};       ///< Estimated place frequency: value, 95 % low, high.
  std::array<double, 3> spiralGanglion_Hz{};  ///< The same on the spiral ganglion.
  double filter_Hz = 0.0;                     ///< Center of its default filter; 0: none is known.
  double mismatch_semitones = 0.0;  ///< Spiral ganglion above the filter; 0 without a filter.

  /// Radius of a sphere with the position's mean square error: sqrt(trace(covariance) / 3).
  double error_mm() const { return std::sqrt(covariance_P.trace() / 3.0); }
  /// The 95 % interval of mismatch_semitones, of that of the frequency on the spiral ganglion; 0 without a filter.
  std::array<double, 2> mismatch95_semitones() const;
};

/// The patient's cochlea in the CT after surgery.
struct Ear {
  ct::CochleaMeasures measures;  ///< Its pose and wall in P of the CT after surgery.
  std::shared_ptr<const anatomy::ScalaTympani> scala;  ///< Its scala tympani, frame W [m].
  bool isRegistered = false;  ///< Carried over from a CT before surgery; else measured in this one.
  double residual_mm = 0.0;   ///< Residual of the registration; 0 without one.
  std::vector<Flag> flags;
};

/// Carries the cochlea measured in a CT before surgery over: rigid registration of both volumes around it,
/// bone against bone, without metal. Takes seconds, longer for large volumes.
/// @param stop        Ends it early, with an error.
/// @param onProgress  Completed fraction, 0 to 1, on the calling thread.
Result<Ear> registeredEar(const ct::CtVolume& postoperative, const ct::CtVolume& preoperative,
                          const ct::CochleaMeasures& measured, const std::stop_token& stop = {},
                          const std::function<void(double)>& onProgress = {});

/// Measures the cochlea in the CT after surgery itself, without the voxels of the metal.
/// @param request  As for measureCochlea().
Result<Ear> measuredEar(const ct::CtVolume& postoperative, const ct::MeasureRequest& request);

/// What speaks against the ear being that of a patient: the other side, A or B that differ by more than three
/// standard deviations of both errors, CTs that do not agree. Nothing if nothing does.
std::optional<Sentence> differenceFrom(const Ear& ear, const anatomy::Patient& patient);

/// What is looked for.
struct ContactsRequest {
  electrode::ArrayDesign array;
  std::string arrayName;  ///< Shipped name, "flex28".
  /// Contacts that a person placed, number and position in P: they are kept, the others follow.
  std::map<int, Eigen::Vector3d> byHand;
  std::function<void(double)> onProgress;  ///< Completed fraction, 0 to 1, on the calling thread.
  std::stop_token stop;                    ///< Ends it early, with an error.
};

/// The array as found.
struct FoundArray {
  std::string array;  ///< Shipped name.
  anatomy::Side side = anatomy::Side::right;
  std::vector<FoundContact> contacts;  ///< The most apical first.
  std::vector<Eigen::Vector3d>
      course_P;  ///< The array's course from the tip to where it leaves the volume, 0.25 mm apart.
  Uncertain angularInsertionDepth_deg;  ///< Angle of the most apical contact inside.
  double tipAngle_deg = 0.0;
  int contactsInside = 0;
  double outside_mm =
      0.0;  ///< Length of the array between the opening and its most basal contact; 0 if inside.
  double insertedLength_mm = 0.0,
         insertedLengthSd_mm = 0.0;  ///< Length of the tip past the opening, along the array.
  bool isFolded = false;
  double translocationProbability =
      0.0;  ///< The second largest over the contacts inside, as one may be in the wrong place.
  double translocationAngle_deg = 0.0;  ///< Where it first exceeds 0.8; 0 without.
  bool isRegistered = false;
  double residual_mm = 0.0;
  double fwhm_mm = 0.0;  ///< Full width at half maximum of the image's blur, as fitted.
  std::vector<Flag> flags;
  double seconds = 0.0;

  bool has(Flag flag) const;
};

/// Finds the contacts of an array in a CT after surgery. Deterministic; takes seconds.
///
/// Refuses with a sentence: a volume without metal in or near the ear, an array without contacts, a
/// canceled search.
Result<FoundArray> findContacts(const ct::CtVolume& postoperative, const Ear& ear,
                                const ContactsRequest& request);

}  // namespace perilymph::outcome
