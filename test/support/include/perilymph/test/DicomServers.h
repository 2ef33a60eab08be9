// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The DICOM servers of the tests, two implementations: Orthanc, and DCMTK's dcmqrscp.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/archive/Servers.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// Gives this process a network with a loopback alone.
void makeOwnNetwork();
/// Why no server can run here; empty if they can.
const std::string& networkObstacle();

/// Whether a program is there, in PATH or in /usr/sbin.
std::optional<std::string> programOf(const std::string& name);

/// A certificate authority with certificates of a server and a workstation, PEM, of one day.
struct TestCertificates {
  explicit TestCertificates(const std::filesystem::path& folder);
  std::filesystem::path authority, serverCertificate, serverKey, certificate, key;
};

/// A running server.
class DicomServer {
public:
  enum class Kind { orthanc, dcmqrscp };
  /// Starts a server and waits until it answers. @throws std::runtime_error if it does not.
  explicit DicomServer(Kind kind, const TestCertificates* tls = nullptr);

  /// How this program reaches it.
  const archive::Server& entry() const { return entry_; }
  /// Stores files by DCMTK's storescu. @return What it says if it fails.
  std::string store(const std::filesystem::path& folder,
                    const std::vector<std::string>& options = {}) const;
  void stop() { process_.reset(); }

private:
  TemporaryFolder folder_;
  archive::Server entry_;
  std::unique_ptr<ChildProcess> process_;
};

/// The name of a program that a kind of server needs and that is not installed; empty if it is.
std::string missingProgram(DicomServer::Kind kind);

}  // namespace perilymph::test
