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

// A change that the user requested other than by a stroke, with a menu command for example.
struct StepRequest {
    // A change's edits, computed from the scene when the queue reaches the step, and the status
    // message for the user when it is done.
    struct Change {
        std::vector<scene::Edit> edits;
        std::string status;
    };
    std::function<Result<Change>(scene::Scene const& scene)> change;

    // Scope of the step: anything in the scene, or only how its plants grow.
    enum class Of { Scene, Growth } of = Of::Scene;
};

// A step that was not made by a stroke, read from a log for replay.
struct LoggedStep {
    enum class What { Edits, Undo, Redo, BeginAgain } what = What::Edits;
    std::size_t strokes_before = 0;    // Number of strokes in the log before the step.
    std::vector<scene::Edit> edits {}; // Edits of the step; only for What::Edits.
};

// Outcome of a step that was not made by a stroke.
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
    std::uint64_t revision = 0; // Increases with every change of the scene.
    // Like `revision`, but not increased by changes of growth alone.
    std::uint64_t drawn_revision = 0;
    std::size_t unkept = 0; // Number of steps that are not in the session yet.
    // Why steps could not be written to the session; empty while they are merely pending.
    std::string not_kept {};
};

// A drawing: the only owner of the scene and of the session that stores its steps. Finished
// strokes, steps, undo and redo are queued and done in the order in which they arrive. Each step is
// computed from the scene that the previous steps left, published in a snapshot, and then written
// to the session. If writing fails (a full disk, say), the step stays in the document and is
// retried; drawing continues meanwhile.
//
// All functions must be called from the same thread.
class Document {
public:
    // OnItsThread: functions return at once, and a thread of the document does the work. AtOnce: a
    // function returns when its work is done.
    enum class Working { OnItsThread, AtOnce };

    // Computes further edits that a step entails. Its arguments are the scene before the step and
    // the step's own edits; the edits that it returns become part of the step. Called on the thread
    // that does the work. May be empty.
    using Follow = std::function<std::vector<scene::Edit>(scene::Scene const& scene,
                                                          std::vector<scene::Edit> const& step)>;

    // The first constructor makes a drawing that exists in memory only, without a session.
    Document(scene::Scene scene, Working working, Follow follow = {});
    Document(session::Session session, Working working, Follow follow = {});
    Document(Document const&) = delete;
    Document& operator=(Document const&) = delete;

    // Finishes the queued work. Steps that cannot be written to the session are lost. To know their
    // number before, call settle() and look at Snapshot::unkept.
    ~Document();

    void draw(tools::ToolStroke stroke);
    void make(StepRequest step);
    void make(LoggedStep step); // Queued like a step that the user requests.
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

    // Returns and removes the oldest outcome of a step that was not made by a stroke; nullopt if
    // there is none.
    std::optional<StepOutcome> take_done();

    // Retry writing steps that are not in the session yet: pass_time() does so one second after the
    // last attempt failed, try_again() at once.
    void pass_time(Timestamp now);
    void try_again();

    // is_settled() is true when all queued work is done, and written unless writing fails. settle()
    // waits for that.
    bool is_settled() const;
    void settle();

    session::Session const& session() const { return session_; } // Call only while is_settled().

    // Calls Session::set_name() when all queued work is done.
    Result<void> set_name(std::string name);

private:
    struct Undo { };
    struct Redo { };
    struct Restart {
        std::string status;
        Growth growth = Growth::AsItBegan;
    };
    using Work = std::variant<tools::ToolStroke, StepRequest, Undo, Redo, Restart>;
    // A computed step. The document's scene already contains its edits.
    struct Step {
        std::vector<scene::Edit> edits;
        // The step as prepared for the session; nullopt if earlier steps are not in the session
        // yet.
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

    // The following members are used only by the thread that does the work.
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
    std::deque<Work> queue_; // While is_at_work_, the front element is being done.
    std::shared_ptr<Snapshot const> newest_;
    std::vector<DrawnStroke> drawn_;
    std::deque<StepOutcome> done_;
    bool is_at_work_ = false;
    // True if the newest snapshot already shows the effect of the front element of queue_.
    bool is_first_shown_ = false;
    bool is_trying_again_ = false;
    bool is_closing_ = false;

    // When to retry writing. Used only by the calling thread, as is stroke_count_.
    std::optional<Timestamp> next_try_;
    std::size_t stroke_count_ = 0;
    std::thread thread_;
};

} // namespace tractus::document
