#include "engine/base/file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <mutex>
#include <string>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

// Returns the paths of the files for which fsync was called, in the order of the calls.
static std::vector<std::string>& flushed()
{
    static std::vector<std::string> paths;
    return paths;
}

static std::mutex flushed_mutex;

// Replaces the C library's fsync in this program. It records the path of the file, and then flushes
// the file.
extern "C" int fsync(int file)
{
    std::error_code ignored;
    auto const path
        = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), ignored).string();
    {
        std::lock_guard const lock(flushed_mutex);
        flushed().push_back(path);
    }
    return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace tractus {
namespace {

namespace fs = std::filesystem;

class File : public ::testing::Test {
protected:
    void SetUp() override
    {
        auto const* const test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(::testing::TempDir()) / (std::string("tractus_file_") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::size_t file_count() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
    }

    fs::path folder_;
};

TEST_F(File, KeepsThePermissionsOfWhatItReplaces)
{
    auto const path = folder_ / "private";
    auto const permissions = [&] { return fs::status(path).permissions(); };
    ASSERT_TRUE(write_file(path, "one"));
    auto const usual = permissions();
    for (auto const wanted : { fs::perms(0600), fs::perms(0640), fs::perms(0666), usual }) {
        fs::permissions(path, wanted);
        ASSERT_TRUE(write_file(path, "two"));
        EXPECT_EQ(permissions(), wanted);
        auto const seen_while_written = [&](std::ostream& out) -> Result<void> {
            for (auto const& entry : fs::directory_iterator(folder_))
                EXPECT_EQ(entry.status().permissions(), wanted) << entry.path();
            out << "three";
            return {};
        };
        ASSERT_TRUE(write_file(path, seen_while_written));
        EXPECT_EQ(permissions(), wanted);
        EXPECT_EQ(read_file(path).value(), "three");
    }
}

TEST_F(File, ReadsNoDeviceAsItMayHaveNoEnd)
{
    auto const read = read_file("/dev/zero");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message, "cannot read /dev/zero: it is a device");
    EXPECT_FALSE(read_file("/dev/null"));
}

TEST_F(File, WritesAndReadsBytes)
{
    std::string const bytes("a\0b\n", 4);
    ASSERT_TRUE(write_file(folder_ / "x", bytes));
    EXPECT_EQ(read_file(folder_ / "x").value(), bytes);
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, KeepsTheOldFileWhenTheWriterFails)
{
    ASSERT_TRUE(write_file(folder_ / "x", "old"));
    auto const result = write_file(folder_ / "x", [](std::ostream& out) -> Result<void> {
        out << "half of the ne";
        return fail(Fault::User, "no more");
    });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "no more");
    EXPECT_EQ(read_file(folder_ / "x").value(), "old");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, SaysWhyAFileCannotBeWritten)
{
    ASSERT_TRUE(write_file(folder_ / "file", "bytes"));
    auto const result = write_file(folder_ / "file" / "x", "bytes");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("Not a directory"), std::string::npos)
        << result.error().message;
}

TEST_F(File, KnowsBeforehandWhereNothingCanBeWritten)
{
    ASSERT_TRUE(write_file(folder_ / "file", "bytes"));
    EXPECT_TRUE(check_writable(folder_ / "new"));
    EXPECT_TRUE(check_writable(folder_ / "file"));
    EXPECT_TRUE(check_writable(folder_ / "a" / "b" / "new"));
    EXPECT_FALSE(fs::exists(folder_ / "a"));
    EXPECT_TRUE(check_writable("/dev/full"));
    EXPECT_EQ(check_writable(folder_).error().message,
              "cannot write " + folder_.string() + ": it is a folder");
    auto const below = (folder_ / "file" / "a" / "b").string();
    EXPECT_EQ(check_writable(below).error().message,
              "cannot write " + below + ": " + (folder_ / "file").string() + " is no folder");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, MakesTheFoldersThatItIsIn)
{
    EXPECT_TRUE(write_file(folder_ / "a" / "b" / "x", "bytes"));
    EXPECT_EQ(read_file(folder_ / "a" / "b" / "x").value(), "bytes");
}

// The contents of a file must reach the disk before its new name, and then the folder. In another
// order, a power failure could leave an empty file under the new name, or the old file.
TEST_F(File, LetsTheDiskTakeAFileBeforeItsNameAndThenItsFolder)
{
    flushed().clear();
    ASSERT_TRUE(write_file(folder_ / "x", "bytes"));
    ASSERT_EQ(flushed().size(), 2u);
    EXPECT_EQ(flushed()[0].find((folder_ / "x.").string()), 0u) << flushed()[0];
    EXPECT_EQ(flushed()[1], folder_.string());
}

TEST_F(File, ManyWritersAtOnceDoNotDisturbEachOther)
{
    std::vector<std::thread> writers;
    for (int i = 0; i < 8; ++i)
        writers.emplace_back([&, i] {
            for (int j = 0; j < 20; ++j)
                EXPECT_TRUE(
                    write_file(folder_ / "x", std::string(10'000, static_cast<char>('a' + i))));
        });
    for (auto& writer : writers)
        writer.join();
    auto const bytes = read_file(folder_ / "x").value();
    EXPECT_EQ(bytes, std::string(10'000, bytes.at(0))) << "one writer's, whole";
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, WritesWhatALinkPointsTo)
{
    ASSERT_TRUE(write_file(folder_ / "x", "old"));
    fs::create_symlink("x", folder_ / "link");
    ASSERT_TRUE(write_file(folder_ / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_file(folder_ / "x").value(), "new");
}

TEST_F(File, LeavesADeviceADevice)
{
    auto const result = write_file("/dev/full", "bytes");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "cannot write /dev/full: No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(File, SaysWhyAFileCannotBeRead)
{
    EXPECT_NE(read_file(folder_ / "x").error().message.find("No such file"), std::string::npos);
    EXPECT_NE(read_file(folder_).error().message.find("it is a folder"), std::string::npos);
    ASSERT_TRUE(write_file(folder_ / "x", "12345"));
    EXPECT_NE(read_file(folder_ / "x", 4).error().message.find("larger than 4 bytes"),
              std::string::npos);
}

} // namespace
} // namespace tractus
