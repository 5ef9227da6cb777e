// SPDX-License-Identifier: MIT
#include <array>

#include <QtTest/QTest>

#include "model/brush/IndividualEdits.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

constexpr TemplateId kFox = 2;

/// A scene with the box man and a "fox" whose slots and clips come in another order.
struct Zoo : BrushScene
{
    Zoo() : BrushScene({stageOf({}, seatRows(1, 3))})
    {
        auto fox = std::make_shared<Template>(*boxMan());
        fox->name = "fox";
        std::swap(fox->slots[0], fox->slots[2]);
        std::swap(fox->clips[0], fox->clips[2]);
        fox->parts = {{"tail", true}, {"hat", false}};
        TemplateEntry entry = boxManEntry(0, fox);
        entry.name = "fox";
        entry.clipNames = {"cheer", "sit", "idle"};
        fox->defaultClip = 2;
        const auto edit = document.beginEdit().value();
        (void)edit->addTemplate(entry);
        edit->commit(QStringLiteral("Import"));
    }
    template<class T>
    [[nodiscard]] T value(ColumnKey<T> key, IndividualId id) const
    {
        return people().column(key)[people().rowOf(id)];
    }
    template<class T>
    void set(ColumnKey<T> key, IndividualId id, T value)
    {
        const auto edit = document.beginEdit().value();
        edit->setColumn(key, std::span(&id, 1), std::span<const T>(&value, 1));
        edit->commit(QStringLiteral("Set"));
    }
};

} // namespace

class tst_BrushIndividuals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anotherTemplateKeepsLooksByName();
    void sitsDownAndStandsUp();
};

void tst_BrushIndividuals::anotherTemplateKeepsLooksByName()
{
    Zoo zoo;
    const auto ids = zoo.addPeople({{0, 0, 0}, {1, 0, 0}});
    const Tint red{255, 0, 0, 255};
    zoo.set(columns::tint(2), ids[0], red); // bottom
    zoo.set(columns::tintReplaces, ids[0], std::uint16_t{4});
    zoo.set(columns::walkStyle, ids[0], std::uint16_t{3});
    zoo.set(columns::clip, ids[0], std::uint16_t{2});
    const auto edit = zoo.document.beginEdit().value();
    changeTemplate(*edit, ids, kFox);
    QVERIFY(edit->commit(QStringLiteral("Change Template")));
    QCOMPARE(zoo.value(columns::templateId, ids[0]), kFox);
    QVERIFY2(zoo.value(columns::tint(0), ids[0]) == red, "bottom is the fox's first slot");
    QVERIFY(!(zoo.value(columns::tint(2), ids[0]) == red));
    QCOMPARE(zoo.value(columns::tintReplaces, ids[0]), std::uint16_t{1});
    QCOMPARE(zoo.value(columns::walkStyle, ids[0]), std::uint16_t{1});
    QCOMPARE(zoo.value(columns::clip, ids[0]), std::uint16_t{0}); // cheers on
    QCOMPARE(zoo.value(columns::clip, ids[1]), std::uint16_t{2}); // idles, as usual there
    QCOMPARE(zoo.value(columns::parts, ids[1]) & 3U, 1U);
    zoo.document.undoStack().undo();
    QVERIFY(zoo.value(columns::tint(2), ids[0]) == red);
    QCOMPARE(zoo.value(columns::tintReplaces, ids[0]), std::uint16_t{4});
    QCOMPARE(zoo.value(columns::walkStyle, ids[0]), std::uint16_t{3});
    QCOMPARE(zoo.value(columns::templateId, ids[1]), TemplateId{1});
}

void tst_BrushIndividuals::sitsDownAndStandsUp()
{
    Zoo zoo;
    const auto ids = zoo.addPeople({{5, 0, 0}, {6, 0, 0}});
    const SeatId seat = zoo.document.scene().worldSeats()[1].id;
    auto edit = zoo.document.beginEdit().value();
    QVERIFY(sitDown(*edit, ids[0], seat) == SitResult::Done);
    QVERIFY(sitDown(*edit, ids[1], seat) == SitResult::SeatIsTaken);
    QVERIFY(sitDown(*edit, ids[1], seat + 1000) == SitResult::NoSuchSeat);
    QVERIFY(sitDown(*edit, ids[0], seat) == SitResult::Done);
    QVERIFY(edit->commit(QStringLiteral("Sit Down")));
    QCOMPARE(zoo.value(columns::seat, ids[0]), seat);
    QCOMPARE(zoo.value(columns::position, ids[0]).x, 0.0F);
    QCOMPARE(zoo.value(columns::heading, ids[0]), 0.25F);
    QCOMPARE(zoo.value(columns::clip, ids[0]), std::uint16_t{1});
    edit = zoo.document.beginEdit().value();
    standUp(*edit, ids);
    QVERIFY(edit->commit(QStringLiteral("Stand Up")));
    QCOMPARE(zoo.value(columns::seat, ids[0]), kNoSeat);
    QCOMPARE(zoo.value(columns::clip, ids[0]), std::uint16_t{0});
}

CROWD_TEST(tst_BrushIndividuals)
#include "tst_BrushIndividuals.moc"
