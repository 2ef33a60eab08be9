// SPDX-License-Identifier: BSD-3-Clause

// The picture of a measurement shows the lumen dark within the drawn wall.

#include "perilymph/imaging/MeasuredPicture.h"

#include <gmock/gmock.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <array>
#include <memory>

#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

class APictureOfAMeasurement : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    auto phantom = test::makeCtPhantom(203, test::highResolutionScan());
    ct::MeasureRequest request;
    request.click_P = phantom.inside_P;
    auto measures = ct::measureCochlea(phantom.volume, request);
    ASSERT_TRUE(measures) << measures.error().message;
    measures_ = std::make_unique<ct::CochleaMeasures>(*std::move(measures));
    volume_ = std::make_shared<const ct::CtVolume>(std::move(phantom.volume));
  }

  static inline std::unique_ptr<ct::CochleaMeasures> measures_;
  static inline std::shared_ptr<const ct::CtVolume> volume_;
};

TEST_F(APictureOfAMeasurement, ShowsThreeViewsWithTheWallInItsColor)
{
  const test::TemporaryFolder folder;
  const auto done = writeMeasuredPicture(volume_, *measures_, folder / "ear.png");
  ASSERT_TRUE(done) << done.error().message;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((folder / "ear.png").c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  ASSERT_EQ(image.GetDimensions()[0], 1536);
  ASSERT_EQ(image.GetDimensions()[1], 512);
  // the wall's green in each view
  std::array<int, 3> green{};
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 1536; ++x) {
      const auto* const p = static_cast<const unsigned char*>(image.GetScalarPointer(x, y, 0));
      green[static_cast<std::size_t>(x / 512)] += p[1] > p[0] + 60 ? 1 : 0;
    }
  for (const int count : green) EXPECT_GT(count, 300);
}

TEST_F(APictureOfAMeasurement, IsWrittenAsPngOnly)
{
  const test::TemporaryFolder folder;
  const auto done = writeMeasuredPicture(volume_, *measures_, folder / "ear.jpg");
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, testing::HasSubstr(".png"));
}

}  // namespace
}  // namespace perilymph::imaging
