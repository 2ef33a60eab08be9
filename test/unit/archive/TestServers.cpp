// SPDX-License-Identifier: BSD-3-Clause
#include "TestServers.h"

#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <stdexcept>

#include "../imaging/SmallCt.h"
#include "perilymph/archive/Echo.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

std::string obstacle;

/// So that DCMTK does not wait 40 ms between the pieces of a message.
const std::pair<std::string, std::optional<std::string>> atOnce = {"TCP_NODELAY", "1"};

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

std::string orthancSettings(const fs::path& folder, const Server& server,
                            const TestCertificates* tls)
{
  const std::string quoted = '"' + (folder / "db").string() + '"';
  std::string text =
      "{ \"Name\": \"TEST\", \"StorageDirectory\": " + quoted + ", \"IndexDirectory\": " + quoted +
      ", \"HttpServerEnabled\": false, \"DicomServerEnabled\": true, \"DicomAet\": \"" +
      server.aeTitle +
      "\", \"DicomCheckCalledAet\": true, \"DicomPort\": " + std::to_string(server.port);
  for (const char* what : {"Echo", "Store", "Find", "Get", "Move"})
    text += std::string(", \"DicomAlwaysAllow") + what + "\": true";
  const std::string isSecure = tls != nullptr ? "true" : "false";
  if (tls != nullptr)
    text += ", \"DicomTlsEnabled\": true, \"DicomTlsCertificate\": \"" +
            tls->serverCertificate.string() + "\", \"DicomTlsPrivateKey\": \"" +
            tls->serverKey.string() + "\", \"DicomTlsTrustedCertificates\": \"" +
            tls->authority.string() + "\"";
  return text + ", \"DicomModalities\": { \"own\": { \"AET\": \"" + server.ownAeTitle +
         "\", \"Host\": \"127.0.0.1\", \"Port\": " + std::to_string(server.ownPort) +
         ", \"UseDicomTls\": " + isSecure + " } } }\n";
}

std::string dcmqrscpSettings(const fs::path& folder, const Server& server)
{
  return "NetworkTCPPort = " + std::to_string(server.port) +
         "\nMaxPDUSize = 16384\nMaxAssociations = 16\nHostTable BEGIN\nown = (" +
         server.ownAeTitle + ", 127.0.0.1, " + std::to_string(server.ownPort) +
         ")\nHostTable END\nVendorTable BEGIN\nVendorTable END\nAETable BEGIN\n" + server.aeTitle +
         " " + (folder / "db").string() + " RW (200, 1024mb) ANY\nAETable END\n";
}

}  // namespace

void makeOwnNetwork()
{
  const auto user = ::geteuid();
  if (::unshare(user == 0 ? CLONE_NEWNET : CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    obstacle = "This machine allows no network of a test's own (unshare): no server may listen.";
    return;
  }
  if (user != 0)
    write("/proc/self/uid_map", std::to_string(user) + " " + std::to_string(user) + " 1");
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  const int file = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (::ioctl(file, SIOCSIFFLAGS, &request) != 0) obstacle = "The loopback cannot be started.";
  ::close(file);
}

const std::string& networkObstacle() { return obstacle; }

std::optional<std::string> programOf(const std::string& name)
{
  for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/bin/"})
    if (fs::exists(folder + name)) return folder + name;
  return std::nullopt;
}

std::string missingProgram(TestServer::Kind kind)
{
  const std::string server = kind == TestServer::Kind::orthanc ? "Orthanc" : "dcmqrscp";
  for (const std::string& name : {server, std::string("storescu")})
    if (!programOf(name)) return name;
  return {};
}

TestCertificates::TestCertificates(const fs::path& folder)
    : authority(folder / "authority.pem"),
      serverCertificate(folder / "server.pem"),
      serverKey(folder / "server.key"),
      certificate(folder / "own.pem"),
      key(folder / "own.key")
{
  const fs::path authorityKey = folder / "authority.key";
  const auto openssl = [](std::vector<std::string> arguments) {
    const auto outcome = test::run({"openssl", std::move(arguments), {}, {}});
    if (outcome.status != 0) throw std::runtime_error("openssl: " + outcome.err);
  };
  openssl({"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "1", "-subj", "/CN=authority",
           "-keyout", authorityKey, "-out", authority});
  for (const auto& [name, pem, own] :
       {std::tuple{"server", serverCertificate, serverKey}, {"workstation", certificate, key}}) {
    const fs::path request = folder / (std::string(name) + ".csr");
    openssl({"req", "-newkey", "rsa:2048", "-nodes", "-subj", std::string("/CN=") + name, "-keyout",
             own, "-out", request});
    openssl({"x509", "-req", "-days", "1", "-in", request, "-CA", authority, "-CAkey", authorityKey,
             "-CAcreateserial", "-out", pem});
  }
}

TestServer::TestServer(Kind kind, const TestCertificates* tls)
{
  const bool isOrthanc = kind == Kind::orthanc;
  entry_.name = isOrthanc ? "orthanc" : "dcmqrscp";
  entry_.aeTitle = isOrthanc ? "ORTHANC" : "QRSCP";
  entry_.host = "127.0.0.1";
  entry_.port = test::freePort();
  entry_.ownPort = test::freePort();
  if (tls != nullptr) entry_.tls = TlsFiles{tls->authority, tls->certificate, tls->key};
  fs::create_directories(folder_ / "db");
  const fs::path settings = folder_ / (isOrthanc ? "orthanc.json" : "dcmqrscp.cfg");
  write(settings, isOrthanc ? orthancSettings(folder_.path(), entry_, tls)
                            : dcmqrscpSettings(folder_.path(), entry_));
  std::vector<std::string> arguments = {settings};
  if (!isOrthanc) arguments.insert(arguments.begin(), {"--quiet", "--config"});
  process_ = std::make_unique<test::ChildProcess>(test::ProgramCall{
      programOf(isOrthanc ? "Orthanc" : "dcmqrscp").value(), arguments, {atOnce}, folder_.path()});
  std::string last;
  const bool answers = test::waitUntil(
      [&] {
        const auto asked = echo(entry_);
        if (!asked) last = asked.error().message;
        return static_cast<bool>(asked);
      },
      std::chrono::seconds(60));
  if (!answers) throw std::runtime_error("A server of the test does not start: " + last);
}

std::string TestServer::store(const fs::path& folder) const
{
  std::vector<std::string> arguments = {"--aetitle",
                                        "STORESCU",
                                        "--call",
                                        entry_.aeTitle,
                                        "--scan-directories",
                                        "--recurse",
                                        "127.0.0.1",
                                        std::to_string(entry_.port),
                                        folder};
  const auto outcome = test::run({programOf("storescu").value(), arguments, {atOnce}, {}});
  return outcome.status == 0 ? "" : outcome.err;
}

std::vector<test::DicomData> smallStudy(int slices, const std::string& series)
{
  auto files = test::dicomSlices(imaging::smallCt(Eigen::Matrix3d::Identity(),
                                                  Eigen::Vector3d(0.3, 0.3, 0.3), {16, 16, slices}),
                                 series);
  for (test::DicomData& file : files) {
    file.setText(0x00080005, "CS", "ISO_IR 100");
    file.setText(0x00080020, "DA", "20250102");
    file.setText(0x00081030, "LO", "Temporal bone");
    file.setText(0x0008103E, "LO", "0.3 mm");
    file.setText(0x00100010, "PN", "M\xfcller^Jane");  // ISO 8859-1
    file.setText(0x00100020, "LO", "MRN-4711");
    file.setText(0x00100030, "DA", "19700102");
    file.setText(0x0020000D, "UI", ctStudy);
    file.setText(0x00200011, "IS", "3");
  }
  return files;
}

}  // namespace perilymph::archive
