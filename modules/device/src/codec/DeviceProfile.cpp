// SPDX-License-Identifier: BSD-3-Clause
#include "codec/DeviceProfile.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "codec/ProfileTables.h"
#include "hid/Transport.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::device {

namespace {

constexpr const char* folder = "plugins/devices";

bool isPlain(CodecKind kind) { return kind == CodecKind::encoders || kind == CodecKind::vector; }

CodecKind readKind(TomlReader& file)
{
  static constexpr std::array kinds{Choice<CodecKind>{CodecKind::encoders, "encoders"},
                                    Choice<CodecKind>{CodecKind::vector, "vector"},
                                    Choice<CodecKind>{CodecKind::pid, "pid"},
                                    Choice<CodecKind>{CodecKind::spaceMouse, "spacemouse"},
                                    Choice<CodecKind>{CodecKind::joystick, "joystick"}};
  return file.choice("kind", kinds);
}

std::optional<std::uint16_t> sixteenBits(TomlReader& table, const char* key)
{
  if (!table.has(key)) return std::nullopt;
  return static_cast<std::uint16_t>(table.integer(key, 0, 0xffff, 0));
}

std::optional<Usage> readUsage(TomlReader& table, const char* pageKey, const char* idKey)
{
  const auto page = sixteenBits(table, pageKey);
  const auto id = sixteenBits(table, idKey);
  if (page.has_value() != id.has_value())
    table.refuse(page ? pageKey : idKey,
                 std::string(pageKey) + " and " + idKey + " belong together; give both or none.");
  if (!page || !id) return std::nullopt;
  return Usage{*page, *id};
}

DeviceMatch readMatch(TomlReader& table)
{
  DeviceMatch match;
  match.vendor = sixteenBits(table, "vendor_id");
  match.product = sixteenBits(table, "product_id");
  if (table.has("interface"))
    match.interfaceNumber = static_cast<int>(table.integer("interface", 0, 255, 0));
  match.usage = readUsage(table, "usage_page", "usage");
  match.contains = readUsage(table, "contains_page", "contains_usage");
  if (match.product && !match.vendor)
    table.refuse("product_id", "product_id means nothing without vendor_id; give both.");
  if (!match.vendor && !match.usage && !match.contains)
    table.refuse("interface",
                 "a [[match]] must name a vendor_id, a usage or a contained usage; else it would "
                 "take every device.");
  return match;
}

DeviceTraits readCapability(TomlReader& table, CodecKind kind)
{
  DeviceTraits traits;
  traits.nominalPeriod = 1e-3 * table.number("nominal_period_ms", {0.1, 100.0});
  traits.workspaceRadius = 1e-3 * table.number("workspace_radius_mm", {0.0, 1000.0}, 0.0);
  traits.transportDelay = 1e-3 * table.number("transport_delay_ms", {0.0, 100.0}, 0.0);
  traits.buttons = static_cast<int>(table.integer("buttons", 0, 32, 1));
  static constexpr std::array reportings{Choice<Reporting>{Reporting::periodic, "periodic"},
                                         Choice<Reporting>{Reporting::onChange, "on_change"},
                                         Choice<Reporting>{Reporting::onWrite, "on_write"},
                                         Choice<Reporting>{Reporting::polled, "polled"}};
  traits.reporting = table.choice("reporting", reportings, Reporting::periodic);
  if (traits.reporting == Reporting::polled || table.has("polled_report"))
    traits.polledReport = static_cast<std::uint8_t>(table.integer("polled_report", 0, 255, 0));

  if (isPlain(kind)) {
    static constexpr std::array axes{
        Choice<std::uint32_t>{0b111, "xyz"}, Choice<std::uint32_t>{0b011, "xy"},
        Choice<std::uint32_t>{0b101, "xz"},  Choice<std::uint32_t>{0b110, "yz"},
        Choice<std::uint32_t>{0b001, "x"},   Choice<std::uint32_t>{0b010, "y"},
        Choice<std::uint32_t>{0b100, "z"}};
    traits.actuatedAxes = table.choice("axes", axes, std::uint32_t{0b111});
    traits.sensedTranslations = std::popcount(traits.actuatedAxes);
  }
  const bool mayRender = isPlain(kind) || kind == CodecKind::pid;
  traits.rendersForce = table.has("max_force_N");
  if (traits.rendersForce && !mayRender)
    table.refuse("max_force_N",
                 "max_force_N does not fit this kind of device, which renders no "
                 "force; leave it out.");
  if (!traits.rendersForce && kind == CodecKind::pid)
    table.refuse("nominal_period_ms",
                 "max_force_N is missing; a device of the kind \"pid\" must "
                 "say how many newtons its greatest magnitude is.");
  if (traits.rendersForce) {
    traits.maxForce = table.number("max_force_N", {0.01, 50.0});
    traits.maxStiffness = table.number("max_stiffness_N_m", {0.0, 1e5}, 0.0);
    traits.maxDamping = table.number("max_damping_N_s_m", {0.0, 1000.0}, 0.0);
    traits.handleDamping = table.number("handle_damping_N_s_m", {0.01, 100.0}, 0.0);
    traits.handleMass = table.number("handle_mass_kg", {1e-3, 10.0}, 0.0);
    traits.watchdog = 1e-3 * table.number("watchdog_ms", {0.0, 10000.0}, 0.0);
    if (traits.reporting == Reporting::onChange)
      table.refuse("reporting",
                   "reporting is \"on_change\"; a device that renders force must report all the "
                   "time: silence could not be told from a broken line. Leave max_force_N out.");
  }
  return traits;
}

/// A proper rotation: orthonormal and right-handed rows.
void readMount(TomlReader& table, DeviceProfile& profile)
{
  profile.graspButton = static_cast<std::uint32_t>(table.integer("grasp_button", 1, 32, 1));
  profile.forceScale = table.number("force_scale", {0.01, 100.0}, 1.0);
  if (!table.has("rotation")) return;
  const std::vector<double> values = table.numbers("rotation", {-1.0, 1.0}, 9);
  const auto& m = profile.mount_DB;
  std::copy_n(values.begin(), 9, profile.mount_DB.begin());
  double worst = values.size() == 9 ? 0.0 : 1.0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      const double product =
          m[3 * i] * m[3 * j] + m[3 * i + 1] * m[3 * j + 1] + m[3 * i + 2] * m[3 * j + 2];
      worst = std::max(worst, std::fabs(product - (i == j ? 1.0 : 0.0)));
    }
  const double volume = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                        m[2] * (m[3] * m[7] - m[4] * m[6]);
  if (worst > 1e-6 || volume < 0.0)
    table.refuse(
        "rotation",
        "rotation is not a rotation matrix; give 9 numbers, row by row: rows of length 1, at right "
        "angles, right-handed.");
}

std::vector<FixedReport> readReports(TomlReader& file, const char* key)
{
  static constexpr std::array kinds{Choice<ReportKind>{ReportKind::output, "output"},
                                    Choice<ReportKind>{ReportKind::feature, "feature"}};
  std::vector<FixedReport> reports;
  for (TomlReader& table : file.tables(key)) {
    FixedReport report;
    report.kind = table.choice("kind", kinds);
    const std::vector<double> bytes = table.numbers("bytes", {0.0, 255.0}, 2);
    if (bytes.size() > longestReport)
      table.refuse("bytes", "bytes has " + std::to_string(bytes.size()) + " numbers; at most " +
                                std::to_string(longestReport) + " make a report.");
    for (const std::int64_t byte : wholeNumbers(table, "bytes", 0.0, 255.0, bytes.size()))
      report.bytes.push_back(static_cast<std::uint8_t>(byte));
    reports.push_back(std::move(report));
  }
  return reports;
}

DeviceProfile read(TomlReader& file)
{
  DeviceProfile profile;
  profile.file = file.name();
  profile.name = file.text("name");
  profile.maker = file.text("maker");
  profile.note = file.text("note", "");
  profile.source = file.text("source");
  profile.confidence = file.choice("confidence", {"high", "medium", "low"});
  profile.kind = readKind(file);

  for (TomlReader& match : file.tables("match")) profile.matches.push_back(readMatch(match));
  if (profile.matches.empty())
    file.refuse("kind", "[[match]] is missing; without one no device would be found.");

  TomlReader capability = file.table("capability");
  profile.traits = readCapability(capability, profile.kind);
  profile.traits.name = profile.name;
  TomlReader mount = file.table("mount");
  readMount(mount, profile);
  if (isPlain(profile.kind)) {
    profile.plain = readPlainLayout(file, profile.kind, profile.traits.rendersForce);
  } else {
    profile.axes = readAxesLayout(file, profile.kind);
    if (profile.kind == CodecKind::pid) profile.pid = readPidLayout(file, profile.axes);
  }
  profile.onOpen = readReports(file, "on_open");
  profile.onClose = readReports(file, "on_close");
  return profile;
}

Result<DeviceProfile> finished(Result<TomlReader> reader)
{
  if (!reader) return reader.error();
  DeviceProfile profile = read(*reader);
  if (const Result<void> done = reader->finish(); !done) return done.error();
  return profile;
}

void addTo(ProfileCatalog& catalog, const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) {
    catalog.broken.push_back({reader.error().message, {}});
    return;
  }
  DeviceProfile profile = read(*reader);
  if (const Result<void> done = reader->finish(); !done)
    catalog.broken.push_back({done.error().message, std::move(profile.matches)});
  else
    catalog.profiles.push_back(std::move(profile));
}

/// Quality of a match: 0 for none, larger for more specific criteria.
int fit(const DeviceMatch& match, const HidIdentity& identity, const ReportDescriptor& descriptor)
{
  const auto& groups = descriptor.collections();
  const bool fits =
      (!match.vendor || *match.vendor == identity.vendor) &&
      (!match.product || *match.product == identity.product) &&
      (!match.interfaceNumber || *match.interfaceNumber == identity.interfaceNumber) &&
      (!match.usage || descriptor.hasApplication(*match.usage)) &&
      (!match.contains || std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
        return group.usage == *match.contains;
      }));
  if (!fits) return 0;
  return (match.product ? 16 : 0) + (match.vendor ? 8 : 0) + (match.interfaceNumber ? 4 : 0) +
         (match.contains ? 2 : 0) + (match.usage ? 1 : 0);
}

}  // namespace

Result<DeviceProfile> loadProfile(const std::filesystem::path& file)
{
  return finished(TomlReader::open(file));
}

Result<DeviceProfile> parseProfile(std::string_view text, const std::string& name)
{
  return finished(TomlReader::parse(text, name));
}

ProfileCatalog shippedProfiles()
{
  ProfileCatalog catalog;
  for (const auto& file : tomlFilesIn(resource(folder))) addTo(catalog, file);
  return catalog;
}

ProfileCatalog allProfiles()
{
  ProfileCatalog catalog;
  for (const auto& file : tomlFilesIn(deviceProfileFolder())) addTo(catalog, file);
  for (const auto& file : tomlFilesIn(resource(folder))) addTo(catalog, file);
  return catalog;
}

Result<DeviceProfile> namedProfile(const std::string& nameOrFile)
{
  for (const auto& file : tomlFilesIn(deviceProfileFolder()))
    if (file.stem() == nameOrFile) return loadProfile(file);
  const auto file = findByName("device profile", folder, nameOrFile);
  if (!file) return file.error();
  return loadProfile(*file);
}

int fitOf(std::span<const DeviceMatch> matches, const HidIdentity& identity,
          const ReportDescriptor& descriptor) noexcept
{
  int best = 0;
  for (const DeviceMatch& match : matches) best = std::max(best, fit(match, identity, descriptor));
  return best;
}

const DeviceProfile* matchingProfile(std::span<const DeviceProfile> profiles,
                                     const HidIdentity& identity,
                                     const ReportDescriptor& descriptor) noexcept
{
  const DeviceProfile* best = nullptr;
  int bestFit = 0;
  for (const DeviceProfile& profile : profiles)
    if (const int now = fitOf(profile.matches, identity, descriptor); now > bestFit) {
      best = &profile;
      bestFit = now;
    }
  return best;
}

}  // namespace perilymph::device
