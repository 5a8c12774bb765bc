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

// Reads the edits of a step from where they are stored.
using ReadStep = std::function<Result<std::vector<SessionEdit>>(std::size_t step)>;

// The number of steps in a session and the current one.
struct SessionExtent {
    std::size_t step = 0; // The current step; later ones are undone.
    std::size_t last_step = 0;
};

// Returns everything to the state at the beginning of the history. Only for steps in memory: in a
// session's file, the edits of step 0 do this.
struct BeginAgain {
    static scene::EditKind const kKind;
};

// States of the document after the steps of a session. Steps are read when they are needed. Some
// states are cached, so that undo and redo need not start at the first step: the newest and a few
// older ones. The tips of strokes are left in their source, if they have one (SharedVector), and
// read again on use. So memory stays bounded however long the session is, apart from some 200 bytes
// per stroke. No plants are built, except for edits of sessions before format 4.
class SessionHistory {
public:
    // Opens the history of a session that has a beginning. Fails if reading fails, or if an edit of
    // the beginning that loads a plant fails; the message says which. A later step that cannot be
    // applied changes nothing: something it needs was lost when the file was damaged, or the
    // program does not know one of its edits.
    static Result<SessionHistory> create(SessionExtent const& extent, ReadStep const& read,
                                         scene::SceneBuilder& builder);

    // Begins a history without steps at this state.
    explicit SessionHistory(scene::DocumentState beginning);

    scene::DocumentState const& state() const { return state_; }
    std::size_t step() const { return extent_.step; }
    std::size_t last_step() const { return extent_.last_step; }

    // Returns the state after one more step, whose tips stay in memory. Fails if an edit does.
    Result<scene::DocumentState> after(std::span<scene::Edit const> edits,
                                       scene::SceneBuilder& builder) const;

    // The state at any step, current, undone or earlier. Fails if reading does.
    Result<scene::DocumentState> at(std::size_t wanted, ReadStep const& read,
                                    scene::SceneBuilder& builder);

    // Appends a step that is in the file and leads to `state`. Undone steps are discarded.
    void push(scene::DocumentState state);

    // Makes `step` the current one; `state` is the result of at(step).
    void go_to(std::size_t step, scene::DocumentState state);

private:
    explicit SessionHistory(SessionExtent const& extent);

    // Applies steps `first` to `last` to the state before `first`.
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
    std::map<std::size_t, scene::DocumentState> kept_; // Cached states by step.
};

// The state after the edits of a session's beginning. An edit that fails is skipped, except for one
// that loads a plant, which makes this fail.
Result<scene::DocumentState> begin_document(std::span<SessionEdit const> edits,
                                            scene::SceneBuilder& builder);

// Builds the scene of a session's state. Fails in a sentence with the number of the edit whose
// plant cannot be built.
Result<scene::Scene> build_scene(scene::SceneBuilder& builder, scene::DocumentState state);

} // namespace tractus::session
