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

// Reads the edits of a step from wherever the session keeps them.
using ReadStep = std::function<Result<std::vector<SessionEdit>>(std::size_t step)>;

// The number of the last step in a session, and that of the current step.
struct SessionExtent {
    std::size_t step = 0; // The current step; later steps are undone.
    std::size_t last_step = 0;
};

// Edit that returns the document to its state at the beginning of the history. Only for sessions in
// memory: in a session's file, the edits of step 0 have this effect.
struct BeginAgain {
    static scene::EditKind const kKind;
};

// States of the document after the steps of a session. Steps are read when they are needed. Some
// states are cached, so that undo and redo need not start at the first step: those near the current
// step, and some farther away. The tips of strokes are left in the file, if they are there
// (SharedVector), and read again on use. So memory stays bounded however long the session is, apart
// from some 200 bytes per stroke. No plants are built, except for edits of sessions before format
// 4.
class SessionHistory {
public:
    // Opens the history of a session that has a beginning. Fails if steps cannot be read, or if an
    // edit of the beginning that loads a plant fails; the message contains the edit's number. A
    // later step that cannot be applied has no effect: something it needs was lost when the file
    // was damaged, or the program does not know one of its edits.
    static Result<SessionHistory> create(SessionExtent const& extent, ReadStep const& read,
                                         scene::SceneBuilder& builder);

    // Begins a history at the state `beginning`, without steps.
    explicit SessionHistory(scene::DocumentState beginning);

    scene::DocumentState const& state() const { return state_; }
    std::size_t step() const { return extent_.step; }
    std::size_t last_step() const { return extent_.last_step; }

    // Returns the state after one more step. The tips of the step's strokes stay in memory. Fails
    // if an edit fails.
    Result<scene::DocumentState> after(std::span<scene::Edit const> edits,
                                       scene::SceneBuilder& builder) const;

    // Returns the state after any step, be it current, undone or earlier. Fails if steps cannot be
    // read.
    Result<scene::DocumentState> at(std::size_t wanted, ReadStep const& read,
                                    scene::SceneBuilder& builder);

    // Appends a step that is already stored and leads to `state`. Steps that were undone are
    // discarded.
    void push(scene::DocumentState state);

    // Makes `step` the current step; `state` is what at(step) returned.
    void go_to(std::size_t step, scene::DocumentState state);

private:
    explicit SessionHistory(SessionExtent const& extent);

    // Applies the steps from `first` to `last` to `state`, the state before `first`.
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
    std::map<std::size_t, scene::DocumentState> kept_; // Cached states by the number of their step.
};

// Returns the document's state after the edits of a session's beginning. An edit that fails is
// skipped, but if it loads a plant, this function fails.
Result<scene::DocumentState> begin_document(std::span<SessionEdit const> edits,
                                            scene::SceneBuilder& builder);

// Builds the scene for a session's state. Fails if a plant cannot be built; the message contains
// the number of the plant's edit.
Result<scene::Scene> build_scene(scene::SceneBuilder& builder, scene::DocumentState state);

} // namespace tractus::session
