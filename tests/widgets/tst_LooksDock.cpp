// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/LookCommands.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/docks/LooksDock.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/ValueSlider.h"
#include "widgets/state/ShownLook.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

struct LooksDesk : crowd::testing::Desk<LooksDock>
{
    [[nodiscard]] QListWidget* list()
    {
        return dock->findChild<QListWidget*>(QStringLiteral("looksList"));
    }
    [[nodiscard]] const model::Looks& looks() { return document.scene().looks; }
    /// As from the menu of the button +.
    void add(const char* text)
    {
        const auto* button = dock->findChild<QToolButton*>(QStringLiteral("addLook"));
        for (QAction* action : button->menu()->actions()) {
            if (action->text() == QLatin1String(text)) {
                action->trigger();
                return;
            }
        }
        QFAIL(text);
    }
};

} // namespace

class TestLooksDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsAddedIsShown();
    void theViewAsItIsBecomesALook();
    void aClickSwitches();
    void changesAreSeenAndUndone();
    void itsOwnLightBeginsAsItIsSeen();
    void namesAreOfOneEach();
    void whatIsRemovedIsNoLongerShown();
    void filesAreShared();
    void camerasBringTheirLooks();
    void anotherSceneHasItsOwn();
};

void TestLooksDock::whatIsAddedIsShown()
{
    LooksDesk desk;
    QVERIFY(desk.isReady());
    QVERIFY(!desk.list()->isVisible());
    desk.add("Comic");
    QCOMPARE(desk.looks().size(), std::size_t{1});
    QCOMPARE(desk.list()->count(), 2);
    QCOMPARE(desk.list()->currentRow(), 1);
    QVERIFY(shownLook(desk.state) == &desk.looks()[0]);
    QVERIFY(desk.state.viewOptions().look == render::Look::Cartoon);
    desk.document.undoStack().undo();
    QVERIFY(desk.looks().empty() && shownLook(desk.state) == nullptr);
}

void TestLooksDock::theViewAsItIsBecomesALook()
{
    LooksDesk desk;
    ViewOptions options = desk.state.viewOptions();
    options.look = render::Look::Property;
    options.property = "tag";
    desk.state.setViewOptions(options);
    desk.add("The View as It Is");
    QVERIFY(desk.looks()[0].style == model::LookStyle::Property);
    QCOMPARE(desk.looks()[0].property, std::string("tag"));
}

void TestLooksDock::aClickSwitches()
{
    LooksDesk desk;
    QVERIFY(desk.isReady());
    desk.add("Evening");
    desk.add("Studio");
    const int steps = desk.document.undoStack().count();
    const auto click = [&desk](int row) {
        const QRect at = desk.list()->visualItemRect(desk.list()->item(row));
        QTest::mouseClick(desk.list()->viewport(), Qt::LeftButton, {}, at.center());
    };
    click(1);
    QCOMPARE(desk.state.viewOptions().ownLook, desk.looks()[0].id);
    click(0);
    QVERIFY(shownLook(desk.state) == nullptr);
    QCOMPARE(desk.document.undoStack().count(), steps); // what is shown is no edit
}

void TestLooksDock::changesAreSeenAndUndone()
{
    LooksDesk desk;
    desk.add("Evening");
    auto* form = desk.dock->findChild<FieldForm*>(QStringLiteral("lookForm"));
    QVERIFY(form != nullptr && form->isVisibleTo(desk.dock));
    model::Looks looks = withLook(desk.looks(), desk.looks()[0].id, [](model::LookPreset& look) {
        look.style = model::LookStyle::Clay;
    });
    desk.document.edit(QStringLiteral("Clay"),
                       [&](model::SceneEdit& edit) { edit.setLooks(looks); });
    QVERIFY(desk.state.viewOptions().look == render::Look::Clay);
    desk.document.undoStack().undo();
    QVERIFY(desk.state.viewOptions().look == render::Look::Lit);
}

void TestLooksDock::itsOwnLightBeginsAsItIsSeen()
{
    LooksDesk desk;
    desk.add("Evening");
    const model::Lighting dusk = lightIn(desk.looks()[0], desk.document.scene().lighting);
    auto* form = desk.dock->findChild<FieldForm*>(QStringLiteral("lookForm"));
    const auto choose = [&](model::LookLight light) {
        for (QComboBox* box : form->findChildren<QComboBox*>()) {
            if (box->count() == static_cast<int>(model::kLookLights.size())) {
                box->setCurrentIndex(static_cast<int>(light));
                Q_EMIT box->activated(static_cast<int>(light));
            }
        }
    };
    const auto sliders = [form] {
        const auto all = form->findChildren<ValueSlider*>();
        return std::ranges::count_if(
            all, [form](const ValueSlider* each) { return each->isVisibleTo(form); });
    };
    const auto before = sliders();
    choose(model::LookLight::Own);
    QVERIFY(desk.looks()[0].light == model::LookLight::Own);
    QVERIFY(desk.looks()[0].ownLight == dusk);
    QVERIFY(sliders() > before + 5);
    choose(model::LookLight::Noon);
    QCOMPARE(sliders(), before);
    choose(model::LookLight::Own);
    QVERIFY(desk.looks()[0].ownLight == dusk); // as it was left
}

void TestLooksDock::namesAreOfOneEach()
{
    LooksDesk desk;
    desk.add("Evening");
    desk.add("Evening");
    QVERIFY(desk.looks()[0].name != desk.looks()[1].name);
    QVERIFY(!renameLook(desk.state, desk.looks()[1].id, QStringLiteral(" Evening ")));
    QVERIFY(!renameLook(desk.state, desk.looks()[1].id, QStringLiteral(" ")));
    QVERIFY(renameLook(desk.state, desk.looks()[1].id, QStringLiteral("Late")));
    moveLook(desk.state, desk.looks()[1].id, -1);
    QCOMPARE(desk.looks()[0].name, std::string("Late"));
}

void TestLooksDock::whatIsRemovedIsNoLongerShown()
{
    LooksDesk desk;
    QVERIFY(desk.isReady());
    desk.add("Studio");
    QTest::mouseClick(desk.dock->findChild<QToolButton*>(QStringLiteral("removeLook")),
                      Qt::LeftButton);
    QVERIFY(desk.looks().empty());
    QVERIFY(!desk.dock->findChild<FieldForm*>(QStringLiteral("lookForm"))->isVisible());
}

void TestLooksDock::filesAreShared()
{
    LooksDesk desk;
    desk.add("Comic");
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.looks"));
    QVERIFY(exportLook(desk.state, desk.looks()[0].id, path).isOk());
    const model::Looks before = desk.looks();
    removeLook(desk.state, before[0].id);
    QVERIFY(importLooks(desk.state, path).isOk());
    QCOMPARE(desk.looks()[0].name, before[0].name);
    QVERIFY(importLooks(desk.state, path).isOk()); // it is the same one
    QCOMPARE(desk.looks().size(), std::size_t{1});
    QVERIFY(!importLooks(desk.state, folder.filePath(QStringLiteral("none.looks"))).isOk());
}

void TestLooksDock::camerasBringTheirLooks()
{
    LooksDesk desk;
    desk.add("Evening");
    desk.add("Comic");
    const model::LookId evening = desk.looks()[0].id;
    const model::LookId comic = desk.looks()[1].id;
    const QString stalls = addCamera(desk.state, QStringLiteral("Stalls"));
    const QString gallery = addCamera(desk.state, QStringLiteral("Gallery"));
    setCameraLook(desk.state, stalls, evening);
    QCOMPARE(desk.state.viewOptions().ownLook, comic); // the view is at another
    goToCamera(desk.state, stalls);
    QCOMPARE(desk.state.viewOptions().ownLook, evening);
    goToCamera(desk.state, gallery); // has none, and this one was that camera's
    QCOMPARE(desk.state.viewOptions().ownLook, model::LookId{0});
    QVERIFY(desk.state.viewOptions().look == render::Look::Lit);
    showLook(desk.state, comic);
    goToCamera(desk.state, gallery);
    QCOMPARE(desk.state.viewOptions().ownLook, comic); // the artist's choice stays
    removeLook(desk.state, evening);
    goToCamera(desk.state, stalls);
    QCOMPARE(desk.state.viewOptions().ownLook, comic);
    desk.document.undoStack().undo();
    goToCamera(desk.state, stalls);
    QCOMPARE(desk.state.viewOptions().ownLook, evening);
}

void TestLooksDock::anotherSceneHasItsOwn()
{
    LooksDesk desk;
    desk.add("Comic");
    model::Scene other;
    model::LookPreset clay;
    clay.id = desk.looks()[0].id;
    clay.name = "Clay";
    clay.style = model::LookStyle::Clay;
    other.looks = {clay};
    desk.document.replaceScene(other, {});
    QCOMPARE(desk.state.viewOptions().ownLook, model::LookId{0});
    QVERIFY(desk.state.viewOptions().look == render::Look::Lit);
    other.cameras = {{"Stalls", {}, clay.id}};
    desk.document.replaceScene(other, {});
    QCOMPARE(desk.state.viewOptions().ownLook, clay.id);
    QVERIFY(desk.state.viewOptions().look == render::Look::Clay);
}

CROWD_WINDOW_TEST(TestLooksDock)
#include "tst_LooksDock.moc"
