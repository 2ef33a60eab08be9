// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/DicomServers.h"

#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <stdexcept>

#include "perilymph/archive/Echo.h"
#include "perilymph/test/InetSockets.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {

namespace fs = std::filesystem;

namespace {

std::string obstacle;

/// So that DCMTK does not wait 40 ms between the pieces of a message.
const std::pair<std::string, std::optional<std::string>> atOnce = {"TCP_NODELAY", "1"};

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

std::string orthancSettings(const fs::path& folder, const archive::Server& server,
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

std::string dcmqrscpSettings(const fs::path& folder, const archive::Server& server)
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

std::string missingProgram(DicomServer::Kind kind)
{
  const std::string server = kind == DicomServer::Kind::orthanc ? "Orthanc" : "dcmqrscp";
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
    const auto outcome = run({"openssl", std::move(arguments), {}, {}});
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

DicomServer::DicomServer(Kind kind, const TestCertificates* tls)
{
  const bool isOrthanc = kind == Kind::orthanc;
  entry_.name = isOrthanc ? "orthanc" : "dcmqrscp";
  entry_.aeTitle = isOrthanc ? "ORTHANC" : "QRSCP";
  entry_.host = "127.0.0.1";
  entry_.port = freePort();
  entry_.ownPort = freePort();
  if (tls != nullptr) entry_.tls = archive::TlsFiles{tls->authority, tls->certificate, tls->key};
  fs::create_directories(folder_ / "db");
  const fs::path settings = folder_ / (isOrthanc ? "orthanc.json" : "dcmqrscp.cfg");
  write(settings, isOrthanc ? orthancSettings(folder_.path(), entry_, tls)
                            : dcmqrscpSettings(folder_.path(), entry_));
  std::vector<std::string> arguments = {settings};
  if (!isOrthanc) arguments.insert(arguments.begin(), {"--quiet", "--config"});
  process_ = std::make_unique<ChildProcess>(ProgramCall{
      programOf(isOrthanc ? "Orthanc" : "dcmqrscp").value(), arguments, {atOnce}, folder_.path()});
  std::string last;
  const bool answers = waitUntil(
      [&] {
        const auto asked = archive::echo(entry_);
        if (!asked) last = asked.error().message;
        return static_cast<bool>(asked);
      },
      std::chrono::seconds(60));
  if (!answers) throw std::runtime_error("A server of the test does not start: " + last);
}

std::string DicomServer::store(const fs::path& folder,
                               const std::vector<std::string>& options) const
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
  arguments.insert(arguments.begin(), options.begin(), options.end());
  const auto outcome = run({programOf("storescu").value(), arguments, {atOnce}, {}});
  return outcome.status == 0 ? "" : outcome.err;
}

}  // namespace perilymph::test
