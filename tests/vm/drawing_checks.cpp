#include "app/controllers/drawing_file.h"
#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "app/session/session_file.h"
#include "app/station/log_replay.h"
#include "drivers/logs/log.h"
#include "engine/scene/fields.h"
#include "tests/vm/checks.h"

#include <algorithm>
#include <fmt/core.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus {

namespace {

// Sets the clock of a stroke's beginning to zero, because each recording has its own clock.
class FromItsBegin final : public scene::Fields {
public:
    void field(char const*, scene::FieldRef) override { }
    void word(char const*, int&, std::span<char const* const>) override { }
    void numbers(std::vector<SkeletonPiece>&) override { }
    void bytes(std::string&) override { }
    void numbers(Stroke& stroke) override
    {
        if (stroke.tips.empty())
            return;
        std::vector<TipSample> tips(stroke.tips.begin(), stroke.tips.end());
        for (auto& tip : tips)
            tip.time = Timestamp(tip.time - stroke.tips.front().time);
        stroke.tips = std::move(tips);
        has_stroke_ = true;
    }

    bool has_stroke() const { return has_stroke_; }

private:
    bool has_stroke_ = false;
};

struct DrawnEdit {
    std::string description;
    session::EditRecord record;
    bool has_stroke = false;
};

// Returns the edits of a session that are not undone.
Result<std::vector<DrawnEdit>> drawn_edits(std::string const& session)
{
    auto const contents = TRY(session::read_session(session, methods::all_methods().edits));
    std::vector<DrawnEdit> drawn;
    for (auto const& made : contents.edits) {
        FromItsBegin clock;
        auto const edit = made.edit.changed_by(clock);
        if (made.step > contents.step)
            continue;
        drawn.push_back({ edit.describe(), session::record_of(edit), clock.has_stroke() });
    }
    return drawn;
}

bool is_same(session::EditRecord const& a, session::EditRecord const& b)
{
    return a.kind == b.kind && a.fields == b.fields && a.numbers == b.numbers;
}

} // namespace

Result<void> go_on_with_recordings(controllers::DrawingRequest const& drawing,
                                   std::vector<std::string> const& logs)
{
    for (auto const& name : logs) {
        std::string trouble;
        auto session
            = TRY(controllers::open_or_begin(drawing, methods::all_methods().edits, trouble));
        document::Document document(std::move(session), document::Document::Working::AtOnce);
        auto const log = TRY(drivers::read_log(name));
        auto replay = TRY(station::LogReplay::create(log, { .methods = methods::all_methods() }));
        replay.run(document);
        if (auto const& outcome = replay.outcome(); !outcome)
            return outcome;
        if (auto const& why = document.newest()->not_kept; !why.empty() || !trouble.empty())
            return fail(Fault::Station, why + trouble);
    }
    return {};
}

Result<void> compare_drawings(std::string const& session, std::string const& other)
{
    auto const edits = TRY(drawn_edits(session));
    auto const others = TRY(drawn_edits(other));
    for (std::size_t i = 0; i < std::min(edits.size(), others.size()); ++i)
        if (!is_same(edits[i].record, others[i].record))
            return fail(Fault::Station,
                        fmt::format("edit {} of {} is \"{}\"; of {} it is \"{}\"{}", i + 1, session,
                                    edits[i].description, other, others[i].description,
                                    edits[i].record.fields == others[i].record.fields
                                        ? ", with other numbers"
                                        : ""));
    if (edits.size() != others.size())
        return fail(
            Fault::Station,
            fmt::format("{} has {} edits, {} has {}", session, edits.size(), other, others.size()));
    auto const strokes = std::count_if(edits.begin(), edits.end(),
                                       [](auto const& edit) { return edit.has_stroke; });
    if (strokes == 0)
        return fail(Fault::Station, fmt::format("nothing is drawn in {}", session));
    fmt::print("{} edits, {} of them with strokes, are the same\n", edits.size(), strokes);
    return {};
}

} // namespace tractus
