// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <igtlCapabilityMessage.h>
#include <igtlImageMessage.h>
#include <igtlPointMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlSensorMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTimeStamp.h>
#include <igtlTransformMessage.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "perilymph/foundation/Units.h"

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

Eigen::Vector3d vectorOf(const std::array<double, 3>& numbers)
{
  return {numbers[0], numbers[1], numbers[2]};
}

/// A point and a vector of W in the frame that is sent.
Eigen::Vector3d point(const std::optional<Placement>& patient, const std::array<double, 3>& place_W)
{
  return patient ? pointIn(*patient, vectorOf(place_W)) : vectorOf(place_W);
}
Eigen::Vector3d direction(const std::optional<Placement>& patient,
                          const std::array<double, 3>& vector_W)
{
  return patient ? directionIn(*patient, vectorOf(vector_W)) : vectorOf(vector_W);
}

/// @param axes  As columns. @param place  As numbers of the message, which are millimeters for a place.
igtl::TransformMessage::Pointer transform(const Eigen::Matrix3d& axes, const Eigen::Vector3d& place)
{
  auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix[row][column] = static_cast<float>(axes(row, column));
    matrix[row][3] = static_cast<float>(place[row]);
    matrix[3][row] = 0.0f;
  }
  matrix[3][3] = 1.0f;
  message->SetMatrix(matrix);
  return message;
}

igtl::TransformMessage::Pointer transform(const Pose& pose, const std::optional<Placement>& patient)
{
  Eigen::Matrix3d axes;
  axes.col(0) = direction(patient, pose.axis_W[0]);
  axes.col(2) = direction(patient, pose.axis_W[2]);
  // Right-handed in a left ear, too: only z has a meaning.
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return transform(axes, 1e3 * point(patient, pose.place_W));
}

Coordinates coordinatesOf(const BroadcastFrame& frame)
{
  return frame.patient ? Coordinates::patient : Coordinates::cochlea;
}

igtl::PointMessage::Pointer contacts(const BroadcastFrame& frame)
{
  constexpr float radius = 0.25f;  // for display [mm]
  auto message = igtl::PointMessage::New();
  for (std::uint32_t i = 0; i < frame.contacts; ++i) {
    const Eigen::Vector3d place = point(frame.patient, frame.contact_W[i]);
    auto element = igtl::PointElement::New();
    element->SetName(("E" + std::to_string(i + 1)).c_str());
    element->SetGroupName("Contact");
    element->SetRGBA(255, 190, 60, 255);
    element->SetPosition(millimeters(place[0]), millimeters(place[1]), millimeters(place[2]));
    element->SetRadius(radius);
    // The field names what the coordinates refer to: not the tip, but the frame.
    element->SetOwner(nameOf(coordinatesOf(frame)));
    message->AddPointElement(element);
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
  const Eigen::Vector3d force = direction(frame.patient, frame.force_W);
  for (unsigned int i = 0; i < 3; ++i) message->SetValue(i, force[i]);
  message->SetValue(3, frame.axialForce);
  return message;
}

void addLine(std::string& text, const char* name, double value)
{
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(name).append("=").append(digits.data(), end).append("\n");
}

bool isMirrored(const Placement& placement)
{
  const auto& [x, y, z] = placement.axis_R;
  return vectorOf(x).cross(vectorOf(y)).dot(vectorOf(z)) < 0.0;
}

/// A message of its own.
Bytes packed(igtl::MessageBase& message, const char* name)
{
  Bytes bytes;
  auto now = timeNow();
  append(bytes, message, name, now);
  return bytes;
}

}  // namespace

std::string readoutText(const BroadcastFrame& frame)
{
  if (!frame.isShown) return "patient=unknown\n";
  const Eigen::Vector3d force = direction(frame.patient, frame.force_W);
  std::string text;
  addLine(text, "time_s", frame.time);
  addLine(text, "travel_mm", frame.travel * 1e3);
  addLine(text, "depth_mm", frame.depth * 1e3);
  addLine(text, "tip_angle_deg", inDegrees(radians(frame.tipAngle)));
  addLine(text, "force_axial_N", frame.axialForce);
  addLine(text, "force_x_N", force.x());
  addLine(text, "force_y_N", force.y());
  addLine(text, "force_z_N", force.z());
  text.append("coordinates=").append(nameOf(coordinatesOf(frame))).append("\n");
  return text.append("patient=").append(frame.isPlaced ? "known" : "unknown").append("\n");
}

Bytes frameMessages(const BroadcastFrame& frame)
{
  Bytes bytes;
  auto now = timeNow();
  auto readout = igtl::StringMessage::New();
  readout->SetString(readoutText(frame).c_str());
  if (!frame.isShown) return packed(*readout, readoutName);
  append(bytes, *transform(frame.tip, frame.patient), tipName, now);
  append(bytes, *transform(frame.tweezers, frame.patient), tweezersName, now);
  append(bytes, *contacts(frame), contactsName, now);
  append(bytes, *force(frame), forceName, now);
  append(bytes, *transform(Eigen::Matrix3d::Identity(), direction(frame.patient, frame.force_W)),
         forceVectorName, now);
  append(bytes, *readout, readoutName, now);
  return bytes;
}

Bytes placementMessage(const Placement& placement)
{
  Eigen::Matrix3d axes;
  for (std::size_t i = 0; i < 3; ++i)
    axes.col(static_cast<Eigen::Index>(i)) = vectorOf(placement.axis_R[i]);
  return packed(*transform(axes, 1e3 * vectorOf(placement.origin_R)), toPatientName);
}

Bytes surfaceMessage(const anatomy::Surface& surface, const char* name,
                     const std::optional<Placement>& patient)
{
  auto points = igtl::PolyDataPointArray::New();
  for (const auto& place_W : surface.points) {
    const Eigen::Vector3d place = point(patient, place_W);
    points->AddPoint(millimeters(place[0]), millimeters(place[1]), millimeters(place[2]));
  }
  // The corners are counterclockwise seen from outside, behind a mirror, too.
  const bool isTurned = patient && isMirrored(*patient);
  auto triangles = igtl::PolyDataCellArray::New();
  for (const auto& corners : surface.triangles) {
    std::array<igtlUint32, 3> cell{};
    for (std::size_t i = 0; i < 3; ++i) cell[i] = static_cast<igtlUint32>(corners[i]);
    if (isTurned) std::swap(cell[1], cell[2]);
    triangles->AddCell(3, cell.data());
  }
  auto message = igtl::PolyDataMessage::New();
  message->SetPoints(points);
  message->SetPolygons(triangles);
  // Empty arrays, since some receivers read all of them.
  message->SetVertices(igtl::PolyDataCellArray::New());
  message->SetLines(igtl::PolyDataCellArray::New());
  message->SetTriangleStrips(igtl::PolyDataCellArray::New());
  return packed(*message, name);
}

Bytes imageMessage(const ct::CtVolume& volume, const Eigen::Matrix4d& placed_SI)
{
  const auto [i, j, k] = volume.size();
  const Eigen::Vector3d spacing_mm = volume.spacing_mm();
  auto message = igtl::ImageMessage::New();
  message->SetDimensions(i, j, k);
  message->SetSpacing(static_cast<float>(spacing_mm[0]), static_cast<float>(spacing_mm[1]),
                      static_cast<float>(spacing_mm[2]));
  // The protocol's origin is the center of the image, not its first voxel.
  const Eigen::Vector4d center =
      placed_SI * Eigen::Vector4d(0.5 * (i - 1), 0.5 * (j - 1), 0.5 * (k - 1), 1.0);
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      matrix[row][column] = static_cast<float>(placed_SI(row, column) / spacing_mm[column]);
    matrix[row][3] = static_cast<float>(center[row]);
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
  return packed(*message, ctName);
}

Bytes capabilityMessage()
{
  auto message = igtl::CapabilityMessage::New();
  std::vector<std::string> types{"TRANSFORM", "POINT", "SENSOR", "STRING",
                                 "POLYDATA",  "IMAGE", "STATUS", "CAPABILITY"};
  message->SetTypes(types);
  return packed(*message, programName);
}

Bytes statusMessage(const std::string& device, std::uint16_t code, const std::string& sentence)
{
  auto message = igtl::StatusMessage::New();
  message->SetCode(code);
  message->SetSubCode(0);
  message->SetErrorName(code == igtl::StatusMessage::STATUS_OK ? "OK" : "Not sent");
  message->SetStatusString(sentence.c_str());
  return packed(*message, device.empty() ? programName : device.c_str());
}

}  // namespace perilymph::broadcast
