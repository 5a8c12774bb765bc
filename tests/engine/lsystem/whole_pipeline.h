#pragma once

#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/lsystem/language/print.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Compiles, derives, prints and draws a text that may be a model, with small limits. Zero bytes
// separate the rules, the view, and the text of the files to which these refer. Without a text for
// the files, each file is a function. Returns true if the result is a plant; every plant is
// checked.
inline bool run_whole_pipeline(std::string_view text)
{
    auto const part = [&] {
        auto const end = std::min(text.find('\0'), text.size());
        auto const result = std::string(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        return result;
    };
    ModelSource source;
    source.text = part();
    source.view_text = part();
    auto const file = text.empty() ? "fver 1 1\nsamples: 5\npoints: 4\n0 0\n0.3 1\n0.6 1\n1 0\n"
                                   : std::string(text);
    auto const model
        = compile_model(source, [&](std::string const&) -> Result<std::string> { return file; });
    if (!model)
        return false;
    // The limit counts how often it is asked instead of time, so that equal texts give equal
    // results. The copies of the function share the number of queries.
    auto const looks = std::make_shared<std::atomic<int>>(0);
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

} // namespace tractus::lsystem
