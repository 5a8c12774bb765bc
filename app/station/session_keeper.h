#pragma once

#include "app/session/session.h"
#include "app/station/newest_job.h"
#include "app/station/station.h"
#include "engine/base/result.h"
#include "engine/base/time.h"
#include "engine/scene/edit.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

// Something that a person does beside drawing.
struct WantedStep {
    // What it changes, given the scene as it is by then, and what to say when it is done.
    struct Change {
        std::vector<Edit> edits;
        std::string status;
    };
    std::function<Result<Change>(Scene const& scene)> change;

    enum class Of { Scene, Growth } of = Of::Scene; // Of Growth nothing else changes.
};

// What became of it.
struct DoneStep {
    Result<std::string> status; // Or why nothing has changed.
    WantedStep::Of of = WantedStep::Of::Scene;
};

// Keeps what a station draws in a session, if there is one, and takes it back when a person asks.
// The disk is waited for by a thread of its own, one step after the other; while one is under way
// the station draws nothing new (Station::hold()), so its scene is always what the file holds, but
// for that step. Without a session steps are made all the same, and stay.
class SessionKeeper {
public:
    explicit SessionKeeper(std::optional<Session> session);

    bool has_session() const { return session_ != nullptr; }
    Session const& session() const { return *session_; } // If there is one, while is_settled().

    // Takes over what has been kept, and begins to keep what the station has drawn, or else what
    // was wanted first. What could not be kept, since the disk was full, say, is tried again a
    // second later.
    void advance(Station& station, Timestamp now);

    // Nothing is under way, nor waits: what the station has drawn is on the disk, if there is a
    // session.
    bool is_settled() const;

    // Advances until that is so, or what was drawn cannot be kept for now.
    void settle(Station& station, Timestamp now);

    // Those that are kept, or for which there is no session, need not be in memory any more.
    void forget_kept(Station& station);

    // Why the newest strokes are not kept, and how many; empty and 0 if they are.
    std::string const& not_kept() const { return not_kept_; }
    std::size_t unkept_strokes() const { return unkept_strokes_; }

    // The next advance() tries to keep them without waiting any longer.
    void try_again() { next_try_ = {}; }

    // These wait for their turn. Refused while a stroke cannot be kept, since it would be lost, and
    // where the session does.
    void make(WantedStep step);
    void undo();
    void redo();
    void begin_again(std::string const& status); // A step like another. There must be a session.

    // The next one that is done since the last call.
    std::optional<DoneStep> take_done();

private:
    // What to do with the session, on its thread.
    using Work = std::function<Result<void>(Session& session)>;
    struct Outcome {
        Result<void> done;
        std::size_t kept_strokes = 0;
        Scene scene; // Of the session, whatever became of it.
    };
    using Thread = NewestJob<std::function<Outcome(Session& session)>, Outcome>;

    struct Wanted {
        struct Plan {
            Work work;
            std::string status;      // When it is done.
            std::vector<Edit> edits; // The same without a session.
        };
        std::function<Result<Plan>(Scene const& scene)> plan; // When its turn has come.
        WantedStep::Of of = WantedStep::Of::Scene;
    };
    // A wanted step of which the thread does the work.
    struct UnderWay {
        std::string status;
        WantedStep::Of of = WantedStep::Of::Scene;
    };

    void want(Wanted wanted);
    void want_of_session(Work const& work, std::string const& status);
    void take_over(Outcome outcome, Station& station, Timestamp now);
    void begin_strokes(Station const& station);
    void begin_wanted(Station& station);
    void begin(std::function<Outcome(Session& session)> work);

    // On the heap, as this moves. The thread's while one is at work.
    std::unique_ptr<Session> session_;
    std::unique_ptr<Thread> thread_; // Null without a session.
    bool is_at_work_ = false;
    std::size_t kept_strokes_ = 0;   // Of those that the station has not forgotten;
    std::size_t unkept_strokes_ = 0; // the others.
    std::optional<UnderWay> under_way_;
    std::deque<Wanted> wanted_;
    std::deque<DoneStep> done_;
    std::string not_kept_;
    Timestamp next_try_ {}; // To keep the next stroke.
};

} // namespace tractus
