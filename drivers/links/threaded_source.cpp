#include "drivers/links/threaded_source.h"

#include <algorithm>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <fmt/core.h>
#include <system_error>
#include <thread>

namespace tractus::drivers {

using namespace std::chrono_literals;

static constexpr Duration kReadTimeout = 50ms; // Upper limit on the time that stopping takes.
static constexpr Duration kPollInterval = 500us;

struct ThreadedSource::Shared {
    explicit Shared(std::unique_ptr<ReportSource> taken)
        : source(std::move(taken))
        , info(source->info())
    {
    }

    void run();

    std::unique_ptr<ReportSource> source; // Only used by the reading thread once it runs.
    DeviceInfo info;                      // Copy of the source's description; never changes.
    // Waiting reports: written by the reading thread, read by the owner.
    boost::lockfree::spsc_queue<RawReport, boost::lockfree::capacity<kRingReports>> ring;
    std::atomic<bool> stop = false; // Set by the owner, read by the reading thread.
    // Set by the reading thread after `error` is written and no further report will follow.
    std::atomic<bool> ended = false;
    // Reports that found the ring full; written by the reading thread.
    std::atomic<std::uint64_t> lost = 0;
    // Reports dropped by the source; written by the reading thread.
    std::atomic<std::uint64_t> too_long = 0;
    Error error; // Written by the reading thread before `ended` is set, read afterwards.
    std::thread thread;
};

void ThreadedSource::Shared::run()
{
    while (!stop.load(std::memory_order_relaxed)) {
        auto const report = source->read(kReadTimeout);
        too_long.store(source->oversized_count(), std::memory_order_relaxed);
        if (!report) {
            error = report.error();
            break;
        }
        if (*report && !ring.push(**report))
            lost.fetch_add(1, std::memory_order_relaxed);
    }
    ended.store(true, std::memory_order_release);
}

ThreadedSource::ThreadedSource(std::unique_ptr<Shared> shared)
    : shared_(std::move(shared))
{
}

Result<std::unique_ptr<ThreadedSource>> ThreadedSource::start(std::unique_ptr<ReportSource> source)
{
    auto shared = std::make_unique<Shared>(std::move(source));
    try {
        shared->thread = std::thread(&Shared::run, shared.get());
    } catch (std::system_error const& error) {
        return fail(
            Fault::Station,
            fmt::format("cannot start a thread for {}: {}", shared->info.name, error.what()));
    }
    return std::unique_ptr<ThreadedSource>(new ThreadedSource(std::move(shared)));
}

ThreadedSource::~ThreadedSource()
{
    shared_->stop.store(true, std::memory_order_relaxed);
    shared_->thread.join();
}

DeviceInfo const& ThreadedSource::info() const
{
    return shared_->info;
}

Result<std::optional<RawReport>> ThreadedSource::read(Duration timeout)
{
    RawReport report;
    for (auto left = timeout;; left -= kPollInterval) {
        // `ended` must be read before the ring, because reports may be pushed until it is set.
        bool const ended = shared_->ended.load(std::memory_order_acquire);
        if (shared_->ring.pop(report))
            return std::optional(report);
        if (ended)
            return tl::unexpected(shared_->error);
        if (left <= Duration::zero())
            return std::optional<RawReport>();
        std::this_thread::sleep_for(std::min(left, kPollInterval));
    }
}

std::uint64_t ThreadedSource::lost_count() const
{
    return shared_->lost.load(std::memory_order_relaxed)
        + shared_->too_long.load(std::memory_order_relaxed);
}

} // namespace tractus::drivers
