// SPDX-License-Identifier: BSD-3-Clause
#include "StoreRequest.h"

#include <dcmtk/dcmdata/dcostrma.h>
#include <dcmtk/dcmdata/dcostrmf.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>

namespace perilymph::archive {

namespace {

/// Appends to a file. After an error it takes and drops the rest, so that the object is read to its
/// end: DCMTK 3.6.7 otherwise waits for more after the last piece of an object that it cannot write,
/// and does not notice an error at closing.
class Appender final : public DcmConsumer {
public:
  explicit Appender(const std::filesystem::path& file)
      : file_(::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW))
  {
    if (file_ < 0) error_ = errno;
  }
  ~Appender() override { close(); }

  OFBool good() const override { return OFTrue; }
  OFCondition status() const override { return EC_Normal; }
  OFBool isFlushed() const override { return OFTrue; }
  offile_off_t avail() const override { return std::numeric_limits<Sint32>::max(); }
  void flush() override {}

  offile_off_t write(const void* buffer, offile_off_t size) override
  {
    const char* place = static_cast<const char*>(buffer);
    for (offile_off_t left = size; left > 0 && error_ == 0;) {
      const ssize_t count = ::write(file_, place, static_cast<std::size_t>(left));
      if (count < 0 && errno != EINTR) error_ = errno;
      left -= std::max<ssize_t>(count, 0);
      place += std::max<ssize_t>(count, 0);
    }
    return size;
  }

  /// Closes the file. @return The first error of it, 0 if there was none.
  int close()
  {
    if (file_ >= 0 && ::close(file_) != 0 && error_ == 0) error_ = errno;
    file_ = -1;
    return error_;
  }

private:
  int file_;
  int error_ = 0;
};

class AppendingStream final : public DcmOutputStream {
public:
  explicit AppendingStream(const std::filesystem::path& file)
      : DcmOutputStream(&appender_), appender_(file)
  {
  }
  int close() { return appender_.close(); }

private:
  Appender appender_;
};

/// Receives an object into a file, with the header of a DICOM file. @return An error number of the
/// file, or the condition of the connection.
OFCondition receiveFile(T_ASC_Association* association, T_ASC_PresentationContextID context,
                        T_DIMSE_C_StoreRQ& request, const std::filesystem::path& place, int seconds,
                        int& error)
{
  DcmOutputFileStream* header = nullptr;
  DIMSE_createFilestream(place.c_str(), &request, association, context, 1, &header);
  delete header;
  AppendingStream stream(place);
  T_ASC_PresentationContextID from = 0;
  const OFCondition received = DIMSE_receiveDataSetInFile(association, DIMSE_NONBLOCKING, seconds,
                                                          &from, &stream, nullptr, nullptr);
  error = stream.close();
  if (received.good() && from != context) return DIMSE_NOVALIDPRESENTATIONCONTEXTID;
  return received;
}

}  // namespace

const std::vector<const char*>& imageClasses()
{
  static const std::vector<const char*> classes = {
      UID_CTImageStorage,
      UID_EnhancedCTImageStorage,
      UID_LegacyConvertedEnhancedCTImageStorage,
      UID_XRay3DCraniofacialImageStorage,
      UID_XRay3DAngiographicImageStorage,
      UID_SecondaryCaptureImageStorage,
      UID_MultiframeGrayscaleWordSecondaryCaptureImageStorage,
      UID_MRImageStorage,
      UID_EnhancedMRImageStorage};
  return classes;
}

const std::vector<const char*>& documentClasses()
{
  static const std::vector<const char*> classes = {
      UID_EncapsulatedPDFStorage, UID_EnhancedSRStorage, UID_ComprehensiveSRStorage,
      UID_Comprehensive3DSRStorage, UID_SegmentationStorage};
  return classes;
}

const std::vector<const char*>& compressedSyntaxes()
{
  static const std::vector<const char*> syntaxes = {
      UID_JPEGProcess14SV1TransferSyntax, UID_JPEGProcess14TransferSyntax,
      UID_JPEGLSLosslessTransferSyntax,   UID_JPEG2000LosslessOnlyTransferSyntax,
      UID_RLELosslessTransferSyntax,      UID_JPEG2000TransferSyntax,
      UID_JPEGLSLossyTransferSyntax,      UID_JPEGProcess2_4TransferSyntax,
      UID_JPEGProcess1TransferSyntax,     UID_DeflatedExplicitVRLittleEndianTransferSyntax,
      UID_BigEndianExplicitTransferSyntax};
  return syntaxes;
}

OFCondition receiveObject(T_ASC_Association* association, T_ASC_PresentationContextID context,
                          T_DIMSE_C_StoreRQ& request, ReceivedSeries& series, int seconds)
{
  const std::filesystem::path place = series.newPlace();
  int error = 0;
  const OFCondition received = receiveFile(association, context, request, place, seconds, error);
  T_DIMSE_C_StoreRSP response{};
  if (error != 0) {
    series.setUnwritable(std::generic_category().message(error));
    response.DimseStatus = STATUS_STORE_Refused_OutOfResources;
  } else if (received.good() && !series.take(place)) {
    response.DimseStatus = STATUS_STORE_Error_CannotUnderstand;
  }
  std::error_code ignored;
  std::filesystem::remove(place, ignored);  // where it was not taken
  if (received.bad()) return received;
  response.MessageIDBeingRespondedTo = request.MessageID;
  response.DataSetType = DIMSE_DATASET_NULL;
  copyText(request.AffectedSOPClassUID, response.AffectedSOPClassUID);
  copyText(request.AffectedSOPInstanceUID, response.AffectedSOPInstanceUID);
  response.opts = O_STORE_AFFECTEDSOPCLASSUID | O_STORE_AFFECTEDSOPINSTANCEUID;
  return DIMSE_sendStoreResponse(association, context, &request, &response, nullptr);
}

}  // namespace perilymph::archive
