// SPDX-License-Identifier: BSD-3-Clause
#include "LaboratoryPeer.h"

#include <stdexcept>

#include "perilymph/test/Places.h"

namespace perilymph::test {

std::vector<LaboratoryDevice> laboratoryDevices()
{
  return {
#ifdef PERILYMPH_HAS_FTDI
      // A count turns a thigh by 0.036 degrees, which is 0.038 mm at its 60 mm; a motor value is
      // 0.1 mN m, 1.7 mN there.
      {"Falcon", "laboratory_falcon", "Novint Falcon", 8.0, 4e-5, 4e-3,
       "No Novint Falcon can be opened"},
#endif
      {"Inverse3", "laboratory_inverse3", "Haply Inverse3", 3.0, 1e-9, 1e-9, "finds no Inverse3"},
      {"Touch", "laboratory_touch", "3D Systems Touch", 3.3, 1e-9, 1e-9,
       "device of 3D Systems cannot be opened"},
      {"Omega", "laboratory_omega", "Force Dimension omega", 12.0, 1e-9, 1e-9,
       "No device of Force Dimension can be opened"},
  };
}

LaboratoryPeer::LaboratoryPeer(const LaboratoryDevice& device) : device_(device)
{
  const std::string path = folder_ / "peer";
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  const bool isSized = file >= 0 && ::ftruncate(file, sizeof(PeerState)) == 0;
  void* const place =
      isSized ? ::mmap(nullptr, sizeof(PeerState), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0)
              : MAP_FAILED;
  ::close(file);
  if (place == MAP_FAILED) throw std::runtime_error("No memory can be shared.");
  state_ = new (place) PeerState;
  ::setenv(peerVariable, path.c_str(), 1);
  if (std::string(device.name) != "Inverse3") return;
  service_ = std::make_unique<InverseService>(*state_);
  ::setenv("PERILYMPH_HAPLY_SERVICE", ("127.0.0.1:" + std::to_string(service_->port())).c_str(), 1);
}

LaboratoryPeer::~LaboratoryPeer()
{
  service_.reset();
  ::unsetenv(peerVariable);
  ::munmap(state_, sizeof *state_);
}

std::filesystem::path LaboratoryPeer::library() const { return testPlugin(device_.library); }

double LaboratoryPeer::force() const
{
  return std::hypot(state_->force[0], state_->force[1], state_->force[2]);
}

void LaboratoryPeer::moveHand(const Vector3& place_D)
{
  for (std::size_t i = 0; i < 3; ++i) state_->hand[i] = place_D[i];
}

}  // namespace perilymph::test
