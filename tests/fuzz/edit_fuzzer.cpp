// Fuzzes an edit's record in a session. The input is its kind, fields and numbers, separated by
// zero bytes. An edit that can be read must be written as a record that reads as an equal edit.

#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "tests/fuzz/fuzz_input.h"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    static auto const methods = methods::all_methods();
    FuzzInput input(data, size);
    session::EditRecord record;
    record.kind = input.take_part();
    record.fields = input.take_part();
    record.numbers = input.text();
    auto const edit = session::edit_of(record, methods.edits);
    if (!is_read(edit))
        return 0;
    CHECK(!edit->describe().empty());
    auto const written = session::record_of(*edit);
    auto const again = session::edit_of(written, methods.edits);
    CHECK(again);
    auto const twice = session::record_of(*again);
    CHECK(twice.kind == written.kind);
    CHECK(twice.fields == written.fields);
    CHECK(twice.numbers == written.numbers);
    return 0;
}
