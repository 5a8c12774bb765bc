#include "app/document/model_cost.h"

#include "app/terminal/console.h"
#include "engine/base/printable.h"

#include <algorithm>
#include <chrono>
#include <fmt/core.h>
#include <fstream>
#include <unistd.h>

namespace tractus::document {

static constexpr std::size_t kMaxPrinted = 100'000;

std::uint64_t machine_memory_mb()
{
    auto const pages = static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES)));
    auto const page_bytes = static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PAGESIZE)));
    auto bytes = pages * page_bytes;
    std::ifstream container("/sys/fs/cgroup/memory.max");
    if (std::uint64_t limit = 0; container >> limit) // Reading fails for "max" (no limit).
        bytes = std::min(bytes, limit);
    return std::max<std::uint64_t>(bytes >> 20, 2);
}

// Prints a model's output to standard error up to kMaxPrinted characters, then a single warning
// that the rest is left out.
class ModelPrinter {
public:
    void operator()(std::string_view text)
    {
        if (is_full_)
            return;
        auto const shown = text.substr(0, kMaxPrinted - printed_);
        terminal::print_error(printable(shown, "\n\t\r"));
        printed_ += shown.size();
        is_full_ = shown.size() < text.size();
        if (is_full_)
            terminal::print_error(
                fmt::format("\nwarning: the model prints more than {} characters; the "
                            "rest is left out\n",
                            kMaxPrinted));
    }

private:
    std::size_t printed_ = 0;
    bool is_full_ = false;
};

scene::LoadOptions load_options(ModelCost const& cost)
{
    using Clock = std::chrono::steady_clock;
    scene::LoadOptions options;
    options.limits.max_modules = cost.max_modules;
    options.limits.max_memory_bytes = cost.max_memory_mb << 20;
    auto end = Clock::time_point::max();
    if (cost.max_seconds > 0)
        end = Clock::now()
            + std::chrono::duration_cast<Clock::duration>(
                  std::chrono::duration<double>(cost.max_seconds));
    if (cost.max_seconds > 0 || cost.is_stopped)
        options.limits.time = { [end, is_stopped = cost.is_stopped] {
                                   return Clock::now() >= end || (is_stopped && is_stopped());
                               },
                                cost.max_seconds };
    options.print = ModelPrinter();
    return options;
}

scene::MakeLoadOptions make_load_options(ModelCost const& cost)
{
    return [cost] { return load_options(cost); };
}

} // namespace tractus::document
