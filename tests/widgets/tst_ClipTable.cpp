// SPDX-License-Identifier: MIT
#include "widgets/dialogs/ClipTable.h"

#include <cmath>

#include <QtTest/QTest>
#include <QtWidgets/QComboBox>

#include "model/template/Template.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using model::ClipRole;
using widgets::ClipTable;

/// Roles and speeds of clips, as the artist sees and changes them.
class tst_ClipTable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersTheProposedRoles();
    void keepsWhatWasChosen();
    void showsWhatWasChosenBefore();
};

namespace {

model::Template knight(ClipRole second = ClipRole::Walk)
{
    model::Template asset;
    for (const auto& [name, role, speed] : {std::tuple("Idle", ClipRole::Idle, 0.0F),
                                            {"Walking_A", second, 0.7F},
                                            {"Attack", ClipRole::Other, 0.0F}}) {
        model::Clip clip;
        clip.name = name;
        clip.role = role;
        clip.speed = speed;
        asset.clips.push_back(clip);
    }
    return asset;
}

QComboBox* roleBox(const ClipTable& table, int row)
{
    return qobject_cast<QComboBox*>(table.cellWidget(row, 3));
}

void chooseRole(const ClipTable& table, int row, ClipRole role)
{
    QComboBox* box = roleBox(table, row);
    box->setCurrentIndex(box->findData(static_cast<int>(role)));
}

} // namespace

void tst_ClipTable::offersTheProposedRoles()
{
    ClipTable table(knight(), nullptr);
    QCOMPARE(roleBox(table, 0)->currentText(), QStringLiteral("Idle"));
    QCOMPARE(roleBox(table, 1)->currentText(), QStringLiteral("Walk"));
    QCOMPARE(roleBox(table, 2)->currentText(), QStringLiteral("Other"));
    QCOMPARE(roleBox(table, 2)->count(), 6);
    QVERIFY(table.editedRoles().empty());
}

void tst_ClipTable::keepsWhatWasChosen()
{
    ClipTable table(knight(), nullptr);
    chooseRole(table, 2, ClipRole::Run);
    const std::vector<std::optional<ClipRole>> expected{std::nullopt, std::nullopt, ClipRole::Run};
    QCOMPARE(table.editedRoles(), expected);
    // Imported anew with other settings, another clip is proposed; the choice stays.
    table.follow(knight(ClipRole::Fly));
    QCOMPARE(roleBox(table, 1)->currentText(), QStringLiteral("Fly"));
    QCOMPARE(table.editedRoles(), expected);
    chooseRole(table, 2, ClipRole::Other);
    QVERIFY(table.editedRoles().empty());
}

void tst_ClipTable::showsWhatWasChosenBefore()
{
    ClipTable table(knight(), nullptr);
    table.setEdited({NAN, 1.5F}, {std::nullopt, std::nullopt, ClipRole::Sit});
    QCOMPARE(roleBox(table, 2)->currentText(), QStringLiteral("Sit"));
    QCOMPARE(table.editedRoles().at(2), std::optional(ClipRole::Sit));
    QCOMPARE(table.editedSpeeds().at(1), 1.5F);
    QVERIFY(std::isnan(table.editedSpeeds().at(0)));
}

CROWD_WINDOW_TEST(tst_ClipTable)
#include "tst_ClipTable.moc"
