// SPDX-License-Identifier: BSD-3-Clause

// Bullet's contact test of a sphere and a fixed mesh: the deepest contact, in single precision; a
// wall outside the sphere is found up to a threshold.

#include <btBulletCollisionCommon.h>

#include <limits>

#include "Peer.h"

namespace {

using namespace perilymph;

constexpr double radius_mm = 1e3 * bench::sphereRadius;

/// Keeps the minimum distance of all contacts.
struct Deepest : btCollisionWorld::ContactResultCallback {
  btScalar distance = std::numeric_limits<btScalar>::max();
  btScalar addSingleResult(btManifoldPoint& contact, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override
  {
    btSetMin(distance, contact.getDistance());
    return 0;
  }
};

class BulletPeer {
public:
  explicit BulletPeer(const anatomy::Surface& wall_mm)
      : mesh_(copy(wall_mm)),
        wallShape_(&mesh_, true),
        sphereShape_(static_cast<btScalar>(radius_mm)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_)
  {
    wallShape_.setMargin(0);
    wall_.setCollisionShape(&wallShape_);
    sphere_.setCollisionShape(&sphereShape_);
  }

  double distance(const Eigen::Vector3d& center_mm)
  {
    btTransform place = btTransform::getIdentity();
    place.setOrigin({static_cast<btScalar>(center_mm.x()), static_cast<btScalar>(center_mm.y()),
                     static_cast<btScalar>(center_mm.z())});
    sphere_.setWorldTransform(place);
    Deepest deepest;
    deepest.m_closestDistanceThreshold = static_cast<btScalar>(1e3 * bench::reach - radius_mm);
    world_.contactPairTest(&sphere_, &wall_, deepest);
    if (deepest.distance == std::numeric_limits<btScalar>::max()) return -1.0;
    return radius_mm + static_cast<double>(deepest.distance);
  }

private:
  static btTriangleMesh copy(const anatomy::Surface& wall_mm)
  {
    btTriangleMesh mesh(true, false);
    const auto corner = [&wall_mm](int index) {
      const auto& point = wall_mm.points[static_cast<std::size_t>(index)];
      return btVector3(static_cast<btScalar>(point[0]), static_cast<btScalar>(point[1]),
                       static_cast<btScalar>(point[2]));
    };
    for (const auto& each : wall_mm.triangles)
      mesh.addTriangle(corner(each[0]), corner(each[1]), corner(each[2]));
    return mesh;
  }

  btTriangleMesh mesh_;
  btBvhTriangleMeshShape wallShape_;
  btSphereShape sphereShape_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  btCollisionObject wall_, sphere_;
};

BENCHMARK(bench::nearestWallBy<BulletPeer>)->Name("lumen/bullet")->Apply(bench::sizes);

}  // namespace
