#pragma once

#include "app/document/draw.h"
#include "app/session/session.h"
#include "app/tools/tool.h"
#include "engine/base/result.h"
#include "engine/base/time.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace tractus::document {

// Something that a person does beside drawing.
struct WantedStep {
    // Its effect, given the scene as it is by then, and what to say when it is done.
    struct Change {
        std::vector<scene::Edit> edits;
        std::string status;
    };
    std::function<Result<Change>(scene::Scene const& scene)> change;

    enum class Of { Scene, Growth } of = Of::Scene; // A step of Growth changes nothing else.
};

// A step beside drawing as it was done once, to be done again.
struct LoggedStep {
    enum class What { Edits, Undo, Redo, BeginAgain } what = What::Edits;
    std::size_t strokes_before = 0;    // Strokes that came before it.
    std::vector<scene::Edit> edits {}; // Set for What::Edits.
};

// Outcome of a step.
struct DoneStep {
    Result<std::string> status; // Or why nothing has changed.
    WantedStep::Of of = WantedStep::Of::Scene;
    LoggedStep::What what = LoggedStep::What::Edits;
    std::size_t strokes_before = 0;    // Strokes of all that the document was given.
    std::vector<scene::Edit> edits {}; // Set for What::Edits.
};

// The document at one moment. Nobody changes it.
struct Snapshot {
    scene::Scene scene {};
    std::uint64_t revision = 0;       // Grows whenever the scene changes,
    std::uint64_t drawn_revision = 0; // and this one whenever more of it does than its growth.
    std::size_t unkept = 0;           // Steps in it that are not on the disk yet.
    std::string not_kept {};          // Why; empty where it is only a matter of time.
};

// A drawing: the one owner of the scene and of the session that keeps its steps. Finished strokes,
// steps, undo and redo go in and are done one after the other in the order in which they came. Each
// is given its meaning by the scene that all earlier ones left, is shown to all in a snapshot, and
// then written to the session. What cannot be written, since the disk is full, say, stays in the
// document and is tried again; drawing goes on meanwhile.
//
// Everything here is called from one thread.
class Document {
public:
    // OnItsThread: calls return at once, and what they began is done by a thread of the document's
    // own. AtOnce: it is done when they return.
    enum class Working { OnItsThread, AtOnce };

    // What a step brings with it, given the scene before it and the step's own edits: edits that
    // become part of it. Called by whoever works. Empty: nothing.
    using Follow = std::function<std::vector<scene::Edit>(scene::Scene const& scene,
                                                          std::vector<scene::Edit> const& step)>;

    // Without a session, what is drawn stays in memory.
    Document(scene::Scene scene, Working working, Follow follow = {});
    Document(session::Session session, Working working, Follow follow = {});
    Document(Document const&) = delete;
    Document& operator=(Document const&) = delete;

    // Does all that has come. What cannot be written is lost: see settle() and newest().
    ~Document();

    void draw(tools::ToolStroke stroke);
    void make(WantedStep step);
    void make(LoggedStep step); // Done in its turn, whatever came before it.
    void undo();
    void redo();

    // Makes the document what it was when it began, but that its growth may be left as it is. It is
    // a step like another.
    enum class Growth { AsItBegan, AsItIs };
    void begin_again(std::string status, Growth growth = Growth::AsItBegan);

    // Never null.
    std::shared_ptr<Snapshot const> newest() const;

    // How many strokes have come.
    std::size_t stroke_count() const { return stroke_count_; }

    // Strokes that have come, in order, and are not in the newest snapshot yet.
    std::vector<tools::ToolStroke> waiting() const;

    // Returns what the strokes since the last call have meant, in order.
    std::vector<DrawnStroke> take_drawn();

    // The next step that is done since the last call; no value: none.
    std::optional<DoneStep> take_done();

    // Tries again to write what could not be written: when a second has passed, or at once.
    void pass_time(Timestamp now);
    void try_again();

    // Whether all that has come is done, and written where it can be for now.
    bool is_settled() const;
    void settle();

    session::Session const& session() const { return session_; } // While is_settled().

    // Session::set_name(), when all that has come is done.
    Result<void> set_name(std::string name);

private:
    struct Undo { };
    struct Redo { };
    struct Restart {
        std::string status;
        Growth growth = Growth::AsItBegan;
    };
    using Work = std::variant<tools::ToolStroke, WantedStep, Undo, Redo, Restart>;
    // A step that is part of the scene already.
    struct Step {
        std::vector<scene::Edit> edits;
        // No value where earlier ones are unkept.
        std::optional<session::Session::Prepared> prepared {};
    };

    void begin_working(Working working);
    void add(Work work);
    void run();
    void do_next(std::unique_lock<std::mutex>& lock);

    // Runs on the document's thread, without the lock.
    void perform(tools::ToolStroke const& stroke);
    void perform(WantedStep const& step);
    void perform(Undo const&);
    void perform(Redo const&);
    void perform(Restart const& wanted);
    void travel(Result<void> (session::Session::*move)(), LoggedStep::What what,
                std::string const& status);
    Result<void> may_travel() const;
    Result<Step> compute(std::vector<scene::Edit> edits);
    void keep(Step step);
    void keep_what_is_not();
    void publish(std::size_t unkept);
    void tell(DoneStep done);

    // The thread's that works.
    Follow follow_;
    session::Session session_;
    scene::Scene scene_;
    std::uint64_t revision_ = 0;
    std::uint64_t drawn_revision_ = 0;
    std::size_t strokes_before_ = 0;              // Strokes that have had their turn.
    std::deque<std::vector<scene::Edit>> unkept_; // Steps of the scene that the session lacks.
    std::string not_kept_;

    mutable std::mutex mutex_; // Protects what follows.
    std::condition_variable changed_;
    std::deque<Work> queue_; // The first is at work, if is_at_work_.
    std::shared_ptr<Snapshot const> newest_;
    std::vector<DrawnStroke> drawn_;
    std::deque<DoneStep> done_;
    bool is_at_work_ = false;
    bool is_first_shown_ = false; // The work under way is in the newest snapshot.
    bool is_trying_again_ = false;
    bool is_closing_ = false;

    std::optional<Timestamp> next_try_; // The caller's,
    std::size_t stroke_count_ = 0;      // as this is.
    std::thread thread_;
};

} // namespace tractus::document
