// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What listens during a move: associations of the one server, for the one series.

#include <string>
#include <vector>

#include "Association.h"
#include "ReceivedSeries.h"

namespace perilymph::archive {

class MoveReceiver {
public:
  /// @param association  On which the move is requested, opened with a port to listen at.
  MoveReceiver(Association& association, ReceivedSeries& series);
  ~MoveReceiver();  ///< Ends the associations that are still open.
  MoveReceiver(const MoveReceiver&) = delete;
  MoveReceiver& operator=(const MoveReceiver&) = delete;

  /// Accepts what is waiting and receives one object from each association that has one. @return
  /// Whether there was anything.
  bool serve();
  /// Associations that came from another machine or under other AE titles, and were refused.
  int strangers() const { return strangers_; }

private:
  void accept();
  bool isOfServer(T_ASC_Association* incoming) const;
  /// False when the association has ended.
  bool receive(T_ASC_Association* incoming);

  Association& association_;
  ReceivedSeries& series_;
  std::string serverAddress_;
  std::vector<T_ASC_Association*> open_;
  int strangers_ = 0;
};

}  // namespace perilymph::archive
