// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyRun.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <stop_token>
#include <tuple>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

namespace {

namespace fs = std::filesystem;

/// Insertions of a block, which an interruption loses at most: a twentieth of the shard, as many as there
/// are threads, which take about the time of one, and 64 at most, which take some seconds.
std::size_t blockSizeOf(std::size_t cases, unsigned jobs)
{
  constexpr std::size_t parts = 20, most = 64;
  const std::size_t threads = jobs > 0 ? jobs : processors();
  return std::min(std::max({std::size_t{1}, cases / parts, threads}), most);
}

/// A cochlea as built, with its measures; or a message.
struct BuiltCochlea {
  std::size_t index = 0;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  double a_mm = 0.0, b_mm = 0.0, scalaLength_mm = 0.0;
  std::string error;
};

BuiltCochlea buildCochlea(const Study& study, std::size_t index)
{
  BuiltCochlea built;
  built.index = index;
  const auto parameters = study.parametersOf(study.caseAt(index * study.casesPerCochlea()));
  const auto anatomy =
      parameters ? session::buildAnatomy(*parameters)
                 : Result<std::shared_ptr<const anatomy::ScalaTympani>>(parameters.error());
  if (!anatomy) {
    built.error = anatomy.error().message;
    return built;
  }
  built.anatomy = *anatomy;
  const analysis::BasalDiameters basal = analysis::basalDiameters(**anatomy, parameters->cochlea);
  built.a_mm = inMillimeters(basal.a);
  built.b_mm = inMillimeters(basal.b);
  built.scalaLength_mm = inMillimeters(analysis::organOfCortiLength(**anatomy));
  namespace physical = analysis::physical;
  for (const auto& [name, value, range] :
       {std::tuple{"A", built.a_mm, physical::a_mm}, std::tuple{"B", built.b_mm, physical::b_mm},
        std::tuple{"The length of the scala", built.scalaLength_mm, physical::scalaLength_mm}})
    if (auto reason = analysis::impossibility(name, "mm", value, range); !reason.empty()) {
      BuiltCochlea none;
      none.index = index;
      none.error = reason + ". Check the patient's measures.";
      return none;
    }
  return built;
}

StudyResult resultOf(const Study& study, std::size_t number, const BuiltCochlea& cochlea,
                     const std::stop_token& stop)
{
  const StudyCase one = study.caseAt(number);
  StudyResult result;
  result.number = number;
  result.cochlea = study.cochleae()[one.cochlea].name;
  result.settings = one.overrides;
  result.a_mm = cochlea.a_mm;
  result.b_mm = cochlea.b_mm;
  result.scalaLength_mm = cochlea.scalaLength_mm;
  if (!cochlea.anatomy) {
    result.insertion.reason = cochlea.error;
    return result;
  }
  const auto parameters = study.parametersOf(one);
  if (!parameters) {
    result.insertion.reason = parameters.error().message;
    return result;
  }
  result.insertion = analysis::asPossible(
      analysis::runInsertion(*parameters, cochlea.anatomy, study.profileSpacing(), stop));
  if (!study.keepsContacts()) result.insertion.contacts.clear();
  return result;
}

/// Cases [first, end) that one thread runs in one cochlea.
struct Piece {
  std::size_t first, end;
};

bool isOneCochlea(const Study& study, std::size_t first, std::size_t end)
{
  return first / study.casesPerCochlea() == (end - 1) / study.casesPerCochlea();
}

/// The pieces of a block: one per cochlea, or one per case if the block lies within one cochlea.
std::vector<Piece> piecesOf(const Study& study, std::size_t first, std::size_t end)
{
  const std::size_t perCochlea = study.casesPerCochlea();
  std::vector<Piece> pieces;
  for (std::size_t at = first; at < end;) {
    const std::size_t nextCochlea = (at / perCochlea + 1) * perCochlea;
    const std::size_t next = isOneCochlea(study, first, end) ? at + 1 : std::min(end, nextCochlea);
    pieces.push_back({at, next});
    at = next;
  }
  return pieces;
}

/// End of the block that begins at a case: whole cochleae, or part of one that has many cases.
std::size_t endOfBlock(const Study& study, std::size_t first, std::size_t end,
                       std::size_t blockSize)
{
  const std::size_t perCochlea = study.casesPerCochlea();
  const std::size_t nextCochlea = (first / perCochlea + 1) * perCochlea;
  if (perCochlea >= blockSize) return std::min({end, nextCochlea, first + blockSize});
  return std::min(end, nextCochlea + (blockSize / perCochlea - 1) * perCochlea);
}

}  // namespace

Shard shardOf(std::size_t cases, std::size_t index, std::size_t count)
{
  return {index, count, cases * (index - 1) / count, cases * index / count};
}

std::string fileNameOf(const Shard& shard)
{
  return "shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count) + ".sqlite";
}

Result<bool> runShard(const Study& study, const Shard& shard, const fs::path& folder, unsigned jobs,
                      const analysis::RunProgress& progress, const std::stop_token& stop)
{
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem)
    return Error{"%1 cannot be created: %2. Give another folder.", folder, problem.message()};
  auto file =
      StudyFile::openToContinue(folder / fileNameOf(shard), factsOf(study, shard.first, shard.end));
  if (!file) return file.error();

  std::size_t first = shard.first + file->size();
  const std::size_t all = shard.end - shard.first;
  const std::size_t blockSize = blockSizeOf(all, jobs);
  BuiltCochlea shared;  // of a block within one cochlea, and of the next such block
  while (first < shard.end) {
    const std::size_t end = endOfBlock(study, first, shard.end, blockSize);
    const std::vector<Piece> pieces = piecesOf(study, first, end);
    const std::size_t cochlea = first / study.casesPerCochlea();
    const bool isShared = isOneCochlea(study, first, end);
    if (isShared && (!shared.anatomy || shared.index != cochlea))
      shared = buildCochlea(study, cochlea);
    std::vector<StudyResult> results(end - first);
    std::atomic<std::size_t> finished{0};
    const auto work = [&](std::size_t number, const std::stop_token& ending) -> Result<void> {
      const Piece& piece = pieces[number];
      const BuiltCochlea own =
          isShared ? shared : buildCochlea(study, piece.first / study.casesPerCochlea());
      for (std::size_t i = piece.first; i < piece.end && !ending.stop_requested(); ++i) {
        results[i - first] = resultOf(study, i, own, ending);
        ++finished;
      }
      return {};
    };
    const auto ran = doInParallel(
        pieces.size(), jobs, work,
        [&](std::size_t) {
          if (progress) progress(first - shard.first + finished, all);
        },
        stop);
    if (stop.stop_requested()) return false;
    if (!ran) return ran.error();
    if (const auto same = study.checkFiles(); !same) return same.error();
    if (const auto added = file->append(results); !added) return added.error();
    first = end;
  }
  if (const auto closed = file->close(); !closed) return closed.error();
  return true;
}

}  // namespace perilymph::study
