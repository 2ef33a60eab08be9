// SPDX-License-Identifier: BSD-3-Clause
#include "MoveReceiver.h"

#include <arpa/inet.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "StoreRequest.h"

namespace perilymph::archive {

namespace {

constexpr std::size_t maxAssociations = 8;  // archives open one, some a few
constexpr int acceptSeconds = 5;

/// The numeric address of the machine at the other end.
std::string peerOf(int socket)
{
  sockaddr_storage place{};
  socklen_t size = sizeof place;
  char text[INET6_ADDRSTRLEN] = {};
  if (::getpeername(socket, reinterpret_cast<sockaddr*>(&place), &size) != 0) return {};
  if (place.ss_family == AF_INET)
    ::inet_ntop(AF_INET, &reinterpret_cast<sockaddr_in*>(&place)->sin_addr, text, sizeof text);
  else if (place.ss_family == AF_INET6)
    ::inet_ntop(AF_INET6, &reinterpret_cast<sockaddr_in6*>(&place)->sin6_addr, text, sizeof text);
  return text;
}

void acceptContexts(T_ASC_Parameters* parameters)
{
  std::vector<const char*> classes = imageClasses();
  classes.insert(classes.end(), documentClasses().begin(), documentClasses().end());
  classes.push_back(UID_VerificationSOPClass);
  std::vector<const char*> syntaxes = plainSyntaxes();
  syntaxes.insert(syntaxes.end(), compressedSyntaxes().begin(), compressedSyntaxes().end());
  ASC_acceptContextsWithPreferredTransferSyntaxes(parameters, classes.data(),
                                                  static_cast<int>(classes.size()), syntaxes.data(),
                                                  static_cast<int>(syntaxes.size()));
}

}  // namespace

MoveReceiver::MoveReceiver(Association& association, ReceivedSeries& series)
    : association_(association), series_(series), serverAddress_(peerOf(association.watch().socket))
{
}

MoveReceiver::~MoveReceiver()
{
  for (T_ASC_Association* each : open_) {
    ASC_abortAssociation(each);
    ASC_destroyAssociation(&each);
  }
}

bool MoveReceiver::isOfServer(T_ASC_Association* incoming) const
{
  const DUL_ASSOCIATESERVICEPARAMETERS& stated = incoming->params->DULparams;
  return serverAddress_ == stated.callingPresentationAddress &&
         association_.server().aeTitle == stated.callingAPTitle &&
         association_.server().ownAeTitle == stated.calledAPTitle;
}

void MoveReceiver::accept()
{
  T_ASC_Association* incoming = nullptr;
  const OFCondition received =
      ASC_receiveAssociation(association_.network(), &incoming, ASC_DEFAULTMAXPDU, nullptr, nullptr,
                             association_.server().tls.has_value(), DUL_NOBLOCK, acceptSeconds);
  if (received.good() && isOfServer(incoming)) {
    acceptContexts(incoming->params);
    if (ASC_acknowledgeAssociation(incoming).good()) {
      open_.push_back(incoming);
      return;
    }
  } else {
    ++strangers_;
    const T_ASC_RejectParameters reject = {ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER,
                                           ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED};
    if (received.good()) ASC_rejectAssociation(incoming, &reject);
  }
  if (incoming != nullptr) {
    ASC_dropAssociation(incoming);
    ASC_destroyAssociation(&incoming);
  }
}

bool MoveReceiver::receive(T_ASC_Association* incoming)
{
  T_ASC_PresentationContextID context = 0;
  T_DIMSE_Message message{};
  DcmDataset* detail = nullptr;
  OFCondition done = DIMSE_receiveCommand(incoming, DIMSE_NONBLOCKING, association_.answerSeconds(),
                                          &context, &message, &detail);
  delete detail;
  if (done == DUL_PEERREQUESTEDRELEASE) ASC_acknowledgeRelease(incoming);
  if (done.bad()) return false;
  if (message.CommandField == DIMSE_C_ECHO_RQ)
    return DIMSE_sendEchoResponse(incoming, context, &message.msg.CEchoRQ, STATUS_Success, nullptr)
        .good();
  if (message.CommandField != DIMSE_C_STORE_RQ) return false;
  return receiveObject(incoming, context, message.msg.CStoreRQ, series_,
                       association_.answerSeconds())
      .good();
}

bool MoveReceiver::serve()
{
  bool hadWork = false;
  if (open_.size() < maxAssociations && ASC_associationWaiting(association_.network(), 0)) {
    accept();
    hadWork = true;
  }
  for (std::size_t i = 0; i < open_.size() && !series_.obstacle();) {
    if (!ASC_dataWaiting(open_[i], 0)) {
      ++i;
      continue;
    }
    hadWork = true;
    if (receive(open_[i])) {
      ++i;
      continue;
    }
    ASC_dropAssociation(open_[i]);
    ASC_destroyAssociation(&open_[i]);
    open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return hadWork;
}

}  // namespace perilymph::archive
