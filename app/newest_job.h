#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace tractus {

// Does one kind of long work on a thread of its own, for somebody who goes on meanwhile. Only the
// newest wish counts: what is being made is finished, what still waits behind it is dropped.
//
// Everything here is called from one thread; `make` runs on the other. What a wish refers to must
// not change.
template<typename Wanted, typename Made> class NewestJob {
public:
    using Make = std::function<Made(Wanted const& wanted)>;

    explicit NewestJob(Make make)
        : make_(std::move(make))
    {
        try {
            thread_ = std::thread([this] { run(); });
        } catch (std::system_error const&) {
            // The system gives none: see catch_up().
        }
    }
    NewestJob(NewestJob const&) = delete;
    NewestJob& operator=(NewestJob const&) = delete;

    // Waits for what is being made.
    ~NewestJob()
    {
        {
            std::lock_guard const lock(mutex_);
            stop_ = true;
        }
        changed_.notify_all();
        if (thread_.joinable())
            thread_.join();
    }

    void want(Wanted wanted)
    {
        {
            std::lock_guard const lock(mutex_);
            wanted_.emplace(std::move(wanted));
        }
        changed_.notify_all();
    }

    // Something was wanted that take() has not given yet.
    bool is_busy() const
    {
        std::lock_guard const lock(mutex_);
        return wanted_ || is_at_work_ || made_;
    }

    // The newest, if one has been finished since the last call.
    std::optional<Made> take()
    {
        Lock lock(mutex_);
        catch_up(lock);
        return std::exchange(made_, std::nullopt);
    }

    // Waits until the newest is there to be taken.
    void settle()
    {
        Lock lock(mutex_);
        catch_up(lock);
        changed_.wait(lock, [&] { return !wanted_ && !is_at_work_; });
    }

private:
    using Lock = std::unique_lock<std::mutex>;

    void run()
    {
        Lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [&] { return stop_ || wanted_; });
            if (stop_)
                return;
            work(lock);
        }
    }

    // Where there is no thread whoever wants something has to wait.
    void catch_up(Lock& lock)
    {
        if (!thread_.joinable() && wanted_)
            work(lock);
    }

    void work(Lock& lock)
    {
        is_at_work_ = true;
        std::optional<Made> made;
        {
            auto const taken = *std::exchange(wanted_, std::nullopt);
            lock.unlock();
            made.emplace(make_(taken));
        }
        lock.lock();
        made_.swap(made);
        is_at_work_ = false;
        changed_.notify_all();
    }

    Make make_;
    mutable std::mutex mutex_; // Of all that follows but the thread.
    std::condition_variable changed_;
    std::optional<Wanted> wanted_; // That nobody has begun to make.
    std::optional<Made> made_;     // That was not taken.
    bool is_at_work_ = false;
    bool stop_ = false;
    std::thread thread_;
};

} // namespace tractus
