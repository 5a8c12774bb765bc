#include "sim/usb_gadget.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

// Tests the error messages for kernels without gadget support; gadgets themselves are tested in
// tests/vm.

namespace tractus::sim {

namespace fs = std::filesystem;

struct UsbGadgetTest : testing::Test {
    fs::path const folder
        = fs::temp_directory_path() / ("tractus_gadget_test." + std::to_string(::getpid()));
    UsbGadgetPlace const place { .configfs = folder / "config",
                                 .ports = folder / "udc",
                                 .mounts = folder / "run" };

    void SetUp() override { fs::create_directories(place.configfs); }
    void TearDown() override { fs::remove_all(folder); }

    std::string refusal() const
    {
        auto const gadget = UsbGadget::create({ .product = "Test" }, place);
        return gadget ? "" : gadget.error().message;
    }
};

TEST_F(UsbGadgetTest, SaysHowToMountConfigfs)
{
    EXPECT_NE(refusal().find("mount -t configfs"), std::string::npos) << refusal();
}

TEST_F(UsbGadgetTest, SaysWhichModuleIsMissing)
{
    fs::create_directories(place.configfs / "other");
    EXPECT_NE(refusal().find("modprobe libcomposite"), std::string::npos) << refusal();
    EXPECT_EQ(refusal().find("mount -t configfs"), std::string::npos) << refusal();
}

TEST_F(UsbGadgetTest, LeavesNothingBehindWhenTheKernelRefuses)
{
    // No kernel creates the attributes in this imitated folder.
    fs::create_directories(place.configfs / "usb_gadget");
    EXPECT_NE(refusal().find("idVendor"), std::string::npos) << refusal();
    EXPECT_TRUE(fs::is_empty(place.configfs / "usb_gadget"));
}

TEST(WriteAttribute, NamesTheFile)
{
    auto const written = write_attribute("/nonexistent/UDC", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, "cannot write /nonexistent/UDC: No such file or directory");
}

} // namespace tractus::sim
