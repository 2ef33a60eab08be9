// SPDX-License-Identifier: BSD-3-Clause

// The lumen as a segmentation and the picture as a secondary capture, read again by DCMTK, dciodvfy and pydicom. Whether a
// voxel lies in the lumen is asked a second time by rays in a direction that is none of the voxels'.

#include "perilymph/archive/Segmentation.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <set>

#include "SmallStudy.h"
#include "perilymph/archive/MeasuredObjects.h"
#include "perilymph/archive/Query.h"
#include "perilymph/archive/SecondaryCapture.h"
#include "perilymph/archive/Send.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomServers.h"

namespace perilymph::archive {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using testing::HasSubstr;
using testing::Not;

/// A segmentation as its file states it, without the program's own reader.
struct ReadBack {
  struct Frame {
    Vector3d origin;
    std::vector<bool> pixels;  // row by row
    std::string source;        // instance UID
  };
  int rows = 0, columns = 0;
  Vector3d across, down;  // steps from pixel to pixel [mm]
  std::vector<Frame> frames;
  std::string frameOfReference;

  Vector3d center(const Frame& frame, int row, int column) const
  {
    return frame.origin + column * across + row * down;
  }
};

double number(DcmItem& item, const DcmTagKey& tag, unsigned long index)
{
  Float64 value = 0.0;
  EXPECT_TRUE(item.findAndGetFloat64(tag, value, index).good());
  return value;
}

ReadBack readBack(const fs::path& file)
{
  ReadBack back;
  DcmFileFormat format;
  EXPECT_TRUE(format.loadFile(file.c_str()).good());
  DcmDataset& data = *format.getDataset();
  Uint16 rows = 0, columns = 0;
  data.findAndGetUint16(DCM_Rows, rows);
  data.findAndGetUint16(DCM_Columns, columns);
  back.rows = rows;
  back.columns = columns;
  OFString text;
  data.findAndGetOFString(DCM_FrameOfReferenceUID, text);
  back.frameOfReference = text.c_str();
  DcmItem *shared = nullptr, *orientation = nullptr, *measures = nullptr;
  data.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared);
  shared->findAndGetSequenceItem(DCM_PlaneOrientationSequence, orientation);
  shared->findAndGetSequenceItem(DCM_PixelMeasuresSequence, measures);
  for (unsigned long i = 0; i < 3; ++i) {
    back.across[long(i)] = number(*orientation, DCM_ImageOrientationPatient, i) *
                           number(*measures, DCM_PixelSpacing, 1);
    back.down[long(i)] = number(*orientation, DCM_ImageOrientationPatient, i + 3) *
                         number(*measures, DCM_PixelSpacing, 0);
  }
  const Uint8* bytes = nullptr;
  unsigned long count = 0;
  data.findAndGetUint8Array(DCM_PixelData, bytes, &count);
  Sint32 frames = 0;
  data.findAndGetSint32(DCM_NumberOfFrames, frames);
  const std::size_t size = std::size_t(rows) * columns;
  EXPECT_GE(8 * count, size * std::size_t(frames));
  for (Sint32 k = 0; k < frames; ++k) {
    ReadBack::Frame frame;
    DcmItem *own = nullptr, *position = nullptr, *derivation = nullptr, *source = nullptr;
    data.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, own, k);
    own->findAndGetSequenceItem(DCM_PlanePositionSequence, position);
    for (unsigned long i = 0; i < 3; ++i)
      frame.origin[long(i)] = number(*position, DCM_ImagePositionPatient, i);
    own->findAndGetSequenceItem(DCM_DerivationImageSequence, derivation);
    derivation->findAndGetSequenceItem(DCM_SourceImageSequence, source);
    source->findAndGetOFString(DCM_ReferencedSOPInstanceUID, text);
    frame.source = text.c_str();
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t bit =
          std::size_t(k) * size + i;  // PS3.5 8.1.1: packed, the lowest bit first
      frame.pixels.push_back((bytes[bit / 8] >> bit % 8 & 1) != 0);
    }
    back.frames.push_back(std::move(frame));
  }
  return back;
}

/// A closed surface, asked by rays.
class Solid {
public:
  explicit Solid(const Lumen& lumen)
  {
    const std::size_t n = lumen.pointsPerRing;
    const auto at = [&](std::size_t ring, std::size_t k) {
      const auto& p = lumen.points_mm[ring * n + k % n];
      return Vector3d(p[0], p[1], p[2]);
    };
    const std::size_t rings = lumen.points_mm.size() / n;
    for (std::size_t ring = 0; ring + 1 < rings; ++ring)
      for (std::size_t k = 0; k < n; ++k) {
        triangles_.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k)});
        triangles_.push_back({at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)});
      }
    for (const std::size_t ring : {std::size_t{0}, rings - 1}) {
      Vector3d middle = Vector3d::Zero();
      for (std::size_t k = 0; k < n; ++k) middle += at(ring, k) / double(n);
      for (std::size_t k = 0; k < n; ++k)
        triangles_.push_back({ring == 0 ? at(ring, k + 1) : at(ring, k),
                              ring == 0 ? at(ring, k) : at(ring, k + 1), middle});
    }
  }

  /// How often the surface winds around a point: signed crossings of a ray (Möller and Trumbore 1997).
  int winding(const Vector3d& point) const
  {
    const Vector3d ray = Vector3d(0.5377, -0.6314, 0.5587).normalized();
    int count = 0;
    for (const auto& [a, b, c] : triangles_) {
      const Vector3d ab = b - a, ac = c - a, h = ray.cross(ac);
      const double determinant = ab.dot(h);
      if (std::fabs(determinant) < 1e-14) continue;
      const Vector3d s = point - a;
      const double u = s.dot(h) / determinant;
      if (u < 0.0 || u > 1.0) continue;
      const Vector3d q = s.cross(ab);
      const double v = ray.dot(q) / determinant;
      if (v < 0.0 || u + v > 1.0) continue;
      if (ac.dot(q) / determinant > 0.0) count += determinant > 0.0 ? 1 : -1;
    }
    return count;
  }

private:
  std::vector<std::array<Vector3d, 3>> triangles_;
};

/// Compares every voxel of the volume within reach of the lumen. @return How many lie in it.
int compare(const ReadBack& back, const Lumen& lumen, const ct::CtVolume& volume)
{
  const Solid solid(lumen);
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (const auto& p : lumen.points_mm) {
    low = low.cwiseMin(Vector3d(p[0], p[1], p[2]));
    high = high.cwiseMax(Vector3d(p[0], p[1], p[2]));
  }
  int inside = 0, wrong = 0;
  for (int k = 0; k < volume.size()[2]; ++k) {
    const Vector3d origin = volume.toLps({0.0, 0.0, double(k)});
    const ReadBack::Frame* frame = nullptr;
    for (const ReadBack::Frame& each : back.frames)
      if ((each.origin - origin).norm() < 1e-3) frame = &each;
    for (int j = 0; j < volume.size()[1]; ++j)
      for (int i = 0; i < volume.size()[0]; ++i) {
        const Vector3d place = volume.toLps({double(i), double(j), double(k)});
        if (((place - low).array() < -0.5).any() || ((place - high).array() > 0.5).any()) {
          const bool isMarked =
              frame != nullptr && frame->pixels[std::size_t(j * volume.size()[0] + i)];
          wrong += isMarked ? 1 : 0;
          continue;
        }
        const bool isInside = solid.winding(place) != 0;
        const bool isMarked =
            frame != nullptr && frame->pixels[std::size_t(j * volume.size()[0] + i)];
        inside += isInside ? 1 : 0;
        wrong += isInside != isMarked ? 1 : 0;
        if (frame != nullptr) {
          EXPECT_LT((back.center(*frame, j, i) - place).norm(), 1e-3);
        }
      }
  }
  EXPECT_EQ(wrong, 0);
  return inside;
}

/// A tube of radius `radius` along two turns of a spiral about the center of a volume, whose turns touch.
Lumen spiral(const Vector3d& center, double radius)
{
  Lumen lumen;
  constexpr int around = 16, perTurn = 90, turns = 2;
  lumen.pointsPerRing = around;
  for (int ring = 0; ring <= turns * perTurn; ++ring) {
    const double t = 2.0 * M_PI * ring / perTurn;
    const double distance = 2.2 - 0.9 * ring / (turns * perTurn);
    const Vector3d outward(std::cos(t), std::sin(t), 0.0);
    const Vector3d middle =
        center + distance * outward + Vector3d(0.0, 0.0, 0.9 * t / (2.0 * M_PI));
    for (int k = 0; k < around; ++k) {
      const double phi = 2.0 * M_PI * k / around;
      const Vector3d p =
          middle + radius * (std::cos(phi) * outward + std::sin(phi) * Vector3d::UnitZ());
      lumen.points_mm.push_back({p.x(), p.y(), p.z()});
    }
  }
  lumen.software = "0.3.0+test";
  return lumen;
}

std::string keyIn(const fs::path& ct)
{
  const auto list = imaging::findSeries(ct);
  EXPECT_TRUE(list) << list.error().message;
  return list->series.at(0).key;
}

class LumenOfACochlea : public testing::Test {
protected:
  fs::path ct() const { return folder_ / "ct"; }
  fs::path file() const { return folder_ / "lumen.dcm"; }

  std::string printed(const std::string& program, const std::vector<std::string>& arguments)
  {
    const auto place = test::programOf(program);
    if (!place) return {};
    std::vector<std::string> all = arguments;
    all.push_back(file());
    const auto outcome = test::run({*place, all, {}, {}});
    return outcome.out + outcome.err;
  }

  test::TemporaryFolder folder_;
};

TEST_F(LumenOfACochlea, IsMarkedVoxelByVoxelWhereverTheSlicesLie)
{
  const Eigen::Matrix3d tilted =
      (Eigen::AngleAxisd(0.4, Vector3d::UnitX()) * Eigen::AngleAxisd(0.7, Vector3d::UnitZ()))
          .toRotationMatrix();
  for (const Eigen::Matrix3d& axes : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), tilted}) {
    fs::remove_all(ct());
    const ct::CtVolume volume = imaging::smallCt(axes, Vector3d(0.31, 0.23, 0.4), {28, 36, 20});
    test::writeDicomFiles(test::dicomSlices(volume, ctSeries), ct());
    Lumen lumen = spiral(volume.toLps({14.0, 17.5, 8.0}), 0.55);
    lumen.seriesKey = keyIn(ct());
    const auto written = writeSegmentation(lumen, ct(), file());
    ASSERT_TRUE(written) << written.error().message;
    const ReadBack back = readBack(file());
    EXPECT_EQ(back.frameOfReference, std::string(ctSeries) + ".52");
    const int inside = compare(back, lumen, volume);
    // the tube's volume by Pappus, less what turns share and the polygon's corners
    const double length = 2.0 * 2.0 * M_PI * 1.75, tube = M_PI * 0.55 * 0.55 * length;
    const double voxel = 0.31 * 0.23 * 0.4;
    EXPECT_NEAR(inside * voxel, tube, 0.12 * tube);
    std::set<std::string> sources;
    for (const ReadBack::Frame& frame : back.frames) sources.insert(frame.source);
    EXPECT_EQ(sources.size(), back.frames.size());
  }
}

TEST_F(LumenOfACochlea, IsThatOfTheFit)
{
  const test::CtPhantom phantom = test::makeCtPhantom(3, test::clinicalScan());
  test::writeDicomFiles(test::dicomSlices(phantom.volume, "1.2.3.33"), ct());
  const auto loaded = imaging::readCt(ct());
  ASSERT_TRUE(loaded) << loaded.error().message;
  ct::MeasureRequest request;
  request.click_P = phantom.inside_P;
  const auto measures = ct::measureCochlea(loaded->volume, request);
  ASSERT_TRUE(measures) << measures.error().message;
  const Lumen lumen = lumenOf(*measures);
  EXPECT_EQ(lumen.isRight, phantom.isRight);
  const auto written = writeSegmentation(lumen, ct(), file());
  ASSERT_TRUE(written) << written.error().message;
  const ReadBack back = readBack(file());
  const int inside = compare(back, lumen, loaded->volume);
  const Vector3d step =
      loaded->volume.toLps({1.0, 1.0, 1.0}) - loaded->volume.toLps({0.0, 0.0, 0.0});
  // a cochlea's canals hold some 50 to 150 mm3
  const double volume_mm3 = inside * std::fabs(step.prod());
  EXPECT_GT(volume_mm3, 40.0);
  EXPECT_LT(volume_mm3, 160.0);
  std::printf("%d voxels, %.1f mm3, %zu frames\n", inside, volume_mm3, back.frames.size());
}

TEST_F(LumenOfACochlea, IsReadByOtherPrograms)
{
  test::writeDicomFiles(smallStudy(), ct());
  Lumen lumen = spiral({-29.0, 14.8, -399.9}, 0.5);
  lumen.isRight = true;
  lumen.seriesKey = keyIn(ct());
  const auto written = writeSegmentation(lumen, ct(), file());
  ASSERT_TRUE(written) << written.error().message;
  const std::string said = printed("dciodvfy", {});
  if (!said.empty()) {
    EXPECT_THAT(said, HasSubstr("Segmentation"));
    EXPECT_THAT(said, Not(HasSubstr("Error"))) << said;
  }
  const fs::path script = folder_ / "read.py";
  std::ofstream(script) << R"(
import sys
import pydicom
data = pydicom.dcmread(sys.argv[1])
print(data.Modality, data.PatientID, data.StudyInstanceUID, data.FrameOfReferenceUID, sep="|")
print(str(data.PatientName) == "M\u00fcller^Jane")
one = data.SegmentSequence[0]
print(len(data.SegmentSequence), one.SegmentLabel, one.SegmentedPropertyTypeCodeSequence[0].CodeMeaning,
      one.SegmentedPropertyTypeCodeSequence[0].SegmentedPropertyTypeModifierCodeSequence[0].CodeMeaning,
      one.SegmentAlgorithmType, sep="|")
print(data.pixel_array.shape == (data.NumberOfFrames, 16, 16), data.pixel_array.max(),
      data.pixel_array.any(axis=(1, 2)).all())
print(len(data.ReferencedSeriesSequence[0].ReferencedInstanceSequence) == data.NumberOfFrames)
)";
  const auto read = test::run({"/usr/bin/python3", {script, file()}, {}, {}});
  if (read.err.find("No module named") != std::string::npos)
    GTEST_SKIP() << "Install the packages python3-pydicom and python3-numpy.";
  EXPECT_EQ(read.out, std::string("SEG|MRN-4711|") + ctStudy + "|" + ctSeries +
                          ".52\nTrue\n1|Lumen of the right cochlea|Cochlea|Right|AUTOMATIC\n"
                          "True 1 True\nTrue\n")
      << read.err;
}

TEST_F(LumenOfACochlea, IsRefusedWhereItWouldLieNowhere)
{
  auto files = smallStudy();
  test::writeDicomFiles(files, ct());
  Lumen lumen = spiral({0.0, 0.0, 0.0}, 0.5);
  lumen.seriesKey = keyIn(ct());
  const auto refusal = [&](const Lumen& what) {
    const auto written = writeSegmentation(what, ct(), file());
    return written ? std::string("written") : std::string(written.error().message);
  };
  EXPECT_THAT(refusal(lumen), HasSubstr("lies in no slice"));
  Lumen few = lumen;
  few.points_mm.resize(20);
  EXPECT_THAT(refusal(few), HasSubstr("two whole rings"));
  Lumen other = lumen;
  other.seriesKey[0] = other.seriesKey[0] == '0' ? '1' : '0';
  EXPECT_THAT(refusal(other), HasSubstr("no file of the series that was measured"));
  fs::remove_all(ct());
  for (test::DicomData& each : files) each.setText(0x00200052, "UI", "");
  test::writeDicomFiles(files, ct());
  EXPECT_THAT(refusal(lumen), HasSubstr("no frame of reference"));
  EXPECT_FALSE(fs::exists(file()));
}

SecondaryCapture picture(const std::string& seriesKey)
{
  SecondaryCapture image;
  image.width = 6;
  image.height = 4;
  for (int i = 0; i < 72; ++i) image.rgb.push_back(static_cast<std::uint8_t>(3 * i));
  image.pixel_mm = 1.0 / 32.0;
  image.isRight = true;
  image.description = "Right cochlea";
  image.software = "0.3.0+test";
  image.seriesKey = seriesKey;
  return image;
}

TEST_F(LumenOfACochlea, HasAPictureThatOtherProgramsRead)
{
  test::writeDicomFiles(smallStudy(), ct());
  const auto written = writeSecondaryCapture(picture(keyIn(ct())), ct(), file());
  ASSERT_TRUE(written) << written.error().message;
  const std::string said = printed("dciodvfy", {});
  if (!said.empty()) {
    EXPECT_THAT(said, HasSubstr("SCImage"));
    EXPECT_THAT(said, Not(HasSubstr("Error"))) << said;
  }
  const fs::path script = folder_ / "read.py";
  std::ofstream(script) << R"(
import sys
import pydicom
data = pydicom.dcmread(sys.argv[1])
print(data.SOPClassUID.name, data.PatientID, data.StudyInstanceUID, data.BurnedInAnnotation, sep="|")
print(str(data.PatientName) == "M\u00fcller^Jane", len(data.SourceImageSequence), [float(x) for x in data.PixelSpacing],
      data.Laterality)
print(data.pixel_array.shape, data.pixel_array.ravel().tolist() == [3 * i for i in range(72)])
)";
  const auto read = test::run({"/usr/bin/python3", {script, file()}, {}, {}});
  if (read.err.find("No module named") != std::string::npos)
    GTEST_SKIP() << "Install the packages python3-pydicom and python3-numpy.";
  EXPECT_EQ(read.out, std::string("Secondary Capture Image Storage|MRN-4711|") + ctStudy +
                          "|NO\nTrue 12 [0.03125, 0.03125] R\n(4, 6, 3) True\n")
      << read.err;
  SecondaryCapture cut = picture(keyIn(ct()));
  cut.rgb.pop_back();
  EXPECT_FALSE(writeSecondaryCapture(cut, ct(), file()));
}

TEST_F(LumenOfACochlea, IsSentBesideTheCtUnderANumberOfItsOwn)
{
  if (!test::networkObstacle().empty()) GTEST_SKIP() << test::networkObstacle();
  auto files = smallStudy();
  for (test::DicomData& each : files) each.setText(0x00200011, "IS", "1");
  test::writeDicomFiles(files, ct());
  for (const auto kind : {test::DicomServer::Kind::orthanc, test::DicomServer::Kind::dcmqrscp}) {
    if (!test::missingProgram(kind).empty()) GTEST_SKIP() << test::missingProgram(kind);
    const test::DicomServer server(kind);
    ASSERT_EQ(server.store(ct()), "");
    Lumen lumen = spiral({-29.0, 14.8, -399.9}, 0.5);
    lumen.seriesKey = keyIn(ct());
    ASSERT_TRUE(writeSegmentation(lumen, ct(), file()));
    auto sent = sendObject(server.entry(), file());
    ASSERT_TRUE(sent) << sent.error().message;
    EXPECT_EQ(sent->seriesNumber, "2");
    ASSERT_TRUE(writeSecondaryCapture(picture(lumen.seriesKey), ct(), file()));
    sent = sendObject(server.entry(), file());
    ASSERT_TRUE(sent) << sent.error().message;
    EXPECT_EQ(sent->seriesNumber, "3");
    const auto series = findSeries(server.entry(), ctStudy);
    ASSERT_TRUE(series) << series.error().message;
    std::set<std::string> found;
    for (const FoundSeries& each : series->rows) found.insert(each.number + " " + each.modality);
    EXPECT_EQ(found, (std::set<std::string>{"1 CT", "2 SEG", "3 OT"}));
  }
}

}  // namespace
}  // namespace perilymph::archive
