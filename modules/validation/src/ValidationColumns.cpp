// SPDX-License-Identifier: BSD-3-Clause
#include "ValidationColumns.h"

#include <string>

#include "perilymph/session/Csv.h"
#include "perilymph/validation/PriorPredictive.h"

namespace perilymph::validation {

const FieldMeanings& forceColumns()
{
  static const FieldMeanings columns = {
      {"travel_mm", "mm", "Travel."},
      {"mean_N", "N", "Mean over the insertions; in difference.csv simulated less published."},
      {"sd_N", "N", "Standard deviation between insertions."},
      {"sem_N", "N", "Standard error of the mean."},
      {"ci95_low_N", "N", "Lower limit of the 95 % interval of the mean."},
      {"ci95_high_N", "N", "Upper limit."}};
  return columns;
}

const FieldMeanings& priorSummaryColumns()
{
  static const FieldMeanings columns = [] {
    FieldMeanings all = {
        {"travel_mm", "mm", "Travel at which forces are compared."},
        {"experiment_low_mN", "mN", "Published mean force, or the lower limit of where it lies."},
        {"experiment_high_mN", "mN", "The same, or the upper limit."},
        {"experiment_sem_mN", "mN", "Standard error of the published mean."},
        {"mean_mN", "mN", "Mean of the predictions."},
        {"sd_mN", "mN", "Their standard deviation."},
        {"low90_mN", "mN", "5 % of the predictions are below."},
        {"high90_mN", "mN", "95 % are below."},
        {"low90_with_error_mN", "mN",
         "The same with the error of the experiment and that of the fitted force: 5 % quantile."},
        {"high90_with_error_mN", "mN", "95 % quantile."},
        {"rank", "", "Fraction of the predictions below the experiment."},
        {"rank_with_error", "", "The same with the errors."},
        {"is_inside", "", "true if the experiment is within the quantiles with errors."}};
    for (const char* name : inputNames)
      all.push_back({std::string("rank_correlation_") + name, "",
                     "Spearman's rank correlation of force and input."});
    return all;
  }();
  return columns;
}

const FieldMeanings& priorColumns()
{
  static const FieldMeanings columns = [] {
    FieldMeanings all = {{"draw", "", "Number of the repetition of the experiment."},
                         {"reason", "", "Why it is left out; else empty."}};
    for (const char* name : inputNames)
      all.push_back({name, "in the name", "Input, drawn within its declared range."});
    all.push_back({"scale", "", "Fitted factor of the stiffness."});
    for (const double travel : comparedTravels_mm)
      all.push_back({"force_" + session::shortestDecimal(travel) + "_mN", "mN",
                     "Mean force of its insertions at this travel in mm."});
    for (std::size_t k = 1; k < comparedTravels_mm.size(); ++k)
      all.push_back({"slope_" + session::shortestDecimal(comparedTravels_mm[k]), "",
                     "Change of this force with that at the fitted travel."});
    return all;
  }();
  return columns;
}

const FieldMeanings& benchFrictionColumns()
{
  static const FieldMeanings columns = {
      {"specimen", "", "Specimen, or several."},
      {"medium", "", "Lining and fluid; tissue-median and tissue-further of fresh cochleae."},
      {"friction", "", "Coefficient of friction."},
      {"low95", "", "Lower limit of its 95 % interval."},
      {"high95", "", "Upper limit."}};
  return columns;
}

const FieldMeanings& benchPredictedColumns()
{
  static const FieldMeanings columns = {
      {"specimen", "", "Specimen."},
      {"medium", "", "Lining and fluid."},
      {"depth_mm", "mm", "Insertion depth."},
      {"measured_mN", "mN", "Measured force."},
      {"predicted_mN", "mN", "Force predicted from the smaller depths, median."},
      {"low90_mN", "mN", "5 % of the predictions are below."},
      {"high90_mN", "mN", "95 % are below."},
      {"inside", "", "1 if the measured force is between them, else 0."}};
  return columns;
}

const FieldMeanings& benchScoreColumns()
{
  static const FieldMeanings columns = {
      {"specimen", "", "Specimen."},
      {"forces", "", "Number of forces behind the depths that were fitted."},
      {"capstan", "",
       "Logarithm of the probability density of these forces if each medium has a friction of its "
       "own."},
      {"constant_ratio", "",
       "The same if each medium has the shape of the soap curve, and a factor."}};
  return columns;
}

const FieldMeanings& predictionColumns()
{
  static const FieldMeanings columns = {
      {"array", "", "Electrode array."},
      {"patient", "", "Patient."},
      {"apical_deg", "deg", "Angular insertion depth: angle of the most apical contact."},
      {"depth_mm", "mm", "Insertion depth at the end."},
      {"end_N", "N", "Axial force where the hand stops."},
      {"peak_N", "N", "Peak insertion force."},
      {"error", "", "Why the insertion was not run; else empty."}};
  return columns;
}

const FieldMeanings& clinicalRowColumns()
{
  static const FieldMeanings columns = {
      {"quantity", "", "What is compared."},
      {"unit", "", "Unit of the values: mN, deg or %."},
      {"published_low", "of the row",
       "Published range, of a rate its 95 % interval; 0 if there is none."},
      {"published_high", "of the row", "Its upper limit."},
      {"median", "of the row", "Predicted median, of a rate its value."},
      {"lower_quartile", "of the row", "Predicted lower quartile."},
      {"upper_quartile", "of the row", "Predicted upper quartile."},
      {"inside_fraction", "", "Fraction of the insertions within the published range."},
      {"runs", "", "Number of simulated insertions."},
      {"verdict", "", "Verdict on the median or the rate: hit, miss or not judged."},
      {"is_clinical", "",
       "true: insertions by hand in patients; false: an experiment with a phantom."},
      {"confidence", "", "Confidence of the published value: high, medium or low."},
      {"source", "", "Its source."},
      {"note", "", "What the prediction rests on besides physics."},
      {"published_median", "of the row", "Published median over centers, of a rate its value."},
      {"patients", "", "Number of patients that it rests on; 0 if unknown."},
      {"tolerance", "of the row", "Largest difference that is a hit."},
      {"power", "",
       "Probability that the rule finds an error of 100 degrees or 20 percentage points."},
      {"verdict_at_median_friction", "", "The verdict if the friction were known."},
      {"spread_factor", "", "Predicted over published interquartile range."},
      {"spread_tolerance", "", "Factor, either way, that is a hit."},
      {"spread_verdict", "", "Verdict on the interquartile range."},
      {"contacts_inside", "", "Mean number of contacts inside; empty where nothing is compared."},
      {"published_contacts_inside", "", "The published one."},
      {"angle_at_length", "deg", "Median angle of the insertions at the published length."},
      {"angle_at_length_runs", "", "Number of these insertions."},
      {"published_angle_at_length", "deg", "The published one."},
      {"depth_mm", "mm", "Median insertion depth."}};
  return columns;
}

const FieldMeanings& clinicalInsertionColumns()
{
  static const FieldMeanings columns = {
      {"seed", "", "Seed of the simulated patients."},
      {"patient", "", "Number of the simulated patient."},
      {"array", "", "Electrode array."},
      {"end", "", "How the insertion ended."},
      {"apical_deg", "deg", "Angular insertion depth: angle of the most apical contact."},
      {"depth_mm", "mm", "Insertion depth at the end."},
      {"end_N", "N", "Axial force where the hand stops."},
      {"peak_N", "N", "Peak insertion force."},
      {"partition_N", "N", "Largest force on the cochlear partition within one contact."},
      {"is_ruptured", "", "true if the partition ruptured."},
      {"reason", "", "Why the engine stopped or refused it; else empty."},
      {"after_1s_N", "N", "Axial force after 1 s of rest; empty if it did not rest so long."},
      {"after_10s_N", "N", "The same after 10 s."},
      {"shared_ln_friction", "", "Deviation of the logarithm of the friction that all ears share."},
      {"contacts_inside", "", "Number of contacts past the opening."},
      {"contacts", "", "Number of contacts of the array."},
      {"is_translocated", "", "true if a part of the array is above the partition at the end."}};
  return columns;
}

}  // namespace perilymph::validation
