#include "app/session/session_copy.h"

#include "app/session/database.h"
#include "app/session/new_session_file.h"
#include "app/session/session_file.h"
#include "app/session/session_schema.h"

namespace tractus::session {

namespace fs = std::filesystem;

std::string session_name(fs::path const& path)
{
    auto const read = [&]() -> Result<std::string> {
        auto const database = TRY(open_session(path, Database::Access::Read));
        auto name = TRY(database.prepare("SELECT value FROM meta WHERE key = 'name'"));
        return TRY(name.step()) ? name.bytes(0) : std::string();
    };
    return read().value_or(std::string());
}

Result<void> copy_session(fs::path const& path, fs::path const& copy, std::string const& name)
{
    return make_session_file(copy, [&](fs::path const& made) -> Result<void> {
        // A new connection, because SQLite cannot back up through one that has an open write
        // transaction.
        auto const original = TRY(open_session(path, Database::Access::Read));
        TRY(original.back_up(made));
        auto const copied = TRY(Database::open(made, Database::Access::Write));
        TRY(copied.execute("BEGIN"));
        TRY(write_name(copied, name));
        return copied.execute("COMMIT");
    });
}

} // namespace tractus::session
