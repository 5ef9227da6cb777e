// SPDX-License-Identifier: MIT
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QSpinBox>

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
    void saysWhatCannotBe();

private:
    /// Answers both dialogs; false: one did not come.
    bool save(const QString& path, const QSize& size, bool isTransparent);
};

bool TestSavePicture::save(const QString& path, const QSize& size, bool isTransparent)
{
    bool hasChosenFile = false;
    std::unique_ptr<DialogAnswer> file;
    const DialogAnswer dialog([&](QDialog& shown) {
        shown.findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(size.width());
        shown.findChild<QSpinBox*>(QStringLiteral("pictureHeight"))->setValue(size.height());
        shown.findChild<QCheckBox*>(QStringLiteral("pictureTransparent"))
            ->setChecked(isTransparent);
        file = std::make_unique<DialogAnswer>([&](QDialog& chooser) {
            auto* name = chooser.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
            hasChosenFile = name != nullptr;
            if (name == nullptr) {
                chooser.reject();
                return;
            }
            for (auto* view : chooser.findChildren<QAbstractItemView*>()) {
                view->clearSelection(); // else the file it offers is taken
            }
            name->setText(path);
            QTest::keyClick(name, Qt::Key_Return);
        });
        shown.accept();
    });
    m_window->actions().action("save-picture")->trigger();
    return hasChosenFile;
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
