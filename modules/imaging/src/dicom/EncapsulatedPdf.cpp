// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/EncapsulatedPdf.h"

#include <gdcmDataElement.h>
#include <gdcmFile.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>

#include <algorithm>
#include <ctime>

#include "StudyIdentity.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::imaging {
namespace {

constexpr const char* encapsulatedPdfStorage = "1.2.840.10008.5.1.4.1.1.104.1";
constexpr std::size_t maxText = 64;  // of LO and ST alike
constexpr std::size_t maxPdfBytes = std::size_t{64} << 20;

/// The object's attributes.
class Attributes {
public:
  explicit Attributes(gdcm::DataSet& data) : data_(data) {}

  void set(std::uint16_t group, std::uint16_t element, gdcm::VR::VRType type, std::string value)
  {
    // values have an even length, UIDs and bytes filled with a zero
    const bool isBinary = type == gdcm::VR::UI || type == gdcm::VR::OB;
    if (value.size() % 2 == 1) value += isBinary ? '\0' : ' ';
    gdcm::DataElement made(gdcm::Tag(group, element));
    made.SetVR(type);
    made.SetByteValue(value.data(), gdcm::VL(static_cast<std::uint32_t>(value.size())));
    data_.Replace(made);
  }

  void setLength(std::uint16_t group, std::uint16_t element, std::uint32_t value)
  {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
    set(group, element, gdcm::VR::UL, bytes);
  }

  void setEmptySequence(std::uint16_t group, std::uint16_t element)
  {
    gdcm::DataElement made(gdcm::Tag(group, element));
    made.SetVR(gdcm::VR::SQ);
    made.SetValue(*gdcm::SmartPointer<gdcm::SequenceOfItems>(new gdcm::SequenceOfItems));
    made.SetVLToUndefined();
    data_.Replace(made);
  }

private:
  gdcm::DataSet& data_;
};

std::string newUid()
{
  gdcm::UIDGenerator generator;
  return generator.Generate();
}

std::string nowAs(const char* format)
{
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32] = {};
  std::strftime(text, sizeof text, format, &local);
  return text;
}

gdcm::VR::VRType typeOf(std::uint16_t group, std::uint16_t element)
{
  switch (std::uint32_t{group} << 16 | element) {
    case 0x00080005:
      return gdcm::VR::CS;
    case 0x00080020:
      return gdcm::VR::DA;
    case 0x00080030:
      return gdcm::VR::TM;
    case 0x00080050:
      return gdcm::VR::SH;
    case 0x00080090:
      return gdcm::VR::PN;
    case 0x00100010:
      return gdcm::VR::PN;
    case 0x00100030:
      return gdcm::VR::DA;
    case 0x00100040:
      return gdcm::VR::CS;
    case 0x0020000D:
      return gdcm::VR::UI;
    case 0x00200010:
      return gdcm::VR::SH;
    default:
      return gdcm::VR::LO;
  }
}

/// Modules Patient and General Study.
void setStudy(Attributes& attributes, const StudyIdentity& identity)
{
  // required, though they may be empty
  for (const auto& [group, element] : {std::pair<std::uint16_t, std::uint16_t>{0x0008, 0x0020},
                                       {0x0008, 0x0030},
                                       {0x0008, 0x0050},
                                       {0x0008, 0x0090},
                                       {0x0010, 0x0010},
                                       {0x0010, 0x0020},
                                       {0x0010, 0x0030},
                                       {0x0010, 0x0040},
                                       {0x0020, 0x0010}})
    attributes.set(group, element, typeOf(group, element), {});
  for (const auto& [tag, value] : identity.values)
    attributes.set(tag.first, tag.second, typeOf(tag.first, tag.second), value);
  attributes.set(0x0020, 0x000D, gdcm::VR::UI, identity.studyUid);
}

/// Modules Encapsulated Document Series, Equipment, Encapsulated Document and SOP Common.
void setDocument(Attributes& attributes, const PdfDocument& document)
{
  attributes.set(0x0008, 0x0016, gdcm::VR::UI, encapsulatedPdfStorage);
  attributes.set(0x0008, 0x0018, gdcm::VR::UI, newUid());
  attributes.set(0x0008, 0x0023, gdcm::VR::DA, nowAs("%Y%m%d"));
  attributes.set(0x0008, 0x002A, gdcm::VR::DT, {});  // a document is not acquired
  attributes.set(0x0008, 0x0033, gdcm::VR::TM, nowAs("%H%M%S"));
  attributes.set(0x0008, 0x0060, gdcm::VR::CS, "DOC");
  attributes.set(0x0008, 0x0064, gdcm::VR::CS, "WSD");  // made on a workstation
  attributes.set(0x0008, 0x0070, gdcm::VR::LO, "Perilymph");
  attributes.set(0x0008, 0x103E, gdcm::VR::LO, document.title);
  attributes.set(0x0018, 0x1020, gdcm::VR::LO, document.software);
  attributes.set(0x0020, 0x000E, gdcm::VR::UI, newUid());
  attributes.set(0x0020, 0x0011, gdcm::VR::IS, "1");
  attributes.set(0x0020, 0x0013, gdcm::VR::IS, "1");
  attributes.set(0x0028, 0x0301, gdcm::VR::CS, "NO");  // the pages name a code alone
  attributes.set(0x0042, 0x0010, gdcm::VR::ST, document.title);
  attributes.set(0x0042, 0x0011, gdcm::VR::OB, document.content);
  attributes.set(0x0042, 0x0012, gdcm::VR::LO, "application/pdf");
  attributes.setLength(0x0042, 0x0015, static_cast<std::uint32_t>(document.content.size()));
  attributes.setEmptySequence(0x0040, 0xA043);  // no code of a concept name
}

Result<void> check(const PdfDocument& document)
{
  const auto isText = [](const std::string& text) {
    return text.size() <= maxText &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  };
  if (document.content.substr(0, 5) != "%PDF-" || document.content.size() > maxPdfBytes)
    return Error{"The document is no PDF of at most 64 MiB."};
  for (const std::string* text : {&document.title, &document.patientCode, &document.software})
    if (!isText(*text))
      return Error{"Title, code and version of a DICOM document have at most 64 ASCII letters."};
  return {};
}

/// Whether a document belongs into a study: it must have the series from which the numbers come.
Result<void> checkSeries(const PdfDocument& document, const StudyIdentity& study,
                         const std::filesystem::path& ct)
{
  constexpr std::size_t shown = 16;  // digits
  if (!document.seriesKey.empty() && study.seriesKeys.contains(document.seriesKey)) return {};
  if (!document.seriesKey.empty())
    return Error{
        "%1 is not the CT in which this was measured: none of its series has the SHA-256 %2... "
        "that the document states. Give the folder of that CT, or leave it out.",
        ct, document.seriesKey.substr(0, shown)};
  if (document.isFiledWithoutSeries) return {};
  return Error{
      "The document states no CT series, so it cannot be compared with %1. Leave the CT out; or, "
      "if you know that it is the patient's, add --ct-not-compared.",
      ct};
}

}  // namespace

Result<void> writeEncapsulatedPdf(const PdfDocument& document,
                                  const std::optional<std::filesystem::path>& ct,
                                  const std::filesystem::path& file)
{
  if (const auto checked = check(document); !checked) return checked;
  StudyIdentity identity;
  if (ct) {
    auto read = readStudyIdentity(*ct);
    if (!read) return read.error();
    if (const auto same = checkSeries(document, *read, *ct); !same) return same;
    identity = *std::move(read);
  } else {
    identity.studyUid = newUid();
    identity.values[{0x0010, 0x0020}] = document.patientCode;
  }
  return writeWhole(file,
                    [&](const std::filesystem::path& place) {
                      gdcm::Writer writer;
                      Attributes attributes(writer.GetFile().GetDataSet());
                      setStudy(attributes, identity);
                      setDocument(attributes, document);
                      writer.GetFile().GetHeader().SetDataSetTransferSyntax(
                          gdcm::TransferSyntax::ExplicitVRLittleEndian);
                      writer.SetFileName(place.c_str());
                      return writer.Write();
                    },
                    {Links::followed, Audience::owner});
}

}  // namespace perilymph::imaging
