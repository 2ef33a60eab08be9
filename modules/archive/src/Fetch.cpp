// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/Fetch.h"

#include <dcmtk/dcmnet/diutil.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <system_error>

#include "Association.h"
#include "MoveReceiver.h"
#include "Rows.h"
#include "StoreRequest.h"
#include "perilymph/foundation/FileLock.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t imagesOfRequest = 200;    // 200 UIDs are 13 kB; a text has at most 64 kB
constexpr std::chrono::milliseconds pause{20};  // between two looks for a new association

/// Final answer of a server to a get or a move.
struct FinalAnswer {
  DIC_US status = STATUS_Success;
  const char* meaning = "";
};

/// What is asked for: the whole series, or some of its images.
void setRequest(DcmDataset& keys, const SeriesAddress& series, const std::set<std::string>& missing,
                bool isWhole)
{
  setLevel(keys, isWhole ? "SERIES" : "IMAGE", series.studyUid);
  keys.putAndInsertString(DCM_SeriesInstanceUID, series.seriesUid.c_str());
  if (isWhole) return;
  std::string uids;
  std::size_t count = 0;
  for (const std::string& uid : missing) {
    if (++count > imagesOfRequest) break;
    uids += (uids.empty() ? "" : "\\") + uid;
  }
  keys.putAndInsertString(DCM_SOPInstanceUID, uids.c_str());
}

Result<std::set<std::string>> listImages(const Server& server, const SeriesAddress& series,
                                         const Exchange& exchange, const FetchLimits& limits)
{
  DcmDataset keys;
  setLevel(keys, "IMAGE", series.studyUid);
  keys.putAndInsertString(DCM_SeriesInstanceUID, series.seriesUid.c_str());
  keys.putAndInsertString(DCM_SOPInstanceUID, "");
  std::set<std::string> images;
  const auto cut = queryRows(server, keys, limits.images, exchange, [&images](DcmItem& row) {
    if (auto uid = textIn(row, DCM_SOPInstanceUID); checkUid(uid, Sentence{"image"}))
      images.insert(uid);
  });
  if (!cut) return cut.error();
  if (*cut)
    return Error{
        "The series %1 has more than %2 images, which is no CT of a temporal bone. Choose "
        "another series.",
        series.seriesUid, limits.images};
  if (images.empty())
    return Error{
        "%1 has no series %2 in the study %3. 'perilymph-cli archive find' lists the series "
        "of a study.",
        server.name, series.seriesUid, series.studyUid};
  return images;
}

/// One get or move of what is missing.
class Transfer {
public:
  Transfer(Association& association, ReceivedSeries& received, const Exchange& exchange)
      : association_(association), received_(received), exchange_(exchange)
  {
  }

  Result<FinalAnswer> get(DcmDataset& keys)
  {
    constexpr const char* service = UID_GETStudyRootQueryRetrieveInformationModel;
    const auto context = association_.contextOf(service, Sentence{"retrieval by C-GET"});
    if (!context) return context.error();
    T_DIMSE_Message message{};
    message.CommandField = DIMSE_C_GET_RQ;
    T_DIMSE_C_GetRQ& request = message.msg.CGetRQ;
    request.MessageID = association_.nextMessage();
    copyText(service, request.AffectedSOPClassUID);
    request.DataSetType = DIMSE_DATASET_PRESENT;
    if (const auto sent = send(*context, message, keys); !sent) return sent.error();
    for (;;) {
      T_ASC_PresentationContextID from = 0;
      T_DIMSE_Message answer{};
      if (const OFCondition got = receive(from, answer); got.bad())
        return association_.failure(got);
      if (answer.CommandField == DIMSE_C_STORE_RQ) {
        const OFCondition stored = receiveObject(association_.get(), from, answer.msg.CStoreRQ,
                                                 received_, association_.answerSeconds());
        if (const auto obstacle = obstacleOf()) return *obstacle;
        if (stored.bad()) return association_.failure(stored);
        report();
        continue;
      }
      if (answer.CommandField != DIMSE_C_GET_RSP) return association_.failure(DIMSE_BADCOMMANDTYPE);
      const DIC_US status = answer.msg.CGetRSP.DimseStatus;
      if (answer.msg.CGetRSP.DataSetType != DIMSE_DATASET_NULL) ignoreDataSet();
      if (!DICOM_PENDING_STATUS(status)) return FinalAnswer{status, DU_cgetStatusString(status)};
    }
  }

  Result<FinalAnswer> move(DcmDataset& keys)
  {
    constexpr const char* service = UID_MOVEStudyRootQueryRetrieveInformationModel;
    const auto context = association_.contextOf(service, Sentence{"retrieval by C-MOVE"});
    if (!context) return context.error();
    MoveReceiver receiver(association_, received_);
    T_DIMSE_Message message{};
    message.CommandField = DIMSE_C_MOVE_RQ;
    T_DIMSE_C_MoveRQ& request = message.msg.CMoveRQ;
    request.MessageID = association_.nextMessage();
    copyText(service, request.AffectedSOPClassUID);
    copyText(association_.server().ownAeTitle, request.MoveDestination);
    request.DataSetType = DIMSE_DATASET_PRESENT;
    if (const auto sent = send(*context, message, keys); !sent) return sent.error();
    for (Clock::time_point idleFrom = Clock::now();;) {
      if (association_.watch().isOver()) return association_.failure(EC_Normal);
      const bool hadObject = receiver.serve();
      if (const auto obstacle = obstacleOf()) return *obstacle;
      if (hadObject) report();
      if (ASC_dataWaiting(association_.get(), 0)) {
        T_ASC_PresentationContextID from = 0;
        T_DIMSE_Message answer{};
        if (const OFCondition got = receive(from, answer); got.bad())
          return association_.failure(got);
        if (answer.CommandField != DIMSE_C_MOVE_RSP)
          return association_.failure(DIMSE_BADCOMMANDTYPE);
        const DIC_US status = answer.msg.CMoveRSP.DimseStatus;
        if (answer.msg.CMoveRSP.DataSetType != DIMSE_DATASET_NULL) ignoreDataSet();
        if (!DICOM_PENDING_STATUS(status)) return ended(receiver, status);
      } else if (!hadObject) {
        if (Clock::now() - idleFrom > exchange_.limits.answer)
          return association_.failure(DIMSE_NODATAAVAILABLE);
        association_.watch().waitForData(pause);
        continue;
      }
      idleFrom = Clock::now();
    }
  }

private:
  Result<void> send(T_ASC_PresentationContextID context, T_DIMSE_Message& message, DcmDataset& keys)
  {
    const OFCondition sent = DIMSE_sendMessageUsingMemoryData(association_.get(), context, &message,
                                                              nullptr, &keys, nullptr, nullptr);
    if (sent.bad()) return association_.failure(sent);
    return {};
  }

  OFCondition receive(T_ASC_PresentationContextID& context, T_DIMSE_Message& message)
  {
    DcmDataset* detail = nullptr;
    const OFCondition got =
        DIMSE_receiveCommand(association_.get(), DIMSE_NONBLOCKING, association_.answerSeconds(),
                             &context, &message, &detail);
    delete detail;
    return got;
  }

  /// The list of images that failed; missing() knows them.
  void ignoreDataSet()
  {
    T_ASC_PresentationContextID context = 0;
    DcmDataset* data = nullptr;
    DIMSE_receiveDataSetInMemory(association_.get(), DIMSE_NONBLOCKING,
                                 association_.answerSeconds(), &context, &data, nullptr, nullptr);
    delete data;
  }

  std::optional<Error> obstacleOf() const
  {
    if (!received_.obstacle()) return std::nullopt;
    return Error{*received_.obstacle()};
  }

  /// Reports what has arrived since the last time.
  void report()
  {
    if (received_.arrivedCount() == reported_) return;
    reported_ = received_.arrivedCount();
    if (exchange_.onProgress)
      exchange_.onProgress(static_cast<double>(reported_) /
                           static_cast<double>(received_.expectedCount()));
  }

  Result<FinalAnswer> ended(MoveReceiver& receiver, DIC_US status) const
  {
    if (status == STATUS_MOVE_Refused_MoveDestinationUnknown)
      return Error{
          "%1 does not know where %2 is. Ask its administrator to enter this AE title with "
          "the address of this machine and port %3.",
          association_.server().name, association_.server().ownAeTitle,
          association_.server().ownPort};
    if (receiver.strangers() > 0 && received_.arrivedCount() == 0)
      return Error{
          "The images for %1 came from another machine or another AE title than %2, and were "
          "refused. Enter the archive's own AE title and host.",
          association_.server().ownAeTitle, association_.server().aeTitle};
    // some archives answer so, too, if they do not know where to send
    if (DICOM_FAILURE_STATUS(status) && received_.arrivedCount() == 0)
      return Error{
          "%1 Ask its administrator whether %2 is entered with the address of this machine and "
          "port "
          "%3.",
          association_.refusal(status, DU_cmoveStatusString(status)).message,
          association_.server().ownAeTitle, association_.server().ownPort};
    return FinalAnswer{status, DU_cmoveStatusString(status)};
  }

  Association& association_;
  ReceivedSeries& received_;
  const Exchange& exchange_;
  std::size_t reported_ = received_.arrivedCount();
};

std::vector<Context> contextsOf(const Server& server)
{
  if (server.retrieval == Retrieval::move)
    return {{UID_MOVEStudyRootQueryRetrieveInformationModel, plainSyntaxes()}};
  std::vector<Context> contexts = {
      {UID_GETStudyRootQueryRetrieveInformationModel, plainSyntaxes()}};
  // A server answers one context with one syntax, so that each compressed one has its own.
  for (const char* each : imageClasses()) {
    contexts.push_back({each, plainSyntaxes(), true});
    for (const char* syntax : compressedSyntaxes()) contexts.push_back({each, {syntax}, true});
  }
  for (const char* each : documentClasses()) contexts.push_back({each, plainSyntaxes(), true});
  return contexts;
}

/// Retrieves all that is missing.
Result<void> retrieve(const Server& server, const SeriesAddress& series, ReceivedSeries& received,
                      const Exchange& exchange, const FetchLimits& limits)
{
  const bool isMove = server.retrieval == Retrieval::move;
  std::uint64_t bytesLeft = limits.bytes;
  bool isWhole = received.arrivedCount() == 0;
  while (!received.missing().empty()) {
    auto opened =
        Association::open(server, contextsOf(server), exchange, isMove ? server.ownPort : 0);
    if (!opened) return opened.error();
    Association& association = **opened;
    association.watch().bytesLeft = bytesLeft;
    DcmDataset keys;
    setRequest(keys, series, received.missing(), isWhole);
    const std::size_t before = received.arrivedCount();
    Transfer transfer(association, received, exchange);
    const auto answer = isMove ? transfer.move(keys) : transfer.get(keys);
    if (!answer) return answer.error();
    bytesLeft = association.watch().bytesLeft;
    association.release();
    if (received.missing().empty()) break;
    const bool isRefused =
        answer->status != STATUS_Success && !DICOM_WARNING_STATUS(answer->status);
    if (isRefused && received.arrivedCount() == before)
      return association.refusal(answer->status, answer->meaning);
    if (isWhole || received.arrivedCount() == before)
      return Error{
          "%1 did not send %2 of the images that it lists. It may hold them in a form that "
          "cannot be read here; ask its administrator.",
          server.name, received.missing().size()};
  }
  return {};
}

/// The private folder of a series that is not complete.
Result<void> makePrivate(const fs::path& folder)
{
  if (::mkdir(folder.c_str(), S_IRWXU) == 0) return {};
  if (errno != EEXIST)
    return Error{"The folder %1 cannot be made: %2.", folder,
                 std::generic_category().message(errno)};
  std::error_code failed;
  if (!fs::is_directory(fs::symlink_status(folder, failed)))
    return Error{"%1 is in the way and is no folder. Move it away.", folder};
  fs::permissions(folder, fs::perms::owner_all, failed);
  if (failed) return Error{"%1 belongs to somebody else. Choose another place.", folder};
  removeLeftovers(folder);
  return {};
}

}  // namespace

Result<FetchedSeries> fetchSeries(const Server& server, const SeriesAddress& series,
                                  const fs::path& folder, const Exchange& exchange,
                                  const FetchLimits& limits)
{
  if (const auto checked = checkUid(series.studyUid, Sentence{"study"}); !checked)
    return checked.error();
  if (const auto checked = checkUid(series.seriesUid, Sentence{"series"}); !checked)
    return checked.error();
  std::error_code failed;
  if (fs::exists(fs::symlink_status(folder, failed)))
    return Error{"%1 exists already. Name a new folder.", folder};
  const fs::path partial = folder.string() + ".partial";
  const auto lock = FileLock::take(folder.string() + ".lock", folder.filename().string());
  if (!lock) return lock.error();

  auto images = listImages(server, series, exchange, limits);
  if (!images) return images.error();
  if (const auto made = makePrivate(partial); !made) return made.error();
  ReceivedSeries received(partial, series, *std::move(images));
  const std::size_t resumed = received.arrivedCount();
  const auto retrieved = retrieve(server, series, received, exchange, limits);
  if (!retrieved) {
    if (received.arrivedCount() == 0) {
      fs::remove(partial, failed);
      return retrieved.error();
    }
    return Error{"%1 %2 of %3 images are in %4: fetch the series again to request the others.",
                 retrieved.error().message, received.arrivedCount(), received.expectedCount(),
                 partial};
  }
  if (const int taken = giveNewName(partial, folder); taken != 0)
    return Error{"%1 cannot get the name %2: %3.", partial, folder.filename(),
                 std::generic_category().message(taken)};
  return FetchedSeries{received.arrivedCount(), resumed};
}

}  // namespace perilymph::archive
