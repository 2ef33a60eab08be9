// SPDX-License-Identifier: BSD-3-Clause

// Which bright place is which contact, on chains whose answer is known.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "Assignment.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::outcome {
namespace {

/// An array of 8 contacts, 1.5 mm apart, in the mean scala, with its blobs.
class AChain : public testing::Test {
protected:
  AChain()
  {
    const auto scala = anatomy::buildMean(
        "mean", {millimeters(9.2), millimeters(6.9), std::nullopt}, millimeters(1));
    if (!scala) throw std::runtime_error(scala.error().message);
    ear_.scala = *scala;
    frame_.emplace(ear_);
    for (int i = 0; i < 8; ++i) array_.contactsFromTip.push_back(millimeters(1.0 + 1.5 * i));
    for (int i = 0; i < 8; ++i) contacts_.push_back(at(16.0 - 1.5 * i));
    // metal all along, in a grid that holds the whole course
    grid_.size = {201, 201, 201};
    grid_.step_mm = 0.15;
    grid_.first_P = Eigen::Vector3d::Constant(-15.0);
    grid_.value.assign(201 * 201 * 201, 0.0F);
    for (double depth = -1.0; depth < 16.5; depth += 0.05) light(at(depth), 1000.0F);
    for (const Eigen::Vector3d& each : contacts_) light(each, 8000.0F);
  }

  /// Point of the duct's center at a depth [mm].
  Eigen::Vector3d at(double depth_mm) const
  {
    const anatomy::Entry entry = ear_.scala->entry();
    if (depth_mm < 1.0) return frame_->toP(entry.origin_W - 1e-3 * depth_mm * entry.out_W);
    double low = 0.0, high = frame_->lastAngle();
    for (int i = 0; i < 60; ++i)
      (frame_->depthAt(0.5 * (low + high)) < depth_mm ? low : high) = 0.5 * (low + high);
    return frame_->toP(ear_.scala->center_W(low));
  }
  void light(const Eigen::Vector3d& point_P, float value)
  {
    const Eigen::Vector3d x = (point_P - grid_.first_P) / grid_.step_mm;
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          float& cell = grid_.value[grid_.index(static_cast<int>(std::lround(x[0])) + i,
                                                static_cast<int>(std::lround(x[1])) + j,
                                                static_cast<int>(std::lround(x[2])) + k)];
          cell = std::max(cell, value);
        }
  }
  std::vector<Candidate> candidates(
      const std::vector<std::pair<Eigen::Vector3d, double>>& others = {}, int without = -1) const
  {
    std::vector<Candidate> all;
    for (int i = 0; i < 8; ++i)
      if (i != without)
        all.push_back({contacts_[static_cast<std::size_t>(i)], 1.0,
                       frame_->placeOf(contacts_[static_cast<std::size_t>(i)])});
    for (const auto& [point_P, strength] : others)
      all.push_back({point_P, strength, frame_->placeOf(point_P)});
    return all;
  }

  Ear ear_;
  std::optional<EarFrame> frame_;
  electrode::ArrayDesign array_;
  std::vector<Eigen::Vector3d> contacts_;
  MetalGrid grid_;
};

TEST_F(AChain, IsFoundFromTheTipWhateverTheOrderOfItsBlobs)
{
  std::vector<Candidate> shuffled = candidates();
  std::rotate(shuffled.begin(), shuffled.begin() + 3, shuffled.end());
  const Chain chain = bestChain(shuffled, grid_, array_, {}, 0.3);
  ASSERT_EQ(chain.candidate.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    ASSERT_GE(chain.candidate[i], 0);
    EXPECT_EQ(shuffled[static_cast<std::size_t>(chain.candidate[i])].position_P, contacts_[i]) << i;
  }
}

TEST_F(AChain, IsNotShiftedByAWeakBlobBeyondEitherEnd)
{
  const auto all = candidates({{at(17.5), 0.3}, {at(4.0), 0.3}, {at(10.3), 0.4}});
  const Chain chain = bestChain(all, grid_, array_, {}, 0.3);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(chain.candidate[static_cast<std::size_t>(i)], i);
}

TEST_F(AChain, LeavesOutAContactThatWasNotSeen)
{
  const Chain chain = bestChain(candidates({}, 3), grid_, array_, {}, 0.3);
  ASSERT_EQ(chain.candidate.size(), 8u);
  EXPECT_EQ(chain.candidate[3], -1);
  EXPECT_EQ(chain.candidate[2], 2);
  EXPECT_EQ(chain.candidate[4], 3);
}

TEST_F(AChain, KeepsAContactThatAPersonPlaced)
{
  // a person says that the strongest chain's second contact is the first
  const Chain chain = bestChain(candidates(), grid_, array_, {{0, 1}}, 0.3);
  ASSERT_EQ(chain.candidate.size(), 8u);
  EXPECT_EQ(chain.candidate[0], 1);
  EXPECT_EQ(chain.candidate[1], 2);
}

}  // namespace
}  // namespace perilymph::outcome
