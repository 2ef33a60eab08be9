// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/RealEars.h"

#include <zlib.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace perilymph::test {
namespace {

const Eigen::Vector3d lpsFromRas(-1.0, -1.0, 1.0);

std::vector<char> unzipped(const std::filesystem::path& file)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> open(gzopen(file.c_str(), "rb"), gzclose);
  if (!open) throw std::runtime_error(file.string() + " cannot be read.");
  std::vector<char> bytes;
  std::vector<char> chunk(1 << 20);
  for (int got = 0; (got = gzread(open.get(), chunk.data(), 1 << 20)) > 0;)
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + got);
  return bytes;
}

template <class Value>
Value read(const std::vector<char>& bytes, std::size_t at)
{
  Value value;
  if (at + sizeof value > bytes.size()) throw std::runtime_error("A NIfTI file is cut short.");
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// A NIfTI file with a QForm without rotation, as in these ears; converts RAS to LPS.
ct::CtVolume readNifti(const std::filesystem::path& file, int scale)
{
  const std::vector<char> bytes = unzipped(file);
  std::array<int, 3> size{};
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    size[axis] = read<std::int16_t>(bytes, 42 + 2 * axis);
    lps(a, a) = lpsFromRas[a] * static_cast<double>(read<float>(bytes, 80 + 4 * axis));
    lps(a, 3) = lpsFromRas[a] * static_cast<double>(read<float>(bytes, 268 + 4 * axis));
    if (read<float>(bytes, 256 + 4 * axis) != 0.0F)
      throw std::runtime_error(file.string() + " is rotated; this reader takes axial files only.");
  }
  const auto type = read<std::int16_t>(bytes, 70);
  const auto first = static_cast<std::size_t>(read<float>(bytes, 108));
  const std::size_t count = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                            static_cast<std::size_t>(size[2]);
  std::vector<std::int16_t> voxels(count);
  for (std::size_t i = 0; i < count; ++i)
    voxels[i] = static_cast<std::int16_t>(
        scale * (type == 4 ? read<std::int16_t>(bytes, first + 2 * i)
                           : static_cast<std::int16_t>(read<std::uint8_t>(bytes, first + i))));
  auto volume = ct::CtVolume::make(size, lps, std::move(voxels), {"", "", "NIfTI"});
  if (!volume) throw std::runtime_error(volume.error().message);
  return std::move(*volume);
}

Eigen::Vector3d lps(const nlohmann::json& ras)
{
  return lpsFromRas.cwiseProduct(
      Eigen::Vector3d(ras.at(0).get<double>(), ras.at(1).get<double>(), ras.at(2).get<double>()));
}

}  // namespace

std::optional<std::filesystem::path> realEarFolder()
{
  const char* folder = std::getenv("PERILYMPH_EARS");
  if (folder == nullptr || *folder == '\0') return std::nullopt;
  return folder;
}

std::vector<std::string> realEarNames(const std::filesystem::path& folder)
{
  const std::string end = "_CT_RAW.nii.gz";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > end.size() && name.substr(name.size() - end.size()) == end)
      names.push_back(name.substr(0, name.size() - end.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

RealEar loadRealEar(const std::filesystem::path& folder, const std::string& name)
{
  std::ifstream file(folder / (name + "_DESC.json"));
  std::stringstream text;
  text << file.rdbuf();
  // Some of the files have a comma before a closing brace.
  const auto json =
      nlohmann::json::parse(std::regex_replace(text.str(), std::regex(",(\\s*[}\\]])"), "$1"));
  const auto& marks = json.at("LANDMARKS");
  const auto& frame = json.at("COORD");
  Eigen::Matrix3d axes;
  axes.col(2) = lps(frame.at("ZAXIS")).normalized();
  const Eigen::Vector3d x = lps(frame.at("XAXIS"));
  axes.col(0) = (x - x.dot(axes.col(2)) * axes.col(2)).normalized();
  const bool isRight = json.at("SIDE").get<std::string>() == "RIGHT";
  axes.col(1) = (isRight ? 1.0 : -1.0) * axes.col(2).cross(axes.col(0));
  return {name,
          isRight,
          readNifti(folder / (name + "_CT_RAW.nii.gz"), 1),
          readNifti(folder / (name + "_CT_LABELS.nii.gz"), 100),
          lps(marks.at("RW")),
          lps(marks.at("C")),
          lps(marks.at("A")),
          axes};
}

}  // namespace perilymph::test
