// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyRun.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <tuple>
#include <unordered_map>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/analysis/RunProgress.h"
#include "perilymph/foundation/InParallel.h"
#include "perilymph/study/StudyFile.h"

namespace perilymph::study {

namespace {

namespace fs = std::filesystem;

/// Insertions that take some seconds.
constexpr std::size_t maxTogether = 64;

/// Insertions that are written together, which a crash loses at most beside those of running pieces: a
/// twentieth of the shard, as many as there are threads, and `maxTogether` at most.
std::size_t blockSizeOf(std::size_t cases, std::size_t threads)
{
  constexpr std::size_t parts = 20;
  return std::min(std::max({std::size_t{1}, cases / parts, threads}), maxTogether);
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

/// The cases [first, end) in pieces: of one cochlea, so that threads seldom wait for the same one to be
/// built, or of one case where there are few cochleae for the threads.
std::vector<Piece> piecesOf(const Study& study, std::size_t first, std::size_t end,
                            std::size_t threads)
{
  const std::size_t perCochlea = study.casesPerCochlea();
  const bool hasFewCochleae = (end - first) / perCochlea < 4 * threads;
  std::vector<Piece> pieces;
  for (std::size_t at = first; at < end;) {
    const std::size_t nextCochlea = (at / perCochlea + 1) * perCochlea;
    const std::size_t next =
        hasFewCochleae ? at + 1 : std::min({end, nextCochlea, at + maxTogether});
    pieces.push_back({at, next});
    at = next;
  }
  return pieces;
}

/// The cochleae that pieces at work share. The first piece that needs one builds it, while others of the same
/// cochlea wait; as pieces begin in their order, only the newest is kept for those that have not begun.
class SharedCochleae {
public:
  explicit SharedCochleae(const Study& study) : study_(study) {}

  std::shared_ptr<const BuiltCochlea> of(std::size_t index)
  {
    const std::shared_ptr<Place> place = placeOf(index);
    std::call_once(place->isBuilt, [&] { place->cochlea = buildCochlea(study_, index); });
    return {place, &place->cochlea};
  }

private:
  struct Place {
    std::once_flag isBuilt;
    BuiltCochlea cochlea;
  };

  std::shared_ptr<Place> placeOf(std::size_t index)
  {
    const std::lock_guard guard(lock_);
    std::erase_if(places_, [](const auto& each) { return each.second.expired(); });
    auto place = places_[index].lock();
    if (!place) places_[index] = place = newest_ = std::make_shared<Place>();
    return place;
  }

  const Study& study_;
  std::mutex lock_;
  std::unordered_map<std::size_t, std::weak_ptr<Place>> places_;
  std::shared_ptr<Place> newest_;
};

/// Results of pieces that end in any order, written in that of the cases.
class OrderedResults {
public:
  OrderedResults(const Study& study, StudyFile& file, std::size_t blockSize,
                 std::vector<Piece> pieces)
      : study_(study),
        file_(file),
        blockSize_(blockSize),
        pieces_(std::move(pieces)),
        ended_(pieces_.size())
  {
  }

  const std::vector<Piece>& pieces() const { return pieces_; }

  /// In any thread.
  void add(std::size_t piece, std::vector<StudyResult> results)
  {
    const std::lock_guard guard(lock_);
    ended_[piece] = std::move(results);
  }

  /// Writes what has ended without a gap, if that is a block, or all that is left.
  Result<void> write(bool isAll)
  {
    {
      const std::lock_guard guard(lock_);
      for (; next_ < ended_.size() && ended_[next_]; ++next_) {
        std::move(ended_[next_]->begin(), ended_[next_]->end(), std::back_inserter(waiting_));
        ended_[next_].reset();
      }
    }
    if (waiting_.empty() || (!isAll && waiting_.size() < blockSize_)) return {};
    if (const auto same = study_.checkFiles(); !same) return same;
    const auto added = file_.append(waiting_);
    waiting_.clear();
    return added;
  }

private:
  const Study& study_;
  StudyFile& file_;
  std::size_t blockSize_;
  std::vector<Piece> pieces_;
  std::mutex lock_;
  /// Each piece's; none before it ends and after it is written.
  std::vector<std::optional<std::vector<StudyResult>>> ended_;
  std::size_t next_ = 0;  ///< The first piece that had not ended.
  std::vector<StudyResult> waiting_;
};

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

  const std::size_t first = shard.first + file->size();
  const std::size_t all = shard.end - shard.first;
  const std::size_t threads = jobs > 0 ? jobs : processors();
  OrderedResults results(study, *file, blockSizeOf(all, threads),
                         piecesOf(study, first, shard.end, threads));
  SharedCochleae cochleae(study);
  std::atomic<std::size_t> finished{0};
  const auto work = [&](std::size_t number, const std::stop_token& ending) -> Result<void> {
    const Piece& piece = results.pieces()[number];
    const auto cochlea = cochleae.of(piece.first / study.casesPerCochlea());
    std::vector<StudyResult> own;
    for (std::size_t i = piece.first; i < piece.end; ++i) {
      own.push_back(resultOf(study, i, *cochlea, ending));
      if (ending.stop_requested()) return {};  // the insertion did not end
      ++finished;
    }
    results.add(number, std::move(own));
    return {};
  };
  std::stop_source ending;
  const std::stop_callback forward(stop, [&ending] { ending.request_stop(); });
  Result<void> written;
  const auto writeAndTell = [&](std::size_t) {
    if (progress) progress(first - shard.first + finished, all);
    if (written) written = results.write(false);
    if (!written) ending.request_stop();
  };
  const auto ran =
      doInParallel(results.pieces().size(), jobs, work, writeAndTell, ending.get_token());
  if (written) written = results.write(true);
  if (!written) return written.error();
  if (stop.stop_requested()) return false;
  if (!ran) return ran.error();
  if (const auto closed = file->close(); !closed) return closed.error();
  return true;
}

}  // namespace perilymph::study
