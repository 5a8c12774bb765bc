#include "app/station/session_keeper.h"

#include "app/station/model_cost.h"

#include <utility>

namespace tractus {

SessionKeeper::SessionKeeper(std::optional<Session> session)
{
    if (!session)
        return;
    session_ = std::make_unique<Session>(*std::move(session));
    thread_ = std::make_unique<Thread>(
        [session = session_.get()](auto const& work) { return work(*session); });
}

void SessionKeeper::advance(Station& station, Timestamp now)
{
    if (is_at_work_)
        if (auto outcome = thread_->take())
            take_over(*std::move(outcome), station, now);
    if (!is_at_work_ && (not_kept_.empty() || now >= next_try_)) {
        station.hold(Station::Hold::Off); // What was finished meanwhile is drawn now.
        begin_strokes(station);
    }
    while (!is_at_work_ && unkept_strokes_ == 0 && !wanted_.empty())
        begin_wanted(station);
    station.hold(is_settled() ? Station::Hold::Off : Station::Hold::On);
}

bool SessionKeeper::is_settled() const
{
    return !is_at_work_ && unkept_strokes_ == 0 && wanted_.empty();
}

void SessionKeeper::settle(Station& station, Timestamp now)
{
    advance(station, now);
    while (is_at_work_) {
        thread_->settle();
        advance(station, now);
    }
}

void SessionKeeper::take_over(Outcome outcome, Station& station, Timestamp now)
{
    constexpr Duration kPatience = std::chrono::seconds(1);
    is_at_work_ = false;
    if (auto step = std::exchange(under_way_, std::nullopt)) {
        station.set_scene(std::move(outcome.scene));
        if (outcome.done)
            done_.push_back({ std::move(step->status), step->of });
        else
            done_.push_back({ tl::unexpected(outcome.done.error()), step->of });
        return;
    }
    kept_strokes_ += outcome.kept_strokes;
    unkept_strokes_ -= outcome.kept_strokes;
    not_kept_ = outcome.done ? "" : outcome.done.error().message;
    if (outcome.done)
        station.set_scene(std::move(outcome.scene));
    else
        next_try_ = now + kPatience;
}

void SessionKeeper::forget_kept(Station& station)
{
    if (unkept_strokes_ > 0)
        return;
    station.forget_strokes();
    kept_strokes_ = 0;
}

void SessionKeeper::begin_strokes(Station const& station)
{
    auto const& strokes = station.strokes();
    if (!session_ || kept_strokes_ > strokes.size()) // Of another station.
        kept_strokes_ = strokes.size();
    std::vector<std::vector<Edit>> steps;
    for (auto i = kept_strokes_; i < strokes.size(); ++i)
        steps.push_back(strokes[i].edits);
    unkept_strokes_ = steps.size();
    if (steps.empty())
        return;
    begin([steps = std::move(steps)](Session& session) {
        Outcome outcome;
        for (auto const& edits : steps) {
            outcome.done = session.append(edits);
            if (!outcome.done)
                break;
            ++outcome.kept_strokes;
        }
        outcome.scene = session.scene();
        return outcome;
    });
}

void SessionKeeper::begin(std::function<Outcome(Session& session)> work)
{
    is_at_work_ = true;
    thread_->want(std::move(work));
}

static Result<Scene> scene_after_all(Scene scene, std::vector<Edit> const& edits)
{
    for (auto const& edit : edits)
        scene = TRY(apply_edit(std::move(scene), edit, load_options()));
    return scene;
}

void SessionKeeper::begin_wanted(Station& station)
{
    auto const wanted = std::move(wanted_.front());
    wanted_.pop_front();
    auto plan = wanted.plan(station.scene());
    if (!plan) {
        done_.push_back({ tl::unexpected(plan.error()), wanted.of });
        return;
    }
    if (session_) {
        under_way_ = { std::move(plan->status), wanted.of };
        begin([work = std::move(plan->work)](Session& session) {
            auto done = work(session);
            return Outcome { .done = std::move(done), .scene = session.scene() };
        });
        return;
    }
    auto scene = scene_after_all(station.scene(), plan->edits);
    if (scene) {
        station.set_scene(*std::move(scene));
        done_.push_back({ std::move(plan->status), wanted.of });
    } else {
        done_.push_back({ tl::unexpected(scene.error()), wanted.of });
    }
}

void SessionKeeper::want(Wanted wanted)
{
    if (not_kept_.empty())
        wanted_.push_back(std::move(wanted));
    else
        done_.push_back(
            { fail(Fault::User, "what was drawn must be kept first: " + not_kept_), wanted.of });
}

void SessionKeeper::make(WantedStep step)
{
    auto plan = [change = std::move(step.change)](Scene const& scene) -> Result<Wanted::Plan> {
        auto [edits, status] = TRY(change(scene));
        auto const append = [edits = edits](Session& session) { return session.append(edits); };
        return Wanted::Plan { append, std::move(status), std::move(edits) };
    };
    want({ std::move(plan), step.of });
}

void SessionKeeper::want_of_session(Work const& work, std::string const& status)
{
    want({ [=, has_session = has_session()](Scene const&) -> Result<Wanted::Plan> {
              if (!has_session)
                  return fail(Fault::User,
                              "nothing is kept that could be taken back: there is no "
                              "session");
              return Wanted::Plan { work, status, {} };
          },
           WantedStep::Of::Scene });
}

void SessionKeeper::undo()
{
    want_of_session([](Session& session) { return session.undo(); }, "Undone");
}

void SessionKeeper::redo()
{
    want_of_session([](Session& session) { return session.redo(); }, "Done again");
}

void SessionKeeper::begin_again(std::string const& status)
{
    auto const append_beginning = [](Session& session) -> Result<void> {
        auto const beginning = TRY(session.beginning());
        return session.append(beginning);
    };
    want_of_session(append_beginning, status);
}

std::optional<DoneStep> SessionKeeper::take_done()
{
    if (done_.empty())
        return std::nullopt;
    auto done = std::move(done_.front());
    done_.pop_front();
    return done;
}

} // namespace tractus
