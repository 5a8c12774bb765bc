#include "app/session/edit_record.h"

#include "app/session/edit_fields.h"

#include <fmt/core.h>
#include <utility>

namespace tractus::session {

// True if the field "name" of this kind of edit holds the name of a source file rather than a name
// that the user chose. "model_name" and "view_name" are always file names.
static bool is_named_after_file(std::string_view kind)
{
    return kind.starts_with("load_");
}

EditRecord record_of(scene::Edit const& edit)
{
    if (auto const* const unknown = edit.get<scene::UnknownEdit>())
        return { unknown->word, unknown->fields, unknown->numbers };
    FieldWriter writer;
    edit.show(writer);
    writer.leave_out_folders(is_named_after_file(edit.kind().word));
    return { edit.kind().word, writer.json(), writer.take_numbers() };
}

EditRecord without_folders(EditRecord record)
{
    auto json = Json::parse(record.fields, nullptr, false);
    if (json.is_object() && leave_out_folders(json, is_named_after_file(record.kind)))
        record.fields = json.dump();
    return record;
}

Result<scene::Edit> edit_of(EditRecord const& record, scene::EditKinds kinds)
{
    auto const* const kind = scene::find_edit_kind(kinds, record.kind);
    if (!kind)
        return fail(Fault::User,
                    fmt::format("its kind \"{}\" is unknown to this tractus: a newer one has "
                                "written it",
                                record.kind));
    auto const json = Json::parse(record.fields, nullptr, false);
    if (!json.is_object())
        return fail(Fault::User, "its fields are not JSON");
    FieldReader reader(json, record.numbers);
    auto fields = kind->make();
    kind->fields(reader, fields.get());
    TRY(reader.finish());
    return scene::Edit(*kind, std::move(fields));
}

scene::Edit edit_or_unknown(EditRecord const& record, scene::EditKinds kinds)
{
    if (auto edit = edit_of(record, kinds))
        return *std::move(edit);
    else
        return scene::UnknownEdit { record.kind, record.fields, record.numbers,
                                    edit.error().message };
}

} // namespace tractus::session
