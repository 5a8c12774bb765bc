#pragma once

#include "app/session/session.h"
#include "app/station.h"
#include "engine/base/result.h"
#include "engine/base/time.h"
#include "engine/scene/edit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tractus {

// Keeps what a station draws in a session, if there is one, and takes it back when a person asks.
// Without a session edits are made all the same, and stay.
class SessionKeeper {
public:
    explicit SessionKeeper(std::optional<Session> session)
        : session_(std::move(session))
    {
    }

    bool has_session() const { return session_.has_value(); }
    Session const& session() const { return *session_; } // Only if there is one.

    // The strokes that the station has drawn since the last call. What could not be kept, since the
    // disk was full, say, is tried again a second later.
    void keep_strokes(Station const& station, Timestamp now);

    // Those that are kept, or for which there is no session, need not be in memory any more.
    void forget_kept(Station& station);

    // Why the newest strokes are not kept; empty if they are.
    std::string const& not_kept() const { return not_kept_; }

    // What a person does beside drawing: the station goes on with the scene that it leads to.
    // Refused while a stroke is not kept, since it would be lost. Fails like Session's.
    Result<void> make(std::span<Edit const> edits, Station& station);
    Result<void> undo(Station& station);
    Result<void> redo(Station& station);
    Result<void> begin_again(Station& station); // A step like another. There must be a session.

private:
    Result<void> check_kept() const;

    std::optional<Session> session_;
    std::size_t kept_strokes_ = 0; // Of those that the station has not forgotten.
    std::string not_kept_;
    Timestamp next_try_ {}; // To keep the next one.
};

} // namespace tractus
