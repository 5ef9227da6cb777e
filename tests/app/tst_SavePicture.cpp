// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>

#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QSpinBox>

#include <glm/geometric.hpp>

#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

/// File > Save Picture, in the real window.
class TestSavePicture : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("tst_SavePicture"); }
    void init() { begin(); }
    void savesTheViewInAnySize();
    void leavesOutWhatIsBehind();
    void drawsDepthOfField();
    void savesPassesForCompositing();
    void saysWhatCannotBe();

private:
    /// Answers both dialogs; false: one did not come.
    bool save(const QString& path, const QSize& size, bool isTransparent);

    std::function<void(QDialog&)> m_onDialog; ///< with the first of them
};

bool TestSavePicture::save(const QString& path, const QSize& size, bool isTransparent)
{
    return answerBoth(
        [this] { m_window->actions().action("save-picture")->trigger(); },
        [&](QDialog& shown) {
            shown.findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(size.width());
            shown.findChild<QSpinBox*>(QStringLiteral("pictureHeight"))->setValue(size.height());
            shown.findChild<QCheckBox*>(QStringLiteral("pictureTransparent"))
                ->setChecked(isTransparent);
            if (m_onDialog) {
                m_onDialog(shown);
            }
        },
        path);
}

void TestSavePicture::savesTheViewInAnySize()
{
    openScene(plainScene(3), QStringLiteral("scene.crowd"));
    const QString path = pathOf(QStringLiteral("view.png"));
    QVERIFY(save(path, {480, 200}, false));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), kPatienceMs);
    const QImage picture(path);
    QCOMPARE(picture.size(), QSize(480, 200));
    QVERIFY(!picture.hasAlphaChannel());
}

/// People are solid, and the sky is not there.
void TestSavePicture::leavesOutWhatIsBehind()
{
    openScene(plainScene(3), QStringLiteral("scene.crowd"));
    const QString path = pathOf(QStringLiteral("crowd.png"));
    QVERIFY(save(path, {320, 240}, true));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), kPatienceMs);
    const QImage picture(path);
    QCOMPARE(picture.size(), QSize(320, 240));
    QVERIFY(picture.hasAlphaChannel());
    int solid = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            solid += qAlpha(picture.pixel(x, y)) == 255 ? 1 : 0;
        }
    }
    QCOMPARE(qAlpha(picture.pixel(0, 0)), 0);
    QVERIFY2(solid > 20 && solid < 320 * 240 / 2, qPrintable(QString::number(solid)));
}

void TestSavePicture::savesPassesForCompositing()
{
    openScene(plainScene(3), QStringLiteral("scene.crowd"));
    const auto tick = [](bool isOn) {
        return [isOn](QDialog& dialog) {
            for (const char* key : {"depth", "id"}) {
                auto* box = dialog.findChild<QCheckBox*>(QLatin1String("picturePass.") +
                                                         QLatin1String(key));
                QVERIFY(box != nullptr);
                QCOMPARE(box->isChecked(), !isOn); // as it was left
                box->setChecked(isOn);
            }
        };
    };
    m_onDialog = tick(true);
    const QString path = pathOf(QStringLiteral("layers.exr"));
    QVERIFY(save(path, {80, 60}, false));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), kPatienceMs);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.contains("depth.Z") && bytes.contains("id.X") && !bytes.contains("normal.X"));

    m_onDialog = tick(false); // they were remembered
    QVERIFY(save(pathOf(QStringLiteral("plain.png")), {80, 60}, false));
    m_onDialog = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), kPatienceMs);
    QCOMPARE(QImage(pathOf(QStringLiteral("plain.png"))).size(), QSize(80, 60));
}

/// Focus on who is selected is offered, and what is chosen is what is drawn.
void TestSavePicture::drawsDepthOfField()
{
    openScene(plainScene(3), QStringLiteral("scene.crowd"));
    const QString sharpPath = pathOf(QStringLiteral("sharp.png"));
    QVERIFY(save(sharpPath, {160, 120}, false));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), kPatienceMs);
    m_window->state().selection().selectAll();
    double selected = 0.0;
    m_onDialog = [&selected](QDialog& dialog) {
        auto* lens = dialog.findChild<QCheckBox*>(QStringLiteral("pictureLens"));
        auto* focuses = dialog.findChild<QComboBox*>(QStringLiteral("pictureFocuses"));
        auto* focus = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("pictureFocus"));
        auto* fStop = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("pictureFStop"));
        QVERIFY(lens->isEnabled() && !focus->isEnabled());
        lens->setChecked(true);
        QVERIFY(focus->isEnabled() && fStop->isEnabled());
        QCOMPARE(focuses->count(), 3);
        selected = focus->value();
        focus->setValue(0.5); // before everybody
        QCOMPARE(focuses->currentIndex(), 2);
        fStop->setValue(0.05);
    };
    const QString softPath = pathOf(QStringLiteral("soft.png"));
    QVERIFY(save(softPath, {160, 120}, false));
    m_onDialog = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), kPatienceMs);
    const auto distance = static_cast<double>(glm::length(m_window->state().camera().position));
    QVERIFY2(std::abs(selected - distance) < 5.0, qPrintable(QString::number(selected)));
    const QImage sharp(sharpPath);
    const QImage soft(softPath);
    QCOMPARE(soft.size(), sharp.size());
    QVERIFY(soft != sharp);
}

void TestSavePicture::saysWhatCannotBe()
{
    openScene(plainScene(1), QStringLiteral("scene.crowd"));
    const QString path = pathOf(QStringLiteral("crowd.jpg"));
    QString said;
    QVERIFY(save(path, {64, 64}, true));
    const DialogAnswer warning([&said](QDialog& dialog) {
        const auto* box = qobject_cast<QMessageBox*>(&dialog);
        said = box != nullptr ? box->text() : QString();
        dialog.accept();
    });
    QTRY_VERIFY_WITH_TIMEOUT(warning.hasAnswered(), kPatienceMs);
    QVERIFY2(said.contains(QStringLiteral("JPEG")), qPrintable(said));
    QVERIFY(!QFileInfo::exists(path));
}

CROWD_WINDOW_TEST(TestSavePicture)
#include "tst_SavePicture.moc"
