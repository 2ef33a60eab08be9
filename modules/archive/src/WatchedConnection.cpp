// SPDX-License-Identifier: BSD-3-Clause
#include "WatchedConnection.h"

#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmtls/tlslayer.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace perilymph::archive {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds look{50};                // between two looks at the cancellation
constexpr std::uint64_t stallBytes = 64 << 10;  // TimeLimits::stall

class WatchedConnection final : public DcmTransportConnection {
public:
  WatchedConnection(DcmTransportConnection* inner, DcmNativeSocketType socket, Watch& watch)
      : DcmTransportConnection(socket), inner_(inner), watch_(watch)
  {
    if (watch.socket < 0) watch.socket = socket;
    watch.latest = socket;
    setNow(TCP_NODELAY);
  }

  ~WatchedConnection() override
  {
    if (watch_.latest == getSocket()) watch_.latest = -1;
  }

  OFCondition serverSideHandshake() override { return inner_->serverSideHandshake(); }
  OFCondition clientSideHandshake() override { return inner_->clientSideHandshake(); }
  OFCondition renegotiate(const char* suite) override { return inner_->renegotiate(suite); }

  ssize_t read(void* buffer, size_t size) override
  {
    const Clock::time_point begin = Clock::now();
    while (!inner_->networkDataAvailable(0)) {
      if (watch_.isOver()) return closed();
      if (waited_ + (Clock::now() - begin) > watch_.stall) {
        watch_.ending = Ending::stalled;
        return closed();
      }
      waitForData(look);
    }
    if (watch_.isOver()) return closed();
    waited_ += Clock::now() - begin;
    const ssize_t count = inner_->read(buffer, size);
    setNow(TCP_QUICKACK);
    if (count <= 0) return count;
    sinceStall_ += static_cast<std::uint64_t>(count);
    if (sinceStall_ >= stallBytes) startCounting();
    watch_.bytesLeft -= std::min(watch_.bytesLeft, static_cast<std::uint64_t>(count));
    return count;
  }

  ssize_t write(void* buffer, size_t size) override
  {
    // an abort is still written after a cancellation, if the peer reads
    pollfd place{getSocket(), POLLOUT, 0};
    while (::poll(&place, 1, static_cast<int>(look.count())) == 0)
      if (watch_.isOver()) return closed();
    return inner_->write(buffer, size);
  }

  /// Waits for the first byte of an answer.
  OFBool networkDataAvailable(int seconds) override
  {
    const auto end = Clock::now() + std::chrono::seconds(seconds);
    while (!inner_->networkDataAvailable(0)) {
      const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
      if (left <= milliseconds::zero() || watch_.isOver()) return OFFalse;
      waitForData(std::min(left, look));
    }
    return OFTrue;
  }

  void close() override { inner_->close(); }
  void closeTransportConnection() override { inner_->closeTransportConnection(); }
  unsigned long getPeerCertificateLength() override { return inner_->getPeerCertificateLength(); }
  unsigned long getPeerCertificate(void* buffer, unsigned long size) override
  {
    return inner_->getPeerCertificate(buffer, size);
  }
  OFBool isTransparentConnection() override { return OFFalse; }
  OFString& dumpConnectionParameters(OFString& text) override
  {
    return inner_->dumpConnectionParameters(text);
  }

private:
  static ssize_t closed()
  {
    errno = ECANCELED;
    return -1;
  }

  void waitForData(milliseconds longest)
  {
    pollfd place{getSocket(), POLLIN, 0};
    ::poll(&place, 1, static_cast<int>(longest.count()));
  }

  /// DCMTK writes a message in several pieces, and so do most servers: each would wait 40 ms for the
  /// acknowledgment of the one before (Nagle's algorithm with delayed acknowledgments), at each end.
  void setNow(int option)
  {
    const int isOn = 1;
    ::setsockopt(getSocket(), IPPROTO_TCP, option, &isOn, sizeof isOn);
  }

  void startCounting()
  {
    sinceStall_ = 0;
    waited_ = Clock::duration::zero();
  }

  std::unique_ptr<DcmTransportConnection> inner_;
  Watch& watch_;
  Clock::duration waited_{};  // within answers, for sinceStall_ bytes
  std::uint64_t sinceStall_ = 0;
};

/// A layer of DCMTK whose connections are watched.
template <class Layer>
class WatchedLayer final : public Layer {
public:
  template <class... Arguments>
  explicit WatchedLayer(Watch& watch, Arguments... arguments) : Layer(arguments...), watch_(watch)
  {
  }

  DcmTransportConnection* createConnection(DcmNativeSocketType socket, OFBool isSecure) override
  {
    DcmTransportConnection* const made = Layer::createConnection(socket, isSecure);
    return made == nullptr ? nullptr : new WatchedConnection(made, socket, watch_);
  }

private:
  Watch& watch_;
};

/// Sets the own certificate; DCMTK 3.6.8 and later want to know the profile.
OFCondition setCertificate(auto& layer, const char* file)
{
  if constexpr (requires { layer.setCertificateFile(file, DCF_Filetype_PEM, TSP_Profile_BCP195); })
    return layer.setCertificateFile(file, DCF_Filetype_PEM, TSP_Profile_BCP195);
  else
    return layer.setCertificateFile(file, DCF_Filetype_PEM);
}

Error unusable(const std::filesystem::path& file, const OFCondition& why)
{
  return Error{"The file %1 cannot be used for TLS: %2. Check that it is a PEM file of this kind.",
               file, why.text()};
}

}  // namespace

bool Watch::isOver()
{
  if (onWait) onWait();
  if (ending == Ending::none && stop.stop_requested()) ending = Ending::canceled;
  if (ending == Ending::none && bytesLeft == 0) ending = Ending::tooLarge;
  return ending != Ending::none;
}

void Watch::waitForData(std::chrono::milliseconds longest) const
{
  // poll() passes over negative numbers
  std::array<pollfd, 2> places = {pollfd{socket, POLLIN, 0}, pollfd{latest, POLLIN, 0}};
  ::poll(places.data(), places.size(), static_cast<int>(longest.count()));
}

Result<std::unique_ptr<DcmTransportLayer>> watchedLayer(const Server& server, Watch& watch)
{
  if (!server.tls)
    return std::unique_ptr<DcmTransportLayer>(new WatchedLayer<DcmTransportLayer>(watch));
  auto layer = std::make_unique<WatchedLayer<DcmTLSTransportLayer>>(
      watch, NET_ACCEPTORREQUESTOR, static_cast<const char*>(nullptr), OFTrue);
  layer->setPrivateKeyPasswd("");  // a key with a password is refused, not asked for
  layer->setCertificateVerification(DCV_requireCertificate);
  const TlsFiles& files = *server.tls;
  if (const OFCondition added =
          layer->addTrustedCertificateFile(files.authority.c_str(), DCF_Filetype_PEM);
      added.bad())
    return unusable(files.authority, added);
  if (!files.certificate.empty()) {
    if (const OFCondition set = layer->setPrivateKeyFile(files.key.c_str(), DCF_Filetype_PEM);
        set.bad())
      return unusable(files.key, set);
    if (const OFCondition set = setCertificate(*layer, files.certificate.c_str()); set.bad())
      return unusable(files.certificate, set);
    if (!layer->checkPrivateKeyMatchesCertificate())
      return Error{
          "The key %1 is not that of the certificate %2. Enter the pair that belongs "
          "together.",
          files.key, files.certificate};
  }
  OFCondition chosen = layer->setTLSProfile(TSP_Profile_BCP195);
  if (chosen.good()) chosen = layer->activateCipherSuites();
  if (chosen.bad())
    return Error{"TLS cannot be set up as DICOM's profile BCP 195 demands: %1.", chosen.text()};
  return std::unique_ptr<DcmTransportLayer>(std::move(layer));
}

}  // namespace perilymph::archive
