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

// The file of a session that is being drawn in. Strokes read from it know their place in it
// (SharedVector::source()), so their tips need not stay in memory. The tips are read again on use,
// on any thread, even after the store is destroyed, as long as the file exists.
//
// The store itself is used by one thread.
class SessionStore {
public:
    // Takes a database with an open write transaction.
    SessionStore(std::filesystem::path path, Database database, scene::EditKinds kinds);
    SessionStore(SessionStore&&) noexcept = default;
    SessionStore& operator=(SessionStore&& other) noexcept;
    ~SessionStore(); // Ends the transaction, so that other programs can write.

    std::filesystem::path const& path() const;

    // Reads the edits of a step. Fails if the file was damaged since it was checked.
    Result<std::vector<SessionEdit>> read_step(std::size_t step) const;

    // A new step as rows for the file, and its edits as read_step() will return them.
    struct NewStep {
        std::vector<EditRow> rows;
        std::vector<scene::Edit> edits;
    };
    Result<NewStep> prepare(SessionStep const& step) const;

    // Each of these writes one transaction, which is on disk on return, and begins the next one, to
    // keep other programs from writing. They fail like the database.
    Result<void> write(NewStep const& step);
    Result<void> write_cursor(std::size_t step);
    Result<void> write_name(std::string const& name);

private:
    class File;
    class StoredStroke;

    void give_source(scene::Edit& edit, EditPlace const& place) const;

    std::shared_ptr<File> file_; // Shared with the sources of strokes; null after a move.
};

} // namespace tractus::session
