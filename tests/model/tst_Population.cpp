// SPDX-License-Identifier: MIT
#include "model/population/Population.h"
#include "tests/program/Test.h"

#include <numeric>

#include <QtTest/QTest>

using namespace crowd::model;

namespace {

IndividualRows people(std::vector<IndividualId> ids)
{
    IndividualRows rows = IndividualRows::withDefaults(std::move(ids));
    for (std::size_t i = 0; i < rows.ids.size(); ++i) {
        rows.column(columns::heading)[i] = static_cast<float>(rows.ids[i]);
    }
    return rows;
}

} // namespace

class tst_Population : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void addsInOrderOfId();
    void putsRemovedRowsBackWhereTheyWere();
    void leavesCopiesAlone();
    void stampsOnlyTouchedBlocks();
    void comingAndGoingStampsFromThereOn();
};

void tst_Population::addsInOrderOfId()
{
    Population population;
    population.add(people({2, 5, 9}));
    population.add(people({1, 6}));
    const std::vector<float> headings(population.column(columns::heading).begin(),
                                      population.column(columns::heading).end());
    QCOMPARE(headings, (std::vector<float>{1, 2, 5, 6, 9}));
    QCOMPARE(population.rowOf(6), std::size_t{3});
    QCOMPARE(population.rowOf(7), Population::npos);
}

void tst_Population::putsRemovedRowsBackWhereTheyWere()
{
    Population population;
    population.add(people({1, 2, 3, 4, 5}));
    const Population before = population;
    const IndividualRows removed = population.remove(std::vector<IndividualId>{1, 3, 5});
    QCOMPARE(population.size(), std::size_t{2});
    QVERIFY(!(population == before));
    population.add(removed);
    QVERIFY(population == before);
}

void tst_Population::leavesCopiesAlone()
{
    Population population;
    population.add(people({1, 2}));
    const Population snapshot = population;
    population.setValues(columns::heading, std::vector<IndividualId>{2},
                         std::span<const float>(std::vector<float>{7.0F}));
    QCOMPARE(snapshot.column(columns::heading)[1], 2.0F);
    QCOMPARE(population.column(columns::heading)[1], 7.0F);
}

void tst_Population::stampsOnlyTouchedBlocks()
{
    std::vector<IndividualId> ids;
    for (IndividualId id = 1; id <= 600; ++id) {
        ids.push_back(id);
    }
    Population population;
    population.add(people(ids));
    const std::uint64_t seen = population.version();
    population.setValues(columns::height, std::vector<IndividualId>{300},
                         std::span<const float>(std::vector<float>{2.0F}));
    QCOMPARE(population.blockVersions().size(), std::size_t{3});
    QVERIFY(population.blockVersions()[0] <= seen);
    QVERIFY(population.blockVersions()[1] > seen);
    QVERIFY(population.blockVersions()[2] <= seen);
    QVERIFY(population.rowsVersion() <= seen);
}

/// Whoever comes or goes leaves the blocks before him as they are.
void tst_Population::comingAndGoingStampsFromThereOn()
{
    std::vector<IndividualId> ids(600);
    std::iota(ids.begin(), ids.end(), IndividualId{1});
    ids[400] = 1000;
    std::ranges::sort(ids); // 401 is free
    Population population;
    population.add(people(ids));
    std::uint64_t seen = population.version();
    const auto stamped = [&] {
        std::vector<bool> blocks;
        for (const std::uint64_t version : population.blockVersions()) {
            blocks.push_back(version > seen);
        }
        const bool isOrderNew = population.rowsVersion() > seen;
        seen = population.version();
        return std::pair(blocks, isOrderNew);
    };
    using Blocks = std::vector<bool>;
    population.add(people({1001, 1002})); // behind all
    QVERIFY(stamped() == std::pair(Blocks{false, false, true}, true));
    population.add(people({401}));
    QVERIFY(stamped() == std::pair(Blocks{false, true, true}, true));
    (void)population.remove(std::vector<IndividualId>{599});
    QVERIFY(stamped() == std::pair(Blocks{false, false, true}, true));
    (void)population.remove(
        std::vector<IndividualId>(population.ids().begin() + 256, population.ids().end()));
    QVERIFY(stamped() == std::pair(Blocks{false}, true));
    (void)population.remove(std::vector<IndividualId>{1});
    QVERIFY(stamped() == std::pair(Blocks{true}, true));
}

CROWD_TEST(tst_Population)
#include "tst_Population.moc"
