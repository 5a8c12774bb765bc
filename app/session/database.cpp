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

// How long to wait for another program that reads or ends just now.
constexpr int kPatience_ms = 500;

// A file name as SQLite takes it in a URI.
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

// Whether another program's journal lies beside the file: what stands in it is part of the file.
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
    , database_(database)
{
}

Result<Database> Database::open(fs::path const& path, Access access)
{
    std::error_code ignored;
    // Its name may look like something else to SQLite if it is not a whole path.
    auto const whole_path = fs::absolute(path, ignored);
    if (access != Access::Create && !fs::is_regular_file(whole_path, ignored))
        return fail(Fault::User,
                    fmt::format("cannot open {}: {}", path.string(),
                                is_there(whole_path) ? "it is no file" : "there is no such file"));
    int const flags = access == Access::Read ? SQLITE_OPEN_READONLY | SQLITE_OPEN_URI
        : access == Access::Write            ? SQLITE_OPEN_READWRITE
                                             : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    // Nobody writes to a file without a journal, and what lies in a folder that may not be written
    // can be read.
    bool const is_still = access == Access::Read && !has_journal(whole_path);
    auto const name = access == Access::Read ? uri_of(whole_path) + (is_still ? "?immutable=1" : "")
                                             : whole_path.string();
    sqlite3* handle = nullptr;
    int const code = sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_EXRESCODE, nullptr);
    Database database(path, handle);
    if (code != SQLITE_OK)
        return database.error(code);
    sqlite3_busy_timeout(handle, kPatience_ms);
    // A file that somebody has made to do harm: no functions and triggers of its own are run.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
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
    return rename_on_disk(made, copy);
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
    case SQLITE_NOMEM:
        return sentence(fmt::format("there is not enough memory to read {}", name));
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
        return sentence(fmt::format(
            "cannot {} {}: {}", (code & 0xff) == SQLITE_CANTOPEN ? "open" : "read or write", name,
            system_error != 0 ? std::strerror(system_error) : sqlite3_errstr(code)));
    default:
        // SQLITE_CORRUPT, and tables that are not as they should be.
        return sentence(
            fmt::format("{0} is damaged ({1}): \"tractus session repair {0} -o NEW.tractus\" "
                        "brings back what is whole",
                        name, sqlite3_errstr(code)));
    }
}

} // namespace tractus::session
