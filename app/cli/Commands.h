// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The subcommands: their options and functions. Each function prints its summary to standard output
// and returns an error if it failed. Output files are checked before (CommandFiles.h).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::cli {

class CommandFiles;

struct SimulateOptions {
  std::string scenario;
  session::Overrides overrides;   ///< From --patient, --array, --set and similar options.
  std::string csv, json, record;  ///< Files; empty if not requested.
  double every_ms = 0.0;          ///< Interval of CSV rows; 0: every tick.
  std::string igtl;               ///< "[ADDRESS:]PORT" to broadcast at; empty: none.
};
Result<void> simulate(const SimulateOptions& options, const CommandFiles& files);

struct AnatomyOptions {
  std::string preset, patient, import;
  std::optional<double> stLength_mm, rwWidth_mm, rwHeight_mm;
  std::optional<double> a_mm, b_mm, h_mm;
  std::optional<std::uint64_t> sample;  ///< Seed of a virtual patient.
  std::string json, sections, surface, hapticSurface;
  std::string part = "scala";
};
Result<void> describeAnatomy(const AnatomyOptions& options);
/// The same for a segmented surface, --import.
Result<void> describeImport(const AnatomyOptions& options);

struct ReplayOptions {
  std::string file;
  bool verifies = false;
  std::string csv;
  std::string sqlite;
  std::string contacts;
  std::string thumbnail;
  int size_px = 256;  ///< Side of the thumbnail.
};
Result<void> replay(const ReplayOptions& options);

struct ValidateOptions {
  std::string variability = "published-experiment";
  session::Overrides overrides;  ///< From --model and --set.
  int runs = 200;
  std::uint64_t seed = 1;
  unsigned jobs = 0;  ///< 0: one per processor.
  std::string
      bench;  ///< Shipped name or folder of curves, in place of the experiment; empty: none.
  bool isPriorPredictive = false;  ///< Draws the inputs in place of one choice of each.
  int draws = 400;                 ///< Number of repetitions.
  std::string out;
};
Result<void> validate(const ValidateOptions& options, const CommandFiles& files);

struct CalibrateOptions {
  std::string variability = "published-experiment";
  session::Overrides overrides;  ///< From --set.
  int runs = 24;
  std::uint64_t seed = 1;
  unsigned jobs = 0;
  std::string out;
};
Result<void> calibrate(const CalibrateOptions& options, const CommandFiles& files);

struct PredictOptions {
  std::vector<std::string> arrays;
  bool isAll = false;  ///< The clinical table in place of chosen arrays.
  std::string friction = "estimate-from-pig-tissue";  ///< Friction of the clinical table.
  std::optional<int> patients;                        ///< 50, for the clinical table 12.
  std::vector<std::uint64_t> seeds = {1};
  unsigned jobs = 0;
  std::string out;
};
Result<void> predict(const PredictOptions& options, const CommandFiles& files);

struct PlanOptions {
  std::string patient;
  std::vector<std::string> arrays;      ///< Shipped names or files; "all": the shipped ones.
  std::optional<std::string> friction;  ///< Shipped name or file; without it, the scenario's.
  std::optional<std::string> clinicResistance;  ///< File; without it, the shipped distributions.
  std::optional<std::size_t> samples;           ///< 64; with a clinic's resistance 512.
  std::uint64_t seed = 1;
  unsigned jobs = 0;
  bool runsAll = false;  ///< All samples, though the bands may stand earlier.
  std::string out;
};
Result<void> plan(const PlanOptions& options, const CommandFiles& files);

struct CompareOptions {
  std::vector<std::string> files;
  std::string over = "travel";
  std::vector<std::string> groups;  ///< "array", "technique", "patient", "friction", "speed".
  std::string out;
};
Result<void> compare(const CompareOptions& options, const CommandFiles& files);

struct RenderOptions {
  std::string scenario;
  std::string preset, patient, array;
  std::optional<double> at_mm;
  std::string view = "surgeon";
  std::string out;
};
Result<void> render(const RenderOptions& options, const CommandFiles& files);

struct PatientsOptions {
  std::string registry, dictionary;  ///< Files; both empty: the patients are listed.
};
Result<void> patients(const PatientsOptions& options);

struct OutcomesOptions {
  std::string library;  ///< Folder with `patients` and `plans`; empty: the user's own.
  std::string out;
  std::string resistance;  ///< File for the clinic's resistance; empty: none.
};
Result<void> outcomes(const OutcomesOptions& options, const CommandFiles& files);

struct DevicesOptions {
  std::string json;
  std::string test;     ///< Device to test: 3 for hidraw3, a name, a place; empty: none.
  std::string capture;  ///< Recording file of the test's reports.
  std::string plugin;   ///< Shared library of a plug-in to test.
  std::string profile;  ///< The only device profile to use; empty: all.
  std::string replay;   ///< Tape to be read instead of a device.
};
Result<void> devices(const DevicesOptions& options);

struct CtInfoOptions {
  std::string path;
  std::string json;
};
Result<void> ctInfo(const CtInfoOptions& options);

struct CtMeasureOptions {
  std::string path, series;
  std::optional<std::array<double, 3>> at_mm;  ///< A point in the cochlea, LPS.
  std::string landmarks;                       ///< A file of Slicer's markups.
  std::string side;                            ///< "left", "right" or empty.
  std::string json, patient, surface, picture, structuredReport, segmentation, keyImage;
};
Result<void> ctMeasure(const CtMeasureOptions& options);

struct CtContactsOptions {
  std::string path, series;
  std::string array;               ///< Shipped name or file.
  std::string patient;             ///< Shipped name or file, to be compared with the ear.
  std::string preop, preopSeries;  ///< CT before surgery.
  std::optional<std::array<double, 3>>
      at_mm;  ///< A point in the cochlea of the CT that is measured, LPS.
  std::string side;
  std::string json, csv, markups, picture;
};
Result<void> ctContacts(const CtContactsOptions& options);

struct CtMarkupsOptions {
  std::string patient;  ///< A patient's file, whose record is beside it.
  std::string series;   ///< SHA-256 of the series, or its beginning; empty for the only one.
  std::string json, csv, markups;
};
Result<void> ctMarkups(const CtMarkupsOptions& options);

struct CtExportOptions {
  std::string path, series, out;
};
Result<void> ctExport(const CtExportOptions& options);

/// Options of all `archive` commands; each uses some.
struct ArchiveOptions {
  std::string server;  ///< Name in servers.toml.
  std::string json;
  // servers
  std::string add, remove;  ///< Names of servers.
  std::string aeTitle, host, ownAeTitle = "PERILYMPH", retrieve = "get";
  int port = 104, ownPort = 11112;
  std::string tlsAuthority, tlsCertificate, tlsKey;
  // find
  std::string patientId, patientName, birthDate, from, until, modality;
  bool showsPatients = false;
  // find, fetch
  std::string study, series, out;
  // send
  std::string file;
};
Result<void> archiveServers(const ArchiveOptions& options);
Result<void> archiveEcho(const ArchiveOptions& options);
Result<void> archiveFind(const ArchiveOptions& options);
Result<void> archiveFetch(const ArchiveOptions& options);
Result<void> archiveSend(const ArchiveOptions& options);

/// Options of all `study` commands; each uses some.
struct StudyOptions {
  std::string file, folder;
  unsigned jobs = 0;                  ///< 0: one per processor.
  std::size_t index = 1, shards = 1;  ///< Part `index` of `shards`, from 1.
  std::string partition, time;        ///< For Slurm; its defaults if empty.
  std::vector<std::string> sbatchOptions;
  std::string group;  ///< Setting whose groups are tabulated; none if empty.
  bool isDryRun = false;
};
Result<void> checkStudy(const StudyOptions& options);
Result<void> runWholeStudy(const StudyOptions& options);
Result<void> runStudyShard(const StudyOptions& options);
Result<void> mergeStudy(const StudyOptions& options);
Result<void> reportStudy(const StudyOptions& options, const CommandFiles& files);
Result<void> showStudyStatus(const StudyOptions& options);
Result<void> submitStudy(const StudyOptions& options);

/// The options of all commands; filled while the command line is parsed.
struct CommandOptions {
  SimulateOptions simulate;
  AnatomyOptions anatomy;
  ReplayOptions replay;
  RenderOptions render;
  ValidateOptions validate;
  CalibrateOptions calibrate;
  PredictOptions predict;
  PlanOptions plan;
  CompareOptions compare;
  PatientsOptions patients;
  OutcomesOptions outcomes;
  DevicesOptions devices;
  CtInfoOptions ctInfo;
  CtMeasureOptions ctMeasure;
  CtContactsOptions ctContacts;
  CtMarkupsOptions ctMarkups;
  CtExportOptions ctExport;
  ArchiveOptions archive;
  StudyOptions study;
};

}  // namespace perilymph::cli
