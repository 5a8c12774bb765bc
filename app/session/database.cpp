#include "app/session/database.h"

#include "engine/base/check.h"
#include "engine/base/file.h"

#include <cstring>
#include <fmt/core.h>
#include <sqlite3.h>
#include <utility>

namespace tractus::session {

namespace fs = std::filesystem;

namespace {

// Waiting time for another program that is reading or just closing the file.
constexpr int kPatience_ms = 500;

// Returns the path as a URI for SQLite.
std::string uri_of(fs::path const& path)
{
    std::string uri = "file:";
    for (char const character : path.string()) {
        bool const is_plain = (character >= 'a' && character <= 'z')
            || (character >= 'A' && character <= 'Z') || (character >= '0' && character <= '9')
            || character == '/';
        uri += is_plain ? std::string(1, character)
                        : fmt::format("%{:02x}", static_cast<unsigned char>(character));
    }
    return uri;
}

bool is_there(fs::path const& path)
{
    std::error_code ignored;
    return fs::exists(path, ignored);
}

// True if a journal or write-ahead log, which contains a part of the data, lies beside the file.
bool has_journal(fs::path const& path)
{
    return is_there(path.string() + "-wal") || is_there(path.string() + "-journal");
}

} // namespace

Statement::Statement(sqlite3_stmt* statement, Database const& database)
    : statement_(statement)
    , database_(&database)
{
}

Statement::Statement(Statement&& other) noexcept
    : statement_(std::exchange(other.statement_, nullptr))
    , database_(other.database_)
    , error_(other.error_)
{
}

Statement::~Statement()
{
    sqlite3_finalize(statement_);
}

Statement& Statement::bind(int parameter, std::int64_t value)
{
    error_ |= sqlite3_bind_int64(statement_, parameter + 1, value);
    return *this;
}

Statement& Statement::bind_text(int parameter, std::string_view text)
{
    error_ |= sqlite3_bind_text64(statement_, parameter + 1, text.data(), text.size(),
                                  SQLITE_TRANSIENT, SQLITE_UTF8);
    return *this;
}

Statement& Statement::bind_blob(int parameter, std::string_view bytes)
{
    error_ |= sqlite3_bind_blob64(statement_, parameter + 1, bytes.data(), bytes.size(),
                                  SQLITE_TRANSIENT);
    return *this;
}

Result<bool> Statement::step()
{
    if (error_ != SQLITE_OK)
        return database_->error(error_);
    database_->reset_instruction_count();
    int const code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE)
        return database_->error(code);
    return code == SQLITE_ROW;
}

Result<void> Statement::run()
{
    while (TRY(step())) { }
    reset();
    return {};
}

void Statement::reset()
{
    sqlite3_reset(statement_);
}

bool Statement::has_types(std::string_view types) const
{
    for (int column = 0; column < static_cast<int>(types.size()); ++column) {
        int const type = sqlite3_column_type(statement_, column);
        char const letter = type == SQLITE_INTEGER ? 'i'
            : type == SQLITE_TEXT                  ? 't'
            : type == SQLITE_BLOB                  ? 'b'
                                                   : ' ';
        if (letter != types[static_cast<std::size_t>(column)])
            return false;
    }
    return true;
}

std::int64_t Statement::whole(int column) const
{
    return sqlite3_column_int64(statement_, column);
}

std::string Statement::bytes(int column) const
{
    auto const* const begin = static_cast<char const*>(sqlite3_column_blob(statement_, column));
    auto const size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
    return begin ? std::string(begin, size) : std::string();
}

void Database::Close::operator()(sqlite3* database) const
{
    sqlite3_close(database);
}

Database::Database(fs::path path, sqlite3* database)
    : path_(std::move(path))
    , instructions_(std::make_unique<std::uint64_t>(0))
    , database_(database)
{
}

// Number of virtual-machine instructions between two calls of the progress handler.
static constexpr int kInstructionsCounted = 10'000;

static int give_up_after_many(void* instructions)
{
    auto& count = *static_cast<std::uint64_t*>(instructions);
    count += kInstructionsCounted;
    return count > Database::kMaxInstructions ? 1 : 0;
}

// Follows the advice of www.sqlite.org/security.html for files that may be malicious.
void Database::harden_connection()
{
    auto* const handle = database_.get();
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    for (int const unwanted :
         { SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_TRIGGER,
           SQLITE_DBCONFIG_ENABLE_VIEW, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION,
           SQLITE_DBCONFIG_ENABLE_FKEY, SQLITE_DBCONFIG_DQS_DDL, SQLITE_DBCONFIG_DQS_DML })
        sqlite3_db_config(handle, unwanted, 0, nullptr);
    constexpr std::pair<int, int> kLimits[] {
        { SQLITE_LIMIT_LENGTH, 512 << 20 },
        { SQLITE_LIMIT_SQL_LENGTH, 100'000 },
        { SQLITE_LIMIT_COLUMN, 16 },
        { SQLITE_LIMIT_EXPR_DEPTH, 20 },
        { SQLITE_LIMIT_COMPOUND_SELECT, 5 },
        { SQLITE_LIMIT_FUNCTION_ARG, 16 },
        { SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 50 },
        { SQLITE_LIMIT_VARIABLE_NUMBER, 16 },
        { SQLITE_LIMIT_TRIGGER_DEPTH, 1 },
        { SQLITE_LIMIT_WORKER_THREADS, 0 },
    };
    for (auto const& [limit, value] : kLimits)
        sqlite3_limit(handle, limit, value);
    sqlite3_progress_handler(handle, kInstructionsCounted, give_up_after_many, instructions_.get());
    (void)execute("PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0");
}

Result<Database> Database::open(fs::path const& path, Access access)
{
    std::error_code ignored;
    // A relative path such as ":memory:" would have a special meaning for SQLite.
    auto const whole_path = fs::absolute(path, ignored);
    if (access != Access::Create && !fs::is_regular_file(whole_path, ignored))
        return fail(Fault::User,
                    fmt::format("cannot open {}: {}", path.string(),
                                is_there(whole_path) ? "it is no file" : "there is no such file"));
    int const flags = access == Access::Read ? SQLITE_OPEN_READONLY | SQLITE_OPEN_URI
        : access == Access::Write            ? SQLITE_OPEN_READWRITE
                                             : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    // Without a journal, no program is writing to the file. It can then be read as immutable, even
    // in a folder without write permission.
    bool const is_still = access == Access::Read && !has_journal(whole_path);
    auto const name = access == Access::Read ? uri_of(whole_path) + (is_still ? "?immutable=1" : "")
                                             : whole_path.string();
    sqlite3* handle = nullptr;
    int const code = sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_EXRESCODE, nullptr);
    Database database(path, handle);
    if (code != SQLITE_OK)
        return database.error(code);
    sqlite3_busy_timeout(handle, kPatience_ms);
    database.harden_connection();
    return database;
}

Result<Database> Database::open_in_memory(std::string const& name, std::string_view bytes)
{
    sqlite3* handle = nullptr;
    int code = sqlite3_open_v2(":memory:", &handle,
                               SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_EXRESCODE,
                               nullptr);
    Database database(name, handle);
    if (code == SQLITE_OK && !bytes.empty()) {
        auto* const copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
        if (!copy)
            return database.error(SQLITE_NOMEM);
        std::memcpy(copy, bytes.data(), bytes.size());
        // The versions of the format for writing and reading (section 1.3.3 of the file format). A
        // database in memory has no write-ahead log.
        constexpr std::size_t kWriteVersion = 18;
        constexpr std::size_t kReadVersion = 19;
        if (bytes.size() > kReadVersion && copy[kWriteVersion] == 2 && copy[kReadVersion] == 2)
            copy[kWriteVersion] = copy[kReadVersion] = 1;
        auto const size = static_cast<sqlite3_int64>(bytes.size());
        code = sqlite3_deserialize(handle, "main", copy, size, size,
                                   SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE);
    }
    if (code != SQLITE_OK)
        return database.error(code);
    database.harden_connection();
    return database;
}

Result<Statement> Database::prepare(char const* sql) const
{
    sqlite3_stmt* statement = nullptr;
    if (int const code = sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr);
        code != SQLITE_OK)
        return error(code);
    return Statement(statement, *this);
}

Result<void> Database::execute(std::string const& sql) const
{
    reset_instruction_count();
    if (int const code = sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr);
        code != SQLITE_OK)
        return error(code);
    return {};
}

Result<std::int64_t> Database::whole(char const* sql) const
{
    auto statement = TRY(prepare(sql));
    if (!TRY(statement.step()))
        return error(SQLITE_CORRUPT);
    return statement.whole(0);
}

Result<void> Database::back_up(fs::path const& copy) const
{
    auto const made = fs::path(copy.string() + ".part");
    std::error_code failed;
    fs::remove(made, failed);
    {
        auto const target = TRY(open(made, Access::Create));
        auto* const backup
            = sqlite3_backup_init(target.database_.get(), "main", database_.get(), "main");
        if (!backup)
            return target.error(sqlite3_errcode(target.database_.get()));
        sqlite3_backup_step(backup, -1);
        if (int const code = sqlite3_backup_finish(backup); code != SQLITE_OK)
            return target.error(code);
    }
    if (auto const original = fs::status(path_, failed); fs::is_regular_file(original))
        fs::permissions(made, original.permissions(), failed);
    return rename_on_disk(made, copy);
}

Result<std::string> Database::bytes() const
{
    sqlite3_int64 size = 0;
    std::unique_ptr<unsigned char, void (*)(void*)> const copy(
        sqlite3_serialize(database_.get(), "main", &size, 0), sqlite3_free);
    if (!copy)
        return error(SQLITE_NOMEM);
    return std::string(reinterpret_cast<char const*>(copy.get()), static_cast<std::size_t>(size));
}

bool Database::is_in_transaction() const
{
    return sqlite3_get_autocommit(database_.get()) == 0;
}

tl::unexpected<Error> Database::error(int code) const
{
    auto const name = path_.string();
    auto const sentence = [&](std::string const& text) { return fail(Fault::User, text); };
    int const system_error = sqlite3_system_errno(database_.get());
    switch (code & 0xff) {
    case SQLITE_NOTADB:
        return sentence(
            fmt::format("{0} is not a session of tractus; if it was one, \"tractus session "
                        "repair {0} -o NEW.tractus\" brings back what is whole",
                        name));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return sentence(fmt::format("{} is in use by another program: close it there first", name));
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
        return sentence(fmt::format("{} may not be written: change its permissions, or work on a "
                                    "copy",
                                    name));
    case SQLITE_FULL:
        return sentence(fmt::format("cannot write {}: there is no space left on its disk", name));
    case SQLITE_INTERRUPT: // Raised by give_up_after_many().
        return sentence(fmt::format("{} cannot be read: it makes SQLite work without end", name));
    case SQLITE_NOMEM:
        return sentence(fmt::format("there is not enough memory to read {}", name));
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
        return sentence(fmt::format(
            "cannot {} {}: {}", (code & 0xff) == SQLITE_CANTOPEN ? "open" : "read or write", name,
            system_error != 0 ? std::strerror(system_error) : sqlite3_errstr(code)));
    case SQLITE_TOOBIG:
        return sentence(fmt::format("cannot write {}: one edit has more than 512 MiB", name));
    default:
        // SQLITE_CORRUPT, or a table without the expected columns or types.
        return sentence(
            fmt::format("{0} is damaged ({1}): \"tractus session repair {0} -o NEW.tractus\" "
                        "brings back what is whole",
                        name, sqlite3_errstr(code)));
    }
}

} // namespace tractus::session
