// SPDX-License-Identifier: BSD-3-Clause
#include "StopLengths.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/foundation/FileLock.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/session/InsertionTable.h"

namespace perilymph::outcome {

namespace {

using nlohmann::json;
using planning::UnstoppedDraw;

/// Simulations between two transactions: what a crash loses at most, as in plans.
constexpr std::size_t blockSize = 8;
/// Rises that a file may hold of one push: 300 mN in steps of 0.2 mN.
constexpr std::size_t maxRises = 1600;

const session::InsertionTableKind& stopsKind()
{
  static const session::InsertionTableKind kind = {
      {Sentence{"the stop lengths of a plan of Perilymph"},
       Sentence{"Choose a stops file that 'perilymph-cli outcomes' wrote."},
       Sentence{"Delete it; it is computed again."},
       0x5065534c,  // "PeSL"
       1,
       {"CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
        "CREATE TABLE insertion(draw INTEGER PRIMARY KEY, content TEXT NOT NULL)"},
       {},
       {},
       1,
       {},
       {},
       0x50655374},  // "PeSt", which studies have
      1,
      {{"insertion", "it", 1}},
      Sentence{"belongs to another plan, or its patient, array, scenario or distributions were "
               "changed since."},
      Sentence{"stop lengths"},
      Audience::owner};
  return kind;
}

/// The content of a row: SI units, which keeps every bit.
std::string contentOf(const UnstoppedDraw& draw)
{
  json depths = json::array(), forces = json::array();
  for (const analysis::DepthForce& rise : draw.curve.rises) {
    depths.push_back(rise.depth.si());
    forces.push_back(rise.force.si());
  }
  return json{{"friction", draw.friction},      {"stop", draw.stop.si()},
              {"intended", draw.intended.si()}, {"end", haptics::nameOf(draw.curve.end)},
              {"depth", draw.curve.depth.si()}, {"rise_depth", std::move(depths)},
              {"rise_force", std::move(forces)}}
      .dump();
}

Result<UnstoppedDraw> drawIn(std::size_t number, const std::string& content)
{
  const json row = json::parse(content, nullptr, false);
  if (!row.is_object()) return Error{"it is not JSON"};
  try {
    UnstoppedDraw draw;
    draw.draw = number;
    draw.friction = row.at("friction").get<double>();
    draw.stop = newtons(row.at("stop").get<double>());
    draw.intended = meters(row.at("intended").get<double>());
    draw.curve.end = haptics::endNamed(row.at("end").get<std::string>());
    draw.curve.depth = meters(row.at("depth").get<double>());
    const json &depths = row.at("rise_depth"), &forces = row.at("rise_force");
    if (!depths.is_array() || !forces.is_array() || depths.size() != forces.size() ||
        depths.size() > maxRises)
      return Error{"its curve has gaps"};
    for (std::size_t i = 0; i < depths.size(); ++i)
      draw.curve.rises.push_back(
          {meters(depths[i].get<double>()), newtons(forces[i].get<double>())});
    const bool ascends =
        std::is_sorted(draw.curve.rises.begin(), draw.curve.rises.end(),
                       [](const auto& one, const auto& other) { return one.force < other.force; });
    if (!ascends || !(draw.friction > 0.0) || draw.curve.end == haptics::InsertionEnd::none)
      return Error{"its values are not possible"};
    return draw;
  } catch (const json::exception&) {
    return Error{"a value is missing or has another type"};
  }
}

Result<std::vector<UnstoppedDraw>> drawsIn(const session::InsertionTable& table)
{
  std::vector<UnstoppedDraw> draws;
  const auto done = table.read([&](const session::InsertionRows& one) -> Result<void> {
    const auto number = std::get<std::int64_t>(one.row[0]);
    if (number != static_cast<std::int64_t>(draws.size()) + 1)
      return table.damaged(Sentence{"its simulations are not consecutive"});
    auto draw = drawIn(draws.size() + 1, std::get<std::string>(one.row[1]));
    if (!draw)
      return table.damaged(
          Sentence{"simulation %1 is not readable: %2", number, draw.error().message});
    draws.push_back(*std::move(draw));
    return {};
  });
  if (!done) return done.error();
  return draws;
}

/// A file with the draws in it.
struct OpenStops {
  session::InsertionTable table;
  std::vector<UnstoppedDraw> draws;
};

Result<OpenStops> opened(Result<session::InsertionTable> table)
{
  if (!table) return table.error();
  auto draws = drawsIn(*table);
  if (!draws) return draws.error();
  return OpenStops{*std::move(table), *std::move(draws)};
}

/// The draws of a file that has all of them; read without a lock and where nothing may be written.
std::optional<std::vector<UnstoppedDraw>> wholeIn(const std::filesystem::path& file,
                                                  const SealedFacts& facts, std::size_t count)
{
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  const auto table = session::InsertionTable::open(file, stopsKind());
  if (!table || table->seal() != Seal::intact || table->facts() != facts || table->size() < count)
    return std::nullopt;
  auto draws = drawsIn(*table);
  if (!draws) return std::nullopt;
  draws->resize(count);
  return *std::move(draws);
}

}  // namespace

std::string stopLengthsFile(std::size_t array)
{
  return "stops-" + std::to_string(array + 1) + ".sqlite";
}

Result<KnownStops> stopLengths(const planning::PlanRequest& request, std::size_t array,
                               const std::filesystem::path& folder,
                               const analysis::RunProgress& progress, const std::stop_token& stop)
{
  if (array >= request.arrays.size())
    return Error{"The plan has no array %1; it has %2. Choose one of them.", array + 1,
                 request.arrays.size()};
  const auto plan = planning::fingerprintOf(request);
  if (!plan) return plan.error();
  Sha256 hash;
  hash.add("stops 1:" + *plan + ":" + std::to_string(array));
  const SealedFacts facts{{session::fingerprintFact, hash.hex()},
                          {session::programFact, buildId()}};
  const std::filesystem::path file = folder / stopLengthsFile(array);
  KnownStops known;
  if (auto draws = wholeIn(file, facts, request.draws)) {
    known.draws = *std::move(draws);
    return known;
  }
  if (progress) progress(0, request.draws);
  const auto lock =
      FileLock::takeWhenFree(folder / ("." + file.stem().string() + ".lock"), file.string(), stop);
  if (!lock) return lock.error();
  std::error_code ignored;
  const bool isThere = std::filesystem::exists(file, ignored);
  auto stops = opened(session::InsertionTable::openToContinue(file, stopsKind(), facts));
  if (!stops && isThere) {
    known.isRenewed = true;
    stops = opened(session::InsertionTable::beginAgain(file, stopsKind(), facts));
  }
  if (!stops) return stops.error();
  auto& [table, draws] = *stops;
  while (draws.size() < request.draws) {
    const std::size_t done = draws.size(), count = std::min(blockSize, request.draws - done);
    auto added = planning::unstoppedDraws(
        request, array, done + 1, count,
        [&](std::size_t pieces, std::size_t) {
          if (progress) progress(done + pieces, request.draws);
        },
        stop);
    if (!added) return added.error();
    if (stop.stop_requested()) return Error{"Stopped."};
    std::vector<session::InsertionRows> rows;
    for (const UnstoppedDraw& each : *added)
      rows.push_back({{static_cast<std::int64_t>(each.draw), contentOf(each)}});
    if (const auto kept = table.append(rows); !kept) return kept.error();
    std::move(added->begin(), added->end(), std::back_inserter(draws));
  }
  if (const auto closed = table.close(); !closed) return closed.error();
  draws.resize(request.draws);
  known.draws = std::move(draws);
  return known;
}

}  // namespace perilymph::outcome
