// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/InsertionState.h"

#include <algorithm>
#include <limits>
#include <span>

#include "StepWorkspace.h"
#include "perilymph/foundation/Hash.h"
#include "points/advancePoints.h"

namespace perilymph::mechanics {
namespace {

void addVector(Hash& hash, const Eigen::Vector3d& vector)
{
  for (int k = 0; k < 3; ++k) hash.add(vector[k]);
}

void addBends(Hash& hash, std::span<const MaterialBend> bends)
{
  for (const auto& [along, across] : bends)
    for (std::size_t i = 0; i < along.size(); ++i) {
      hash.add(along[i]);
      hash.add(across[i]);
    }
}

void straighten(std::span<MaterialBend> bends) noexcept
{
  for (auto& [along, across] : bends) {
    std::fill(along.begin(), along.end(), 0.0);
    std::fill(across.begin(), across.end(), 0.0);
  }
}

void addPartition(Hash& hash, const PartitionState& partition)
{
  for (std::size_t k = 0; k < partition.count; ++k) {
    hash.add(partition.ranges[k].begin);
    hash.add(partition.ranges[k].end);
  }
  hash.add(partition.first.tick);
  for (const double value : {partition.first.angle, partition.first.force, partition.first.depth})
    hash.add(value);
  for (const unsigned char isAbove : partition.isAbove) hash.add(isAbove);
}

void addSeen(Hash& hash, const ContactSet& contacts)
{
  const SeenWalls& seen = contacts.seen;
  for (std::size_t i = 0; i < contacts.wall.size(); ++i) {
    if (!(seen.trustRadius[i] > 0.0)) continue;
    hash.add(i);
    addVector(hash, seen.from_W[i]);
    hash.add(seen.distance[i]);
    addVector(hash, seen.normal_W[i]);
    hash.add(seen.trustRadius[i]);
    hash.add(contacts.wall[i].onMembrane);
    const Eigen::Vector3d rows[] = {seen.hessian_W[0][i], seen.hessian_W[1][i],
                                    seen.hessian_W[2][i]};
    for (int k = 0; k < 3; ++k) {
      addVector(hash, {rows[0][k], rows[1][k], rows[2][k]});
      addVector(hash, contacts.wall[i].shapeOperator_W.col(k));
    }
  }
}

}  // namespace

WorkspaceHandle::WorkspaceHandle(std::size_t rodNodes)
    : workspace_(std::make_unique<StepWorkspace>(rodNodes))
{
}

WorkspaceHandle::~WorkspaceHandle() = default;
WorkspaceHandle::WorkspaceHandle(WorkspaceHandle&& other) noexcept = default;
WorkspaceHandle& WorkspaceHandle::operator=(WorkspaceHandle&& other) noexcept = default;

WorkspaceHandle::WorkspaceHandle(const WorkspaceHandle& other)
    : workspace_(std::make_unique<StepWorkspace>(*other))
{
}

WorkspaceHandle& WorkspaceHandle::operator=(const WorkspaceHandle& other)
{
  if (workspace_)
    *workspace_ = *other;
  else
    workspace_ = std::make_unique<StepWorkspace>(*other);
  return *this;
}

InsertionState::InsertionState(const InsertionModel& model)
    : position_W(static_cast<std::size_t>(model.nodes)),
      velocity_W(position_W.size()),
      velocityTrend_W(position_W.size()),
      curl_W(position_W.size()),
      frictionSpring_W(position_W.size()),
      isSliding(position_W.size()),
      slipSpeed(position_W.size()),
      track(position_W.size()),
      isBeside(position_W.size()),
      clearance(position_W.size()),
      normalForce(position_W.size()),
      normalForceBefore(position_W.size()),
      wallForce_W(position_W.size()),
      wallNormal_W(position_W.size()),
      wallTorque(position_W.size()),
      section(position_W.size()),
      membraneForce(position_W.size()),
      workspace(model.points ? 0 : position_W.size())
{
  if (model.parts.relaxation.bends())
    for (auto& [along, across] : relaxedBend) {
      along.resize(position_W.size());
      across.resize(position_W.size());
    }
  if (model.parts.array.yields())
    for (auto& [along, across] : plasticBend) {
      along.resize(position_W.size());
      across.resize(position_W.size());
    }
  if (model.parts.relaxation.hasFilm()) frictionFilm_W.resize(position_W.size());
  if (model.partition) {
    partition.isAbove.resize(position_W.size());
    workspace->rod.contacts.open.resize(position_W.size());
  }
  if (model.points) {
    points.place_W.resize(position_W.size());
    points.proxy_W.resize(position_W.size());
  }
  reset(model);
}

void InsertionState::reset(const InsertionModel& model) noexcept
{
  tick = 0;
  isSettling = false;
  base_W = model.startBase_W;
  baseVelocity_W.setZero();
  styletWithdrawal = 0.0;
  for (std::size_t i = 0; i < position_W.size(); ++i) {
    position_W[i] = base_W + (static_cast<double>(i) * model.spacing) * model.startAxis_W;
    velocity_W[i].setZero();
    velocityTrend_W[i].setZero();
    curl_W[i] = model.startCurl_W;
    frictionSpring_W[i].setZero();
    isSliding[i] = 0;
    slipSpeed[i] = 0.0;
    track[i] = model.parts.lumen->startTrack();
    normalForce[i] = normalForceBefore[i] = 0.0;
    wallForce_W[i].setZero();
    wallNormal_W[i].setZero();
    wallTorque[i] = {};
    section[i] = {};
    membraneForce[i] = 0.0;
    isBeside[i] = 0;
    clearance[i] = 0.0;
  }
  straighten(relaxedBend);
  straighten(plasticBend);
  for (Eigen::Vector3d& film : frictionFilm_W) film.setZero();
  rim = RimContact{};
  rimForceBefore = 0.0;
  partition.count = 0;
  partition.first = {};
  for (unsigned char& isAbove : partition.isAbove) isAbove = 0;
  RodWorkspace& rod = workspace->rod;
  // nodes farther from the wall than this cannot touch it
  for (std::size_t i = 0; i < rod.contacts.reach.size(); ++i)
    rod.contacts.reach[i] = model.radius[i];
  std::ranges::fill(rod.contacts.seen.trustRadius, 0.0);
  rod.inertia.timeStep = 0.0;
  rod.section.styletWithdrawal = std::numeric_limits<double>::quiet_NaN();
  for (OpenNode& node : rod.contacts.open) node = OpenNode{};
  rod.system.factors.invalidate();
  rod.system.stepRemains = false;
  if (model.points) resetPoints(model, *this, workspace->points);
  readings = Readings{};
  readings.depth = model.parts.startInside.si() > 0.0 ? model.parts.startInside.si() : 0.0;
}

std::uint64_t InsertionState::fingerprint() const noexcept
{
  Hash hash;
  hash.add(tick);
  if (isSettling) hash.add(isSettling);
  addVector(hash, base_W);
  addVector(hash, baseVelocity_W);
  hash.add(styletWithdrawal);
  for (std::size_t i = 0; i < position_W.size(); ++i) {
    addVector(hash, position_W[i]);
    addVector(hash, velocity_W[i]);
    addVector(hash, velocityTrend_W[i]);
    addVector(hash, curl_W[i]);
    addVector(hash, frictionSpring_W[i]);
    hash.add(isSliding[i]);
    hash.add(slipSpeed[i]);
    hash.add(track[i].inLeadIn);
    hash.add(track[i].angle);
    hash.add(clearance[i]);
    if (isBeside[i] != 0) hash.add(i);
    hash.add(normalForce[i]);
    hash.add(normalForceBefore[i]);
    addVector(hash, wallNormal_W[i]);
    hash.add(wallTorque[i].torque);
    if (section[i].isKnown) {
      hash.add(section[i].length);
      hash.add(section[i].rate);
    }
  }
  addBends(hash, relaxedBend);
  addBends(hash, plasticBend);
  for (const Eigen::Vector3d& film : frictionFilm_W) addVector(hash, film);
  if (!frictionFilm_W.empty()) addVector(hash, rim.film_W);
  addSeen(hash, workspace->rod.contacts);
  workspace->rod.system.factors.addTo(hash);
  if (workspace->rod.system.stepRemains)
    for (const Eigen::Vector3d& step : workspace->rod.system.trial_W) addVector(hash, step);
  addVector(hash, rim.spring_W);
  hash.add(rim.isSliding);
  hash.add(rim.slipSpeed);
  hash.add(rim.normalForce);
  hash.add(rimForceBefore);
  addVector(hash, rim.normal_W);
  if (rim.fromTip > 0.0) hash.add(rim.fromTip);
  if (!points.place_W.empty()) points.addTo(hash);
  if (partition.isRuptured()) addPartition(hash, partition);
  return hash.value();
}

}  // namespace perilymph::mechanics
