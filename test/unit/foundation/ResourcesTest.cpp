// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Resources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>

#include "perilymph/foundation/Version.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Sets or removes an environment variable, and restores the previous value.
class Variable {
public:
  Variable(const char* name, const std::optional<std::string>& value) : name_(name)
  {
    if (const char* older = std::getenv(name)) older_ = older;
    apply(value);
  }
  ~Variable() { apply(older_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

private:
  void apply(const std::optional<std::string>& value)
  {
    if (value)
      ::setenv(name_, value->c_str(), 1);
    else
      ::unsetenv(name_);
  }

  const char* name_;
  std::optional<std::string> older_;
};

/// A resource folder with a few arrays of two manufacturers.
class ShippedArrays : public testing::Test {
protected:
  ShippedArrays() : root_("PERILYMPH_RESOURCES", folder_.path().string())
  {
    put("arrays/straight.toml");
    put("arrays/one/curved.toml");
    put("arrays/one/both.toml");
    put("arrays/two/both.toml");
    put("arrays/two/notes.txt");
    put("arrays/two/deeper/hidden.toml");
    put("outside.toml");
  }

  void put(const fs::path& file)
  {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << "name = 'x'\n";
  }

  std::string messageFor(const std::string& name)
  {
    const Result<fs::path> found = findByName("array", "arrays", name);
    return found ? Sentence("found " + found->string()) : found.error().message;
  }

  test::TemporaryFolder folder_;
  Variable root_;
};

TEST_F(ShippedArrays, AreFoundByNameInTheFolderAndOneBelow)
{
  EXPECT_EQ(*findByName("array", "arrays", "straight"), folder_ / "arrays/straight.toml");
  EXPECT_EQ(*findByName("array", "arrays", "curved"), folder_ / "arrays/one/curved.toml");
}

TEST_F(ShippedArrays, AreFoundByPath)
{
  const std::string path = (folder_ / "arrays/two/deeper/hidden.toml").string();
  EXPECT_EQ(*findByName("array", "arrays", path), path);
}

TEST_F(ShippedArrays, HaveNamesInOrder)
{
  EXPECT_THAT(shippedNames("arrays"), ElementsAre("both", "curved", "straight"));
  EXPECT_TRUE(shippedNames("no-such-folder").empty());
}

TEST_F(ShippedArrays, AnswerAnUnknownNameWithTheNamesThereAre)
{
  EXPECT_EQ(
      messageFor("bent"),
      "There is no array or file 'bent'. The names there are: both, curved, straight. Give one "
      "of these or the path of a TOML file.");
}

TEST_F(ShippedArrays, AnswerTheNameOfTwoFilesWithBoth)
{
  EXPECT_THAT(messageFor("both"), AllOf(HasSubstr("one/both.toml"), HasSubstr("two/both.toml")));
}

TEST_F(ShippedArrays, AreNotLookedForOutsideTheirFolder)
{
  EXPECT_THAT(messageFor("../outside"), StartsWith("There is no array or file '../outside'."));
  EXPECT_THAT(messageFor("one/curved"), StartsWith("There is no array or file"));
  EXPECT_THAT(messageFor(""), StartsWith("There is no array or file ''."));
  EXPECT_THAT(messageFor(".."), HasSubstr("is a folder"));
}

TEST_F(ShippedArrays, AnswerWhereThereAreNone)
{
  const Result<fs::path> found = findByName("array", "empty", "x");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message,
              HasSubstr("None is shipped in " + (folder_ / "empty").string()));
}

TEST(Resources, StandWhereTheEnvironmentSays)
{
  const Variable root("PERILYMPH_RESOURCES", "/somewhere/else");
  EXPECT_EQ(resource("resources/icons/app.svg"), "/somewhere/else/resources/icons/app.svg");
}

// What changes results is stated wherever the build is.
TEST(BuildId, NamesTheEnvironmentThatReplacesResourcesAndDevices)
{
  const Variable devices("PERILYMPH_SYSTEM_ROOT", std::nullopt);
  const Variable own("PERILYMPH_RESOURCES", std::nullopt), few(fewDraws, std::nullopt);
  const std::string plain = buildId();
  EXPECT_EQ(plain.find("PERILYMPH"), std::string::npos);
  {
    const Variable same("PERILYMPH_RESOURCES", resourceRoot().string() + "/resources/..");
    EXPECT_EQ(buildId(), plain);
  }
  const Variable other("PERILYMPH_RESOURCES", "/somewhere/else");
  EXPECT_EQ(buildId(), plain + " with PERILYMPH_RESOURCES");
  const Variable recorded("PERILYMPH_SYSTEM_ROOT", "/recorded");
  EXPECT_EQ(buildId(), plain + " with PERILYMPH_RESOURCES with PERILYMPH_SYSTEM_ROOT");
  const Variable cheap(fewDraws, "1");
  EXPECT_THAT(buildId(), testing::EndsWith(" with PERILYMPH_FEW_DRAWS"));
}

TEST(Resources, AreFoundWithoutTheEnvironment)
{
  const Variable root("PERILYMPH_RESOURCES", std::nullopt);
  EXPECT_TRUE(fs::is_directory(resource("resources")));
}

TEST(SessionFolder, FollowsTheXdgRules)
{
  const Variable home("HOME", "/home/ana");
  {
    const Variable data("XDG_DATA_HOME", "/data");
    EXPECT_EQ(sessionFolder(), "/data/perilymph/sessions");
  }
  {
    const Variable data("XDG_DATA_HOME", std::nullopt);
    EXPECT_EQ(sessionFolder(), "/home/ana/.local/share/perilymph/sessions");
  }
  const Variable relative("XDG_DATA_HOME", "not/absolute");
  EXPECT_EQ(sessionFolder(), "/home/ana/.local/share/perilymph/sessions");
}

TEST(SessionFolder, IsAbsoluteWithoutAHome)
{
  const Variable data("XDG_DATA_HOME", std::nullopt);
  const Variable home("HOME", std::nullopt);
  EXPECT_TRUE(sessionFolder().is_absolute());
}

TEST(Version, BeginsTheBuildId)
{
  EXPECT_THAT(version(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+(-dev)?"));
  EXPECT_THAT(buildId(), StartsWith(version()));
}

}  // namespace
}  // namespace perilymph
