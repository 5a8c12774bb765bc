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

// A prepared statement of a Database, which must outlive it. Parameters and columns count from 0.
class Statement {
public:
    Statement(Statement&&) noexcept;
    ~Statement();

    Statement& bind(int parameter, std::int64_t value);
    Statement& bind_text(int parameter, std::string_view text);
    Statement& bind_blob(int parameter, std::string_view bytes);

    // Advances to the next row; false after the last one. Fails like the database.
    Result<bool> step();

    // Runs a statement that returns no rows. Afterwards it may be bound and run again.
    Result<void> run();

    // Rewinds to before the first row, so that new values can be bound.
    void reset();

    // True if the row's values have these types, one letter each: i for integer, t for text, b for
    // blob.
    bool has_types(std::string_view types) const;

    // Values of the current row.
    std::int64_t whole(int column) const;
    std::string bytes(int column) const; // Text or blob; empty for null.

private:
    friend class Database;
    explicit Statement(sqlite3_stmt* statement, class Database const& database);

    sqlite3_stmt* statement_;
    Database const* database_;
    int error_ = 0; // Error code of the last bind.
};

// An SQLite file, possibly from an untrusted source: its triggers, views and functions do not run,
// and statements that run too long are stopped. Errors are sentences that name the file and say
// what to do if it is not a database, damaged, locked by another program, not writable, or its disk
// is full.
class Database {
public:
    // Limit of virtual-machine instructions per row; reading or writing a row takes a few hundred.
    static constexpr std::uint64_t kMaxInstructions = 50'000'000;

    enum class Access {
        Read,  // Writes nothing, not even journal files beside the file.
        Write, // Reads and writes a file that must exist.
        Create,
    };

    static Result<Database> open(std::filesystem::path const& path, Access access);

    Result<Statement> prepare(char const* sql) const;

    // Runs statements that return no rows, one after the other.
    Result<void> execute(std::string const& sql) const;

    // The first column of the first row, an integer.
    Result<std::int64_t> whole(char const* sql) const;

    // Copies the whole database to a file, which appears complete and replaces an older one.
    Result<void> back_up(std::filesystem::path const& copy) const;

    // True between "BEGIN" and the end of its transaction; an error may end it.
    bool is_in_transaction() const;

    // The error sentence for an SQLite result code.
    tl::unexpected<Error> error(int code) const;

private:
    friend class Statement;
    struct Close {
        void operator()(sqlite3* database) const;
    };

    Database(std::filesystem::path path, sqlite3* database);

    void harden_connection();
    void reset_instruction_count() const { *instructions_ = 0; }

    std::filesystem::path path_;
    std::unique_ptr<std::uint64_t> instructions_; // Count since reset_instruction_count(), on the
                                                  // heap because SQLite holds its address.
    std::unique_ptr<sqlite3, Close> database_;
};

} // namespace tractus::session
