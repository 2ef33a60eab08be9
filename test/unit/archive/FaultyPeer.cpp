// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyPeer.h"

#include <arpa/inet.h>
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>

#include "perilymph/test/InetSockets.h"

namespace perilymph::archive {
namespace {

constexpr int seconds = 10;

template <std::size_t size>
void copyTo(char (&field)[size], const std::string& text)
{
  std::snprintf(field, size, "%s", text.c_str());
}

std::string textOf(DcmDataset& data, const DcmTagKey& tag)
{
  OFString found;
  data.findAndGetOFString(tag, found);
  return {found.c_str(), found.size()};
}

/// DCMTK 3.6.8 and later want the time in which the connection must be opened.
void createParameters(auto** parameters)
{
  if constexpr (requires {
                  ASC_createAssociationParameters(parameters, ASC_DEFAULTMAXPDU, seconds);
                })
    ASC_createAssociationParameters(parameters, ASC_DEFAULTMAXPDU, seconds);
  else
    ASC_createAssociationParameters(parameters, ASC_DEFAULTMAXPDU);
}

/// Between two looks of a peer, and between two bytes of a slow one.
void pause()
{
  pollfd none{-1, 0, 0};
  ::poll(&none, 1, 5);  // milliseconds
}

}  // namespace

FaultyPeer::FaultyPeer(Faults faults) : faults_(std::move(faults))
{
  entry_.name = "faulty";
  entry_.aeTitle = "FAULTY";
  entry_.host = "127.0.0.1";
  entry_.port = test::freePort();
  entry_.ownPort = test::freePort();
  EXPECT_TRUE(ASC_initializeNetwork(NET_ACCEPTORREQUESTOR, entry_.port, seconds, &network_).good());
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

FaultyPeer::~FaultyPeer()
{
  thread_.request_stop();
  thread_.join();
  ASC_dropNetwork(&network_);
}

void FaultyPeer::run(const std::stop_token& stop)
{
  while (!stop.stop_requested()) {
    if (!ASC_associationWaiting(network_, 0)) {
      pause();
      continue;
    }
    T_ASC_Association* association = nullptr;
    if (ASC_receiveAssociation(network_, &association, ASC_DEFAULTMAXPDU, nullptr, nullptr, OFFalse,
                               DUL_NOBLOCK, seconds)
            .good()) {
      if (faults_.rejection != 0) {
        const T_ASC_RejectParameters reject = {
            ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER,
            static_cast<T_ASC_RejectParametersReason>(faults_.rejection)};
        ASC_rejectAssociation(association, &reject);
      } else {
        serve(association);
      }
    }
    if (association == nullptr) continue;
    ASC_dropAssociation(association);
    ASC_destroyAssociation(&association);
  }
}

void FaultyPeer::serve(T_ASC_Association* association)
{
  // every context that is proposed, in the role that is proposed
  T_ASC_Parameters* parameters = association->params;
  for (int i = 0; i < ASC_countPresentationContexts(parameters); ++i) {
    T_ASC_PresentationContext context;
    ASC_getPresentationContext(parameters, i, &context);
    ASC_acceptPresentationContext(parameters, context.presentationContextID,
                                  context.proposedTransferSyntaxes[0], context.proposedRole);
  }
  ASC_acknowledgeAssociation(association);
  for (;;) {
    T_ASC_PresentationContextID context = 0;
    T_DIMSE_Message message{};
    DcmDataset* detail = nullptr;
    const OFCondition got =
        DIMSE_receiveCommand(association, DIMSE_NONBLOCKING, seconds, &context, &message, &detail);
    delete detail;
    if (got == DUL_PEERREQUESTEDRELEASE) ASC_acknowledgeRelease(association);
    if (got.bad()) return;
    if (message.CommandField == DIMSE_C_FIND_RQ)
      answerFind(association, context, message.msg.CFindRQ);
    else if (message.CommandField == DIMSE_C_GET_RQ)
      answerGet(association, context, message.msg.CGetRQ);
    else if (message.CommandField == DIMSE_C_MOVE_RQ)
      answerMove(association, context, message.msg.CMoveRQ);
    else if (message.CommandField == DIMSE_C_STORE_RQ)
      answerStore(association, context, message.msg.CStoreRQ);
    else if (message.CommandField != DIMSE_C_CANCEL_RQ)
      return;
  }
}

void FaultyPeer::answerStore(T_ASC_Association* association, T_ASC_PresentationContextID context,
                             T_DIMSE_C_StoreRQ& request)
{
  if (faults_.offered) faults_.offered();
  DcmDataset* object = nullptr;
  T_ASC_PresentationContextID from = context;
  const OFCondition received = DIMSE_receiveDataSetInMemory(association, DIMSE_NONBLOCKING, seconds,
                                                            &from, &object, nullptr, nullptr);
  delete object;
  if (received.bad()) return;
  ++stored_;
  T_DIMSE_C_StoreRSP answer{};
  answer.MessageIDBeingRespondedTo = request.MessageID;
  copyTo(answer.AffectedSOPClassUID, request.AffectedSOPClassUID);
  copyTo(answer.AffectedSOPInstanceUID, request.AffectedSOPInstanceUID);
  answer.opts = O_STORE_AFFECTEDSOPCLASSUID | O_STORE_AFFECTEDSOPINSTANCEUID;
  answer.DimseStatus = STATUS_Success;
  answer.DataSetType = DIMSE_DATASET_NULL;
  DIMSE_sendStoreResponse(association, context, &request, &answer, nullptr);
}

void FaultyPeer::answerFind(T_ASC_Association* association, T_ASC_PresentationContextID context,
                            T_DIMSE_C_FindRQ& request)
{
  DcmDataset* keys = nullptr;
  T_ASC_PresentationContextID from = context;
  DIMSE_receiveDataSetInMemory(association, DIMSE_NONBLOCKING, seconds, &from, &keys, nullptr,
                               nullptr);
  delete keys;
  T_DIMSE_C_FindRSP answer{};
  answer.MessageIDBeingRespondedTo = request.MessageID;
  copyTo(answer.AffectedSOPClassUID, request.AffectedSOPClassUID);
  answer.opts = O_FIND_AFFECTEDSOPCLASSUID;
  for (int i = 0; i < faults_.rows; ++i) {
    DcmDataset row;
    faults_.row(row, i);
    answer.DimseStatus = STATUS_FIND_Pending_MatchesAreContinuing;
    answer.DataSetType = DIMSE_DATASET_PRESENT;
    if (DIMSE_sendFindResponse(association, context, &request, &answer, &row, nullptr).bad())
      return;
  }
  answer.DimseStatus = faults_.rows > 0 ? STATUS_Success : faults_.finalStatus;
  answer.DataSetType = DIMSE_DATASET_NULL;
  DIMSE_sendFindResponse(association, context, &request, &answer, nullptr, nullptr);
}

bool FaultyPeer::storeRaw(T_ASC_Association* association, T_ASC_PresentationContextID context,
                          const T_DIMSE_C_StoreRQ& request)
{
  // DCMTK sends no command without its data set
  DcmDataset command;
  command.putAndInsertString(DCM_AffectedSOPClassUID, request.AffectedSOPClassUID);
  command.putAndInsertUint16(DCM_CommandField, DIMSE_C_STORE_RQ);
  command.putAndInsertUint16(DCM_MessageID, request.MessageID);
  command.putAndInsertUint16(DCM_Priority, 0);
  command.putAndInsertUint16(DCM_CommandDataSetType, DIMSE_DATASET_PRESENT);
  command.putAndInsertString(DCM_AffectedSOPInstanceUID, request.AffectedSOPInstanceUID);
  std::string bytes(4096, '\0');
  DcmOutputBufferStream stream(bytes.data(), static_cast<offile_off_t>(bytes.size()));
  command.transferInit();
  command.write(stream, EXS_LittleEndianImplicit, EET_ExplicitLength, nullptr, EGL_withGL);
  command.transferEnd();
  void* written = nullptr;
  offile_off_t length = 0;
  stream.flushBuffer(written, length);
  bytes.resize(static_cast<std::size_t>(length));
  const auto send = [&](std::string& content, DUL_DATAPDV kind) {
    DUL_PDV piece{};
    piece.fragmentLength = static_cast<unsigned long>(content.size());
    piece.presentationContextID = context;
    piece.pdvType = kind;
    piece.lastPDV = OFTrue;
    piece.data = content.data();
    DUL_PDVLIST pieces{};
    pieces.count = 1;
    pieces.pdv = &piece;
    return DUL_WritePDVs(&association->DULassociation, &pieces).good();
  };
  std::string raw = faults_.raw;
  if (!send(bytes, DUL_COMMANDPDV) || !send(raw, DUL_DATASETPDV)) return false;
  T_DIMSE_Message answer{};
  T_ASC_PresentationContextID from = 0;
  DcmDataset* detail = nullptr;
  const OFCondition got =
      DIMSE_receiveCommand(association, DIMSE_NONBLOCKING, seconds, &from, &answer, &detail);
  delete detail;
  return got.good();
}

bool FaultyPeer::store(T_ASC_Association* association)
{
  for (int i = 0; i < faults_.objects; ++i) {
    DcmDataset object;
    faults_.object(object, i);
    T_DIMSE_C_StoreRQ request{};
    request.MessageID = association->nextMsgID++;
    copyTo(request.AffectedSOPClassUID, textOf(object, DCM_SOPClassUID));
    copyTo(request.AffectedSOPInstanceUID, textOf(object, DCM_SOPInstanceUID));
    request.DataSetType = DIMSE_DATASET_PRESENT;
    T_DIMSE_C_StoreRSP answer{};
    DcmDataset* detail = nullptr;
    const auto context =
        ASC_findAcceptedPresentationContextID(association, request.AffectedSOPClassUID);
    if (i == 1 && !faults_.raw.empty()) {
      if (!storeRaw(association, context, request)) return false;
      continue;
    }
    const OFCondition sent =
        DIMSE_storeUser(association, context, &request, nullptr, &object, nullptr, nullptr,
                        DIMSE_NONBLOCKING, seconds, &answer, &detail);
    delete detail;
    if (sent.bad()) return false;  // it goes on to its final answer all the same
  }
  return true;
}

void FaultyPeer::answerGet(T_ASC_Association* association, T_ASC_PresentationContextID context,
                           T_DIMSE_C_GetRQ& request)
{
  DcmDataset* keys = nullptr;
  T_ASC_PresentationContextID from = context;
  DIMSE_receiveDataSetInMemory(association, DIMSE_NONBLOCKING, seconds, &from, &keys, nullptr,
                               nullptr);
  delete keys;
  store(association);
  T_DIMSE_C_GetRSP answer{};
  answer.MessageIDBeingRespondedTo = request.MessageID;
  answer.DataSetType = DIMSE_DATASET_NULL;
  answer.DimseStatus = faults_.finalStatus;
  DIMSE_sendGetResponse(association, context, &request, &answer, nullptr, nullptr);
}

void FaultyPeer::answerMove(T_ASC_Association* association, T_ASC_PresentationContextID context,
                            T_DIMSE_C_MoveRQ& request)
{
  DcmDataset* keys = nullptr;
  T_ASC_PresentationContextID from = context;
  DIMSE_receiveDataSetInMemory(association, DIMSE_NONBLOCKING, seconds, &from, &keys, nullptr,
                               nullptr);
  delete keys;
  T_ASC_Parameters* parameters = nullptr;
  createParameters(&parameters);
  ASC_setAPTitles(parameters, faults_.movesAs.empty() ? "FAULTY" : faults_.movesAs.c_str(),
                  request.MoveDestination, nullptr);
  const std::string place = "127.0.0.1:" + std::to_string(entry_.ownPort);
  ASC_setPresentationAddresses(parameters, "localhost", place.c_str());
  const char* syntaxes[] = {faults_.moveSyntax.c_str()};
  ASC_addPresentationContext(parameters, 1, UID_CTImageStorage, syntaxes, 1);
  T_ASC_Association* sending = nullptr;
  if (ASC_requestAssociation(network_, parameters, &sending).good()) {
    store(sending);
    ASC_releaseAssociation(sending);
  }
  ASC_destroyAssociation(&sending);
  T_DIMSE_C_MoveRSP answer{};
  answer.MessageIDBeingRespondedTo = request.MessageID;
  answer.DataSetType = DIMSE_DATASET_NULL;
  answer.DimseStatus = faults_.finalStatus;
  DIMSE_sendMoveResponse(association, context, &request, &answer, nullptr, nullptr);
}

DribblingPeer::DribblingPeer()
{
  file_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  EXPECT_EQ(::bind(file_, reinterpret_cast<sockaddr*>(&place), size), 0);
  EXPECT_EQ(::listen(file_, 1), 0);
  ::getsockname(file_, reinterpret_cast<sockaddr*>(&place), &size);
  port_ = ntohs(place.sin_port);
  thread_ = std::jthread([this](const std::stop_token& stop) {
    const int client = ::accept4(file_, nullptr, nullptr, SOCK_CLOEXEC);
    // A-ASSOCIATE-AC with a body of 1 MB
    const unsigned char header[] = {2, 0, 0, 16, 0, 0};
    for (std::size_t i = 0; !stop.stop_requested(); ++i) {
      const unsigned char byte = i < sizeof header ? header[i] : 0;
      if (::send(client, &byte, 1, MSG_NOSIGNAL) != 1) break;
      pause();
    }
    ::close(client);
  });
}

DribblingPeer::~DribblingPeer()
{
  thread_.request_stop();
  ::shutdown(file_, SHUT_RDWR);
  thread_.join();
  ::close(file_);
}

Server DribblingPeer::entry() const
{
  Server entry;
  entry.name = "slow";
  entry.aeTitle = "SLOW";
  entry.host = "127.0.0.1";
  entry.port = port_;
  return entry;
}

}  // namespace perilymph::archive
