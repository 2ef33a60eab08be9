// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/SurfaceReader.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>

#include "SurfaceDecoder.h"
#include "SurfaceText.h"
#include "UntrustedRead.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::imaging {
namespace {

// 256 MiB contain five million triangles, a hundred times what a cochlea needs.
constexpr std::size_t maxBytes = 256u << 20;
// A file of that size, its triangles and those of its strips and polygons (choice, medium).
constexpr std::size_t maxChildBytes = 4 * maxBytes;

/// A file descriptor, closed with its owner.
class OwnedDescriptor {
public:
  explicit OwnedDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~OwnedDescriptor()
  {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OwnedDescriptor(const OwnedDescriptor&) = delete;
  OwnedDescriptor& operator=(const OwnedDescriptor&) = delete;
  int get() const { return descriptor_; }

private:
  int descriptor_;
};

bool writeBytes(int descriptor, const void* from, std::size_t bytes)
{
  const char* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const ::ssize_t written = ::write(descriptor, at, bytes);
    if (written <= 0) return false;
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

bool readBytes(int descriptor, void* to, std::size_t bytes)
{
  char* at = static_cast<char*>(to);
  while (bytes > 0) {
    const ::ssize_t count = ::read(descriptor, at, bytes);
    if (count <= 0) return false;
    at += count;
    bytes -= static_cast<std::size_t>(count);
  }
  return true;
}

using Corner = decltype(anatomy::Surface::points)::value_type;
using Triangle = decltype(anatomy::Surface::triangles)::value_type;

bool writeTo(int descriptor, const anatomy::Surface& surface)
{
  const std::uint64_t counts[2] = {surface.points.size(), surface.triangles.size()};
  return writeBytes(descriptor, counts, sizeof counts) &&
         writeBytes(descriptor, surface.points.data(), surface.points.size() * sizeof(Corner)) &&
         writeBytes(descriptor, surface.triangles.data(),
                    surface.triangles.size() * sizeof(Triangle));
}

/// The surface that a child wrote; empty if it is incomplete.
std::optional<anatomy::Surface> readFrom(int descriptor)
{
  std::uint64_t counts[2] = {0, 0};
  if (::lseek(descriptor, 0, SEEK_SET) != 0 || !readBytes(descriptor, counts, sizeof counts) ||
      counts[0] > maxChildBytes / sizeof(Corner) || counts[1] > maxChildBytes / sizeof(Triangle))
    return std::nullopt;
  anatomy::Surface surface;
  surface.points.resize(counts[0]);
  surface.triangles.resize(counts[1]);
  if (!readBytes(descriptor, surface.points.data(), counts[0] * sizeof(Corner)) ||
      !readBytes(descriptor, surface.triangles.data(), counts[1] * sizeof(Triangle)))
    return std::nullopt;
  return surface;
}

/// Whether a binary STL is as long as its triangles are; VTK's reader does not check it.
bool isWholeStl(const std::string& content)
{
  if (content.size() < 84) return false;
  std::uint32_t count = 0;
  for (std::size_t k = 4; k-- > 0;)
    count = (count << 8) | static_cast<unsigned char>(content[80 + k]);
  return content.size() == 84 + 50 * static_cast<std::size_t>(count);
}

/// A text as a file in memory, for a reader that wants a name.
class TextFile {
public:
  explicit TextFile(const std::string& text) : memory_(::memfd_create("text", MFD_CLOEXEC))
  {
    if (memory_.get() >= 0) isWritten_ = writeBytes(memory_.get(), text.data(), text.size());
  }
  bool isWritten() const { return isWritten_; }
  std::filesystem::path name() const { return "/proc/self/fd/" + std::to_string(memory_.get()); }

private:
  OwnedDescriptor memory_;
  bool isWritten_ = false;
};

/// What a file is read from, once its content was seen.
struct Readable {
  std::optional<std::string> text;  ///< Instead of the file.
  std::optional<PlyHeader> ply;     ///< Header of a binary PLY.
};

/// Refuses what VTK would read wrong, or end with. Without a subject; an empty error for damage.
Result<Readable> readableForm(const std::string& content, const std::string& ending)
{
  const Error damaged{Sentence()};
  Readable form;
  const auto withPoints = [](const std::string& number) {
    return Error{
        "has numbers with a decimal comma, such as '%1'. Export it with points, or replace the "
        "commas by points.",
        number};
  };
  if (ending == ".vtp") {
    if (content.find("<VTKFile") == std::string::npos) return damaged;
  } else if (ending == ".stl") {
    form.text = namelessStl(content);
    if (form.text)
      if (const auto number = commaNumber(*form.text)) return withPoints(*number);
    if (!form.text && !isWholeStl(content)) return damaged;
  } else {
    form.ply = plyHeader(content);
    if (!form.ply) return damaged;
    if (form.ply->isText)
      if (const auto number = commaNumber(content, form.ply->end)) return withPoints(*number);
    if (const auto fine = checkPly(*form.ply, content); !fine) return fine.error();
    if (form.ply->isText) form.ply.reset();
  }
  return form;
}

/// Reads the surface in a child process: damaged files make VTK print, and allocate what their
/// headers claim. Empty if it cannot.
std::optional<anatomy::Surface> decodeGuarded(const std::filesystem::path& file,
                                              const std::string& ending, const Readable& form,
                                              std::size_t fileBytes)
{
  const OwnedDescriptor memory(::memfd_create("surface", MFD_CLOEXEC));
  std::optional<TextFile> text;
  if (form.text) text.emplace(*form.text);
  if (memory.get() < 0 || (text && !text->isWritten())) return std::nullopt;
  const auto decode = [&] {
    std::size_t corners = 0;
    const auto surface = decodeSurface(text ? text->name() : file, ending, corners);
    if (surface && form.ply) {
      const auto bytes = plyDataBytes(*form.ply, corners);
      if (bytes && form.ply->end + *bytes != fileBytes) return childFailed;
    }
    return surface && writeTo(memory.get(), *surface) ? 0 : childFailed;
  };
  if (runInChild(decode, {maxChildBytes, {}, {}}) != 0) return std::nullopt;
  return readFrom(memory.get());
}

}  // namespace

Result<anatomy::Surface> readSurface(const std::filesystem::path& file)
{
  const std::string name = file.string();
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".stl" && ending != ".ply" && ending != ".vtp")
    return Error{
        "%1 ends in '%2'; a surface is read from .stl, .ply or .vtp. Export it as one of these.",
        name, ending};
  const auto content = readWhole(file, maxBytes);
  if (!content) return content.error();
  const Error damaged{name + " is not a whole " + ending +
                      " file of a surface, or needs over 1 GiB to read. Export it again from the "
                      "segmentation program."};
  try {
    const auto form = readableForm(*content, ending);
    if (!form)
      return form.error().message.empty() ? damaged : Error{"%1 %2", name, form.error().message};
    if (auto surface = decodeGuarded(file, ending, *form, content->size()))
      return *std::move(surface);
    return damaged;
  } catch (const std::exception&) {  // sizes beyond the available memory
    return damaged;
  }
}

}  // namespace perilymph::imaging
