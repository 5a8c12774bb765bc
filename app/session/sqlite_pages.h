#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::session {

// A column of a row that was found.
struct FoundColumn {
    enum class Kind { Null, Whole, Real, Text, Blob } kind = Kind::Null;
    std::int64_t whole = 0;
    std::string bytes {}; // Value of Text and Blob.
};

// Bytes that look like a row of a table.
struct FoundRow {
    std::int64_t id = 0;
    std::vector<FoundColumn> columns;

    // Whether the row counts.
    enum class Standing {
        Deleted, // Its page is whole and does not list it, or is not in use any more.
        Unknown, // Its page is damaged.
        Listed,  // A page that is in use lists it.
    };
    Standing standing = Standing::Unknown;
};

// The pages of a SQLite file and its write-ahead log, of one size of page, as bytes that may be
// damaged anywhere. Nothing is read beyond the bytes that are there.
class SqlitePages {
public:
    // Rows with more are not looked for.
    static constexpr std::size_t kMostColumns = 8;

    // Neither is copied.
    SqlitePages(std::string_view file, std::string_view log, std::size_t page_size);

    // The sizes of page that the file may have, the likeliest first.
    static std::vector<std::size_t> likely_page_sizes(std::string_view file);

    // Calls `take` with each place that may be a row with so many columns as `accepts` says. A row
    // whose bytes go on in other pages is given once for each state of these pages that the log
    // holds.
    void find_rows(std::function<bool(std::size_t columns)> const& accepts,
                   std::function<void(FoundRow&&)> const& take) const;

private:
    struct Page {
        std::string_view bytes;
        std::uint32_t number = 0;
        bool is_current = false; // True if no later one overwrites it.
    };
    struct Header {
        std::uint64_t payload_bytes = 0;
        std::int64_t id = 0;
        std::size_t begin = 0; // Offset of the payload, in the page.
        std::array<std::uint64_t, kMostColumns> types {};
        std::size_t columns = 0;
        std::size_t header_bytes = 0;
    };

    void add_log(std::string_view log);
    void find_free_pages();
    std::vector<FoundRow::Standing> standings(Page const& page) const;
    std::optional<Header> header_at(std::string_view page, std::size_t place) const;
    std::optional<std::string> payload(Page const& page, Header const& header,
                                       std::vector<std::string_view> const& pages) const;

    std::size_t page_size_;
    std::vector<Page> pages_;
    std::vector<std::string_view> newest_; // Pages by number, from 1; the log's where it has one.
    std::vector<std::string_view> oldest_; // The file's own.
    // Indexed by number; all false where the list of free pages is broken.
    std::vector<bool> is_free_;
};

} // namespace tractus::session
