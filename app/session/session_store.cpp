#include "app/session/session_store.h"

#include "app/session/session_schema.h"
#include "engine/base/check.h"

#include <fmt/core.h>
#include <mutex>
#include <optional>
#include <utility>

namespace tractus::session {

using Tips = SharedVector<TipSample>;

// The session's database, shared with the sources of strokes. Any thread may read it while one
// thread writes.
class SessionStore::File {
public:
    File(std::filesystem::path path, Database database, scene::EditKinds kinds)
        : path_(std::move(path))
        , kinds_(kinds)
        , database_(std::move(database))
    {
    }

    std::filesystem::path const& path() const { return path_; }
    scene::EditKinds kinds() const { return kinds_; } // Kinds of edits that are known.

    // Ends writing. The file can still be read, through new connections.
    void close()
    {
        std::lock_guard const lock(mutex_);
        database_.reset();
    }

    template<typename Read>
    auto read(Read const& read) const -> decltype(read(std::declval<Database const&>()))
    {
        std::lock_guard const lock(mutex_);
        if (database_)
            return read(*database_);
        return read(TRY(open_session(path_, Database::Access::Read)));
    }

    Result<void> commit(std::function<Result<void>(Database const&)> const& write)
    {
        std::lock_guard const lock(mutex_);
        // An error may have ended the transaction that was open.
        if (!database_->is_in_transaction())
            TRY(database_->execute("BEGIN IMMEDIATE"));
        auto done = write(*database_);
        if (done)
            done = database_->execute("COMMIT");
        if (!done && database_->is_in_transaction())
            (void)database_->execute("ROLLBACK");
        // If beginning the next transaction fails, the next commit tries again.
        (void)database_->execute("BEGIN IMMEDIATE");
        return done;
    }

private:
    std::filesystem::path path_;
    mutable std::mutex mutex_;
    scene::EditKinds kinds_;
    std::optional<Database> database_; // nullopt after close().
};

namespace {

// Finds the tips of an edit's stroke. If a source is given, attaches it to these tips.
class StrokeVisitor final : public scene::Fields {
public:
    explicit StrokeVisitor(Tips::Source source = nullptr)
        : source_(std::move(source))
    {
    }

    // Tips of the edit's stroke; nullopt if the edit has no stroke.
    std::optional<Tips> const& tips() const { return tips_; }

    void field(char const*, scene::FieldRef) override { }
    void word(char const*, int&, std::span<char const* const>) override { }
    void numbers(std::vector<SkeletonPiece>&) override { }
    void bytes(std::string&) override { }
    void numbers(Stroke& stroke) override
    {
        if (source_)
            stroke.tips = Tips(stroke.tips.vector(), source_);
        tips_ = stroke.tips;
    }

private:
    Tips::Source source_;
    std::optional<Tips> tips_;
};

} // namespace

// Source of a stroke's tips: reads them from an edit in the file.
class SessionStore::StoredStroke final : public ElementSource<TipSample> {
public:
    StoredStroke(std::shared_ptr<File const> file, EditPlace const& place)
        : file_(std::move(file))
        , place_(place)
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        auto edit = file_->read(
            [&](Database const& database) { return read_edit(database, place_, file_->kinds()); });
        if (!edit)
            return fail(edit.error().fault,
                        fmt::format("the stroke of edit {} cannot be read: {}", place_.number,
                                    edit.error().message));
        StrokeVisitor visitor;
        edit->show(visitor);
        CHECK(visitor.tips().has_value()); // The checksum shows that the edit has a stroke.
        return visitor.tips()->vector();
    }

private:
    std::shared_ptr<File const> file_;
    EditPlace place_;
};

SessionStore::SessionStore(std::filesystem::path path, Database database, scene::EditKinds kinds)
    : file_(std::make_shared<File>(std::move(path), std::move(database), kinds))
{
}

SessionStore& SessionStore::operator=(SessionStore&& other) noexcept
{
    std::swap(file_, other.file_);
    return *this;
}

SessionStore::~SessionStore()
{
    if (file_)
        file_->close();
}

std::filesystem::path const& SessionStore::path() const
{
    return file_->path();
}

void SessionStore::give_source(scene::Edit& edit, EditPlace const& place) const
{
    StrokeVisitor visitor(std::make_shared<StoredStroke>(file_, place));
    edit = edit.changed_by(visitor);
}

Result<std::vector<SessionEdit>> SessionStore::read_step(std::size_t step) const
{
    auto edits = TRY(file_->read([&](Database const& database) {
        return session::read_step(database, step, file_->kinds());
    }));
    for (auto& edit : edits)
        give_source(edit.edit, edit.place);
    return edits;
}

Result<SessionStore::NewStep> SessionStore::prepare(SessionStep const& step) const
{
    NewStep prepared;
    prepared.rows
        = TRY(file_->read([&](Database const& database) { return rows_of(database, step); }));
    prepared.edits.assign(step.edits.begin(), step.edits.end());
    for (std::size_t i = 0; i < prepared.edits.size(); ++i)
        give_source(prepared.edits[i], prepared.rows[i].place);
    return prepared;
}

Result<void> SessionStore::write(NewStep const& step)
{
    return file_->commit([&](Database const& database) { return write_step(database, step.rows); });
}

Result<void> SessionStore::write_cursor(std::size_t step)
{
    return file_->commit(
        [&](Database const& database) { return session::write_cursor(database, step); });
}

Result<void> SessionStore::write_name(std::string const& name)
{
    return file_->commit(
        [&](Database const& database) { return session::write_name(database, name); });
}

} // namespace tractus::session
