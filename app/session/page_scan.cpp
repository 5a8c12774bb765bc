#include "app/session/page_scan.h"

#include "app/session/sqlite_pages.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace tractus::session {

namespace {

using Kind = FoundColumn::Kind;
using State = FoundRow::State;

constexpr std::size_t kEditColumns = 7;
constexpr std::size_t kEditColumnsOfFormat1 = 5; // Format 1 has no time and no checksum.
constexpr std::size_t kMetaColumns = 2;
constexpr std::size_t kMetaCopyColumns = 3; // Columns of meta_copies: key, value and checksum.

bool has_kinds(FoundRow const& row, std::initializer_list<Kind> kinds)
{
    return row.columns.size() == kinds.size()
        && std::equal(kinds.begin(), kinds.end(), row.columns.begin(),
                      [](Kind kind, FoundColumn const& column) { return column.kind == kind; });
}

// Converts a row that was found to a row of the table "edits"; nullopt if it is not one or is
// damaged.
std::optional<EditRow> edit_row(FoundRow&& found, scene::EditKinds kinds)
{
    bool const has_checksum = has_kinds(
        found,
        { Kind::Null, Kind::Whole, Kind::Text, Kind::Text, Kind::Blob, Kind::Whole, Kind::Whole });
    bool const has_none
        = has_kinds(found, { Kind::Null, Kind::Whole, Kind::Text, Kind::Text, Kind::Blob });
    if ((!has_checksum && !has_none) || found.columns[1].whole < 0)
        return std::nullopt;
    EditRow row { .place = { .number = found.id },
                  .step = static_cast<std::size_t>(found.columns[1].whole),
                  .record = { std::move(found.columns[2].bytes), std::move(found.columns[3].bytes),
                              std::move(found.columns[4].bytes) } };
    row.place.checksum = checksum_of(row);
    if (has_none) // Without a checksum, only the edit's form shows whether it is intact.
        return edit_of(row.record, kinds) ? std::optional(std::move(row)) : std::nullopt;
    row.made = std::chrono::sys_seconds(std::chrono::seconds(found.columns[5].whole));
    return found.columns[6].whole == row.place.checksum ? std::optional(std::move(row))
                                                        : std::nullopt;
}

class Scan {
public:
    explicit Scan(scene::EditKinds kinds)
        : kinds_(kinds)
    {
    }

    void take(FoundRow&& found)
    {
        if (found.columns.size() == kMetaColumns || found.columns.size() == kMetaCopyColumns)
            return take_meta(found);
        auto const standing = found.standing;
        if (auto row = edit_row(std::move(found), kinds_))
            take_edit(*std::move(row), standing);
    }

    std::size_t edit_count() const { return edits_.size(); }

    ScannedSession finish() &&
    {
        ScannedSession session;
        for (auto& [key, candidate] : meta_)
            session.meta.emplace(key, std::move(candidate.text));
        std::int64_t last_listed = 0;
        for (auto const& [number, candidate] : edits_)
            if (candidate.standing == State::Listed)
                last_listed = number;
        std::chrono::sys_seconds newest {};
        for (auto& [number, candidate] : edits_) {
            // The numbers of edits in the table have no gaps. So an edit that no page lists,
            // although an edit with a higher number is listed, was lost rather than deleted, unless
            // it is older than the edit before it.
            bool const was_deleted = candidate.standing != State::Listed
                && (candidate.row.made < newest
                    || (candidate.standing == State::Deleted && number > last_listed));
            if (was_deleted)
                continue;
            newest = std::max(newest, candidate.row.made);
            session.last_number = number;
            session.rows.push_back(std::move(candidate.row));
        }
        return session;
    }

private:
    struct Candidate {
        EditRow row;
        State standing = State::Deleted;
    };

    void take_edit(EditRow&& row, State standing)
    {
        auto const number = row.place.number;
        auto const [found, is_new] = edits_.try_emplace(number);
        auto& best = found->second;
        if (is_new || std::pair(standing, row.made) > std::pair(best.standing, best.row.made))
            best = { std::move(row), standing };
    }

    // A value found for a key of the meta table. A value that a page lists is preferred; among
    // equals, one from meta_copies with a valid checksum. Values with a wrong checksum are ignored.
    struct MetaCandidate {
        std::string text;
        // Whether a page lists the value, and whether it has a checksum.
        std::pair<bool, bool> rank {};
    };

    void take_meta(FoundRow const& found)
    {
        constexpr std::array kKeys { "plant", "name", "program", "created", "step" };
        auto const& key = found.columns[0];
        auto const& value = found.columns[1];
        if (key.kind != Kind::Text
            || std::find(kKeys.begin(), kKeys.end(), key.bytes) == kKeys.end())
            return;
        auto text = value.kind == Kind::Whole ? std::to_string(value.whole) : value.bytes;
        bool const is_copy = found.columns.size() == kMetaCopyColumns;
        if (is_copy && found.columns[2].whole != checksum_of_meta(key.bytes, text))
            return;
        std::pair const rank(found.standing == State::Listed, is_copy);
        auto const [best, is_new] = meta_.try_emplace(key.bytes);
        if (is_new || rank > best->second.rank || (rank.first && rank == best->second.rank))
            best->second = { std::move(text), rank };
    }

    scene::EditKinds kinds_;
    std::map<std::int64_t, Candidate> edits_;
    std::map<std::string, MetaCandidate> meta_;
};

} // namespace

ScannedSession scan_pages(std::string_view file, std::string_view log, scene::EditKinds kinds)
{
    auto const accepts = [](std::size_t columns) {
        return columns == kEditColumns || columns == kEditColumnsOfFormat1
            || columns == kMetaColumns || columns == kMetaCopyColumns;
    };
    // First tries the page size in the file's header and SQLite's default size. Other sizes are
    // tried only if no edit is found with these.
    constexpr std::size_t kUsualPageBytes = 4096;
    Scan best(kinds);
    std::size_t tried = 0;
    for (auto const page_size : SqlitePages::likely_page_sizes(file)) {
        Scan scan(kinds);
        SqlitePages(file, log, page_size).find_rows(accepts, [&](FoundRow&& row) {
            scan.take(std::move(row));
        });
        if (scan.edit_count() > best.edit_count())
            best = std::move(scan);
        if (best.edit_count() > 0 && (page_size == kUsualPageBytes || ++tried == 2))
            break;
    }
    return std::move(best).finish();
}

} // namespace tractus::session
