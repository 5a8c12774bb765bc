#include "engine/base/unfinished_file.h"

#include <chrono>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

// Returns the number of a process that has ended.
pid_t ended_process()
{
    pid_t const child = ::fork();
    if (child == 0)
        ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

class UnfinishedFileTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    void leave(std::string const& name, std::chrono::hours age) const
    {
        std::ofstream(folder_ / name) << "the first half";
        fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - age);
    }

    std::set<std::string> names() const
    {
        std::set<std::string> names;
        for (auto const& entry : fs::directory_iterator(folder_))
            names.insert(entry.path().filename().string());
        return names;
    }

    fs::path folder_ = fs::temp_directory_path() / fmt::format("tractus_unfinished_{}", ::getpid());
};

TEST_F(UnfinishedFileTest, OfAKilledProcessGoesTheNextDay)
{
    using std::chrono::hours;
    auto const ended = ended_process();
    auto const of = [](pid_t process, char const* ending) {
        return fmt::format("a.glb.{}-7000.part{}", process, ending);
    };
    for (char const* const ending : { "", ".part", "-wal", "-shm", "-journal", ".part-journal" })
        leave(of(ended, ending), hours(25));
    auto const of_today = "b" + of(ended, "");
    leave(of_today, hours(1));
    std::set<std::string> kept { of_today };
    for (auto const& name :
         { of(::getpid(), ""), std::string("letter.part"), fmt::format("disk.{}.part", ended),
           std::string("-1.part"), fmt::format("a.glb.{}-.part", ended),
           fmt::format("a.glb.{}-0.parts", ended) }) {
        leave(name, hours(25));
        kept.insert(name);
    }
    ASSERT_TRUE(write_file(folder_ / "a.glb", "whole"));
    kept.insert("a.glb");
    EXPECT_EQ(names(), kept);
}

TEST_F(UnfinishedFileTest, HasANameOfItsOwn)
{
    auto const target = folder_ / "a.glb";
    auto const first = unfinished_path(target);
    EXPECT_NE(first, unfinished_path(target));
    EXPECT_EQ(first.parent_path(), folder_);
    EXPECT_TRUE(first.filename().string().starts_with("a.glb."));
}

} // namespace
} // namespace tractus
