#include "app/plants/session_export.h"

#include "app/plants/session_plant.h"
#include "tests/app/small_model.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus {
namespace {

// A session may come from anybody.
TEST(SessionExport, WritesNothingOutsideOfItsFolder)
{
    auto const folder = std::filesystem::temp_directory_path()
        / ("tractus_session_export_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    for (std::string const name : { "../escaped", "/tmp/tractus_escaped", "a/../../escaped", "" }) {
        auto model = small_model();
        model.source.name = "../../..";
        model.includes[name] = "harm";
        auto const path = folder / "a.tractus";
        std::filesystem::remove(path);
        ASSERT_TRUE(begin_session(path, { model }, core_edit_kinds()));
        auto const written = export_session(path, folder / "inner", core_edit_kinds());
        ASSERT_FALSE(written) << name;
        EXPECT_NE(written.error().message.find("outside the model's folder"), std::string::npos);
        EXPECT_TRUE(std::filesystem::exists(folder / "inner" / "model.l"));
        EXPECT_FALSE(std::filesystem::exists(folder / "escaped"));
    }
    EXPECT_FALSE(std::filesystem::exists("/tmp/tractus_escaped"));
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace tractus
