// Fuzzes session files: reads the input as a session, and repairs it.

#include "app/methods/all_methods.h"
#include "app/session/session_file.h"
#include "app/session/session_repair.h"
#include "tests/fuzz/fuzz_input.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <unistd.h>

// Returns the path of a file in memory if the system has /dev/shm, otherwise in the folder for
// temporary files.
static std::filesystem::path own_file()
{
    std::filesystem::path const memory = "/dev/shm";
    auto const folder = exists(memory) ? memory : std::filesystem::temp_directory_path();
    return folder / fmt::format("session-fuzzer-{}.tractus", getpid());
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    static auto const methods = methods::all_methods();
    static auto const path = own_file();
    FuzzInput const input(data, size);
    std::ofstream(path, std::ios::binary) << input.text();
    auto const session = session::read_session(path, methods.edits);
    if (is_read(session))
        CHECK(!session->edits.empty());
    auto const salvaged = session::salvage_session(path, methods.edits);
    if (is_read(salvaged))
        CHECK(!session::contents_of(*salvaged).edits.empty());
    std::filesystem::remove(path);
    return 0;
}
