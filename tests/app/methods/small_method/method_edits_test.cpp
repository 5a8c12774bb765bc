#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"

#include "tests/app/session/random_edits.h"
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tractus::methods {
namespace {

// Sets the fields of an edit to random values. It supports the field types used by the edits of
// methods.
class RandomFields final : public scene::Fields {
public:
    void field(char const*, scene::FieldRef value) override
    {
        std::visit([](auto* field) { set(*field); }, value);
    }
    void word(char const*, int& value, std::span<char const* const> words) override
    {
        value = *rc::gen::inRange(0, static_cast<int>(words.size()));
    }
    void numbers(Stroke& stroke) override { stroke = session::random_stroke(); }
    void numbers(std::vector<SkeletonPiece>&) override { }
    void bytes(std::string& file) override { file = session::random_bytes(); }

private:
    static void set(bool& value) { value = *rc::gen::arbitrary<bool>(); }
    static void set(int& value) { value = *rc::gen::arbitrary<int>(); }
    static void set(std::uint64_t& value) { value = *rc::gen::arbitrary<std::uint64_t>(); }
    static void set(double& value) { value = session::random_double(); }
    static void set(std::string& value) { value = session::random_file_name(); }
    static void set(Vec3& value) { value = session::random_vec3(); }
    // Only edits of the scene itself have fields of other types.
    template<typename T> static void set(T&) { }
};

// An edit of any method must be equal, bit by bit, when it is read back from its record.
RC_GTEST_PROP(MethodEdits, ComeBackFromTheirRecords, ())
{
    for (auto const* const kind : all_methods().edits) {
        RandomFields random;
        auto const edit = scene::Edit(*kind, kind->make()).changed_by(random);
        auto const record = session::record_of(edit);
        auto const read = session::edit_of(record, all_methods().edits);
        RC_ASSERT(read.has_value());
        auto const again = session::record_of(*read);
        RC_ASSERT(again.kind == record.kind);
        RC_ASSERT(again.fields == record.fields);
        RC_ASSERT(again.numbers == record.numbers);
    }
}

} // namespace
} // namespace tractus::methods
