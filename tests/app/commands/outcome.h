#pragma once

#include "app/commands/command_line.h"
#include "app/methods/all_methods.h"
#include "app/methods/commands/all_commands.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::commands {

// Result of a command as its caller sees it: exit code, standard output, standard error.
struct Outcome {
    int exit_code = 0;
    std::string out {};
    std::string err {};
};

inline Outcome run(std::vector<std::string> const& arguments)
{
    std::vector<char const*> argv { "tractus" };
    for (auto const& argument : arguments)
        argv.push_back(argument.c_str());
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    auto const exit_code = run_command_line(static_cast<int>(argv.size()), argv.data(),
                                            methods::with_commands(methods::all_methods()));
    auto out = ::testing::internal::GetCapturedStdout();
    return { exit_code, std::move(out), ::testing::internal::GetCapturedStderr() };
}

} // namespace tractus::commands
