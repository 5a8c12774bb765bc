#include "app/document/document.h"

#include "app/document/model_cost.h"
#include "engine/base/urgency.h"

#include <fmt/core.h>
#include <system_error>
#include <utility>

namespace tractus::document {

namespace {

// Computes the plants' rest shapes in advance, so that other threads, which render the scene, need
// not wait for these.
void find_rest_shapes(scene::Scene const& scene)
{
    for (auto const& plant : scene.plants)
        static_cast<void>(*plant->rest);
}

} // namespace

Document::Document(scene::Scene scene, Working working, Follow follow)
    : Document(
        session::Session::in_memory(
            std::move(scene), session::session_by_the_clock({}, [] { return load_options(); })),
        working, std::move(follow))
{
}

Document::Document(session::Session session, Working working, Follow follow)
    : follow_(std::move(follow))
    , session_(std::move(session))
    , scene_(session_.scene())
{
    begin_working(working);
}

void Document::begin_working(Working working)
{
    publish(0);
    if (working == Working::AtOnce)
        return;
    try {
        thread_ = std::thread([this] { run(); });
    } catch (std::system_error const&) {
        // The system cannot start a thread, so add() does the work in the caller's thread.
    }
}

Document::~Document()
{
    {
        std::lock_guard const lock(mutex_);
        is_closing_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable())
        thread_.join();
}

void Document::add(Work work)
{
    std::unique_lock lock(mutex_);
    queue_.push_back(std::move(work));
    if (!thread_.joinable())
        do_next(lock);
    lock.unlock();
    changed_.notify_all();
}

void Document::run()
{
    set_urgency(Urgency::Soon);
    find_rest_shapes(scene_);
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return is_closing_ || is_trying_again_ || !queue_.empty(); });
        if (!is_trying_again_ && queue_.empty())
            return;
        do_next(lock);
        changed_.notify_all();
    }
}

// Does one piece of work: retries writing pending steps if that was requested, otherwise the first
// element of the queue. Releases the lock while working.
void Document::do_next(std::unique_lock<std::mutex>& lock)
{
    is_at_work_ = true;
    is_first_shown_ = false;
    if (std::exchange(is_trying_again_, false)) {
        lock.unlock();
        save_pending_steps();
        lock.lock();
    } else {
        auto const& work = queue_.front(); // Stays valid while add() appends other elements.
        lock.unlock();
        std::visit([this](auto const& kind) { perform(kind); }, work);
        lock.lock();
        queue_.pop_front();
    }
    is_at_work_ = false;
}

void Document::draw(tools::ToolStroke stroke)
{
    ++stroke_count_;
    add(std::move(stroke));
}

void Document::make(StepRequest step)
{
    add(std::move(step));
}

void Document::make(LoggedStep step)
{
    switch (step.what) {
    case LoggedStep::What::Undo:
        return undo();
    case LoggedStep::What::Redo:
        return redo();
    case LoggedStep::What::BeginAgain:
        return begin_again("As it began");
    case LoggedStep::What::Edits:
        break;
    }
    auto const status
        = step.edits.empty() ? std::string() : fmt::format("It {}", step.edits.back().describe());
    make({ [change = StepRequest::Change { std::move(step.edits), status }](
               scene::Scene const&) -> Result<StepRequest::Change> { return change; } });
}

void Document::undo()
{
    add(Undo {});
}

void Document::redo()
{
    add(Redo {});
}

void Document::begin_again(std::string status, Growth growth)
{
    add(Restart { std::move(status), growth });
}

std::shared_ptr<Snapshot const> Document::newest() const
{
    std::lock_guard const lock(mutex_);
    return newest_;
}

std::vector<tools::ToolStroke> Document::waiting() const
{
    std::lock_guard const lock(mutex_);
    std::vector<tools::ToolStroke> strokes;
    bool is_shown = is_at_work_ && is_first_shown_;
    for (auto const& work : queue_)
        if (auto const* const stroke = std::get_if<tools::ToolStroke>(&work);
            !std::exchange(is_shown, false) && stroke)
            strokes.push_back(*stroke);
    return strokes;
}

std::vector<DrawnStroke> Document::take_finished_strokes()
{
    std::lock_guard const lock(mutex_);
    return std::exchange(drawn_, {});
}

std::optional<StepOutcome> Document::take_done()
{
    std::lock_guard const lock(mutex_);
    if (done_.empty())
        return std::nullopt;
    auto done = std::move(done_.front());
    done_.pop_front();
    return done;
}

void Document::pass_time(Timestamp now)
{
    constexpr Duration kPatience = std::chrono::seconds(1);
    if (newest()->not_kept.empty())
        next_try_.reset();
    else if (!next_try_)
        next_try_ = now + kPatience;
    else if (now >= *next_try_)
        try_again();
}

void Document::try_again()
{
    next_try_.reset();
    std::unique_lock lock(mutex_);
    if (newest_->not_kept.empty())
        return;
    is_trying_again_ = true;
    if (!thread_.joinable())
        do_next(lock);
    lock.unlock();
    changed_.notify_all();
}

bool Document::is_settled() const
{
    std::lock_guard const lock(mutex_);
    return queue_.empty() && !is_at_work_ && !is_trying_again_;
}

void Document::settle()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return queue_.empty() && !is_at_work_ && !is_trying_again_; });
}

Result<void> Document::set_name(std::string name)
{
    settle();
    return session_.set_name(std::move(name));
}

void Document::perform(tools::ToolStroke const& stroke)
{
    DrawnStroke drawn { stroke.stroke, stroke.tool };
    auto edits = stroke.tool.edits_for(stroke.stroke, scene_);
    auto step = edits ? compute(*std::move(edits)) : tl::unexpected(edits.error());
    if (step) {
        drawn.edits = step->edits;
        drawn.message = describe_result(stroke.tool, scene_);
    } else {
        drawn.refusal = step.error().message;
    }
    ++strokes_before_;
    {
        std::lock_guard const lock(mutex_);
        drawn_.push_back(std::move(drawn));
        // A refused stroke is shown at once; a stroke with edits is shown together with its scene.
        is_first_shown_ = !step || step->edits.empty();
    }
    if (step)
        keep(*std::move(step));
}

void Document::perform(StepRequest const& step)
{
    auto const computed = [&]() -> Result<std::pair<Step, std::string>> {
        auto change = TRY(step.change(scene_));
        return std::pair { TRY(compute(std::move(change.edits))), std::move(change.status) };
    };
    auto const before = drawn_revision_;
    auto done = computed();
    if (!done)
        return tell({ .status = tl::unexpected(done.error()), .of = step.of });
    if (step.of == StepRequest::Of::Growth)
        drawn_revision_ = before;
    tell({ .status = std::move(done->second), .of = step.of, .edits = done->first.edits });
    keep(std::move(done->first));
}

// Fails if steps of the drawing are not in the session yet: undo and redo would lose them.
Result<void> Document::check_all_saved() const
{
    if (!unkept_.empty())
        return fail(Fault::User, "what was drawn must be kept first: " + save_error_);
    return {};
}

void Document::travel(Result<void> (session::Session::*move)(), LoggedStep::What what,
                      std::string const& status)
{
    auto moved = check_all_saved();
    if (moved)
        moved = (session_.*move)();
    if (!moved)
        return tell({ .status = tl::unexpected(moved.error()), .what = what });
    scene_ = session_.scene();
    ++revision_;
    ++drawn_revision_;
    publish(0);
    tell({ .status = status, .what = what });
}

void Document::perform(Undo const&)
{
    travel(&session::Session::undo, LoggedStep::What::Undo, "Undone");
}

void Document::perform(Redo const&)
{
    travel(&session::Session::redo, LoggedStep::What::Redo, "Done again");
}

void Document::perform(Restart const& wanted)
{
    auto const computed = [&]() -> Result<Step> {
        TRY(check_all_saved());
        auto edits = TRY(session_.beginning());
        if (wanted.growth == Growth::AsItIs)
            edits.push_back(scene_.growth);
        return compute(std::move(edits));
    };
    auto step = computed();
    if (!step)
        return tell({ .status = tl::unexpected(step.error()) });
    tell({ .status = wanted.status, .what = LoggedStep::What::BeginAgain });
    keep(*std::move(step));
}

// Computes the scene after the edits and makes it the document's scene.
Result<Document::Step> Document::compute(std::vector<scene::Edit> edits)
{
    Step step { .edits = std::move(edits) };
    if (step.edits.empty())
        return step;
    if (follow_)
        for (auto& edit : follow_(scene_, step.edits))
            step.edits.push_back(std::move(edit));
    if (unkept_.empty()) {
        step.prepared = TRY(session_.prepare(step.edits));
        scene_ = step.prepared->scene;
    } else {
        scene_ = TRY(scene_after(scene_, step.edits));
    }
    ++revision_;
    ++drawn_revision_;
    return step;
}

// Publishes a step in a snapshot and writes it to the session.
void Document::keep(Step step)
{
    if (step.edits.empty())
        return;
    if (session_.is_in_file())
        publish(unkept_.size() + 1);
    if (!step.prepared) {
        unkept_.push_back(std::move(step.edits));
        return;
    }
    if (auto const kept = session_.keep(*std::move(step.prepared)); !kept) {
        unkept_.push_back(std::move(step.edits));
        save_error_ = kept.error().message;
    } else {
        // The strokes of the session's scene read their tips from the file.
        scene_ = session_.scene();
    }
    publish(unkept_.size());
}

void Document::save_pending_steps()
{
    save_error_.clear();
    while (!unkept_.empty()) {
        if (auto const kept = session_.append(unkept_.front()); !kept) {
            save_error_ = kept.error().message;
            return publish(unkept_.size());
        }
        unkept_.pop_front();
    }
    scene_ = session_.scene();
    publish(0);
}

void Document::publish(std::size_t unkept)
{
    if (thread_.joinable())
        find_rest_shapes(scene_);
    auto snapshot = std::make_shared<Snapshot const>(Snapshot { .scene = scene_,
                                                                .revision = revision_,
                                                                .drawn_revision = drawn_revision_,
                                                                .unkept = unkept,
                                                                .not_kept = save_error_ });
    std::lock_guard const lock(mutex_);
    // The old snapshot is destroyed after the lock has been released, if nobody else owns it.
    newest_.swap(snapshot);
    is_first_shown_ = true;
}

void Document::tell(StepOutcome done)
{
    done.strokes_before = strokes_before_;
    std::lock_guard const lock(mutex_);
    done_.push_back(std::move(done));
}

} // namespace tractus::document
