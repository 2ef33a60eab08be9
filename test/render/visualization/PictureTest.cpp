// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/visualization/Picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "SceneOnScreen.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::visualization {
namespace {

PictureRequest request(const std::filesystem::path& file)
{
  PictureRequest asked;
  asked.scala = test::publishedScala();
  asked.width = 320;
  asked.height = 240;
  asked.file = file;
  return asked;
}

/// Removes DISPLAY until the end of the test.
class WithoutDisplay {
public:
  WithoutDisplay()
  {
    if (const char* name = std::getenv("DISPLAY")) before_ = name;
    unsetenv("DISPLAY");
  }
  ~WithoutDisplay() { setenv("DISPLAY", before_.c_str(), 1); }

private:
  std::string before_;
};

TEST(Picture, HasTheSizeAskedFor)
{
  const test::TemporaryFolder folder;
  const Result<void> done = renderPicture(request(folder / "scala.png"));
  ASSERT_TRUE(done) << done.error().message;
  const test::DrawnPicture picture = test::load(folder / "scala.png");
  EXPECT_EQ(picture.width, 320);
  EXPECT_EQ(picture.height, 240);
}

TEST(Picture, ShowsTheArrayOfTheSnapshot)
{
  const test::TemporaryFolder folder;
  PictureRequest asked = request(folder / "a.png");
  ASSERT_TRUE(renderPicture(asked));
  const haptics::Snapshot now = test::insertedTo(degrees(200));
  asked.array = test::plainArray();
  asked.now = &now;
  asked.file = folder / "b.png";
  ASSERT_TRUE(renderPicture(asked));
  EXPECT_NE(test::load(folder / "a.png").rgb, test::load(folder / "b.png").rgb);
}

TEST(Picture, StartsADisplayOfItsOwnWhereThereIsNone)
{
  const test::TemporaryFolder folder;
  const WithoutDisplay none;
  EXPECT_FALSE(canRender());
  const Result<void> done = renderPicture(request(folder / "scala.png"));
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_TRUE(std::filesystem::exists(folder / "scala.png"));
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

TEST(Picture, ReplacesADisplayThatDoesNotAnswerAndKeepsItsName)
{
  const test::TemporaryFolder folder;
  const WithoutDisplay none;
  setenv("DISPLAY", ":9999", 1);
  const Result<void> done = renderPicture(request(folder / "scala.png"));
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_STREQ(std::getenv("DISPLAY"), ":9999");
}

TEST(Picture, SaysThatADisplayDoesNotAnswer)
{
  const WithoutDisplay none;
  setenv("DISPLAY", ":9999", 1);
  const Result<void> can = canRender();
  ASSERT_FALSE(can);
  EXPECT_THAT(can.error().message, testing::HasSubstr(":9999"));
}

TEST(Picture, RefusesAnotherFormat)
{
  const test::TemporaryFolder folder;
  const Result<void> done = renderPicture(request(folder / "scala.jpg"));
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, testing::HasSubstr(".png"));
}

TEST(Picture, RefusesASizeThatNoScreenHas)
{
  const test::TemporaryFolder folder;
  PictureRequest asked = request(folder / "scala.png");
  asked.width = 100000;
  const Result<void> done = renderPicture(asked);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, testing::HasSubstr("8192"));
}

TEST(Picture, LeavesNothingBehindWhereItCannotWrite)
{
  const test::TemporaryFolder folder;
  EXPECT_FALSE(renderPicture(request(folder / "no-such-folder" / "scala.png")));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace perilymph::visualization
