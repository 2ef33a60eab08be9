// SPDX-License-Identifier: BSD-3-Clause
#include "StoreRequest.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <system_error>

namespace perilymph::archive {

namespace {

/// After the last byte of an object, before it is answered.
void onStored(void* data, T_DIMSE_StoreProgress* progress, T_DIMSE_C_StoreRQ*, char* file,
              DcmDataset**, T_DIMSE_C_StoreRSP* response, DcmDataset**)
{
  if (progress->state != DIMSE_StoreEnd || response->DimseStatus != STATUS_STORE_Success) return;
  if (!static_cast<ReceivedSeries*>(data)->take(file))
    response->DimseStatus = STATUS_STORE_Error_CannotUnderstand;
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
  // Straight to the file, byte by byte as it is sent: large objects take no memory.
  const OFCondition received =
      DIMSE_storeProvider(association, context, &request, place.c_str(), 1, nullptr, onStored,
                          &series, DIMSE_NONBLOCKING, seconds);
  std::error_code ignored;
  std::filesystem::remove(place, ignored);  // what is left of one that was cut off
  return received;
}

}  // namespace perilymph::archive
