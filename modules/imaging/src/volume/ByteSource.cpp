// SPDX-License-Identifier: BSD-3-Clause
#include "ByteSource.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <vector>

namespace perilymph::imaging {

struct ByteSource::Stream {
  Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream()
  {
    if (isPacked) ::inflateEnd(&inflater);
  }

  std::filesystem::path file;
  std::ifstream bytes;
  std::uintmax_t fileBytes = 0;
  bool isPacked = false, isEnded = false;
  z_stream inflater = {};
  std::array<char, 1u << 16> packed{};

  /// True if there are packed bytes to inflate.
  bool refill()
  {
    if (inflater.avail_in > 0) return true;
    bytes.read(packed.data(), static_cast<std::streamsize>(packed.size()));
    inflater.next_in = reinterpret_cast<Bytef*>(packed.data());
    inflater.avail_in = static_cast<unsigned>(bytes.gcount());
    return inflater.avail_in > 0;
  }

  Result<std::size_t> inflate(char* to, std::size_t count)
  {
    inflater.next_out = reinterpret_cast<Bytef*>(to);
    inflater.avail_out = static_cast<unsigned>(count);
    while (inflater.avail_out > 0) {
      const bool isThere = refill();
      if (isEnded) {
        if (!isThere) break;
        // gzip files may be joined
        if (::inflateReset(&inflater) != Z_OK) return cutOffFile(file);
        isEnded = false;
      } else if (!isThere) {
        return cutOffFile(file);
      }
      const int state = ::inflate(&inflater, Z_NO_FLUSH);
      if (state == Z_STREAM_END)
        isEnded = true;
      else if (state != Z_OK)
        return cutOffFile(file);
    }
    return count - inflater.avail_out;
  }
};

Result<ByteSource> ByteSource::open(const std::filesystem::path& file, std::size_t from,
                                    Packing packing)
{
  std::error_code failed;
  // a pipe would never end
  if (!std::filesystem::is_regular_file(file, failed)) return unreadableFile(file);
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  auto stream = std::make_shared<Stream>();
  stream->file = file;
  stream->bytes.open(file, std::ios::binary);
  if (failed || !stream->bytes) return unreadableFile(file);
  if (from > size) return cutOffFile(file);
  stream->fileBytes = size - from;
  std::array<char, 2> magic{};
  stream->bytes.seekg(static_cast<std::streamoff>(from));
  stream->bytes.read(magic.data(), magic.size());
  const bool isGzip = magic == std::array<char, 2>{'\x1f', '\x8b'};
  stream->bytes.clear();
  stream->bytes.seekg(static_cast<std::streamoff>(from));
  if (packing == Packing::required || (packing == Packing::detected && isGzip)) {
    constexpr int detectHeader = 32;
    if (::inflateInit2(&stream->inflater, MAX_WBITS + detectHeader) != Z_OK)
      return Error{"%1 cannot be inflated: there is no memory. Close programs.", file};
    stream->isPacked = true;
  }
  return ByteSource(std::move(stream));
}

Result<std::size_t> ByteSource::read(char* to, std::size_t count)
{
  if (stream_->isPacked) return stream_->inflate(to, count);
  stream_->bytes.read(to, static_cast<std::streamsize>(count));
  if (stream_->bytes.bad()) return unreadableFile(stream_->file);
  return static_cast<std::size_t>(stream_->bytes.gcount());
}

Result<void> ByteSource::skip(std::size_t count)
{
  std::array<char, 1u << 12> unused{};
  while (count > 0) {
    const auto done = read(unused.data(), std::min(count, unused.size()));
    if (!done) return done.error();
    if (*done == 0) return cutOffFile(stream_->file);
    count -= *done;
  }
  return {};
}

bool ByteSource::isPacked() const noexcept { return stream_->isPacked; }

std::uintmax_t ByteSource::fileBytes() const noexcept { return stream_->fileBytes; }

Error unreadableFile(const std::filesystem::path& file)
{
  return Error{"%1 cannot be read. Check its name and permissions.", file};
}

Error cutOffFile(const std::filesystem::path& file)
{
  return Error{"%1 is cut off or damaged. Copy or export it again.", file};
}

}  // namespace perilymph::imaging
