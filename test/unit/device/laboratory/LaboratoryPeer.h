// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The four devices of laboratories that have a plug-in, each with its substitute.

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "InverseService.h"
#include "PeerState.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// A device, and what is published of it.
struct LaboratoryDevice {
  const char* name;     ///< In names of tests.
  const char* library;  ///< The plug-in, linked with its substitute.
  const char* shown;    ///< Name in the program.
  double maxForce;      ///< [N]
  double quantum;       ///< Error of a position by its sensors [m].
  double forceQuantum;  ///< Error of a force by its motors' values [N].
  const char* absent;   ///< In the sentence if it is not plugged in.
};
inline std::ostream& operator<<(std::ostream& out, const LaboratoryDevice& device)
{
  return out << device.name;
}

/// Those whose libraries this build has.
std::vector<LaboratoryDevice> laboratoryDevices();

/// A substitute in memory that the plug-in's process finds by the environment.
class LaboratoryPeer {
public:
  explicit LaboratoryPeer(const LaboratoryDevice& device);
  ~LaboratoryPeer();
  LaboratoryPeer(const LaboratoryPeer&) = delete;
  LaboratoryPeer& operator=(const LaboratoryPeer&) = delete;

  PeerState& state() { return *state_; }
  std::filesystem::path library() const;
  /// Magnitude of the force on the hand [N].
  double force() const;
  void moveHand(const Vector3& place_D);
  /// The service of the Inverse3; null for other devices.
  InverseService* service() { return service_.get(); }

private:
  TemporaryFolder folder_;
  LaboratoryDevice device_;
  PeerState* state_ = nullptr;
  std::unique_ptr<InverseService> service_;
};

}  // namespace perilymph::test
