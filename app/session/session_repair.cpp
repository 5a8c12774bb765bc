#include "app/session/session_repair.h"

#include "app/session/page_scan.h"
#include "engine/base/file.h"
#include "engine/scene/edit_ids.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <set>
#include <utility>

namespace tractus::session {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxBytes = std::size_t { 4 } << 30;

std::optional<std::int64_t> whole_of(ScannedSession const& scanned, char const* key)
{
    auto const found = scanned.meta.find(key);
    std::int64_t value = 0;
    if (found == scanned.meta.end())
        return std::nullopt;
    auto const& text = found->second;
    auto const result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc() && value >= 0 ? std::optional(value) : std::nullopt;
}

std::string text_of(ScannedSession const& scanned, char const* key, char const* otherwise)
{
    auto const found = scanned.meta.find(key);
    return found == scanned.meta.end() ? otherwise : found->second;
}

// Numbers of the edits that are missing before the last intact one.
std::vector<std::int64_t> missing_numbers(std::vector<EditRow> const& rows)
{
    constexpr std::size_t kMax = 1'000'000;
    std::vector<std::int64_t> missing;
    std::int64_t next = 1;
    for (auto const& row : rows) {
        for (; next < row.place.number && missing.size() < kMax; ++next)
            missing.push_back(next);
        next = row.place.number + 1;
    }
    return missing;
}

// Stores the edit's number as the id of the object that the edit creates, before the edit is
// numbered anew. Old formats stored no ids.
void give_id(EditRow& row, scene::EditKinds kinds)
{
    auto const edit = edit_of(row.record, kinds);
    if (edit && row.place.number > 0)
        row.record = record_of(scene::with_id(*edit, static_cast<std::uint64_t>(row.place.number)));
}

// Returns the intact rows, with edits and steps numbered without gaps, to follow the `first` edits
// of a new beginning.
std::vector<EditRow> numbered_anew(SalvagedSession const& session, std::size_t first)
{
    auto rows = session.rows;
    auto number = static_cast<std::int64_t>(first);
    std::size_t step = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        auto const old_step = rows[i].step;
        bool const is_first = i == 0;
        // After a new beginning, the intact steps start at 1. Without one, the first intact step
        // becomes step 0.
        if (is_first)
            step = first > 0 && old_step > 0 ? 1 : 0;
        give_id(rows[i], session.kinds);
        rows[i].place.number = ++number;
        bool const step_ends = i + 1 < rows.size() && rows[i + 1].step != old_step;
        rows[i].step = step;
        rows[i].place.checksum = checksum_of(rows[i]);
        step += step_ends;
    }
    return rows;
}

// Returns the number of the current step after numbering the steps anew.
std::size_t step_anew(SalvagedSession const& session, std::vector<EditRow> const& anew)
{
    std::size_t step = 0;
    for (std::size_t i = 0; i < anew.size(); ++i)
        if (!session.step || session.rows[i].step <= *session.step)
            step = anew[i].step;
    return step;
}

} // namespace

Result<SalvagedSession> salvage_session(fs::path const& path, scene::EditKinds kinds)
{
    auto const file = TRY(read_file(path, kMaxBytes));
    auto const log_path = fs::path(path.string() + "-wal");
    std::error_code ignored;
    std::string log;
    if (fs::exists(log_path, ignored))
        log = TRY(read_file(log_path, kMaxBytes));
    return salvage_session({ file, log }, path, kinds);
}

Result<SalvagedSession> salvage_session(SessionBytes const& bytes, fs::path const& path,
                                        scene::EditKinds kinds)
{
    auto scanned = scan_pages(bytes.file, bytes.log, kinds);
    if (scanned.rows.empty())
        return fail(Fault::User,
                    fmt::format("{}: no edit of a session can be found in it", path.string()));
    SalvagedSession session { .kinds = kinds };
    session.missing = missing_numbers(scanned.rows);
    session.origin = { .plant = text_of(scanned, "plant", path.stem().c_str()),
                       .name = text_of(scanned, "name", ""),
                       .program = text_of(scanned, "program", "an unknown version") };
    session.origin.created
        = std::chrono::sys_seconds(std::chrono::seconds(whole_of(scanned, "created").value_or(0)));
    if (auto const step = whole_of(scanned, "step"))
        session.step = static_cast<std::size_t>(*step);
    std::set<std::size_t> broken;
    for (std::size_t i = 1; i < scanned.rows.size(); ++i)
        if (scanned.rows[i].place.number != scanned.rows[i - 1].place.number + 1)
            for (auto const step : { scanned.rows[i - 1].step, scanned.rows[i].step })
                broken.insert(step);
    session.broken_steps = broken.size();
    session.rows = std::move(scanned.rows);
    return session;
}

SessionContents contents_of(SalvagedSession const& session)
{
    SessionContents contents { .origin = session.origin, .edits = {}, .step = 0 };
    auto const anew = numbered_anew(session, 0);
    for (auto const& row : anew)
        contents.edits.push_back(
            { row.step, edit_or_unknown(row.record, session.kinds), row.made, row.place });
    contents.step = step_anew(session, anew);
    return contents;
}

Result<void> write_repaired(SalvagedSession const& session,
                            std::vector<scene::Edit> const& beginning, fs::path const& path)
{
    auto rows = beginning_rows(beginning, session.rows.front().made);
    auto const anew = numbered_anew(session, beginning.size());
    rows.insert(rows.end(), anew.begin(), anew.end());
    return write_new_session(path, session.origin, rows, step_anew(session, anew));
}

} // namespace tractus::session
