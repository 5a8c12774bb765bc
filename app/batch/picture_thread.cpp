#include "app/batch/picture_thread.h"

#include <condition_variable>
#include <fmt/core.h>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace tractus::batch {

// State shared by the thread and its callers. All members but `thread` are guarded by the mutex.
struct PictureThread::Shared {
    ~Shared();
    void run();

    std::mutex mutex;
    std::condition_variable changed;
    // Set once the thread is ready to draw or its start has failed.
    std::optional<Result<void>> begun;
    // Request in progress; null if there is none.
    std::function<void(PictureMaker&)> const* wanted = nullptr;
    bool stop = false;
    std::thread thread;
};

PictureThread::Shared::~Shared()
{
    {
        std::lock_guard const lock(mutex);
        stop = true;
    }
    changed.notify_all();
    if (thread.joinable())
        thread.join();
}

void PictureThread::Shared::run()
{
    auto pictures = PictureMaker::create();
    std::unique_lock lock(mutex);
    begun = pictures ? Result<void>() : tl::unexpected(pictures.error());
    changed.notify_all();
    while (pictures) {
        changed.wait(lock, [&] { return stop || wanted; });
        if (stop)
            return;
        auto const& draw = *wanted;
        lock.unlock();
        draw(*pictures);
        lock.lock();
        wanted = nullptr;
        changed.notify_all();
    }
}

Result<PictureThread> PictureThread::create()
{
    auto shared = std::make_unique<Shared>();
    try {
        shared->thread = std::thread(&Shared::run, shared.get());
    } catch (std::system_error const& error) {
        return fail(
            Fault::User,
            fmt::format("cannot draw: the system gives no thread for it: {}", error.what()));
    }
    {
        std::unique_lock lock(shared->mutex);
        shared->changed.wait(lock, [&] { return shared->begun.has_value(); });
        if (!*shared->begun)
            return tl::unexpected(shared->begun->error());
    }
    return PictureThread(std::move(shared));
}

PictureThread::PictureThread(std::unique_ptr<Shared> shared)
    : shared_(std::move(shared))
{
}

PictureThread::PictureThread(PictureThread&&) noexcept = default;
PictureThread::~PictureThread() = default;

void PictureThread::draw(std::function<void(PictureMaker&)> const& draw)
{
    std::unique_lock lock(shared_->mutex);
    shared_->changed.wait(lock, [&] { return !shared_->wanted; });
    shared_->wanted = &draw;
    shared_->changed.notify_all();
    // Waits until this request is no longer the current one; another caller's may already have
    // replaced it.
    shared_->changed.wait(lock, [&] { return shared_->wanted != &draw; });
}

} // namespace tractus::batch
