// SPDX-License-Identifier: MIT
#include "app/window/LookMenu.h"

#include <QtTest/QTest>
#include <QtWidgets/QMenu>

#include "model/document/SceneEdit.h"
#include "render/Looks.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/EditorState.h"

class TestLookMenu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyLookCanBeChosen();
    void looksOfTheSceneAreBelow();
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

void TestLookMenu::looksOfTheSceneAreBelow()
{
    crowd::model::SceneDocument document;
    crowd::widgets::EditorState state(document);
    QMenu menu;
    crowd::app::fillLookMenu(menu, state);
    const auto styles = menu.actions().size();
    crowd::model::LookPreset dusk;
    dusk.id = 4;
    dusk.name = "Dusk & after";
    document.edit(QStringLiteral("Add"),
                  [&dusk](crowd::model::SceneEdit& edit) { edit.setLooks({dusk}); });
    for (int time = 0; time < 2; ++time) {
        Q_EMIT menu.aboutToShow();
        QCOMPARE(menu.actions().size(), styles + 2); // with a line between, once
    }
    QCOMPARE(menu.actions().back()->text(), QStringLiteral("Dusk && after"));
    menu.actions().back()->trigger();
    QCOMPARE(state.viewOptions().ownLook, crowd::model::LookId{4});
    Q_EMIT menu.aboutToShow();
    QVERIFY(menu.actions().back()->isChecked());
    menu.findChild<QAction*>(QStringLiteral("look-choice-clay"))->trigger();
    QCOMPARE(state.viewOptions().ownLook, crowd::model::LookId{0});
    document.undoStack().undo();
    Q_EMIT menu.aboutToShow();
    QCOMPARE(menu.actions().size(), styles);
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
