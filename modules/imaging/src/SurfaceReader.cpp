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

#include "PlyFile.h"
#include "SurfaceDecoder.h"
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

/// Whether VTK also regards the content as text: above a fraction of other bytes, such as control
/// characters, it takes the file for binary and its text for a number of triangles.
bool isPlainText(const std::string& content)
{
  return std::all_of(content.begin(), content.end(), [](char c) {
    return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
  });
}

/// Whether the content matches the extension; VTK's readers do not check it.
bool beginsRight(const std::string& content, const std::string& ending)
{
  if (ending == ".vtp") return content.find("<VTKFile") != std::string::npos;
  const bool isText = content.rfind("solid", 0) == 0 && content.find("facet") != std::string::npos;
  if (isText && isPlainText(content)) return true;
  if (content.size() < 84) return false;
  std::uint32_t count = 0;
  for (std::size_t k = 4; k-- > 0;)
    count = (count << 8) | static_cast<unsigned char>(content[80 + k]);
  return content.size() == 84 + 50 * static_cast<std::size_t>(count);
}

/// Reads the surface in a child process: damaged files make VTK print, and allocate what their
/// headers claim. Empty if it cannot.
std::optional<anatomy::Surface> decodeGuarded(const std::filesystem::path& file,
                                              const std::string& ending)
{
  const OwnedDescriptor memory(::memfd_create("surface", MFD_CLOEXEC));
  if (memory.get() < 0) return std::nullopt;
  const auto decode = [&] {
    const auto surface = decodeSurface(file, ending);
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
    return Error{name + " ends in '" + ending +
                 "'; a surface is read from .stl, .ply or .vtp. Export it as one of these."};
  const auto content = readWhole(file, maxBytes);
  if (!content) return content.error();
  const Error damaged{name + " is not a whole " + ending +
                      " file of a surface, or needs over 1 GiB to read. Export it again from the "
                      "segmentation program."};
  try {
    if (ending == ".ply") {
      if (auto surface = readPly(*content)) return *std::move(surface);
      return damaged;
    }
    if (!beginsRight(*content, ending)) return damaged;
    if (auto surface = decodeGuarded(file, ending)) return *std::move(surface);
    return damaged;
  } catch (const std::exception&) {  // sizes beyond the available memory
    return damaged;
  }
}

}  // namespace perilymph::imaging
