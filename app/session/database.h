#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace tractus::session {

// One prepared statement of a Database, which must outlive it. Parameters and columns count from 0.
class Statement {
public:
    Statement(Statement&&) noexcept;
    ~Statement();

    Statement& bind(int parameter, std::int64_t value);
    Statement& bind_text(int parameter, std::string_view text);
    Statement& bind_blob(int parameter, std::string_view bytes);

    // The next row: false when there is none any more. Fails like the database.
    Result<bool> step();

    // Runs to the end, for statements without rows. Then the statement may be bound and run again.
    Result<void> run();

    // Back to before the first row, to be bound again.
    void reset();

    // Whether the row's values are of these types: i for whole numbers, t for text, b for blobs.
    bool has_types(std::string_view types) const;

    // Values of the row.
    std::int64_t whole(int column) const;
    std::string bytes(int column) const; // Text or blob; empty for null.

private:
    friend class Database;
    explicit Statement(sqlite3_stmt* statement, class Database const& database);

    sqlite3_stmt* statement_;
    Database const* database_;
    int error_ = 0; // Error of a bind.
};

// A SQLite file, which may come from anybody: it runs no triggers, views and functions of its own,
// and a statement that goes on and on is given up. Everything that fails does so in a sentence that
// names the file and says what to do: what is no database, is damaged, is locked by another
// program, may not be written, or has no room left.
class Database {
public:
    // Instructions of SQLite's virtual machine from one row to the next; reading or writing one
    // takes a few hundred.
    static constexpr std::uint64_t kMostInstructions = 50'000'000;

    enum class Access {
        Read,  // Writes nothing, not even beside the file.
        Write, // The file is there.
        Create,
    };

    static Result<Database> open(std::filesystem::path const& path, Access access);

    Result<Statement> prepare(char const* sql) const;

    // Statements without rows, one after the other.
    Result<void> execute(std::string const& sql) const;

    // The first column of the first row.
    Result<std::int64_t> whole(char const* sql) const;

    // Copies the whole of it to a file, which appears whole, in the place of an older one.
    Result<void> back_up(std::filesystem::path const& copy) const;

    // True between a "BEGIN" and its end, which an error may be.
    bool is_in_transaction() const;

    // The sentence for a result code of the library's.
    tl::unexpected<Error> error(int code) const;

private:
    friend class Statement;
    struct Close {
        void operator()(sqlite3* database) const;
    };

    Database(std::filesystem::path path, sqlite3* database);

    void limit_what_files_may_do();
    void begin_counting() const { *instructions_ = 0; }

    std::filesystem::path path_;
    std::unique_ptr<std::uint64_t> instructions_; // Since begin_counting(); SQLite has its address.
    std::unique_ptr<sqlite3, Close> database_;
};

} // namespace tractus::session
