// SPDX-License-Identifier: BSD-3-Clause

// Labels of points in a picture: whatever the points, each label has a place of its own.

#include "gui/widgets/LabelPlaces.h"

#include <gtest/gtest.h>

#include <random>

namespace perilymph::gui {
namespace {

/// Random numbers of one seed, the same on every machine.
class Chance {
public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double upTo(double end) { return end * double(engine_()) / 4294967296.0; }

private:
  std::mt19937 engine_;
};

TEST(LabelPlaces, LieInThePaneAndOnNoOtherLabelPointOrTakenPlace)
{
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Chance chance(seed);
    const QRectF pane(0.0, 0.0, 160.0 + chance.upTo(900.0), 140.0 + chance.upTo(600.0));
    const std::vector<QRectF> taken{QRectF(0.0, 0.0, 120.0, 30.0)};
    std::vector<LabelledPoint> labels;
    // crowded at every third seed
    const double spread = seed % 3 == 0 ? 0.1 : 1.0;
    for (int k = 0; k < 1 + int(seed % 10); ++k)
      labels.push_back({{pane.width() * (0.4 * (1.0 - spread) + chance.upTo(spread)),
                         pane.height() * (0.4 * (1.0 - spread) + chance.upTo(spread))},
                        {12.0 + chance.upTo(30.0), 16.0 + chance.upTo(10.0)}});
    const std::vector<QRectF> places = placeLabels(labels, pane, taken);
    ASSERT_EQ(places.size(), labels.size());
    for (std::size_t one = 0; one < places.size(); ++one) {
      const QRectF& place = places[one];
      const bool hasRoom = pane.width() > 400.0 && pane.height() > 300.0;
      EXPECT_FALSE(hasRoom && place.isNull());
      if (place.isNull()) continue;
      EXPECT_EQ(place.size(), labels[one].size);
      EXPECT_TRUE(pane.contains(place));
      EXPECT_FALSE(taken[0].intersects(place));
      for (std::size_t other = 0; other < places.size(); ++other) {
        EXPECT_FALSE(place.contains(labels[other].at));
        EXPECT_FALSE(other != one && place.intersects(places[other]));
      }
    }
  }
}

TEST(LabelPlaces, HaveLeaderLinesFromTheirPointToTheirEdge)
{
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Chance chance(seed);
    std::vector<LabelledPoint> labels;
    for (int k = 0; k < 5 + int(seed % 20); ++k)
      labels.push_back({{chance.upTo(900.0), chance.upTo(600.0)},
                        {14.0 + chance.upTo(120.0), 14.0 + chance.upTo(10.0)}});
    const auto places = placeLabels(labels, {0.0, 0.0, 900.0, 600.0});
    for (std::size_t k = 0; k < labels.size(); ++k) {
      const QLineF leader = leaderLine(labels[k].at, places[k]);
      if (leader.isNull()) continue;
      // it begins on the ring about the point, and its line goes through the point
      EXPECT_LT(QLineF(labels[k].at, leader.p1()).length(), 7.01);
      const QLineF whole(labels[k].at, leader.p2());
      EXPECT_NEAR(whole.length(), QLineF(labels[k].at, leader.p1()).length() + leader.length(),
                  1e-9);
      // and ends on the label's edge
      const QPointF end = leader.p2();
      EXPECT_TRUE(places[k].adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(end));
      EXPECT_FALSE(places[k].adjusted(1e-6, 1e-6, -1e-6, -1e-6).contains(end));
    }
  }
}

TEST(LabelPlaces, OfALonePointIsBesideIt)
{
  const LabelledPoint label{{200.0, 150.0}, {30.0, 16.0}};
  const QRectF place = placeLabels({label}, {0.0, 0.0, 400.0, 300.0}).front();
  EXPECT_TRUE(leaderLine(label.at, place).isNull());
  EXPECT_LT(std::hypot(place.center().x() - 200.0, place.center().y() - 150.0), 40.0);
}

TEST(LabelPlaces, HaveLeaderLinesThatCrossNoLabelWhereThereIsRoom)
{
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Chance chance(seed);
    std::vector<LabelledPoint> labels;
    for (int k = 0; k < 7; ++k)
      labels.push_back({{320.0 + chance.upTo(160.0), 220.0 + chance.upTo(160.0)}, {34.0, 16.0}});
    const auto places = placeLabels(labels, {0.0, 0.0, 800.0, 600.0});
    std::vector<QLineF> leaders;
    for (std::size_t k = 0; k < labels.size(); ++k)
      leaders.push_back(leaderLine(labels[k].at, places[k]));
    for (std::size_t one = 0; one < leaders.size(); ++one)
      for (std::size_t other = 0; other < leaders.size(); ++other) {
        if (one == other || leaders[one].isNull()) continue;
        for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9})
          EXPECT_FALSE(places[other].contains(leaders[one].pointAt(part)));
        EXPECT_TRUE(leaders[other].isNull() || leaders[one].intersects(leaders[other], nullptr) !=
                                                   QLineF::BoundedIntersection);
      }
  }
}

}  // namespace
}  // namespace perilymph::gui
