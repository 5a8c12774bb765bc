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

// The file of a session that is being drawn in. Strokes read from it know their place in the file
// (SharedVector::source()), so their tips need not stay in memory. The tips are read again on use,
// on any thread, as long as the file exists, even after the store is destroyed.
//
// The functions of the store itself must be called from the same thread.
class SessionStore {
public:
    // Takes over a database that has an open write transaction.
    SessionStore(std::filesystem::path path, Database database, scene::EditKinds kinds);
    SessionStore(SessionStore&&) noexcept = default;
    SessionStore& operator=(SessionStore&& other) noexcept;
    ~SessionStore(); // Ends the write transaction, so that other programs can write.

    std::filesystem::path const& path() const;

    // Reads the edits of a step. Fails if the file was damaged after it was checked.
    Result<std::vector<SessionEdit>> read_step(std::size_t step) const;

    // A new step: its rows for the file, and its edits as read_step() will return them.
    struct NewStep {
        std::vector<EditRow> rows;
        std::vector<scene::Edit> edits;
    };
    Result<NewStep> prepare(SessionStep const& step) const;

    // Each of these functions commits a transaction with one change, which is on disk when the
    // function returns. It then begins the next transaction, to keep other programs from writing.
    // Fails with a Database error.
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
