// SPDX-License-Identifier: MIT
#include <QtCore/QPointer>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableWidget>

#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/dialogs/ClipsDialog.h"
#include "widgets/dialogs/ImportDialog.h"
#include "widgets/dialogs/LibraryDialog.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// As by hand: a click into it, all of it replaced, on to the next field. A busy window manager may
/// yet have given the keys to the window before.
void type(QDoubleSpinBox& box, const QString& text)
{
    QVERIFY(QTest::qWaitFor(
        [&box] {
            box.window()->activateWindow();
            QTest::mouseClick(&box, Qt::LeftButton);
            return box.hasFocus();
        },
        kPatienceMs));
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Tab);
}

} // namespace

/// What brings characters along, and the views that are kept, in the real window.
class AssetDialogsTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("AssetDialogsTest"); }
    void init() { begin(); }
    void cleanup() { m_window.reset(); }
    void theImportTakesWhatIsTyped();
    void aCancelledImportLeavesNothing();
    void anImportGoesWithItsWindow();
    void theLibraryAddsWhomOneClicks();
    void clipsOfATemplateAreChanged();
    void theViewGoesToANewStage();
    void numbersKeepViewsAndBringThemBack();

private:
    template<class Dialog>
    [[nodiscard]] Dialog* opened();
    [[nodiscard]] std::size_t templates() { return document().scene().templates.size(); }
    void import()
    {
        m_window->assets().importTemplates({QStringLiteral(CROWD_RESOURCES "/templates/man.glb")});
    }
};

/// Once it is there; null: it does not come.
template<class Dialog>
Dialog* AssetDialogsTest::opened()
{
    Dialog* found = nullptr;
    (void)QTest::qWaitFor(
        [&] {
            found = qobject_cast<Dialog*>(openDialog());
            return found != nullptr;
        },
        kPatienceMs);
    return found;
}

void AssetDialogsTest::theImportTakesWhatIsTyped()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const std::size_t before = templates();
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    import();
    auto* dialog = opened<widgets::ImportDialog>();
    QVERIFY(dialog != nullptr);
    auto* scale = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("importScale"));
    auto* height = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("importHeight"));
    QTRY_VERIFY_WITH_TIMEOUT(dialog->isSettled(), kPatienceMs);
    const double tall = height->value();
    type(*scale, QLocale().toString(2.0));
    QTRY_VERIFY_WITH_TIMEOUT(dialog->isSettled() && height->value() > tall * 1.9, kPatienceMs);
    type(*height, QLocale().toString(1.75));
    QTRY_VERIFY_WITH_TIMEOUT(dialog->isSettled(), kPatienceMs);
    const float wanted = dialog->settings().scale;
    QVERIFY(wanted < 2.0F && wanted > 0.5F);
    auto* take = dialog->findChild<QPushButton*>(QStringLiteral("import"));
    QVERIFY(take != nullptr && take->isEnabled());
    QTest::mouseClick(take, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 1, kPatienceMs);
    QCOMPARE(templates(), before + 1);
    QCOMPARE(document().scene().templates.back().import.scale, wanted);
    document().undoStack().undo();
    QCOMPARE(templates(), before);
}

void AssetDialogsTest::aCancelledImportLeavesNothing()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const std::size_t before = templates();
    const int steps = document().undoStack().count();
    import();
    auto* dialog = opened<widgets::ImportDialog>();
    QVERIFY(dialog != nullptr);
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!m_window->assets().isBusy());
    QCOMPARE(templates(), before);
    QCOMPARE(document().undoStack().count(), steps);
}

/// While somebody types into it.
void AssetDialogsTest::anImportGoesWithItsWindow()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    import();
    auto* dialog = opened<widgets::ImportDialog>();
    QVERIFY(dialog != nullptr);
    auto* height = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("importHeight"));
    QTest::mouseClick(height, Qt::LeftButton);
    QTest::keyClick(height, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(height, QLocale().toString(1.25));
    const QPointer<QDialog> watched = dialog;
    m_window.reset();
    QVERIFY(watched.isNull());
}

void AssetDialogsTest::theLibraryAddsWhomOneClicks()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    const std::size_t before = templates();
    QTest::keyClick(m_window->windowHandle(), Qt::Key_L, Qt::ControlModifier | Qt::AltModifier);
    auto* dialog = opened<widgets::LibraryDialog>();
    QVERIFY(dialog != nullptr);
    auto* list = dialog->findChild<QListWidget*>();
    auto* take = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    QVERIFY(!take->isEnabled()); // nobody is chosen
    QListWidgetItem* free = nullptr;
    for (int row = 0; row < list->count() && free == nullptr; ++row) {
        free = list->item(row)->flags().testFlag(Qt::ItemIsEnabled) ? list->item(row) : nullptr;
    }
    QVERIFY(free != nullptr);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(free).center());
    QVERIFY(take->isEnabled());
    QTest::mouseClick(take, Qt::LeftButton);
    QTRY_COMPARE(templates(), before + 1);
    QVERIFY(document().scene().templates.back().asset != nullptr);
}

void AssetDialogsTest::clipsOfATemplateAreChanged()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    QSignalSpy added(&m_window->assets(), &app::AssetController::templateAdded);
    m_window->assets().addTemplate(QStringLiteral(CROWD_RESOURCES "/templates/man.glb"), {});
    QTRY_COMPARE_WITH_TIMEOUT(added.count(), 1, kPatienceMs);
    QTRY_VERIFY(!m_window->assets().isBusy());
    const model::TemplateId id = document().scene().templates.back().id;
    m_window->assets().editClips(id);
    auto* dialog = opened<widgets::ClipsDialog>();
    QVERIFY(dialog != nullptr);
    auto* table = dialog->findChild<QTableWidget*>();
    auto* speed = qobject_cast<QDoubleSpinBox*>(table->cellWidget(2, 2));
    QVERIFY(speed != nullptr);
    table->scrollToItem(table->item(2, 0));
    type(*speed, QLocale().toString(1.5));
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                      Qt::LeftButton);
    const auto speeds = [this, id] { return document().scene().findTemplate(id)->clipSpeeds; };
    QTRY_VERIFY(speeds().size() > 2);
    QCOMPARE(speeds()[2], 1.5F);
    document().undoStack().undo();
    QVERIFY(speeds().empty());
}

void AssetDialogsTest::theViewGoesToANewStage()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    m_window->state().setCamera(
        model::Camera::lookingAt({900.0F, 3.0F, 900.0F}, {950.0F, 3.0F, 950.0F}));
    const std::size_t before = document().scene().stages.size();
    m_window->assets().addStage(QStringLiteral(CROWD_RESOURCES "/stages/city.glb"));
    QTRY_COMPARE_WITH_TIMEOUT(document().scene().stages.size(), before + 1, kPatienceMs);
    QTRY_VERIFY(glm::length(m_window->state().camera().position) < 300.0F);
    const model::View view(m_window->state().cameraTarget(), {800.0F, 600.0F});
    const auto middle = view.project({0.0F, 1.0F, 0.0F});
    QVERIFY(middle && middle->x > 0.0F && middle->x < 800.0F && middle->y > 0.0F &&
            middle->y < 600.0F);
}

void AssetDialogsTest::numbersKeepViewsAndBringThemBack()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    m_window->viewport().setFocus();
    const std::size_t before = document().scene().cameras.size();
    const glm::vec3 kept = m_window->state().camera().position;
    const auto press = [this](Qt::KeyboardModifiers with) {
        const auto key =
            static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(document().scene().cameras.size()) -
                                 (with == Qt::NoModifier ? 1 : 0));
        QTest::keyClick(m_window->windowHandle(), key, with);
    };
    press(Qt::ControlModifier);
    QTRY_COMPARE(document().scene().cameras.size(), before + 1);
    model::Camera away = m_window->state().camera();
    away.position += glm::vec3(5.0F, 2.0F, 1.0F);
    m_window->state().setCamera(away);
    press(Qt::NoModifier);
    QTRY_VERIFY(glm::distance(m_window->state().camera().position, kept) < 0.01F);
    document().undoStack().undo();
    QCOMPARE(document().scene().cameras.size(), before);
}

CROWD_WINDOW_TEST(AssetDialogsTest)
#include "tst_AssetDialogs.moc"
