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

// A column's value in a row that was found.
struct FoundColumn {
    enum class Kind { Null, Whole, Real, Text, Blob } kind = Kind::Null;
    std::int64_t whole = 0;
    std::string bytes {}; // Content of Text and Blob.
};

// Bytes that look like a row of a table, wherever they were found.
struct FoundRow {
    std::int64_t id = 0;
    std::vector<FoundColumn> columns;

    // Whether a page of the database still lists the row.
    enum class State {
        Deleted, // The row's page is free, or is intact and does not list the row.
        Unknown, // The row's page is damaged.
        Listed,  // The row's page is in use and lists the row.
    };
    State standing = State::Unknown;
};

// The pages of an SQLite file and its write-ahead log, if pages have a given size. The bytes may be
// damaged anywhere; nothing is read out of bounds.
class SqlitePages {
public:
    // Rows with more columns than this are skipped.
    static constexpr std::size_t kMaxColumns = 8;

    // `file` and `log` are not copied and must outlive this object.
    SqlitePages(std::string_view file, std::string_view log, std::size_t page_size);

    // Page sizes that the file may have, most likely first.
    static std::vector<std::size_t> likely_page_sizes(std::string_view file);

    // Calls `take` for each place in the pages that may be a row and for whose number of columns
    // `accepts` returns true. If pages in the log differ from the file's, a row is reported up to
    // twice: with the newest overflow pages, and with those of the file.
    void find_rows(std::function<bool(std::size_t columns)> const& accepts,
                   std::function<void(FoundRow&&)> const& take) const;

private:
    struct Page {
        std::string_view bytes;
        std::uint32_t number = 0;
        bool is_current = false; // True if no newer version of the page exists.
    };
    struct Header {
        std::uint64_t payload_bytes = 0;
        std::int64_t id = 0;
        std::size_t begin = 0; // Offset of the payload in the page.
        std::array<std::uint64_t, kMaxColumns> types {};
        std::size_t columns = 0;
        std::size_t header_bytes = 0;
    };

    void add_log(std::string_view log);
    void find_free_pages();
    std::vector<FoundRow::State> states_of_rows(Page const& page) const;
    std::optional<Header> header_at(std::string_view page, std::size_t place) const;
    std::optional<std::string> payload(Page const& page, Header const& header,
                                       std::vector<std::string_view> const& pages) const;

    std::size_t page_size_;
    std::vector<Page> pages_;
    // Contents of page 1, 2, …: the log's version if there is one, otherwise the file's.
    std::vector<std::string_view> newest_;
    std::vector<std::string_view> oldest_; // Contents of page 1, 2, … in the file itself.
    // Whether each page is free, by page number; all false if the free list is damaged.
    std::vector<bool> is_free_;
};

} // namespace tractus::session
