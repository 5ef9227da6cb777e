// SPDX-License-Identifier: MIT
#include "widgets/actions/Findable.h"

#include <QtTest/QTest>

#include "tests/program/Test.h"

using namespace crowd::widgets;

namespace {

std::vector<Findable> someFindables()
{
    std::vector<Findable> all;
    all.push_back({QStringLiteral("Recolour"), QStringLiteral("Brush › Look")});
    all.push_back({QStringLiteral("Colours (New)"), QStringLiteral("Panel")});
    all.push_back({QStringLiteral("Colour"), QStringLiteral("Panel")});
    all.push_back({QStringLiteral("Save Picture…"), QStringLiteral("File")});
    all.push_back({QStringLiteral("König"), QStringLiteral("Panel")});
    all.push_back({QStringLiteral("Loop"), QStringLiteral("View")});
    all.back().tip = QStringLiteral("Begin again with the colours of before");
    all.push_back({QStringLiteral("Environment"), QStringLiteral("Brush")});
    all.back().words = QStringLiteral("wall fence");
    return all;
}

QStringList namesFoundBy(const char* typed)
{
    const std::vector<Findable> all = someFindables();
    QStringList names;
    for (const std::size_t index : foundBy(QString::fromUtf8(typed), all)) {
        names += all[index].name;
    }
    return names;
}

} // namespace

class TestFindable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatFitsComesBestFirst_data();
    void whatFitsComesBestFirst();
};

void TestFindable::whatFitsComesBestFirst_data()
{
    QTest::addColumn<QByteArray>("typed");
    QTest::addColumn<QStringList>("names");
    QTest::newRow("a name, a part of one, a tip")
        << QByteArray("colour")
        << QStringList{QStringLiteral("Colour"), QStringLiteral("Colours (New)"),
                       QStringLiteral("Recolour"), QStringLiteral("Loop")};
    QTest::newRow("case") << QByteArray("SAVE") << QStringList{QStringLiteral("Save Picture…")};
    QTest::newRow("several words in any order")
        << QByteArray("pict sav") << QStringList{QStringLiteral("Save Picture…")};
    QTest::newRow("a place") << QByteArray("look recol") << QStringList{QStringLiteral("Recolour")};
    QTest::newRow("accents") << QByteArray("konig") << QStringList{QString::fromUtf8("König")};
    QTest::newRow("typed with accents")
        << QByteArray("k\xC3\xB6nig") << QStringList{QString::fromUtf8("König")};
    QTest::newRow("a letter left out")
        << QByteArray("pictre") << QStringList{QStringLiteral("Save Picture…")};
    QTest::newRow("another spelling")
        << QByteArray("color")
        << QStringList{QStringLiteral("Colours (New)"), QStringLiteral("Colour")};
    QTest::newRow("nothing") << QByteArray("zebra") << QStringList{};
    QTest::newRow("signs alone") << QByteArray("…") << QStringList{QStringLiteral("Recolour"),
                                                                   QStringLiteral("Colours (New)"),
                                                                   QStringLiteral("Colour"),
                                                                   QStringLiteral("Save Picture…"),
                                                                   QString::fromUtf8("König"),
                                                                   QStringLiteral("Loop"),
                                                                   QStringLiteral("Environment")};
    QTest::newRow("another word for it")
        << QByteArray("wall") << QStringList{QStringLiteral("Environment")};
}

void TestFindable::whatFitsComesBestFirst()
{
    const QFETCH(QByteArray, typed);
    const QFETCH(QStringList, names);
    QCOMPARE(namesFoundBy(typed.constData()), names);
}

CROWD_TEST(TestFindable)
#include "tst_Findable.moc"
