// SPDX-License-Identifier: BSD-3-Clause
#include "Association.h"

#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/diutil.h>
#include <dcmtk/oflog/oflog.h>

#include <cstdio>
#include <cstring>
#include <mutex>

namespace perilymph::archive {

namespace {

/// Limit of reads and writes of DCMTK that have begun. They begin only where there is data, or place for it.
constexpr int socketSeconds = 10;

bool isOf(const OFCondition& why, unsigned short code)
{
  return why.module() == OFM_dcmnet && why.code() == code;
}

/// Parameters of an association that is opened within a time. DCMTK 3.6.8 and later take the time as an
/// argument, earlier ones as a setting of the process.
void createParameters(auto** parameters, int seconds)
{
  if constexpr (requires {
                  ASC_createAssociationParameters(parameters, ASC_DEFAULTMAXPDU, seconds);
                }) {
    ASC_createAssociationParameters(parameters, ASC_DEFAULTMAXPDU, seconds);
  } else {
    dcmConnectionTimeout.set(seconds);
    ASC_createAssociationParameters(parameters, ASC_DEFAULTMAXPDU);
  }
}

}  // namespace

Result<void> prepareDcmtk()
{
  static std::once_flag isDone;
  std::call_once(isDone, [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    dcmDisableGethostbyaddr.set(OFTrue);
    dcmSocketReceiveTimeout.set(socketSeconds);
    dcmSocketSendTimeout.set(socketSeconds);
  });
  if (dcmDataDict.isDictionaryLoaded()) return {};
  return Error{
      "The DICOM dictionary of DCMTK is not there, so no server can be asked. Install the package "
      "of "
      "libdcmtk again; DCMDICTPATH must not be set."};
}

std::vector<const char*> plainSyntaxes()
{
  return {UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax};
}

void copyText(const std::string& text, char* field, std::size_t size)
{
  std::snprintf(field, size, "%s", text.c_str());
}

Association::Association(const Server& server, const Exchange& exchange)
    : server_(server),
      connection_(static_cast<int>(exchange.limits.connection.count())),
      answer_(static_cast<int>(exchange.limits.answer.count()))
{
  watch_.stop = exchange.stop;
  watch_.onWait = exchange.onWait;
  watch_.stall = exchange.limits.stall;
}

Association::~Association()
{
  if (association_ != nullptr) {
    ASC_abortAssociation(association_);
    ASC_destroyAssociation(&association_);
  }
  if (network_ != nullptr) ASC_dropNetwork(&network_);
}

void Association::release()
{
  if (association_ == nullptr) return;
  ASC_releaseAssociation(association_);
  ASC_destroyAssociation(&association_);
}

std::string Association::place() const
{
  return server_.name + " (" + server_.host + ":" + std::to_string(server_.port) + ")";
}

Result<std::unique_ptr<Association>> Association::open(const Server& server,
                                                       const std::vector<Context>& contexts,
                                                       const Exchange& exchange, int listensAt)
{
  if (const auto ready = prepareDcmtk(); !ready) return ready.error();
  std::unique_ptr<Association> made(new Association(server, exchange));
  if (made->watch_.isOver()) return made->failure(EC_Normal);
  auto layer = watchedLayer(server, made->watch_);
  if (!layer) return layer.error();
  made->layer_ = *std::move(layer);

  const auto role = listensAt == 0 ? NET_REQUESTOR : NET_ACCEPTORREQUESTOR;
  if (const OFCondition ready =
          ASC_initializeNetwork(role, listensAt, made->connection_, &made->network_);
      ready.bad())
    return Error{
        "Port %1 of this machine cannot be listened at: %2. End what uses it, or enter "
        "another own port, which the archive must know.",
        listensAt, ready.text()};
  ASC_setTransportLayer(made->network_, made->layer_.get(), 0);

  T_ASC_Parameters* parameters = nullptr;
  createParameters(&parameters, made->connection_);
  ASC_setAPTitles(parameters, server.ownAeTitle.c_str(), server.aeTitle.c_str(), nullptr);
  const std::string called = server.host + ":" + std::to_string(server.port);
  ASC_setPresentationAddresses(parameters, "localhost", called.c_str());
  ASC_setTransportLayerType(parameters, server.tls.has_value());
  T_ASC_PresentationContextID id = 1;
  for (const Context& context : contexts) {
    std::vector<const char*> syntaxes = context.transferSyntaxes;
    ASC_addPresentationContext(parameters, id, context.abstractSyntax, syntaxes.data(),
                               static_cast<int>(syntaxes.size()),
                               context.isProvidedHere ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
    id = static_cast<T_ASC_PresentationContextID>(id + 2);  // odd numbers, PS3.8
  }
  const OFCondition opened =
      ASC_requestAssociation(made->network_, parameters, &made->association_, nullptr, nullptr,
                             DUL_NOBLOCK, made->connection_);
  if (opened.bad()) {
    const Error error = made->openingFailure(opened, parameters);
    // nothing is there to be aborted
    if (made->association_ != nullptr) ASC_destroyAssociation(&made->association_);
    return error;
  }
  if (ASC_countAcceptedPresentationContexts(parameters) == 0)
    return Error{
        "%1 offers none of the services that this needs. Ask its administrator to enable "
        "them for %2.",
        made->place(), server.ownAeTitle};
  return made;
}

Result<T_ASC_PresentationContextID> Association::contextOf(const char* abstractSyntax,
                                                           const Sentence& service) const
{
  const auto id = ASC_findAcceptedPresentationContextID(association_, abstractSyntax);
  if (id != 0) return id;
  return Error{"%1 does not offer %2 to %3. Ask its administrator to enable it.", place(), service,
               server_.ownAeTitle};
}

Error Association::openingFailure(const OFCondition& why, T_ASC_Parameters* parameters)
{
  if (watch_.isOver()) return failure(why);
  if (why == DUL_ASSOCIATIONREJECTED) return rejection(parameters);
  if (isOf(why, DULC_UNKNOWNHOST))
    return Error{"%1: no machine of this name is known. Check the host.", place()};
  if (isOf(why, DULC_TCPINITERROR))
    return Error{
        "%1 cannot be reached: %2. Check host and port, that the server runs, and that no "
        "firewall is between.",
        place(), why.text()};
  if (isOf(why, DULC_TLSERROR) || why.module() == OFM_dcmtls)
    return Error{
        "%1: TLS failed: %2. Check that the server speaks TLS at this port, and the files "
        "of certificates.",
        place(), why.text()};
  if (why == DUL_READTIMEOUT || why == DIMSE_NODATAAVAILABLE)
    return Error{
        "%1 accepted the connection but no association within %2 s. Check that a DICOM "
        "server is at this port.",
        place(), connection_};
  if (why == DUL_PEERABORTEDASSOCIATION || why == DUL_NETWORKCLOSED)
    return Error{
        "%1 closed the connection before it agreed on an association. Check that a DICOM "
        "server is at this port, and whether it demands TLS.",
        place()};
  return Error{"%1: no association: %2.", place(), why.text()};
}

Error Association::rejection(T_ASC_Parameters* parameters) const
{
  T_ASC_RejectParameters reject{};
  ASC_getRejectParameters(parameters, &reject);
  switch (reject.reason) {
    case ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED:
      return Error{
          "%1 is not called %2: it does not know this AE title. Check the server's AE title.",
          place(), server_.aeTitle};
    case ASC_REASON_SU_CALLINGAETITLENOTRECOGNIZED:
      return Error{
          "%1 does not know this workstation as %2. Ask its administrator to enter this AE "
          "title with the address of this machine.",
          place(), server_.ownAeTitle};
    case ASC_REASON_SP_PRES_TEMPORARYCONGESTION:
    case ASC_REASON_SP_PRES_LOCALLIMITEXCEEDED:
      return Error{"%1 has too many connections. Try again later.", place()};
    default:
      return Error{
          "%1 refused the association without a reason. Ask its administrator whether %2 is "
          "allowed.",
          place(), server_.ownAeTitle};
  }
}

Error Association::failure(const OFCondition& why)
{
  watch_.isOver();
  switch (watch_.ending) {
    case Ending::canceled:
      return Error{"The exchange with %1 was canceled.", place()};
    case Ending::stalled:
      return Error{"%1 sent less than 64 KiB in %2 s. Try again when the network is faster.",
                   place(), std::chrono::duration_cast<std::chrono::seconds>(watch_.stall).count()};
    case Ending::tooLarge:
      return Error{"%1 sent more bytes than a CT of a temporal bone has. Choose another series.",
                   place()};
    case Ending::none:
      break;
  }
  if (why == DIMSE_NODATAAVAILABLE || why == DUL_READTIMEOUT)
    return Error{"%1 did not answer within %2 s. Try again; ask its administrator if it stays so.",
                 place(), answer_};
  if (why == DUL_PEERABORTEDASSOCIATION || why == DUL_NETWORKCLOSED ||
      why == DUL_PEERREQUESTEDRELEASE || why == DIMSE_READPDVFAILED)
    return Error{"%1 ended the connection in the middle of an answer. Try again.", place()};
  return Error{"The exchange with %1 failed: %2.", place(), why.text()};
}

Error Association::refusal(DIC_US status, const char* meaning) const
{
  char digits[8];
  std::snprintf(digits, sizeof digits, "%04X", static_cast<unsigned>(status));
  return Error{"%1 refused the request: %2 (status %3).", place(), std::string(meaning),
               std::string(digits)};
}

}  // namespace perilymph::archive
