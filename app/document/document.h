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

// A change that the user requested without a stroke, with a menu command for example.
struct StepRequest {
    // The edits of the change, computed from the scene when the queue reaches it, and the status
    // message to show when it is done.
    struct Change {
        std::vector<scene::Edit> edits;
        std::string status;
    };
    std::function<Result<Change>(scene::Scene const& scene)> change;

    // What the step changes. Growth: only how the plants grow.
    enum class Of { Scene, Growth } of = Of::Scene;
};

// A step without a stroke that was recorded in a log, for replay.
struct LoggedStep {
    enum class What { Edits, Undo, Redo, BeginAgain } what = What::Edits;
    std::size_t strokes_before = 0;    // Number of strokes in the log before this step.
    std::vector<scene::Edit> edits {}; // Edits of the step; only for What::Edits.
};

// Outcome of a step without a stroke.
struct StepOutcome {
    Result<std::string> status; // The message for the user, or the reason why nothing changed.
    StepRequest::Of of = StepRequest::Of::Scene;
    LoggedStep::What what = LoggedStep::What::Edits;
    std::size_t strokes_before = 0;    // Number of strokes handled before the step.
    std::vector<scene::Edit> edits {}; // Edits of the step; only for What::Edits.
};

// The document at one moment; immutable.
struct Snapshot {
    scene::Scene scene {};
    std::uint64_t revision = 0;       // Increases with every change of the scene.
    std::uint64_t drawn_revision = 0; // Like `revision`, but ignores changes of growth alone.
    std::size_t unkept = 0;           // Number of steps that are not on disk yet.
    std::string not_kept {}; // Why steps could not be written; empty while they are merely pending.
};

// A drawing: the only owner of the scene and of the session that stores its steps. Finished
// strokes, steps, undo and redo are queued and done in the order in which they arrive. Each is
// interpreted in the scene that the previous ones left, published in a snapshot, and then written
// to the session. If writing fails (a full disk, say) the step stays in the document and is
// retried; drawing continues meanwhile.
//
// All functions are called from one thread.
class Document {
public:
    // OnItsThread: functions return at once and the document's own thread does the work. AtOnce: a
    // function returns when its work is done.
    enum class Working { OnItsThread, AtOnce };

    // Computes further edits that a step entails, from the scene before the step and the step's own
    // edits; they become part of the step. Called on the thread that does the work. The function
    // may be empty.
    using Follow = std::function<std::vector<scene::Edit>(scene::Scene const& scene,
                                                          std::vector<scene::Edit> const& step)>;

    // Without a session, the drawing exists in memory only.
    Document(scene::Scene scene, Working working, Follow follow = {});
    Document(session::Session session, Working working, Follow follow = {});
    Document(Document const&) = delete;
    Document& operator=(Document const&) = delete;

    // Finishes the queued work first. Steps that cannot be written are lost; see settle() and
    // newest().
    ~Document();

    void draw(tools::ToolStroke stroke);
    void make(StepRequest step);
    void make(LoggedStep step); // Queued like any other step.
    void undo();
    void redo();

    // Returns the document to its initial state, optionally keeping how its plants grow. This is a
    // step like any other and can be undone.
    enum class Growth { AsItBegan, AsItIs };
    void begin_again(std::string status, Growth growth = Growth::AsItBegan);

    // The newest snapshot; never null.
    std::shared_ptr<Snapshot const> newest() const;

    // Number of strokes received so far.
    std::size_t stroke_count() const { return stroke_count_; }

    // Strokes received but not yet in the newest snapshot, in order.
    std::vector<tools::ToolStroke> waiting() const;

    // Returns the strokes done since the last call and their effects, in order.
    std::vector<DrawnStroke> take_finished_strokes();

    // Returns the oldest outcome of a step that has not been taken yet; nullopt if there is none.
    std::optional<StepOutcome> take_done();

    // Retries writing unkept steps: pass_time() one second after the last attempt, try_again() at
    // once.
    void pass_time(Timestamp now);
    void try_again();

    // True when all queued work is done and written, as far as it can be written now.
    bool is_settled() const;
    void settle();

    session::Session const& session() const { return session_; } // Call only while is_settled().

    // Calls Session::set_name() after all queued work.
    Result<void> set_name(std::string name);

private:
    struct Undo { };
    struct Redo { };
    struct Restart {
        std::string status;
        Growth growth = Growth::AsItBegan;
    };
    using Work = std::variant<tools::ToolStroke, StepRequest, Undo, Redo, Restart>;
    // A computed step; the document's scene already contains it.
    struct Step {
        std::vector<scene::Edit> edits;
        // Prepared for the session; nullopt while earlier steps are unkept.
        std::optional<session::Session::Prepared> prepared {};
    };

    void begin_working(Working working);
    void add(Work work);
    void run();
    void do_next(std::unique_lock<std::mutex>& lock);

    // The functions below run on the document's thread, without the lock.
    void perform(tools::ToolStroke const& stroke);
    void perform(StepRequest const& step);
    void perform(Undo const&);
    void perform(Redo const&);
    void perform(Restart const& wanted);
    void travel(Result<void> (session::Session::*move)(), LoggedStep::What what,
                std::string const& status);
    Result<void> check_all_saved() const;
    Result<Step> compute(std::vector<scene::Edit> edits);
    void keep(Step step);
    void save_pending_steps();
    void publish(std::size_t unkept);
    void tell(StepOutcome done);

    // Used only by the working thread.
    Follow follow_;
    session::Session session_;
    scene::Scene scene_;
    std::uint64_t revision_ = 0;
    std::uint64_t drawn_revision_ = 0;
    std::size_t strokes_before_ = 0;              // Number of strokes handled so far.
    std::deque<std::vector<scene::Edit>> unkept_; // Steps not in the session yet.
    std::string save_error_;

    mutable std::mutex mutex_; // Protects the members below.
    std::condition_variable changed_;
    std::deque<Work> queue_; // While is_at_work_, the front element is being worked on.
    std::shared_ptr<Snapshot const> newest_;
    std::vector<DrawnStroke> drawn_;
    std::deque<StepOutcome> done_;
    bool is_at_work_ = false;
    bool is_first_shown_ = false; // True if the newest snapshot contains the current work.
    bool is_trying_again_ = false;
    bool is_closing_ = false;

    // When to retry writing. Only for the calling thread, as is stroke_count_.
    std::optional<Timestamp> next_try_;
    std::size_t stroke_count_ = 0;
    std::thread thread_;
};

} // namespace tractus::document
