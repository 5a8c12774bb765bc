#include "app/session/edit_record.h"

#include "tests/app/session/random_edits.h"
#include "tests/app/session/same_edit.h"
#include "tests/app/small_model.h"
#include "tests/engine/scene/edits.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tractus::session {
namespace {

std::string refusal(EditRecord const& record)
{
    auto const edit = edit_of(record, scene::core_edit_kinds());
    return edit ? "" : edit.error().message;
}

RC_GTEST_PROP(EditRecord, GivesEveryEditBackBitForBit, ())
{
    auto const edit = random_edit();
    auto const read = edit_of(record_of(edit), scene::core_edit_kinds());
    RC_ASSERT(read.has_value());
    RC_ASSERT(same(*read, edit));
}

RC_GTEST_PROP(EditRecord, TakesAnyBytesWithoutHarm, ())
{
    auto record = record_of(random_edit());
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
        auto& part = *rc::gen::arbitrary<bool>() ? record.fields : record.numbers;
        if (!part.empty())
            part[*rc::gen::inRange<std::size_t>(0, part.size())] = *rc::gen::arbitrary<char>();
    }
    auto const read = edit_of(record, scene::core_edit_kinds());
    if (!read)
        RC_ASSERT(!read.error().message.empty());
}

// A record's text is legible in the file. It must stay the same, so that existing files remain
// readable.
TEST(EditRecord, IsReadableByEyeAndStaysAsItIs)
{
    auto const select = record_of(scene::Select { { { 0, 1 }, { 7 } } });
    EXPECT_EQ(select.kind, "select");
    EXPECT_EQ(select.fields, R"({"paths":[[0,1],[7]]})");
    EXPECT_EQ(select.numbers, "");
    EXPECT_EQ(record_of(scene::Indicate { { .start_mm = { 0, 0.1, -0.0 }, .end_mm = { 1, 2, 3 } } })
                  .fields,
              R"({"start_mm":[0.0,0.1,-0.0],"end_mm":[1.0,2.0,3.0],"kind":"push","below":[],)"
              R"("reach_mm":null,"is_orphaned":false})");
    EXPECT_EQ(
        record_of(scene::EraseTips { scene::numbered({ 4, 5 }), { { 0, 2 }, { 9, 9 } } }).fields,
        R"({"associations":[4,5],"ranges":[[0,2],[9,9]]})");
    scene::Associate stroke;
    stroke.propagation = variation::Propagation::Both;
    auto& tip = stroke.stroke.tips.own().emplace_back();
    tip.time = timestamp_ns(258);
    tip.touching = true;
    auto const drawn = record_of(stroke);
    EXPECT_EQ(drawn.fields,
              R"({"propagation":"both","fit":"start","kept_hand":1.0,"laying":"least_twist"})");
    std::string numbers(41, '\0');
    numbers[0] = 2;
    numbers[1] = 1;
    numbers[40] = 1;
    EXPECT_EQ(drawn.numbers, numbers);
    scene::Associate leaning;
    leaning.id = 5;
    leaning.stroke.tips.own().emplace_back().tilt_rad = Vec2(0, 2);
    auto const tilted = record_of(leaning);
    EXPECT_EQ(
        tilted.fields,
        R"({"propagation":"selected","fit":"start","kept_hand":1.0,"laying":"least_twist","id":5})");
    EXPECT_EQ(tilted.numbers, std::string(40, '\0') + '\x10' + std::string(15, '\0') + '\x40');
    EXPECT_FALSE(
        edit_of({ "associate", "{}", tilted.numbers.substr(0, 56) }, scene::core_edit_kinds()));
    EXPECT_EQ(record_of(scene::Select { .at = { { { 0, 1 }, { 0, 4 } } } }).fields,
              R"({"at":[[[0,1],[0,4]]]})");
    EXPECT_EQ(record_of(scene::DeleteStroke { { .ids = { 7, 9 } } }).fields,
              R"({"strokes":[7,9]})");
    scene::LoadMeasured const measured { .name = "a.csv",
                                         .text = "1 2\n",
                                         .format = scene::LoadMeasured::Format::Qsm };
    EXPECT_EQ(record_of(measured).fields,
              R"({"name":"a.csv","text":"1 2\n","format":"qsm","drawn":"forget"})");
    EXPECT_EQ(record_of(scene::LoadModel { .source = { .name = "\xff.l" } }).fields.substr(0, 24),
              "{\"name\":{\"bytes\":\"\xc3\xbf.l\"}");
}

TEST(EditRecord, FieldsThatAreMissingAreAsTheyAreByDefault)
{
    auto const edit
        = edit_of({ "load_model", R"({"name":"a.l","text":"x"})", "" }, scene::core_edit_kinds());
    ASSERT_TRUE(edit) << edit.error().message;
    EXPECT_TRUE(same(*edit, scene::LoadModel { .source = { .name = "a.l", .text = "x" } }));
}

TEST(EditRecord, RefusesWhatItDoesNotKnow)
{
    EXPECT_EQ(refusal({ "graft", "{}", "" }),
              "its kind \"graft\" is unknown to this tractus: a newer one has written it");
    EXPECT_EQ(refusal({ "delete_indicator", R"({"number":0,"why":1})", "" }),
              "its field \"why\" is unknown to this tractus: a newer one has written it");
}

TEST(EditRecord, RefusesWhatHasAnotherForm)
{
    EXPECT_EQ(refusal({ "select", "{", "" }), "its fields are not JSON");
    EXPECT_EQ(refusal({ "select", "[]", "" }), "its fields are not JSON");
    EXPECT_EQ(refusal({ "select", R"({"paths":[[-1]]})", "" }),
              "its field \"paths\" does not have the form of one");
    for (char const* const fields :
         { R"({"fit":"loosely"})", R"({"fit":0})", R"({"kept_hand":"1"})",
           R"({"kept_hand":"7ff000000000000g"})", R"({"kept_hand":null})" })
        EXPECT_NE(refusal({ "associate", fields, "" }), "") << fields;
    for (char const* const fields :
         { R"({"seed":-1})", R"({"seed":1.5})", R"({"steps":3000000000})",
           R"({"name":{"bytes":3}})", R"({"name":{"bytes":"Ā"}})",
           R"({"includes":[{"name":"a"}]})" })
        EXPECT_NE(refusal({ "load_model", fields, "" }), "") << fields;
    for (char const* const fields : { R"({"ranges":[3]})", R"({"ranges":[[3]]})",
                                      R"({"ranges":[[3,4,5]]})", R"({"ranges":[[3,-1]]})" })
        EXPECT_NE(refusal({ "erase_tips", fields, "" }), "") << fields;
    EXPECT_NE(refusal({ "associate", "{}", std::string(40, '\0') }), "");
    EXPECT_NE(refusal({ "associate", "{}", std::string(40, '\0') + '\x10' }), "");
    EXPECT_EQ(refusal({ "select", "{}", "x" }), "it has numbers, and should have none");
}

// A session or a recording that is given to others must not reveal the author's folders.
TEST(EditRecord, HasNoFolders)
{
    auto model = small_model();
    model.source.name = "/home/anna/models/small.l";
    model.source.view_name = "/home/anna/models/small.v";
    for (auto const& edit :
         { scene::Edit(model), scene::Edit(scene::LoadSkeleton { .name = "/home/anna/tree.obj" }),
           scene::Edit(scene::LoadMeasured { .name = "/home/anna/tree.mtg" }) }) {
        auto const record = record_of(edit);
        EXPECT_EQ(record.fields.find("anna"), std::string::npos) << record.fields;
        auto older = record;
        auto const at = older.fields.find("\"name\":\"") + 8;
        older.fields.insert(at, "/home/anna/");
        EXPECT_EQ(without_folders(older).fields, record.fields);
    }
    EXPECT_NE(record_of(scene::NamePlant { 1, "/home" }).fields.find("/home"), std::string::npos)
        << "a person's own words stay";
}

} // namespace
} // namespace tractus::session
