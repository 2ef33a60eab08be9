// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "perilymph/outcome/FoundArray.h"

namespace perilymph::outcome {

namespace {

struct Entry {
  Flag flag;
  const char* name;
  Phrase sentence;
};

constexpr std::array<Entry, 15> entries{
    {{Flag::secondAssignment, "second_assignment",
      Phrase{"Another assignment of the contacts explains the metal nearly as well: check the "
             "number of the most apical contact."}},
     {Flag::missingContacts, "missing_contacts",
      Phrase{"Some contacts were not seen and are placed by the array's spacings: check them in "
             "the images."}},
     {Flag::extraMetal, "extra_metal",
      Phrase{"There is more metal in the ear than this array explains, such as an old lead: check "
             "which is the array."}},
     {Flag::arrayDoesNotFit, "array_does_not_fit",
      Phrase{
          "Spacing, number or place of the contacts contradict the array named or this ear: check "
          "the contacts in the images, and the array's name."}},
     {Flag::notSeenSingly, "not_seen_singly",
      Phrase{"The contacts merge in these voxels: they are placed by the array's spacings along "
             "its course."}},
     {Flag::fold, "fold", Phrase{"The angle turns back toward the tip: possible fold of the tip."}},
     {Flag::kink, "kink",
      Phrase{"The array bends more sharply than in any cochlea: possible kink, or a contact in the "
             "wrong place."}},
     {Flag::possibleTranslocation, "possible_translocation",
      Phrase{"Possible translocation: contacts lie above the place of the basilar membrane, which "
             "no CT shows."}},
     {Flag::contactsOutside, "contacts_outside", Phrase{"Contacts lie outside the cochlea."}},
     {Flag::registrationPoor, "registration_poor",
      Phrase{"The CTs before and after surgery agree badly around the cochlea: check the outline "
             "of the cochlea in the images."}},
     {Flag::earFitPoor, "ear_fit_poor",
      Phrase{"The cochlea was fitted badly to its images: angles may be wrong by more than their "
             "intervals. Check the outline of the cochlea, or give another CT before surgery."}},
     {Flag::earFromThisCt, "ear_from_this_ct",
      Phrase{"The cochlea was measured in the CT after surgery, beside the metal: angles and "
             "depths have wider errors. Give the CT before surgery if there is one."}},
     {Flag::anotherEar, "another_ear",
      Phrase{"Side, A or B differ from the patient's by more than their errors: check that this CT "
             "is of the same patient and ear."}},
     {Flag::clipped, "clipped", Phrase{"A part of the array lies outside the CT."}},
     {Flag::coarseVoxels, "coarse_voxels",
      Phrase{"A voxel is longer than 0.65 mm, the coarsest that was tested: take a finer series if "
             "there is one."}}}};

const Entry& entryOf(Flag flag)
{
  return *std::find_if(entries.begin(), entries.end(),
                       [&](const Entry& each) { return each.flag == flag; });
}

}  // namespace

const char* nameOf(Flag flag) { return entryOf(flag).name; }

Sentence sentenceOf(Flag flag) { return Sentence(entryOf(flag).sentence); }

std::vector<Flag> allFlags()
{
  std::vector<Flag> flags;
  for (const Entry& each : entries) flags.push_back(each.flag);
  return flags;
}

}  // namespace perilymph::outcome
