// SPDX-License-Identifier: MIT
#include "widgets/docks/EnvironmentMenu.h"

#include <algorithm>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include "model/document/PathEdits.h"
#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/SmallTheatre.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// Two paths of two places each, and the menu of the first, open.
struct OpenMenu
{
    OpenMenu() : state(document), menu(state, nullptr)
    {
        document.replaceScene(crowd::testing::smallTheatre(), {});
        document.edit(QStringLiteral("Paths"), [this](model::SceneEdit& edit) {
            for (model::PathId* path : {&first, &second}) {
                for (const float x : {0.0F, 4.0F}) {
                    model::Place place;
                    place.position.x = x;
                    *path = model::appendPlace(edit, *path, place, model::PathKind::Simple);
                }
            }
        });
        menu.fillForPath(first);
        menu.popup({200, 200});
    }
    [[nodiscard]] bool isReady() { return QTest::qWaitForWindowExposed(&menu); }
    [[nodiscard]] QAction* entry(const QString& text) const
    {
        const QList<QAction*> all = menu.actions();
        const auto found = std::ranges::find(all, text, &QAction::text);
        return found == all.end() ? nullptr : *found;
    }
    /// As an artist does.
    void click(const QString& text)
    {
        QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(entry(text)).center());
    }
    [[nodiscard]] const model::Path* path(model::PathId id) const
    {
        return document.scene().findPath(id);
    }

    model::SceneDocument document;
    EditorState state;
    model::PathId first = 0;
    model::PathId second = 0;
    EnvironmentMenu menu;
};

} // namespace

/// What a right click on a path or place offers.
class tst_EnvironmentMenu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reversesAPath();
    void deletesAPathWithItsPlaces();
    void refusesWhileSomethingElseIsEdited();
    void closesWhenItsPathIsGone();
    void whatComesBackIsChosenAsItWas();
};

void tst_EnvironmentMenu::reversesAPath()
{
    OpenMenu open;
    QVERIFY(open.isReady());
    const model::PlaceId last = open.path(open.first)->places.back();
    open.click(QStringLiteral("Reverse"));
    QCOMPARE(open.path(open.first)->places.front(), last);
    QCOMPARE(open.document.undoStack().count(), 2);
}

void tst_EnvironmentMenu::deletesAPathWithItsPlaces()
{
    OpenMenu open;
    QVERIFY(open.isReady());
    open.click(QStringLiteral("Delete It with Its Places"));
    QVERIFY(open.path(open.first) == nullptr);
    QCOMPARE(open.document.scene().places.size(), std::size_t{2});
}

/// A thread that a script left behind edits while the menu is open.
void tst_EnvironmentMenu::refusesWhileSomethingElseIsEdited()
{
    OpenMenu open;
    QVERIFY(open.isReady());
    QSignalSpy refused(&open.document, &model::SceneDocument::editRefused);
    const std::vector<model::PlaceId> before = open.path(open.first)->places;
    const auto other = open.document.beginEdit();
    QVERIFY(other);
    open.click(QStringLiteral("Reverse"));
    QCOMPARE(refused.count(), 1);
    for (QAction* each : open.menu.actions()) {
        each->trigger();
    }
    QCOMPARE(refused.count(), 4);
    QCOMPARE(open.path(open.first)->places, before);
    QCOMPARE(open.document.scene().paths.size(), std::size_t{2});
}

void tst_EnvironmentMenu::closesWhenItsPathIsGone()
{
    OpenMenu open;
    QVERIFY(open.isReady());
    open.document.edit(QStringLiteral("Delete"),
                       [&](model::SceneEdit& edit) { edit.removePath(open.first); });
    QVERIFY(!open.menu.isVisible());
}

/// Undone, a deletion leaves everything as before it.
void tst_EnvironmentMenu::whatComesBackIsChosenAsItWas()
{
    OpenMenu open;
    PathFocus& focus = open.state.paths();
    const std::vector<model::PlaceId> places = open.path(open.first)->places;
    focus.look(open.first);
    focus.select(places);
    open.click(QStringLiteral("Delete It with Its Places"));
    QVERIFY(focus.places().empty());
    QCOMPARE(focus.path(), model::PathId{0});
    open.document.undoStack().undo();
    QCOMPARE(focus.places(), places);
    QCOMPARE(focus.path(), open.first);
    // Who has chosen something else since keeps that.
    open.document.undoStack().redo();
    const std::vector<model::PlaceId> others = open.path(open.second)->places;
    focus.look(open.second);
    focus.select(others);
    open.document.undoStack().undo();
    QCOMPARE(focus.places(), others);
    QCOMPARE(focus.path(), open.second);
}

CROWD_WINDOW_TEST(tst_EnvironmentMenu)
#include "tst_EnvironmentMenu.moc"
