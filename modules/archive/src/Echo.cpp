// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/Echo.h"

#include "Association.h"

#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/dcmnet/diutil.h>

namespace perilymph::archive {

Result<void> echo(const Server& server, const Exchange& exchange)
{
  auto opened = Association::open(server, {{UID_VerificationSOPClass, plainSyntaxes()}}, exchange);
  if (!opened) return opened.error();
  Association& association = **opened;
  DIC_US status = 0;
  DcmDataset* detail = nullptr;
  const OFCondition answered =
      DIMSE_echoUser(association.get(), association.nextMessage(), DIMSE_NONBLOCKING,
                     association.answerSeconds(), &status, &detail);
  delete detail;
  if (answered.bad()) return association.failure(answered);
  if (status != STATUS_Success) return association.refusal(status, DU_cechoStatusString(status));
  association.release();
  return {};
}

}  // namespace perilymph::archive
