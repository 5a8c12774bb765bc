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

// A prepared statement of a Database. The database must outlive the statement. Parameters and
// columns count from 0.
class Statement {
public:
    Statement(Statement&&) noexcept;
    ~Statement();

    Statement& bind(int parameter, std::int64_t value);
    Statement& bind_text(int parameter, std::string_view text);
    Statement& bind_blob(int parameter, std::string_view bytes);

    // Advances to the next row of the result; returns false after the last row. Fails with a
    // Database error.
    Result<bool> step();

    // Runs a statement that returns no rows. Afterwards, new values can be bound and the statement
    // run again.
    Result<void> run();

    // Rewinds the statement to before the first row of its result, so that new values can be bound.
    void reset();

    // True if the values of the current row have these types, one letter for each column: i for
    // integer, t for text, b for blob.
    bool has_types(std::string_view types) const;

    // Values of the current row.
    std::int64_t whole(int column) const;
    std::string bytes(int column) const; // Bytes of a text or blob; empty for null.

private:
    friend class Database;
    explicit Statement(sqlite3_stmt* statement, class Database const& database);

    sqlite3_stmt* statement_;
    Database const* database_;
    int error_ = 0; // SQLite error codes of the bind functions so far, combined; 0: no error.
};

// An SQLite file, possibly from an untrusted source: the file's triggers, views and functions do
// not run, and statements that run too long are stopped. Error messages are sentences that name the
// file. They say what to do if the file is not a database, is damaged, is locked by another
// program, is not writable, or if its disk is full.
class Database {
public:
    // Maximum number of instructions of SQLite's virtual machine per row; a row takes a few
    // hundred.
    static constexpr std::uint64_t kMaxInstructions = 50'000'000;

    enum class Access {
        Read,  // Writes nothing, not even journal files beside the database.
        Write, // Reads and writes a file that must exist.
        Create,
    };

    static Result<Database> open(std::filesystem::path const& path, Access access);

    // Opens a copy of a file's bytes in memory, which can be changed; no bytes make an empty
    // database. `name` is the name of the database for messages. A write-ahead log is not read.
    static Result<Database> open_in_memory(std::string const& name, std::string_view bytes = {});

    Result<Statement> prepare(char const* sql) const;

    // Runs statements that return no rows; `sql` may have several, separated by semicolons.
    Result<void> execute(std::string const& sql) const;

    // Runs a query and returns the integer in the first column of the first row.
    Result<std::int64_t> whole(char const* sql) const;

    // Copies the whole database to a file. The file appears only when complete, and replaces an
    // older one.
    Result<void> back_up(std::filesystem::path const& copy) const;

    // Returns the whole database as the bytes of a file.
    Result<std::string> bytes() const;

    // True from "BEGIN" to the end of that transaction. An error may also end a transaction.
    bool is_in_transaction() const;

    // The error with the sentence for an SQLite result code.
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
    // Instructions since reset_instruction_count(); on the heap, as SQLite keeps the address.
    std::unique_ptr<std::uint64_t> instructions_;
    std::unique_ptr<sqlite3, Close> database_;
};

} // namespace tractus::session
