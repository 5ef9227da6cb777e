// SPDX-License-Identifier: MIT
#include <QtCore/QFileInfo>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QToolButton>

#include "app/window/KeysDialog.h"
#include "app/window/PreferencesDialog.h"
#include "app/window/RecentFiles.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/dialogs/WelcomePage.h"
#include "widgets/theme/Theme.h"

using namespace crowd;
using namespace crowd::testing;

/// The page that the editor shows at a start without a file.
class WelcomeTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("WelcomeTest"); }
    void init() { begin(); }
    void cleanup() { m_window.reset(); }

    void clickOnThePictureOfTheCityOpensIt();
    void theSecondClickDoesNotPaintBehindThePage();
    void everyReadyMadeSceneHasAPicture();
    void keyboardReachesEveryChoice();
    void theKeyForTheCardWorksOnIt();
    void escapeLeavesAnEmptyTheatre();
    void newGroundAndRecentScenes();
    void libraryIsOneClickAway();
    void staysAwayWhenItIsNotWanted();
    void filesComeWithoutIt();
    void menuBringsItBackOnce();
    void readableInLightAndDark();

private:
    [[nodiscard]] widgets::WelcomePage* page() const
    {
        return m_window->findChild<widgets::WelcomePage*>();
    }
    void startAndWait()
    {
        m_window->start({});
        QTRY_VERIFY_WITH_TIMEOUT(page() != nullptr && page()->isVisible(), 3 * kPatienceMs);
        QVERIFY(!m_window->files().isBusy());
    }
};

void WelcomeTest::clickOnThePictureOfTheCityOpensIt()
{
    startAndWait();
    auto* city = page()->findChild<QToolButton*>(QStringLiteral("city"));
    QVERIFY(city != nullptr);
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    QTest::mouseClick(city, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 6 * kPatienceMs);
    QTRY_VERIFY(page() == nullptr);
    QVERIFY(document().scene().population.size() > 200);
    QCOMPARE(m_window->files().documentName(), QStringLiteral("City"));
    QVERIFY2(document().path().isEmpty(), "saving must not write into the program's own files");
}

void WelcomeTest::theSecondClickDoesNotPaintBehindThePage()
{
    startAndWait();
    m_window->state().setTool(widgets::ToolId::BrushCreate);
    auto* city = page()->findChild<QToolButton*>(QStringLiteral("city"));
    QVERIFY(city != nullptr);
    auto& picture = m_window->viewport();
    QTest::mouseClick(city, Qt::LeftButton);
    QTest::mousePress(&picture, Qt::LeftButton, {}, picture.rect().center());
    QVERIFY(!document().isEditOpen());
    QTest::mouseRelease(&picture, Qt::LeftButton, {}, picture.rect().center());
    QCOMPARE(document().undoStack().count(), 0);
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 6 * kPatienceMs);
    QTest::qWait(QApplication::doubleClickInterval()); // from then on the hand paints
    QTest::mousePress(&picture, Qt::LeftButton, {}, picture.rect().center());
    QVERIFY(document().isEditOpen());
    QTest::keyClick(&picture, Qt::Key_Escape);
    QTest::mouseRelease(&picture, Qt::LeftButton, {}, picture.rect().center());
}

void WelcomeTest::everyReadyMadeSceneHasAPicture()
{
    const QStringList examples = app::FileController::examples();
    QCOMPARE(examples.size(), 4);
    m_window->showWelcome();
    for (const QString& path : examples) {
        const QFileInfo scene(path);
        const QImage picture(scene.path() + QLatin1Char('/') + scene.completeBaseName() +
                             QStringLiteral(".png"));
        QCOMPARE(picture.size(), QSize(320, 180));
        const auto* button = page()->findChild<QToolButton*>(scene.completeBaseName());
        QVERIFY2(button != nullptr, qPrintable(path));
        QVERIFY(!button->text().isEmpty());
        QVERIFY(button->icon().availableSizes().contains(picture.size()));
    }
}

void WelcomeTest::keyboardReachesEveryChoice()
{
    m_window->showWelcome();
    QTRY_VERIFY(page()->isActiveWindow());
    QStringList seen;
    for (int i = 0; i < 16; ++i) {
        if (const QWidget* focus = page()->focusWidget()) {
            seen << focus->objectName();
        }
        QTest::keyClick(page(), Qt::Key_Tab);
    }
    for (const char* name : {"theatre", "city", "stadium", "meadow", "newTheatre", "newGround",
                             "open", "library", "showAtStart"}) {
        QVERIFY2(seen.contains(QLatin1String(name)), name);
    }
    auto* meadow = page()->findChild<QToolButton*>(QStringLiteral("meadow"));
    meadow->setFocus();
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    QTest::keyClick(meadow, Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 6 * kPatienceMs);
    QCOMPARE(m_window->files().documentName(), QStringLiteral("Meadow"));
}

/// The hint in the picture behind names it.
void WelcomeTest::theKeyForTheCardWorksOnIt()
{
    startAndWait();
    QTRY_VERIFY(page()->isActiveWindow());
    QTest::keyClick(page(), Qt::Key_F1);
    QTRY_VERIFY(page()->findChild<app::KeysDialog*>() != nullptr);
    auto* card = page()->findChild<app::KeysDialog*>();
    QTRY_VERIFY(card->isActiveWindow());
    QTest::keyClick(card, Qt::Key_Escape);
    QTRY_VERIFY(page()->findChild<app::KeysDialog*>() == nullptr);
    QVERIFY(page()->isVisible());
}

void WelcomeTest::escapeLeavesAnEmptyTheatre()
{
    startAndWait();
    QTest::keyClick(page(), Qt::Key_Escape);
    QTRY_VERIFY(page() == nullptr);
    QCOMPARE(document().scene().stages.size(), std::size_t{1});
    QCOMPARE(document().scene().population.size(), std::size_t{0});
    QVERIFY(!document().isModified());
}

void WelcomeTest::newGroundAndRecentScenes()
{
    openScene(plainScene(3), QStringLiteral("three & more.crowd"));
    m_window->showWelcome();
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    page()->findChild<QPushButton*>(QStringLiteral("newGround"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QVERIFY(document().scene().stages.empty());
    QTRY_VERIFY(page() == nullptr);
    m_window->showWelcome();
    auto* recent = page()->findChild<QPushButton*>(QStringLiteral("recent"));
    QVERIFY(recent != nullptr);
    recent->click();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 2, kPatienceMs);
    QCOMPARE(document().scene().population.size(), std::size_t{3});
    QCOMPARE(document().path(), pathOf(QStringLiteral("three & more.crowd")));
}

void WelcomeTest::libraryIsOneClickAway()
{
    startAndWait();
    const DialogAnswer answer([](QDialog& dialog) { dialog.reject(); });
    page()->findChild<QPushButton*>(QStringLiteral("library"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(answer.hasAnswered(), 3 * kPatienceMs);
    QVERIFY2(answer.title().contains(QStringLiteral("Library"), Qt::CaseInsensitive),
             qPrintable(answer.title()));
    QVERIFY(page() == nullptr);
}

void WelcomeTest::staysAwayWhenItIsNotWanted()
{
    m_window->showWelcome();
    auto* atStart = page()->findChild<QCheckBox*>(QStringLiteral("showAtStart"));
    QVERIFY(atStart->isChecked());
    atStart->click();
    page()->reject();
    QTRY_VERIFY(page() == nullptr);
    QVERIFY(!app::Preferences::load().showsWelcome);
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->start({});
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 6 * kPatienceMs);
    QVERIFY2(document().scene().population.size() > 500, "the full theatre, as ever");
    QVERIFY(page() == nullptr);
}

void WelcomeTest::filesComeWithoutIt()
{
    QVERIFY(model::saveProject(plainScene(2), pathOf(QStringLiteral("two.crowd"))).isOk());
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->start({pathOf(QStringLiteral("two.crowd"))});
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QCOMPARE(document().scene().population.size(), std::size_t{2});
    QVERIFY(page() == nullptr);
}

void WelcomeTest::menuBringsItBackOnce()
{
    m_window->actions().action("welcome")->trigger();
    QVERIFY(page() != nullptr && page()->isVisible());
    m_window->actions().action("welcome")->trigger();
    QCOMPARE(m_window->findChildren<widgets::WelcomePage*>().size(), 1);
}

void WelcomeTest::readableInLightAndDark()
{
    for (const widgets::Theme theme : {widgets::Theme::Light, widgets::Theme::Dark}) {
        widgets::applyTheme(theme);
        m_window->showWelcome();
        const QPalette palette = page()->palette();
        const int back = palette.color(QPalette::Window).lightness();
        const int text = palette.color(QPalette::WindowText).lightness();
        QVERIFY(std::abs(back - text) > 100);
        QCOMPARE(back < text, theme == widgets::Theme::Dark);
        const QImage drawn = page()->grab().toImage();
        QVERIFY(std::abs(drawn.pixelColor(drawn.width() / 2, 4).lightness() - back) < 12);
        page()->reject();
        QTRY_VERIFY(page() == nullptr);
    }
    widgets::applyTheme(widgets::Theme::System);
}

CROWD_WINDOW_TEST(WelcomeTest)

#include "tst_Welcome.moc"
