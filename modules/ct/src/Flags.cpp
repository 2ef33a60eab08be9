// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "perilymph/ct/Measures.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::ct {
namespace {

struct Entry {
  Flag flag;
  const char* name;
  Phrase sentence;
};

constexpr std::array<Entry, 18> entries{
    {{Flag::coarseVoxels, "coarse_voxels",
      Phrase{"A voxel is longer than 0.65 mm, the coarsest the measurement was tried with: take a "
             "finer "
             "series if there is one, or trust the measures less than their error bars say."}},
     {Flag::airInCochlea, "air_in_cochlea",
      Phrase{"The cochlea is filled with air, as in a dried specimen: a patient's is filled with "
             "fluid, "
             "so "
             "check that this is the right place and the right series."}},
     {Flag::mirrored, "mirrored",
      Phrase{"Possible left-right swap: the spiral winds as in the other ear. Check the file and "
             "the side before anything is planned."}},
     {Flag::outsidePopulation, "outside_population",
      Phrase{
          "A or B lies more than two standard deviations from the mean of 138 cochleae: check the "
          "outline in the images before using the measures."}},
     {Flag::poorFit, "poor_fit",
      Phrase{
          "Poor fit: the outline deviates from the images. Measure by hand if it does not lie on "
          "the wall."}},
     {Flag::sectionsDisagree, "sections_disagree",
      Phrase{"The wall found in sections through the modiolus lies apart from the fitted one: "
             "check the "
             "outline in the images."}},
     {Flag::roundWindowUnsure, "round_window_unsure",
      Phrase{
          "No round window was found, so 0 degrees follows from the spiral alone: mark the round "
          "window's center."}},
     {Flag::clipped, "clipped",
      Phrase{"Part of the cochlea lies outside the volume, or where nothing was measured: take a "
             "series "
             "that "
             "shows all of it."}},
     {Flag::landmarkContradicted, "landmark_contradicted",
      Phrase{"A landmark placed by hand lies far from the fitted cochlea, and the voxels "
             "contradict it: "
             "check that landmark in the images."}},
     {Flag::fewTurns, "few_turns",
      Phrase{
          "Fewer than 2.15 turns of the lumen were seen: the cochlea is malformed, or its upper "
          "turns "
          "are filled with bone. No duct length is given, because its formula assumes 2.5 turns."}},
     {Flag::cysticApex, "cystic_apex",
      Phrase{
          "No modiolus was seen within the middle turn: middle and apical turn may be one cavity "
          "(incomplete partition). No duct length is given, because its formula assumes 2.5 turns, "
          "and "
          "H is that of the cavity."}},
     {Flag::apexNotJudged, "apex_not_judged",
      Phrase{"Whether middle and apical turn are one cavity (incomplete partition) could not be "
             "judged: the modiolus is faint, the CT too coarse or too noisy, or the middle turn "
             "not empty. Look for the septum between both turns in a section through the axis, or "
             "take a finer series."}},
     {Flag::wallWithoutContrast, "wall_without_contrast",
      Phrase{"Along a fifth or more of the basal turn nothing distinguishes the lumen from the "
             "bone: it "
             "may "
             "be ossified; check the outline in the images."}},
     {Flag::metal, "metal_in_cochlea",
      Phrase{"There is metal in or beside the cochlea (an implant?): it hides the wall, so take a "
             "CT from "
             "before "
             "the "
             "implantation."}},
     {Flag::unusualProportions, "unusual_proportions",
      Phrase{"B does not fit A, or H is beyond that of known cochleae: check the outline in the "
             "images; a "
             "malformed cochlea has no A, B and H."}},
     {Flag::secondCochlea, "second_cochlea",
      Phrase{
          "The volume shows a second cochlea: choose the ear by its side, or by a point in it."}},
     {Flag::landmarksDisagree, "landmarks_disagree",
      Phrase{"A, B or H between the landmarks placed by hand differs from the fitted one by more "
             "than the "
             "errors of both: check the landmarks in the images."}},
     {Flag::seriesInDoubt, "series_in_doubt",
      Phrase{"The files of the CT contradict themselves, or something of them is missing: read the "
             "warnings about the series before using the measures."}}}};

const Entry& entryOf(Flag flag)
{
  return *std::find_if(entries.begin(), entries.end(),
                       [&](const Entry& entry) { return entry.flag == flag; });
}

}  // namespace

const char* nameOf(Flag flag) { return entryOf(flag).name; }
Sentence sentenceOf(Flag flag) { return Sentence(entryOf(flag).sentence); }

std::vector<Flag> allFlags()
{
  std::vector<Flag> flags;
  for (const Entry& entry : entries) flags.push_back(entry.flag);
  return flags;
}

bool CochleaMeasures::has(Flag flag) const
{
  return std::find(flags.begin(), flags.end(), flag) != flags.end();
}

std::optional<Flag> CochleaMeasures::noFullSpiral() const
{
  for (const Flag flag : {Flag::fewTurns, Flag::cysticApex})
    if (has(flag)) return flag;
  return std::nullopt;
}

double Measure::sd() const
{
  return std::sqrt(statistical * statistical + model * model + definition * definition);
}

std::array<double, 2> Measure::interval95() const
{
  return {value - halfWidth95 * sd(), value + halfWidth95 * sd()};
}

std::string millimetersOf(double value_mm)
{
  std::array<char, 400> digits;
  const auto done = std::to_chars(digits.data(), digits.data() + digits.size(), value_mm,
                                  std::chars_format::fixed, 2);
  return {digits.data(), done.ptr};
}

}  // namespace perilymph::ct
