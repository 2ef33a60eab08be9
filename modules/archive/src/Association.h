// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One DICOM association with a server, and what went wrong with it in a sentence.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

#include <memory>
#include <string>
#include <vector>

#include "WatchedConnection.h"
#include "perilymph/archive/Exchange.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// What is proposed to a server: a service, and the transfer syntaxes of one presentation context.
struct Context {
  const char* abstractSyntax;
  std::vector<const char*> transferSyntaxes;
  bool isProvidedHere = false;  ///< The server sends, as in C-GET.
};

/// The transfer syntaxes that every implementation has.
std::vector<const char*> plainSyntaxes();

/// The same to find in the server's structures: their fixed text fields.
void copyText(const std::string& text, char* field, std::size_t size);
template <std::size_t size>
void copyText(const std::string& text, char (&field)[size])
{
  copyText(text, field, size);
}

/// Turns off the log of DCMTK for the whole program, because it would hold names. The error says that
/// its dictionary is not installed.
Result<void> prepareDcmtk();

class Association {
public:
  /// Opens an association. The error says what failed.
  ///
  /// @param listensAt  A port where the server may open associations of its own; 0: none.
  static Result<std::unique_ptr<Association>> open(const Server& server,
                                                   const std::vector<Context>& contexts,
                                                   const Exchange& exchange, int listensAt = 0);
  ~Association();  ///< Aborts it, unless it was released.
  Association(const Association&) = delete;
  Association& operator=(const Association&) = delete;

  /// Ends it properly.
  void release();

  T_ASC_Association* get() const { return association_; }
  T_ASC_Network* network() const { return network_; }
  Watch& watch() { return watch_; }
  const Server& server() const { return server_; }
  int answerSeconds() const { return answer_; }
  DIC_US nextMessage() { return association_->nextMsgID++; }

  /// The context of an accepted service. The error says that the server does not offer it.
  Result<T_ASC_PresentationContextID> contextOf(const char* abstractSyntax,
                                                const Sentence& service) const;

  /// Why a request failed.
  Error failure(const OFCondition& why);
  /// The server's own refusal of a request.
  Error refusal(DIC_US status, const char* meaning) const;

private:
  Association(const Server& server, const Exchange& exchange);
  Error openingFailure(const OFCondition& why, T_ASC_Parameters* parameters);
  Error rejection(T_ASC_Parameters* parameters) const;
  std::string place() const;

  Server server_;
  Watch watch_;
  int connection_, answer_;  // seconds
  std::unique_ptr<DcmTransportLayer> layer_;
  T_ASC_Network* network_ = nullptr;
  T_ASC_Association* association_ = nullptr;
};

}  // namespace perilymph::archive
