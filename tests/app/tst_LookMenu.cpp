// SPDX-License-Identifier: MIT
#include "app/window/LookMenu.h"

#include <QtTest/QTest>
#include <QtWidgets/QMenu>

#include "render/Looks.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/EditorState.h"

class TestLookMenu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyLookCanBeChosen();
    void keysNameLooks();
};

void TestLookMenu::everyLookCanBeChosen()
{
    crowd::model::SceneDocument document;
    crowd::widgets::EditorState state(document);
    QMenu menu;
    crowd::app::fillLookMenu(menu, state);
    QCOMPARE(menu.actions().size(), static_cast<qsizetype>(crowd::render::kLooks.size()));
    for (const auto& info : crowd::render::kLooks) {
        auto* action =
            menu.findChild<QAction*>(QStringLiteral("look-choice-") + QLatin1String(info.key));
        QVERIFY2(action != nullptr, info.key);
        action->trigger();
        QVERIFY(state.viewOptions().look == info.look);
        Q_EMIT menu.aboutToShow();
        QVERIFY(action->isChecked());
        QVERIFY(!action->text().isEmpty());
    }
}

void TestLookMenu::keysNameLooks()
{
    for (const auto& info : crowd::render::kLooks) {
        QVERIFY(crowd::render::lookOfKey(info.key) == info.look);
    }
    QVERIFY(!crowd::render::lookOfKey("x-ray"));
}

CROWD_WINDOW_TEST(TestLookMenu)
#include "tst_LookMenu.moc"
