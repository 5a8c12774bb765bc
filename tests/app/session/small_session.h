#pragma once

#include "app/session/session.h"
#include "tests/app/session/same_edit.h"
#include "tests/app/small_model.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus::session {

// Returns options with a clock that stands still.
inline SessionOptions options_for_tests()
{
    return { scene::core_edit_kinds(), [] { return scene::LoadOptions {}; },
             [] { return std::chrono::sys_seconds(std::chrono::seconds(1'800'000'000)); } };
}

// SQL statements that convert a session to format 1.
constexpr char const* kToFormat1 = "DROP TABLE copies; DROP TABLE meta_copies;"
                                   "ALTER TABLE edits DROP COLUMN made;"
                                   "ALTER TABLE edits DROP COLUMN checksum;"
                                   "PRAGMA user_version = 1;";

// SQL statements that convert a session to format 2. The formats 2 to 4 differ only in their kinds
// of edits.
constexpr char const* kToFormat2 = "DROP TABLE copies; DROP TABLE meta_copies;"
                                   "PRAGMA user_version = 2;";

inline std::vector<scene::Edit> const& beginning()
{
    static std::vector<scene::Edit> const edits { small_model(), scene::SetGrowth {} };
    return edits;
}

// Returns a step that selects the trunk and shapes it by a stroke, whose end depends on `number`.
inline std::vector<scene::Edit> drawing_step(int number)
{
    return { scene::Select { { { 0, 1, 2 } } },
             scene::Associate { stroke_through({ { 0, 0, 0 }, { 10.1 * number, 5, 100 } }) } };
}

inline bool same_scene(scene::Scene const& one, scene::Scene const& other)
{
    bool equal = one.model_name == other.model_name
        && one.base->node_position_mm == other.base->node_position_mm
        && one.selection == other.selection && same(one.growth, other.growth)
        && one.associations.size() == other.associations.size()
        && one.indicators.size() == other.indicators.size();
    for (std::size_t i = 0; equal && i < one.associations.size(); ++i) {
        auto const& a = one.associations[i].what;
        auto const& b = other.associations[i].what;
        equal = one.associations[i].id == other.associations[i].id && a.path == b.path
            && same(a.stroke, b.stroke) && a.propagation == b.propagation && a.fit == b.fit
            && same(a.detail_weight, b.detail_weight) && a.laying == b.laying
            && a.is_orphaned == b.is_orphaned;
    }
    for (std::size_t i = 0; equal && i < one.indicators.size(); ++i)
        equal = same(one.indicators[i].what, other.indicators[i].what);
    return equal;
}

// Fixture with an empty folder for session files.
class SessionFolder : public testing::Test {
protected:
    void SetUp() override
    {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path path(std::string const& name = "a.tractus") const
    {
        return folder_ / name;
    }

    Result<Session> create(std::string const& name = "a.tractus") const
    {
        return Session::create(path(name), { .plant = "small.l", .program = "1.2.3" }, beginning(),
                               options_for_tests());
    }

    Result<Session> open(std::string const& name = "a.tractus") const
    {
        return Session::open(path(name), options_for_tests());
    }

    std::string read_bytes(std::string const& name = "a.tractus") const
    {
        return file_bytes(path(name));
    }

    void write_bytes(std::string const& name, std::string const& bytes) const
    {
        std::ofstream(path(name), std::ios::binary) << bytes;
    }

    // Returns the error message for a session that can be opened neither for reading nor for
    // writing.
    std::string refusal(std::string const& name) const
    {
        auto const read = read_session(path(name), scene::core_edit_kinds());
        auto const opened = open(name);
        EXPECT_FALSE(read);
        EXPECT_FALSE(opened);
        if (read || opened)
            return "";
        EXPECT_EQ(read.error().message, opened.error().message);
        EXPECT_EQ(read.error().fault, Fault::User);
        return read.error().message;
    }

    std::size_t file_count() const
    {
        auto const entries = std::filesystem::directory_iterator(folder_);
        return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
    }

private:
    std::filesystem::path folder_ = std::filesystem::temp_directory_path()
        / ("tractus_session_" + std::to_string(::getpid()));
};

} // namespace tractus::session
