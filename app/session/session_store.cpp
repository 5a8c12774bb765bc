#include "app/session/session_store.h"

#include "engine/base/check.h"
#include "engine/stroke/oversketch.h"

#include <fmt/core.h>
#include <mutex>
#include <optional>
#include <utility>

namespace tractus {

using Tips = SharedVector<TipSample>;

// Any thread may read, while one writes.
class SessionStore::File {
public:
    File(std::filesystem::path path, Database database)
        : path_(std::move(path))
        , database_(std::move(database))
    {
    }

    std::filesystem::path const& path() const { return path_; }

    // From here on it is only read.
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
        return read(TRY(Database::open(path_, Database::Access::Read)));
    }

    Result<void> commit(std::function<Result<void>(Database const&)> const& write)
    {
        std::lock_guard const lock(mutex_);
        if (!database_->is_in_transaction()) // An error has ended it.
            TRY(database_->execute("BEGIN IMMEDIATE"));
        auto done = write(*database_);
        if (done)
            done = database_->execute("COMMIT");
        if (!done && database_->is_in_transaction())
            (void)database_->execute("ROLLBACK");
        // If it cannot be begun now, the next commit tries again.
        (void)database_->execute("BEGIN IMMEDIATE");
        return done;
    }

private:
    std::filesystem::path path_;
    mutable std::mutex mutex_;
    std::optional<Database> database_; // No value once the store is gone.
};

// The stroke that an edit brings, or null.
static Stroke* stroke_of(Edit& edit)
{
    if (auto* const associate = std::get_if<Associate>(&edit))
        return &associate->stroke;
    if (auto* const oversketch = std::get_if<Oversketch>(&edit))
        return &oversketch->over;
    return nullptr;
}

// A stroke that stands in an edit.
class SessionStore::StoredStroke final : public ElementSource<TipSample> {
public:
    StoredStroke(std::shared_ptr<File const> file, EditPlace const& place)
        : file_(std::move(file))
        , place_(place)
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        auto edit
            = file_->read([&](Database const& database) { return read_edit(database, place_); });
        if (!edit)
            return fail(edit.error().fault,
                        fmt::format("the stroke of edit {} cannot be read: {}", place_.number,
                                    edit.error().message));
        auto const* const stroke = stroke_of(*edit);
        CHECK(stroke != nullptr); // Its checksum is that of one which has.
        return stroke->tips.vector();
    }

private:
    std::shared_ptr<File const> file_;
    EditPlace place_;
};

namespace {

class RedrawnStroke final : public ElementSource<TipSample> {
public:
    RedrawnStroke(Tips::Source drawn, Tips::Source over)
        : drawn_(std::move(drawn))
        , over_(std::move(over))
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        auto drawn = TRY(drawn_->read());
        auto over = TRY(over_->read());
        return TRY(oversketch({ std::move(drawn) }, { std::move(over) })).tips.vector();
    }

private:
    Tips::Source drawn_;
    Tips::Source over_;
};

class ErasedStroke final : public ElementSource<TipSample> {
public:
    ErasedStroke(Tips::Source drawn, std::vector<TipRange> ranges)
        : drawn_(std::move(drawn))
        , ranges_(std::move(ranges))
    {
    }

    Result<std::vector<TipSample>> read() const override
    {
        auto drawn = TRY(drawn_->read());
        return TRY(erase_tips({ std::move(drawn) }, ranges_)).tips.vector();
    }

private:
    Tips::Source drawn_;
    std::vector<TipRange> ranges_;
};

} // namespace

Tips::Source redrawn_source(Tips::Source drawn, Tips::Source over)
{
    if (!drawn || !over)
        return nullptr;
    return std::make_shared<RedrawnStroke>(std::move(drawn), std::move(over));
}

Tips::Source erased_source(Tips::Source drawn, std::vector<TipRange> ranges)
{
    if (!drawn)
        return nullptr;
    return std::make_shared<ErasedStroke>(std::move(drawn), std::move(ranges));
}

SessionStore::SessionStore(std::filesystem::path path, Database database)
    : file_(std::make_shared<File>(std::move(path), std::move(database)))
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

void SessionStore::give_source(Edit& edit, EditPlace const& place) const
{
    if (auto* const stroke = stroke_of(edit))
        stroke->tips = Tips(stroke->tips.vector(), std::make_shared<StoredStroke>(file_, place));
}

Result<std::vector<SessionEdit>> SessionStore::read_step(std::size_t step) const
{
    auto edits = TRY(
        file_->read([&](Database const& database) { return tractus::read_step(database, step); }));
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
        [&](Database const& database) { return tractus::write_cursor(database, step); });
}

} // namespace tractus
