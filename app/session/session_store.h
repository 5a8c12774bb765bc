#pragma once

#include "app/session/session_file.h"
#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tractus::session {

// The file of a session that somebody draws in. What is read of it has strokes that know where they
// stand (SharedVector::source()), so that they need not stay in memory: they are read again from
// there when somebody looks at them, on any thread, and after the store is gone as long as the file
// is there.
//
// The store itself belongs to one thread.
class SessionStore {
public:
    // A database in which a transaction has begun.
    SessionStore(std::filesystem::path path, Database database, scene::EditKinds kinds);
    SessionStore(SessionStore&&) noexcept = default;
    SessionStore& operator=(SessionStore&& other) noexcept;
    ~SessionStore(); // Lets others write.

    std::filesystem::path const& path() const;

    // The edits of a step that is in the file. Fails where it was damaged since it was checked.
    Result<std::vector<SessionEdit>> read_step(std::size_t step) const;

    // Form of a new step in the file, and its edits as read_step() will give them.
    struct NewStep {
        std::vector<EditRow> rows;
        std::vector<scene::Edit> edits;
    };
    Result<NewStep> prepare(SessionStep const& step) const;

    // Writes in one transaction, which is on the disk when this returns. Afterwards the next one is
    // begun, which is what keeps others from writing. Fails as the database does.
    Result<void> write(NewStep const& step);
    Result<void> write_cursor(std::size_t step);
    Result<void> write_name(std::string const& name);

private:
    class File;
    class StoredStroke;

    void give_source(scene::Edit& edit, EditPlace const& place) const;

    std::shared_ptr<File> file_; // Shared with the sources of strokes; null when moved from.
};

} // namespace tractus::session
