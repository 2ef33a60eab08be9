#include "Rod.h"

#include <algorithm>
#include <cmath>

namespace perilymph::mechanics {
namespace {

/// Discrete curvature of two unit tangents, as a vector in their plane that points to the inside of
/// the bend: w = 2 (t - p) / (1 + t . p). For small angles its length is the angle between them.
Eigen::Vector3d bendOf(const Eigen::Vector3d& p, const Eigen::Vector3d& t) noexcept
{
  return (2.0 / std::max(1.0 + p.dot(t), 1e-3)) * (t - p);
}

Eigen::Matrix3d across(const Eigen::Vector3d& t) noexcept
{
  return Eigen::Matrix3d::Identity() - t * t.transpose();
}

}  // namespace

void setStiffness(const InsertionModel& model, double styletWithdrawal, StepRoom& room) noexcept
{
  const double styletTip = model.styletFromTip + styletWithdrawal;
  for (std::size_t i = 0; i < room.bending.size(); ++i) {
    double covered = 0.0;
    if (model.styletBending > 0.0)
      covered = std::clamp((model.fromTip[i] - styletTip) / model.spacing + 0.5, 0.0, 1.0);
    room.bending[i] = model.bendingCarrier[i] + covered * model.styletBending;
    room.restBend[i] =
        model.spacing * model.restCurvature[i] * (1.0 - covered * (1.0 - model.styletResidual));
  }
}

void setRestBends(const InsertionModel& model, const InsertionState& state,
                  const Eigen::Vector3d& curl_W, StepRoom& room) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  Eigen::Vector3d p = (state.position_W[1] - state.position_W[0]).normalized();
  Eigen::Vector3d d = curl_W;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Eigen::Vector3d t = (state.position_W[i + 1] - state.position_W[i]).normalized();
    // the least rotation that takes p to t
    const Eigen::Vector3d next = d - (d.dot(t) / std::max(1.0 + p.dot(t), 1e-3)) * (p + t);
    room.restBend_W[i] = room.restBend[i] * 0.5 * (d + next);
    d = next;
    p = t;
  }
}

void rememberShape(const InsertionModel& model, const InsertionState& state,
                   StepRoom& room) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  Eigen::Vector3d previous = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Eigen::Vector3d edge = state.position_W[i + 1] - state.position_W[i];
    room.lengthBefore[i] = edge.norm();
    const Eigen::Vector3d t = edge / room.lengthBefore[i];
    if (i > 0) room.bendBefore_W[i] = bendOf(previous, t);
    previous = t;
  }
}

void addRod(const InsertionModel& model, const std::vector<Eigen::Vector3d>& position_W,
            Compression compression, StepRoom& room) noexcept
{
  const auto n = static_cast<std::size_t>(model.nodes);
  const double h = model.spacing;
  const double damping = dampingTime / model.timeStep;

  Eigen::Vector3d p;
  double pLength = 0.0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Eigen::Vector3d edge = position_W[i + 1] - position_W[i];
    const double length = edge.norm();
    const Eigen::Vector3d t = edge / length;

    // stretching; the first edge is in the tweezers
    if (i > 0) {
      const double stiffness = model.stretching[i] / h;
      const double tension = stiffness * ((length - h) + damping * (length - room.lengthBefore[i]));
      room.force_W[i] += tension * t;
      room.force_W[i + 1] -= tension * t;
      const double sideways =
          (compression == Compression::included ? tension : std::max(tension, 0.0)) / length;
      const Eigen::Matrix3d block = (stiffness * (1.0 + damping) - sideways) * t * t.transpose() +
                                    sideways * Eigen::Matrix3d::Identity();
      const std::size_t a = blockOf(i);
      room.system.diagonal[a] += block;
      room.system.diagonal[a + 1] += block;
      room.system.beside[a + 1] -= block;
    }

    // bending between the edge before and this one
    if (i > 0) {
      const double stiffness = room.bending[i] / h;
      const double cosine = p.dot(t);
      const double c = 1.0 / std::max(1.0 + cosine, 1e-3);
      const Eigen::Vector3d w = (2.0 * c) * (t - p);
      const Eigen::Vector3d stress =
          stiffness * ((w - room.restBend_W[i]) + damping * (w - room.bendBefore_W[i]));
      const double a = 2.0 * c / length;
      const double b = 2.0 * c / pLength;

      // forces, exactly: the derivatives of w by t and p are c (2 - w p^T) and -c (2 + w t^T)
      const double half = 0.5 * w.dot(stress);
      const Eigen::Vector3d onNext = a * (stress - t * t.dot(stress) - half * (p - cosine * t));
      const Eigen::Vector3d onLast = b * (stress - p * p.dot(stress) + half * (t - cosine * p));
      room.force_W[i + 1] -= onNext;
      room.force_W[i - 1] -= onLast;
      room.force_W[i] += onNext + onLast;

      // stiffness, to first order in the angle between the links: w changes by a P_t dx_next there
      // and by b P_p dx_last here, where P_t takes away what is along t
      const double k = stiffness * (1.0 + damping);
      const Eigen::Matrix3d nextNext = (k * a * a) * across(t);
      const Eigen::Matrix3d lastLast = (k * b * b) * across(p);
      const Eigen::Matrix3d nextLast =
          (k * a * b) *
          (Eigen::Matrix3d::Identity() - t * (t - cosine * p).transpose() - p * p.transpose());
      const Eigen::Matrix3d nextHere = nextNext + nextLast;  // to be taken away
      const Eigen::Matrix3d hereLast = nextLast + lastLast;  // likewise
      const std::size_t next = i, here = blockOf(i), last = blockOf(i - 1);
      room.system.diagonal[next] += nextNext;
      room.system.diagonal[here] += nextHere + hereLast.transpose();
      room.system.diagonal[last] += lastLast;
      room.system.beside[next] -= nextHere;
      if (here == last) {
        // both belong to the base
        room.system.diagonal[here] -= hereLast + hereLast.transpose();
        room.system.beside[next] += nextLast;
      } else {
        room.system.beside[here] -= hereLast;
        room.system.beyond[next] += nextLast;
      }
    }
    p = t;
    pLength = length;
  }
}

}  // namespace perilymph::mechanics
