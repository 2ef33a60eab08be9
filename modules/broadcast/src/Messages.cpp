// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <igtlCapabilityMessage.h>
#include <igtlImageMessage.h>
#include <igtlPointMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlSensorMessage.h>
#include <igtlTimeStamp.h>
#include <igtlTransformMessage.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace perilymph::broadcast {

namespace {

float millimeters(double meters) { return static_cast<float>(meters * 1e3); }

void append(Bytes& bytes, igtl::MessageBase& message, const char* name,
            igtl::TimeStamp::Pointer& now)
{
  message.SetDeviceName(name);
  message.SetTimeStamp(now);
  message.Pack();
  const auto* const begin = static_cast<const std::uint8_t*>(message.GetPackPointer());
  bytes.insert(bytes.end(), begin, begin + message.GetPackSize());
}

igtl::TimeStamp::Pointer timeNow()
{
  auto now = igtl::TimeStamp::New();
  now->GetTime();
  return now;
}

igtl::TransformMessage::Pointer transform(const Pose& pose)
{
  auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      matrix[row][column] = static_cast<float>(pose.axis_W[column][row]);
    matrix[row][3] = millimeters(pose.place_W[row]);
    matrix[3][row] = 0.0f;
  }
  matrix[3][3] = 1.0f;
  message->SetMatrix(matrix);
  return message;
}

igtl::PointMessage::Pointer contacts(const BroadcastFrame& frame)
{
  constexpr float radius = 0.25f;  // for display [mm]
  auto message = igtl::PointMessage::New();
  for (std::uint32_t i = 0; i < frame.contacts; ++i) {
    const auto& place = frame.contact_W[i];
    auto point = igtl::PointElement::New();
    point->SetName(("E" + std::to_string(i + 1)).c_str());
    point->SetGroupName("Contact");
    point->SetRGBA(255, 190, 60, 255);
    point->SetPosition(millimeters(place[0]), millimeters(place[1]), millimeters(place[2]));
    point->SetRadius(radius);
    point->SetOwner(tipName);
    message->AddPointElement(point);
  }
  return message;
}

igtl::SensorMessage::Pointer force(const BroadcastFrame& frame)
{
  auto message = igtl::SensorMessage::New();
  auto unit = igtl::Unit::New();
  unit->Append(igtl::Unit::SI_DERIVED_NEWTON, 1);
  message->SetLength(4);
  message->SetUnit(unit);
  for (unsigned int i = 0; i < 3; ++i) message->SetValue(i, frame.force_W[i]);
  message->SetValue(3, frame.axialForce);
  return message;
}

}  // namespace

Bytes frameMessages(const BroadcastFrame& frame)
{
  Bytes bytes;
  auto now = timeNow();
  append(bytes, *transform(frame.tip), tipName, now);
  append(bytes, *transform(frame.tweezers), tweezersName, now);
  append(bytes, *contacts(frame), contactsName, now);
  append(bytes, *force(frame), forceName, now);
  return bytes;
}

Bytes surfaceMessage(const anatomy::Surface& surface, const char* name)
{
  auto points = igtl::PolyDataPointArray::New();
  for (const auto& place : surface.points)
    points->AddPoint(millimeters(place[0]), millimeters(place[1]), millimeters(place[2]));
  auto triangles = igtl::PolyDataCellArray::New();
  for (const auto& corners : surface.triangles) {
    std::array<igtlUint32, 3> cell{};
    for (std::size_t i = 0; i < 3; ++i) cell[i] = static_cast<igtlUint32>(corners[i]);
    triangles->AddCell(3, cell.data());
  }
  auto message = igtl::PolyDataMessage::New();
  message->SetPoints(points);
  message->SetPolygons(triangles);
  // Empty arrays, since some receivers read all of them.
  message->SetVertices(igtl::PolyDataCellArray::New());
  message->SetLines(igtl::PolyDataCellArray::New());
  message->SetTriangleStrips(igtl::PolyDataCellArray::New());
  Bytes bytes;
  auto now = timeNow();
  append(bytes, *message, name, now);
  return bytes;
}

Bytes imageMessage(const ct::CtVolume& volume, const Eigen::Matrix4d& placed_WI)
{
  const auto [i, j, k] = volume.size();
  const Eigen::Vector3d spacing_mm = volume.spacing_mm();
  auto message = igtl::ImageMessage::New();
  message->SetDimensions(i, j, k);
  message->SetSpacing(static_cast<float>(spacing_mm[0]), static_cast<float>(spacing_mm[1]),
                      static_cast<float>(spacing_mm[2]));
  // The protocol's origin is the center of the image, not its first voxel.
  const Eigen::Vector4d center_W =
      placed_WI * Eigen::Vector4d(0.5 * (i - 1), 0.5 * (j - 1), 0.5 * (k - 1), 1.0);
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix[row][column] = static_cast<float>(placed_WI(row, column) / spacing_mm[column]);
    matrix[row][3] = static_cast<float>(center_W[row]);
  }
  message->SetMatrix(matrix);
  message->SetCoordinateSystem(igtl::ImageMessage::COORDINATE_RAS);
  message->SetScalarTypeToInt16();
  message->SetNumComponents(1);
  message->SetEndian(std::endian::native == std::endian::little ? igtl::ImageMessage::ENDIAN_LITTLE
                                                                : igtl::ImageMessage::ENDIAN_BIG);
  message->AllocateScalars();
  std::ranges::transform(volume.voxels(), static_cast<std::int16_t*>(message->GetScalarPointer()),
                         ct::asAir);
  Bytes bytes;
  auto now = timeNow();
  append(bytes, *message, ctName, now);
  return bytes;
}

Bytes capabilityMessage()
{
  auto message = igtl::CapabilityMessage::New();
  std::vector<std::string> types{"TRANSFORM", "POINT", "SENSOR", "POLYDATA", "IMAGE", "CAPABILITY"};
  message->SetTypes(types);
  Bytes bytes;
  auto now = timeNow();
  append(bytes, *message, "Perilymph", now);
  return bytes;
}

}  // namespace perilymph::broadcast
