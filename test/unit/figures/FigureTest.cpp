// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perilymph/figures/Svg.h"

namespace perilymph::figures {
namespace {

using testing::HasSubstr;
using testing::Not;

Figure someFigure()
{
  Figure figure;
  figure.title = "a < b & c";
  figure.x = {"travel, mm", 0.0, 16.0, 4.0, 0};
  figure.y = {"force, N", 0.0, 0.2, 0.05, 2};
  figure.values.push_back({"printed",
                           {8.0, 30.0},
                           {0.1, 0.1},
                           {0.05, 0.05},
                           {0.15, 0.15},
                           ink::black,
                           MarkerShape::disk});
  return figure;
}

int count(const std::string& text, const std::string& part)
{
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(Figure, EscapesWhatSvgDoesNotTakeAsText)
{
  const std::string text = svg(draw(someFigure()));
  EXPECT_THAT(text, HasSubstr("a &lt; b &amp; c"));
  EXPECT_THAT(text, Not(HasSubstr("a < b")));
}

TEST(Figure, LeavesOutWhatLiesBesideItsAxis)
{
  // one disk for the value at 8 mm and one in the legend; 30 mm is outside the axis
  EXPECT_EQ(count(svg(draw(someFigure())), "<circle"), 2);
}

TEST(Figure, BreaksALongNoteBetweenWordsBeforeThePageEnds)
{
  Figure figure = someFigure();
  const std::string note =
      "Insertions that did not finish are not drawn: 12 buckled in front of the opening, "
      "903 finished, 61 stopped by resistance, 4 slipped out of the opening, 20 jammed at 2 N.";
  const double heightWithout = draw(figure).height;
  figure.notes.push_back(note);
  const Drawing page = draw(figure);

  std::string together;
  int lines = 0;
  for (const Mark& mark : page.marks) {
    const Label* label = std::get_if<Label>(&mark);
    if (label == nullptr || note.find(label->text) == std::string::npos) continue;
    if (label->anchor != Anchor::start || label->at.y < heightWithout - 10.0) continue;
    together += (together.empty() ? "" : " ") + label->text;
    ++lines;
    // A sentence in DejaVu Sans, the widest typeface in use, has 0.51 of its size a letter.
    EXPECT_LT(label->at.x + 0.51 * label->size * static_cast<double>(label->text.size()),
              page.width);
    EXPECT_LT(label->at.y, page.height);
  }
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(together, note);
}

TEST(Figure, DrawsNothingBetweenSingleValues)
{
  Figure figure = someFigure();
  figure.values.front().label.clear();
  const int frame = count(svg(draw(figure)), "<polyline");
  figure.values.front().x = {8.0,
                             12.0};  // now both are inside: three more strokes, their error bar
  EXPECT_EQ(count(svg(draw(figure)), "<polyline"), frame + 3);
}

TEST(Figure, SaysTheUnitsOfItsAxes)
{
  const std::string text = svg(draw(someFigure()));
  EXPECT_THAT(text, HasSubstr("travel, mm"));
  EXPECT_THAT(text, HasSubstr("force, N"));
}

TEST(FigureAxis, HoldsItsRangeWithRoundTicks)
{
  for (const auto& [low, high] : {std::pair{-0.06, 0.043}, {0.0, 612.0}, {0.2, 0.21}}) {
    const FigureAxis axis = axisOver("a", low, high);
    EXPECT_LE(axis.low, low + 1e-12);
    EXPECT_GE(axis.high, high - 1e-12);
    const double ticks = (axis.high - axis.low) / axis.tick;
    EXPECT_GE(ticks, 3.0);
    EXPECT_LE(ticks, 10.0);
  }
}

}  // namespace
}  // namespace perilymph::figures
