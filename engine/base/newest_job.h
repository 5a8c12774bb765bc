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

// Does one kind of long work on a thread of its own, for somebody who goes on meanwhile. Only the
// newest wish counts: what still waits behind it is dropped. What is being made is finished, unless
// `make` takes a stop token: then it is told to stop when this goes, or when a newer wish comes and
// it has been at work for kPatience; what it gives after that is dropped, too.
//
// The thread that shows ink is never interrupted for it (urgency.h).
//
// Everything here is called from one thread; `make` runs on the other. What a wish refers to must
// not change.
template<typename Wanted, typename Made> class NewestJob {
public:
    // So that a person who moves a slider sees what can be made as fast.
    static constexpr std::chrono::milliseconds kPatience { 200 };

    // `make` is called with what is wanted, and with a std::stop_token if it takes one.
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
            // The system gives none: see catch_up().
        }
    }
    NewestJob(NewestJob const&) = delete;
    NewestJob& operator=(NewestJob const&) = delete;

    // Waits for what is being made, or until it has stopped.
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

    // Where there is no thread whoever wants something has to wait.
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
        made.reset(); // What nobody has taken, or may. It may be large: nobody waits for that.
        lock.lock();
    }

    using Clock = std::chrono::steady_clock;

    std::function<Made(Wanted const& wanted, std::stop_token const& stop)> make_;
    bool may_stop_;
    mutable std::mutex mutex_; // Of all that follows but the thread.
    std::condition_variable changed_;
    std::optional<Wanted> wanted_; // That nobody has begun to make.
    std::optional<Made> made_;     // That was not taken.
    bool is_at_work_ = false;
    Clock::time_point begun_ {}; // With the present work,
    std::stop_source stop_work_; // and how to stop it.
    bool stop_ = false;
    std::thread thread_;
};

} // namespace tractus
