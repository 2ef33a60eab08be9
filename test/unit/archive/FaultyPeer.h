// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A DICOM server with faults that real ones do not show on request.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// What the peer does. Functions make data sets, which it owns.
struct Faults {
  /// Rejects every association for this reason; 0: none.
  unsigned long rejection = 0;
  /// Rows of every query: `row(i)` for i below `rows`.
  int rows = 0;
  std::function<void(DcmDataset& row, int i)> row = {};
  /// Objects of every retrieval.
  int objects = 0;
  std::function<void(DcmDataset& object, int i)> object = {};
  /// Called when an object is offered, before its data set is read.
  std::function<void()> offered = {};
  std::string raw = {};  ///< Bytes that are sent in place of the second object's data set.
  DIC_US finalStatus = STATUS_Success;
  std::string movesAs = {};  ///< AE title under which it sends during a move; empty: its own.
  /// The one transfer syntax that it proposes during a move.
  std::string moveSyntax = UID_LittleEndianExplicitTransferSyntax;
};

/// The peer, on a thread of its own, at a free port of the loopback.
class FaultyPeer {
public:
  explicit FaultyPeer(Faults faults);
  ~FaultyPeer();
  FaultyPeer(const FaultyPeer&) = delete;
  FaultyPeer& operator=(const FaultyPeer&) = delete;

  const Server& entry() const { return entry_; }
  /// Number of objects that arrived whole.
  int stored() const { return stored_; }

private:
  void run(const std::stop_token& stop);
  void serve(T_ASC_Association* association);
  void answerStore(T_ASC_Association* association, T_ASC_PresentationContextID context,
                   T_DIMSE_C_StoreRQ& request);
  void answerFind(T_ASC_Association* association, T_ASC_PresentationContextID context,
                  T_DIMSE_C_FindRQ& request);
  void answerGet(T_ASC_Association* association, T_ASC_PresentationContextID context,
                 T_DIMSE_C_GetRQ& request);
  void answerMove(T_ASC_Association* association, T_ASC_PresentationContextID context,
                  T_DIMSE_C_MoveRQ& request);
  /// Sends the objects. False if one was not taken.
  bool store(T_ASC_Association* association);
  /// Sends bytes that are no data set. False if there was no answer.
  bool storeRaw(T_ASC_Association* association, T_ASC_PresentationContextID context,
                const T_DIMSE_C_StoreRQ& request);

  Faults faults_;
  Server entry_;
  std::atomic<int> stored_ = 0;
  T_ASC_Network* network_ = nullptr;
  std::jthread thread_;
};

/// A listener that answers with a byte every few milliseconds, for ever.
class DribblingPeer {
public:
  DribblingPeer();
  ~DribblingPeer();
  DribblingPeer(const DribblingPeer&) = delete;
  DribblingPeer& operator=(const DribblingPeer&) = delete;

  Server entry() const;

private:
  int file_ = -1;
  int port_ = 0;
  std::jthread thread_;
};

}  // namespace perilymph::archive
