// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "behavior/agents/PropertyOverrides.h"
#include "tests/behavior/Actors.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::behavior;
namespace columns = model::columns;

namespace {

std::vector<float> heightsOf(const OverrideColumn& column)
{
    std::vector<float> values(column.ids.size());
    std::memcpy(values.data(), column.bytes.data(), column.bytes.size());
    return values;
}

using Ids = std::vector<model::IndividualId>;
using Heights = std::vector<float>;

} // namespace

/// What rules have set of people's properties.
class TestPropertyOverrides : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsSetIsThereUntilItIsForgotten();
    void aPublishedColumnIsByAscendingId();
    void whatIsPublishedStaysAsItWas();
    void columnsThatNobodyWroteAreShared();
    void thoseWhoAreGoneAreLeftOut();
};

void TestPropertyOverrides::whatIsSetIsThereUntilItIsForgotten()
{
    PropertyOverrides overrides;
    QVERIFY(!overrides.value(columns::height, 7));
    overrides.set(columns::height, 7, 1.5F);
    QCOMPARE(overrides.value(columns::height, 7), std::optional(1.5F));
    QVERIFY(!overrides.value(columns::height, 8));
    QVERIFY(!overrides.value(columns::girth, 7));
    QVERIFY(overrides.forget(columns::height.id, 7));
    QVERIFY(!overrides.forget(columns::height.id, 7));
    QVERIFY(!overrides.value(columns::height, 7));
}

void TestPropertyOverrides::aPublishedColumnIsByAscendingId()
{
    PropertyOverrides overrides;
    QVERIFY(!overrides.publish());
    overrides.set(columns::height, 9, 1.9F);
    overrides.set(columns::height, 3, 1.3F);
    const auto published = overrides.publish();
    const OverrideColumn* heights = published->column(columns::height.id);
    QVERIFY(heights != nullptr);
    QCOMPARE(heights->ids, (Ids{3, 9}));
    QCOMPARE(heightsOf(*heights), (Heights{1.3F, 1.9F}));
    QVERIFY(published->column(columns::tags.id) == nullptr);
}

void TestPropertyOverrides::whatIsPublishedStaysAsItWas()
{
    PropertyOverrides overrides;
    overrides.set(columns::height, 3, 1.3F);
    const auto before = overrides.publish();
    overrides.set(columns::height, 3, 2.0F);
    const auto after = overrides.publish();
    QCOMPARE(heightsOf(*before->column(columns::height.id)), (Heights{1.3F}));
    QCOMPARE(heightsOf(*after->column(columns::height.id)), (Heights{2.0F}));
    overrides.forget(columns::height.id, 3);
    QVERIFY(overrides.publish()->column(columns::height.id) == nullptr);
}

void TestPropertyOverrides::columnsThatNobodyWroteAreShared()
{
    PropertyOverrides overrides;
    overrides.set(columns::height, 3, 1.3F);
    overrides.set(columns::tags, 3, std::uint64_t{1});
    const auto before = overrides.publish();
    QCOMPARE(overrides.publish(), before);
    overrides.set(columns::tags, 3, std::uint64_t{2});
    const auto after = overrides.publish();
    QCOMPARE(after->column(columns::height.id), before->column(columns::height.id));
    QVERIFY(after->column(columns::tags.id) != before->column(columns::tags.id));
}

void TestPropertyOverrides::thoseWhoAreGoneAreLeftOut()
{
    PropertyOverrides overrides;
    for (const model::IndividualId id : {2U, 5U, 1U}) {
        overrides.set(columns::height, id, 1.0F + 0.1F * static_cast<float>(id));
    }
    const auto published = overrides.publish();
    const model::Scene scene = testing::rowOf(2); // individuals 1 and 2
    const OverrideColumn present =
        presentIn(scene.population, columns::height.id, *published->column(columns::height.id));
    QCOMPARE(present.ids, (Ids{1, 2}));
    QCOMPARE(heightsOf(present), (Heights{1.1F, 1.2F}));
}

CROWD_TEST(TestPropertyOverrides)
#include "tst_PropertyOverrides.moc"
