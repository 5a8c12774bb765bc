#pragma once

#include "engine/base/urgency.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

namespace tractus {

// Runs one kind of long computation on a thread of its own while the caller continues. Only the
// newest request counts: an older request that has not started is dropped. A computation that has
// started is finished, unless `make` accepts a stop token. In that case the computation is asked to
// stop, and its result is discarded, when this object is destroyed, or when a newer request arrives
// after the computation has run for kPatience.
//
// The computation never interrupts the thread that shows ink (urgency.h).
//
// All functions here must be called from one thread; `make` runs on the other thread. Data that a
// request refers to must not change.
template<typename Wanted, typename Made> class NewestJob {
public:
    // How long a computation runs before a newer request may stop it. Results that take less time
    // are thus all shown while the user moves a slider.
    static constexpr std::chrono::milliseconds kPatience { 200 };

    // `make` is called with the request, and with a std::stop_token if it accepts one.
    template<typename Make>
    explicit NewestJob(Make make, Urgency urgency = Urgency::Soon)
        : may_stop_(std::is_invocable_v<Make&, Wanted const&, std::stop_token const&>)
    {
        if constexpr (std::is_invocable_v<Make&, Wanted const&, std::stop_token const&>)
            make_ = std::move(make);
        else
            make_ = [make = std::move(make)](Wanted const& wanted, std::stop_token const&) mutable {
                return make(wanted);
            };
        try {
            thread_ = std::thread([this, urgency] { run(urgency); });
        } catch (std::system_error const&) {
            // The system cannot start a thread: catch_up() computes in the caller instead.
        }
    }
    NewestJob(NewestJob const&) = delete;
    NewestJob& operator=(NewestJob const&) = delete;

    // Waits until the computation in progress, if any, has finished or stopped.
    ~NewestJob()
    {
        {
            std::lock_guard const lock(mutex_);
            stop_ = true;
            stop_work_.request_stop();
        }
        changed_.notify_all();
        if (thread_.joinable())
            thread_.join();
    }

    void want(Wanted wanted)
    {
        {
            std::lock_guard const lock(mutex_);
            if (is_at_work_ && Clock::now() - begun_ > kPatience)
                stop_work_.request_stop();
            wanted_.emplace(std::move(wanted));
        }
        changed_.notify_all();
    }

    // True if there is a request whose result take() has not returned yet.
    bool is_busy() const
    {
        std::lock_guard const lock(mutex_);
        return wanted_ || is_at_work_ || made_;
    }

    // Returns the newest result, or no value if none was finished since the last call.
    std::optional<Made> take()
    {
        Lock lock(mutex_);
        catch_up(lock);
        return std::exchange(made_, std::nullopt);
    }

    // Waits until no request is pending and no computation is in progress.
    void settle()
    {
        Lock lock(mutex_);
        catch_up(lock);
        changed_.wait(lock, [&] { return !wanted_ && !is_at_work_; });
    }

private:
    using Lock = std::unique_lock<std::mutex>;

    void run(Urgency urgency)
    {
        set_urgency(urgency);
        Lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [&] { return stop_ || wanted_; });
            if (stop_)
                return;
            work(lock);
        }
    }

    // If the thread could not be started, runs the computation in the caller, which has to wait.
    void catch_up(Lock& lock)
    {
        if (!thread_.joinable() && wanted_)
            work(lock);
    }

    void work(Lock& lock)
    {
        is_at_work_ = true;
        begun_ = Clock::now();
        stop_work_ = std::stop_source();
        auto const token = stop_work_.get_token();
        std::optional<Made> made;
        {
            auto const taken = *std::exchange(wanted_, std::nullopt);
            lock.unlock();
            made.emplace(make_(taken, token));
        }
        lock.lock();
        if (!may_stop_ || !token.stop_requested())
            made_.swap(made);
        is_at_work_ = false;
        changed_.notify_all();
        lock.unlock();
        // Frees a result that take() never returned, or the result of a stopped computation. This
        // may take long, so the lock is released meanwhile.
        made.reset();
        lock.lock();
    }

    using Clock = std::chrono::steady_clock;

    std::function<Made(Wanted const& wanted, std::stop_token const& stop)> make_;
    bool may_stop_;
    mutable std::mutex mutex_; // Guards all members below except the thread.
    std::condition_variable changed_;
    std::optional<Wanted> wanted_; // The request that has not been started, if any.
    std::optional<Made> made_;     // The result that has not been taken, if any.
    bool is_at_work_ = false;
    Clock::time_point begun_ {}; // Start of the computation in progress.
    std::stop_source stop_work_; // Stops the computation in progress.
    bool stop_ = false;
    std::thread thread_;
};

} // namespace tractus
