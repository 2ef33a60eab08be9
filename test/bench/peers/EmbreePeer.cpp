// SPDX-License-Identifier: BSD-3-Clause

// Embree's point query: the nearest triangle in a tree for rays, in single precision.

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <type_traits>

#include "Peer.h"
#include "perilymph/anatomy/SurfaceDistance.h"

namespace {

using namespace perilymph;

class EmbreePeer {
public:
  explicit EmbreePeer(const anatomy::Surface& wall_mm)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get()))
  {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    points_ = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                          RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                          wall_mm.points.size()));
    corners_ = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), wall_mm.triangles.size()));
    float* point = points_;
    for (const auto& each : wall_mm.points)
      for (const double coordinate : each) *point++ = static_cast<float>(coordinate);
    unsigned* corner = corners_;
    for (const auto& each : wall_mm.triangles)
      for (const int index : each) *corner++ = static_cast<unsigned>(index);
    rtcSetGeometryPointQueryFunction(geometry, shrinkTo);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
  }

  double distance(const Eigen::Vector3d& center_mm)
  {
    RTCPointQuery query{static_cast<float>(center_mm.x()), static_cast<float>(center_mm.y()),
                        static_cast<float>(center_mm.z()), 0.0F,
                        static_cast<float>(1e3 * bench::reach)};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    nearest_ = -1.0;
    rtcPointQuery(scene_.get(), &query, &context, nullptr, this);
    return nearest_;
  }

private:
  /// Embree calls this for each triangle that may be nearer; its distance reduces the search
  /// radius.
  static bool shrinkTo(RTCPointQueryFunctionArguments* asked)
  {
    auto& self = *static_cast<EmbreePeer*>(asked->userPtr);
    const unsigned* corner = self.corners_ + 3UL * asked->primID;
    const Eigen::Vector3d center(asked->query->x, asked->query->y, asked->query->z);
    const Eigen::Vector3d a = self.point(corner[0]);
    const Eigen::Vector3d b = self.point(corner[1]);
    const Eigen::Vector3d c = self.point(corner[2]);
    const Eigen::Vector3d weights = anatomy::barycentricWeights(center, a, b, c);
    const Eigen::Vector3d foot = weights.x() * a + weights.y() * b + weights.z() * c;
    const double distance = (center - foot).norm();
    if (distance >= asked->query->radius) return false;
    self.nearest_ = distance;
    asked->query->radius = static_cast<float>(distance);
    return true;
  }
  Eigen::Vector3d point(unsigned index) const
  {
    return Eigen::Map<const Eigen::Vector3f>(points_ + 3UL * index).cast<double>();
  }

  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
  float* points_ = nullptr;      ///< Owned by the geometry.
  unsigned* corners_ = nullptr;  ///< Owned by the geometry.
  double nearest_ = -1.0;        ///< [mm]
};

BENCHMARK(bench::nearestWallBy<EmbreePeer>)->Name("lumen/embree")->Apply(bench::sizes);

}  // namespace
