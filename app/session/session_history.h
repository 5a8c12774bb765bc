#pragma once

#include "app/session/session_file.h"
#include "engine/base/result.h"
#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace tractus::session {

// The edits of a step, which somebody keeps.
using ReadStep = std::function<Result<std::vector<SessionEdit>>(std::size_t step)>;

// How far a session has come.
struct SessionExtent {
    std::size_t step = 0; // The last that counts.
    std::size_t last_step = 0;
};

// Takes everything back to the state that a history began with. For steps in memory alone: a
// session's file has the edits of its beginning.
struct BeginAgain {
    static scene::EditKind const kKind;
};

// States that the steps of a session amount to. The steps themselves are read when they are needed;
// so that undo and redo need not begin at the first, some states on the way are kept, the newest
// ones and a few of old. The tips of strokes are left to their source, if they have one
// (SharedVector), and read again by who needs them. So memory stays bounded however long the
// session is, but for some 200 bytes for each stroke that still counts. No plant is built, but for
// edits of sessions before format 4.
class SessionHistory {
public:
    // Opens the history of a session that has a beginning. Fails where an edit of that which brings
    // a plant does, saying which, and where reading does. A later step whose edits cannot be made
    // changes nothing: what they need was lost when the session was damaged, or this program does
    // not know one of them.
    static Result<SessionHistory> create(SessionExtent const& extent, ReadStep const& read,
                                         scene::SceneBuilder& builder);

    // Begins the history of a session without steps, whose beginning is a state.
    explicit SessionHistory(scene::DocumentState beginning);

    scene::DocumentState const& state() const { return state_; }
    std::size_t step() const { return extent_.step; }
    std::size_t last_step() const { return extent_.last_step; }

    // Returns the state after one more step, whose tips are in memory. Fails where an edit does.
    Result<scene::DocumentState> after(std::span<scene::Edit const> edits,
                                       scene::SceneBuilder& builder) const;

    // The state as it is, or was, at another step. Fails where reading does.
    Result<scene::DocumentState> at(std::size_t wanted, ReadStep const& read,
                                    scene::SceneBuilder& builder);

    // The next step is in the file, and leads to `state`. What was undone is gone.
    void push(scene::DocumentState state);

    // Makes `step` the last that counts; `state` is what at() gives.
    void go_to(std::size_t step, scene::DocumentState state);

private:
    explicit SessionHistory(SessionExtent const& extent);

    // Goes on from the state before step `first`.
    Result<scene::DocumentState> fold(scene::DocumentState state, std::size_t first,
                                      std::size_t last, ReadStep const& read,
                                      scene::SceneBuilder& builder);
    Result<scene::DocumentState> apply(scene::DocumentState state, scene::Edit const& edit,
                                       scene::SceneBuilder& builder) const;
    scene::DocumentState apply_step(scene::DocumentState state, std::span<SessionEdit const> edits,
                                    scene::SceneBuilder& builder) const;
    void keep(std::size_t step, scene::DocumentState state);
    bool is_worth_keeping(std::size_t step) const;

    SessionExtent extent_;
    scene::DocumentState state_;
    std::map<std::size_t, scene::DocumentState> kept_; // States by step.
};

// The state after the edits that a session begins with. Each does what it can, since there is no
// step before it. Fails where one that brings a plant does.
Result<scene::DocumentState> begin_document(std::span<SessionEdit const> edits,
                                            scene::SceneBuilder& builder);

// Builds the scene of a session's state. Fails in a sentence that names the edit whose plant cannot
// be built.
Result<scene::Scene> build_scene(scene::SceneBuilder& builder, scene::DocumentState state);

} // namespace tractus::session
