#include "app/session/sqlite_pages.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace tractus::session {

namespace {

using State = FoundRow::State;

constexpr std::size_t kFileHeaderBytes = 100;
constexpr std::size_t kLogHeaderBytes = 32;
constexpr std::size_t kFrameHeaderBytes = 24;
constexpr std::uint8_t kTableLeaf = 0x0d;

std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t size)
{
    std::uint64_t value = 0;
    if (at + size > bytes.size())
        return 0;
    for (std::size_t i = 0; i < size; ++i)
        value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

// Reads a variable-length integer at `at` and advances `at`. Returns false if the bytes end too
// early.
bool read_varint(std::string_view bytes, std::size_t& at, std::uint64_t& value)
{
    value = 0;
    for (int i = 0; i < 9; ++i) {
        if (at >= bytes.size())
            return false;
        auto const byte = static_cast<std::uint8_t>(bytes[at++]);
        if (i == 8) {
            value = value << 8 | byte;
            return true;
        }
        value = value << 7 | (byte & 0x7fU);
        if (byte < 0x80)
            return true;
    }
    return true;
}

// The size in bytes of a value with this serial type; nullopt for the types 10 and 11, which are
// reserved.
std::optional<std::uint64_t> column_bytes(std::uint64_t type)
{
    constexpr std::uint64_t kSizes[] { 0, 1, 2, 3, 4, 6, 8, 8, 0, 0 };
    if (type < std::size(kSizes))
        return kSizes[type];
    if (type < 12)
        return std::nullopt;
    return (type - 12) / 2;
}

FoundColumn column_of(std::uint64_t type, std::string_view bytes)
{
    if (type == 0)
        return {};
    if (type == 8 || type == 9)
        return { .kind = FoundColumn::Kind::Whole, .whole = type == 9 };
    if (type >= 12)
        return { .kind = type % 2 == 0 ? FoundColumn::Kind::Blob : FoundColumn::Kind::Text,
                 .bytes = std::string(bytes) };
    auto const bits = big_endian(bytes, 0, bytes.size());
    auto const unused = 64 - 8 * bytes.size();
    return { .kind = type == 7 ? FoundColumn::Kind::Real : FoundColumn::Kind::Whole,
             .whole = static_cast<std::int64_t>(bits << unused) >> unused };
}

} // namespace

std::vector<std::size_t> SqlitePages::likely_page_sizes(std::string_view file)
{
    auto const written = big_endian(file, 16, 2);
    std::vector<std::size_t> sizes;
    auto const add = [&](std::size_t size) {
        bool const is_size = size >= 512 && size <= 65536 && (size & (size - 1)) == 0;
        if (is_size && std::find(sizes.begin(), sizes.end(), size) == sizes.end())
            sizes.push_back(size);
    };
    add(written == 1 ? 65536 : written);
    add(4096); // Default page size of SQLite.
    for (std::size_t size = 512; size <= 65536; size *= 2)
        add(size);
    return sizes;
}

SqlitePages::SqlitePages(std::string_view file, std::string_view log, std::size_t page_size)
    : page_size_(page_size)
{
    for (std::size_t at = 0; at < file.size(); at += page_size) {
        auto const bytes = file.substr(at, page_size); // The last page may be incomplete.
        pages_.push_back({ bytes, static_cast<std::uint32_t>(pages_.size() + 1), true });
        oldest_.push_back(bytes);
    }
    newest_ = oldest_;
    add_log(log);
    find_free_pages();
}

// Adds the pages in the log's frames. Frames from an earlier use of the log, which have other
// salts, and frames of an uncommitted transaction are added too, but not as current versions of
// their pages.
void SqlitePages::add_log(std::string_view log)
{
    auto const frame_bytes = kFrameHeaderBytes + page_size_;
    std::uint64_t const salts = big_endian(log, 16, 8);
    std::size_t committed = 0; // Number of frames up to the last commit.
    std::size_t count = 0;
    for (auto at = kLogHeaderBytes; at + frame_bytes <= log.size(); at += frame_bytes) {
        ++count;
        if (big_endian(log, at + 4, 4) != 0 && big_endian(log, at + 8, 8) == salts)
            committed = count;
    }
    // For each page (its number minus 1), the index in pages_ of its newest version.
    constexpr auto kUnseen = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> newest_at(newest_.size());
    std::iota(newest_at.begin(), newest_at.end(), std::size_t { 0 });
    for (std::size_t i = 0; i < count; ++i) {
        auto const at = kLogHeaderBytes + i * frame_bytes;
        auto const number = static_cast<std::uint32_t>(big_endian(log, at, 4));
        auto const bytes = log.substr(at + kFrameHeaderBytes, page_size_);
        bool const counts = i < committed && big_endian(log, at + 8, 8) == salts && number > 0
            && number <= newest_.size() + count;
        pages_.push_back({ bytes, number, counts });
        if (!counts)
            continue;
        if (number > newest_.size()) {
            newest_.resize(number);
            newest_at.resize(number, kUnseen);
        }
        auto const before = std::exchange(newest_at[number - 1], pages_.size() - 1);
        if (before != kUnseen)
            pages_[before].is_current = false;
        newest_[number - 1] = bytes;
    }
}

void SqlitePages::find_free_pages()
{
    is_free_.assign(newest_.size() + 1, false);
    if (newest_.empty())
        return;
    auto free = is_free_;
    std::uint64_t found = 0;
    auto const take = [&](std::uint64_t number) {
        if (number == 0 || number > newest_.size() || free[number])
            return false;
        free[number] = true;
        ++found;
        return true;
    };
    for (auto trunk = big_endian(newest_[0], 32, 4); trunk != 0;) {
        if (!take(trunk))
            return;
        auto const page = newest_[trunk - 1];
        auto const leaves = std::min<std::uint64_t>(big_endian(page, 4, 4), page_size_ / 4);
        for (std::uint64_t i = 0; i < leaves; ++i)
            if (!take(big_endian(page, 8 + 4 * i, 4)))
                return;
        trunk = big_endian(page, 0, 4);
    }
    if (found == big_endian(newest_[0], 36, 4))
        is_free_ = std::move(free);
}

// Returns, for each offset in the page, the state of a row that would begin there.
std::vector<FoundRow::State> SqlitePages::states_of_rows(Page const& page) const
{
    std::size_t const begin = page.number == 1 ? kFileHeaderBytes : 0;
    std::vector<State> states_of_rows(page.bytes.size(), State::Unknown);
    auto const all_deleted = [&] {
        for (auto& standing : states_of_rows)
            if (standing == State::Unknown)
                standing = State::Deleted;
        return states_of_rows;
    };
    if (!page.is_current || (page.number < is_free_.size() && is_free_[page.number]))
        return all_deleted();
    if (big_endian(page.bytes, begin, 1) != kTableLeaf)
        return states_of_rows;
    auto const count = big_endian(page.bytes, begin + 3, 2);
    bool is_whole = true;
    for (std::uint64_t i = 0; i < count; ++i) {
        auto const place = big_endian(page.bytes, begin + 8 + 2 * i, 2);
        bool const is_row
            = place < states_of_rows.size() && header_at(page.bytes, place).has_value();
        is_whole = is_whole && is_row;
        if (is_row)
            states_of_rows[place] = State::Listed;
    }
    return is_whole ? all_deleted() : states_of_rows;
}

std::optional<SqlitePages::Header> SqlitePages::header_at(std::string_view page,
                                                          std::size_t place) const
{
    constexpr std::uint64_t kMaxHeaderBytes = 64;
    std::uint64_t payload_bytes = 0;
    std::uint64_t id = 0;
    std::uint64_t size = 0;
    // At most places there is no row, as their first bytes show.
    if (!read_varint(page, place, payload_bytes) || payload_bytes < 2
        || !read_varint(page, place, id) || static_cast<std::int64_t>(id) < 1)
        return std::nullopt;
    auto const begin = place;
    if (!read_varint(page, place, size) || size < 2 || size > kMaxHeaderBytes
        || size > payload_bytes)
        return std::nullopt;
    Header header { .payload_bytes = payload_bytes,
                    .id = static_cast<std::int64_t>(id),
                    .begin = begin };
    header.header_bytes = static_cast<std::size_t>(size);
    auto const end = header.begin + header.header_bytes;
    std::uint64_t total = size;
    while (place < end) {
        std::uint64_t type = 0;
        if (!read_varint(page, place, type))
            return std::nullopt;
        auto const bytes = column_bytes(type);
        if (!bytes || *bytes > header.payload_bytes)
            return std::nullopt;
        total += *bytes;
        if (header.columns == kMaxColumns)
            return std::nullopt;
        header.types[header.columns++] = type;
    }
    return place == end && total == header.payload_bytes ? std::optional(header) : std::nullopt;
}

// Reads a row's payload, which may continue in a chain of overflow pages (section 1.6, "Cell
// payload overflow pages").
std::optional<std::string> SqlitePages::payload(Page const& page, Header const& header,
                                                std::vector<std::string_view> const& pages) const
{
    auto const wanted = header.payload_bytes;
    std::uint64_t const most_here = page_size_ - 35;
    std::uint64_t const min_here = (page_size_ - 12) * 32 / 255 - 23;
    std::uint64_t here = wanted;
    if (wanted > most_here) {
        here = min_here + (wanted - min_here) % (page_size_ - 4);
        if (here > most_here)
            here = min_here;
    }
    if (header.begin + here > page.bytes.size() || wanted > pages.size() * page_size_)
        return std::nullopt;
    std::string bytes(page.bytes.substr(header.begin, static_cast<std::size_t>(here)));
    auto next = here == wanted ? 0 : big_endian(page.bytes, header.begin + here, 4);
    while (bytes.size() < wanted) {
        if (next == 0 || next > pages.size())
            return std::nullopt;
        auto const more = pages[next - 1];
        auto const size = std::min<std::uint64_t>(wanted - bytes.size(), page_size_ - 4);
        if (more.size() < 4 + size)
            return std::nullopt;
        bytes.append(more.substr(4, static_cast<std::size_t>(size)));
        next = big_endian(more, 0, 4);
    }
    return bytes;
}

void SqlitePages::find_rows(std::function<bool(std::size_t columns)> const& accepts,
                            std::function<void(FoundRow&&)> const& take) const
{
    auto const states
        = newest_ == oldest_ ? std::vector { &newest_ } : std::vector { &newest_, &oldest_ };
    for (auto const& page : pages_) {
        auto const standing = states_of_rows(page);
        for (std::size_t place = 0; place < page.bytes.size(); ++place) {
            // A row begins with its size, at least 2. Most of a page's free space is zeros.
            if (static_cast<std::uint8_t>(page.bytes[place]) < 2)
                continue;
            auto const header = header_at(page.bytes, place);
            if (!header || !accepts(header->columns))
                continue;
            for (auto const* const state : states) {
                auto const bytes = payload(page, *header, *state);
                if (!bytes)
                    continue;
                FoundRow row { .id = header->id, .columns = {}, .standing = standing[place] };
                auto at = header->header_bytes;
                for (std::size_t i = 0; i < header->columns; ++i) {
                    auto const type = header->types[i];
                    auto const size = static_cast<std::size_t>(*column_bytes(type));
                    row.columns.push_back(
                        column_of(type, std::string_view(*bytes).substr(at, size)));
                    at += size;
                }
                take(std::move(row));
            }
        }
    }
}

} // namespace tractus::session
