#pragma once

#include "engine/lsystem/derive.h"
#include "engine/lsystem/interpret.h"
#include "engine/lsystem/print.h"

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

namespace tractus {

// Everything that can be done with text that may be a model, under small limits. A zero byte
// divides rules from view. Returns whether a plant came out; every plant is checked.
inline bool run_whole_pipeline(std::string_view text)
{
    auto const middle = text.find('\0');
    ModelSource source;
    source.text = text.substr(0, middle);
    if (middle != std::string_view::npos)
        source.view_text = text.substr(middle + 1);
    auto const model = compile_model(source, [](std::string const&) -> Result<std::string> {
        return "fver 1 1\nsamples: 5\npoints: 4\n0 0\n0.3 1\n0.6 1\n1 0\n";
    });
    if (!model)
        return false;
    // Work instead of time, so that the same text always gives the same result.
    auto const looks = std::make_shared<std::atomic<int>>(0); // Shared by the function's copies.
    ModelLimits const limits { .max_modules = 2000,
                               .max_memory_bytes = std::size_t { 1 } << 20,
                               .time = { [looks] { return ++*looks > 200; }, 1 } };
    auto const string = derive(*model, { .steps = 4, .seed = 1, .limits = limits });
    if (!string)
        return false;
    static_cast<void>(to_string(*model, *string).size());
    auto const plant = interpret(*model, *string, { .unit_mm = 10, .max_modules = 5000 });
    if (!plant)
        return false;
    check_plant(*plant);
    return true;
}

} // namespace tractus
