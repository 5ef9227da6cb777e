// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>

#include <QtCore/QDateTime>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QTimer>
#include <QtGui/QAction>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QProgressDialog>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QStatusBar>

#include "app/window/PictureSizeFields.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/MovieContent.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/SessionControl.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 64;

/// Somebody walks across the picture.
model::Scene walkScene()
{
    model::Scene scene = plainScene(1);
    scene.places = {{1, "here", {-6.0F, 0.0F, 0.0F}, 0.3F}, {2, "there", {6.0F, 0.0F, 0.0F}, 0.3F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    const auto ids = scene.population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    scene.population.setValues<model::PathId>(model::columns::path, all,
                                              std::vector<model::PathId>{1});
    scene.population.setValues<glm::vec3>(model::columns::position, all,
                                          std::vector<glm::vec3>{{-6.0F, 0.0F, 0.0F}});
    return scene;
}

} // namespace

/// File > Make Movie, in the real window.
class TestMakeMovie : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("tst_MakeMovie"); }
    void init() { begin(); }
    void cleanup() { qunsetenv("CROWDBRUSH_FFMPEG"); }
    void ofTheSceneFromItsBeginning();
    void ofWhatHasBeenPlayed();
    void sizesAreEven();
    void proportionsAreKept();
    void asTheTimelineMovesTheCamera();
    void asNumberedPictures();
    void nothingStaysOfWhatIsCancelled();
    void saysWhereFfmpegIsNot();

private:
    /// Answers both dialogs; false: one did not come.
    bool make(const QString& path, const std::function<void(QDialog&)>& choose);
};

bool TestMakeMovie::make(const QString& path, const std::function<void(QDialog&)>& choose)
{
    return answerBoth(
        [this] { m_window->actions().action("make-movie")->trigger(); },
        [&choose](QDialog& shown) {
            shown.findChild<QSpinBox*>(QStringLiteral("pictureWidth"))->setValue(kWidth);
            shown.findChild<QSpinBox*>(QStringLiteral("pictureHeight"))->setValue(kHeight);
            for (QCheckBox* box : shown.findChildren<QCheckBox*>()) {
                box->setChecked(false); // whatever the last one was asked for
            }
            choose(shown);
        },
        path);
}

void TestMakeMovie::ofTheSceneFromItsBeginning()
{
    openScene(walkScene(), QStringLiteral("walk.crowd"));
    const QString path = pathOf(QStringLiteral("walk.mp4"));
    QVERIFY(make(path, [](QDialog& dialog) {
        auto* sources = dialog.findChild<QComboBox*>(QStringLiteral("movieSources"));
        QCOMPARE(sources->count(), 1); // nothing has been played
        auto* from = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieFrom"));
        auto* to = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"));
        QCOMPARE(from->value(), 0.0);
        to->setValue(0.4);
        from->setValue(1.0); // the other way round
        auto* rates = dialog.findChild<QComboBox*>(QStringLiteral("movieRates"));
        rates->setCurrentIndex(rates->findData(25.0));
        auto* count = dialog.findChild<QLabel*>(QStringLiteral("movieCount"));
        QVERIFY2(count->text().startsWith(QStringLiteral("15 ")), qPrintable(count->text()));
        auto* cameras = dialog.findChild<QComboBox*>(QStringLiteral("movieCameras"));
        QCOMPARE(cameras->count(), 3); // the view, around it, the scene's own
        cameras->setCurrentIndex(2);
    }));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), 6 * kPatienceMs);
    const auto pictures = picturesOf(path, kWidth, kHeight);
    QCOMPARE(pictures.size(), std::size_t{15});
    QVERIFY(pictures.front() != pictures.back());
    QVERIFY(!m_window->state().session().isRunning()); // it was another run
    const QString said = m_window->statusBar()->currentMessage();
    QVERIFY2(said.contains(QStringLiteral("walk.mp4")), qPrintable(said));
}

/// An odd size would be cut without a word.
void TestMakeMovie::sizesAreEven()
{
    openScene(walkScene(), QStringLiteral("walk.crowd"));
    (void)make(pathOf(QStringLiteral("walk.mp4")), [](QDialog& dialog) {
        auto* width = dialog.findChild<QSpinBox*>(QStringLiteral("pictureWidth"));
        auto* height = dialog.findChild<QSpinBox*>(QStringLiteral("pictureHeight"));
        auto* sizes = dialog.findChild<QComboBox*>(QStringLiteral("pictureSizes"));
        sizes->setCurrentIndex(0);
        QCOMPARE(width->value() % 2, 0);
        QCOMPARE(height->value() % 2, 0);
        width->setValue(kWidth + 1);
        Q_EMIT width->editingFinished();
        QCOMPARE(width->value(), kWidth);
        height->setValue(kHeight);
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->setValue(0.1);
    });
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), 6 * kPatienceMs);
}

void TestMakeMovie::proportionsAreKept()
{
    const QString key = QStringLiteral("test/size");
    const auto part = [](const QWidget& fields, const char* name) {
        return fields.findChild<QSpinBox*>(QLatin1String(name));
    };
    app::PictureSizeFields fields({1000, 500}, 4000, 2, key, nullptr);
    QSpinBox* width = part(fields, "pictureWidth");
    QSpinBox* height = part(fields, "pictureHeight");
    width->setValue(800);
    QCOMPARE(height->value(), 500);
    auto* keep = fields.findChild<QCheckBox*>(QStringLiteral("keepProportions"));
    QTest::mouseClick(keep, Qt::LeftButton, {}, {8, keep->height() / 2});
    QVERIFY(keep->isChecked());
    width->setValue(400);
    QCOMPARE(height->value(), 250);
    height->setValue(500);
    QCOMPARE(width->value(), 800);
    QCOMPARE(fields.findChild<QComboBox*>(QStringLiteral("pictureSizes"))->currentText(),
             QStringLiteral("Another size"));
    height->setValue(4000); // more width than there is
    QCOMPARE(width->value(), 4000);
    auto* sizes = fields.findChild<QComboBox*>(QStringLiteral("pictureSizes"));
    sizes->setCurrentIndex(sizes->findText(QStringLiteral("Square")));
    width->setValue(600);
    QCOMPARE(height->value(), 600);
    fields.remember();
    const app::PictureSizeFields next({1000, 500}, 4000, 2, key, nullptr);
    part(next, "pictureWidth")->setValue(300);
    QCOMPARE(part(next, "pictureHeight")->value(), 300);
}

void TestMakeMovie::asTheTimelineMovesTheCamera()
{
    model::Scene scene = plainScene(1); // who stands
    scene.cameras.push_back({"aside", model::Camera::lookingAt({9, 2, 1}, {0, 1, 0})});
    model::Mark cut;
    cut.id = 1;
    cut.kind = model::MarkKind::Camera;
    cut.seconds = 0.2;
    cut.camera = "aside";
    scene.timeline = {cut};
    openScene(scene, QStringLiteral("cut.crowd"));
    const QString path = pathOf(QStringLiteral("cut.png"));
    const auto picturesTaken = [&](int camera) {
        (void)make(path, [camera](QDialog& dialog) {
            dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->setValue(0.34);
            auto* rates = dialog.findChild<QComboBox*>(QStringLiteral("movieRates"));
            rates->setCurrentIndex(rates->findData(30.0));
            auto* cameras = dialog.findChild<QComboBox*>(QStringLiteral("movieCameras"));
            QCOMPARE(cameras->currentIndex(), 0); // by the timeline, unless one wants otherwise
            cameras->setCurrentIndex(camera);
        });
        std::vector<QImage> pictures;
        if (QTest::qWaitFor([this] { return m_window->isFree(); }, 6 * kPatienceMs)) {
            for (int i = 0; i < 10; ++i) {
                const QString file = pathOf(QStringLiteral("cut_000%1.png").arg(i));
                pictures.emplace_back(file);
                QFile::remove(file);
            }
        }
        return pictures;
    };
    const auto directed = picturesTaken(0);
    const auto around = picturesTaken(2);
    const auto aside = picturesTaken(4);
    QVERIFY(directed.size() == 10 && around.size() == 10 && aside.size() == 10);
    QVERIFY(!directed[0].isNull() && directed[5] != aside[5] && directed[6] == aside[6]);
    QVERIFY(directed[0] == around[0]);
    QVERIFY(around[1] != directed[1]);
}

/// With passes, and again only those that are missing or not whole.
void TestMakeMovie::asNumberedPictures()
{
    openScene(walkScene(), QStringLiteral("walk.crowd"));
    const auto choose = [](QDialog& dialog) {
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieFrom"))->setValue(0.0);
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->setValue(0.14);
        auto* rates = dialog.findChild<QComboBox*>(QStringLiteral("movieRates"));
        rates->setCurrentIndex(rates->findData(30.0));
        dialog.findChild<QCheckBox*>(QStringLiteral("picturePass.depth"))->setChecked(true);
    };
    const QString path = pathOf(QStringLiteral("walk.exr"));
    QVERIFY(make(path, choose));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), 6 * kPatienceMs);
    const auto bytesOf = [this](int number) {
        QFile file(pathOf(QStringLiteral("walk_000%1.exr").arg(number)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    for (int i = 0; i < 4; ++i) {
        QVERIFY2(bytesOf(i).contains("depth.Z"), qPrintable(QString::number(i)));
    }
    QVERIFY(bytesOf(4).isEmpty() && !QFile::exists(path));
    const QByteArray second = bytesOf(1);
    const QByteArray third = bytesOf(2);

    QVERIFY(QFile::remove(pathOf(QStringLiteral("walk_0001.exr"))));
    const QString broken = pathOf(QStringLiteral("walk_0002.exr"));
    QVERIFY(QFile::resize(broken, QFileInfo(broken).size() - 10));
    const QFileInfo whole(pathOf(QStringLiteral("walk_0003.exr")));
    const QDateTime drawn = whole.lastModified();
    QTimer answer; // to the question that comes after both dialogs
    connect(&answer, &QTimer::timeout, this, [this] {
        if (auto* missing = m_window->findChild<QPushButton*>(QStringLiteral("drawMissing"))) {
            missing->click();
        }
    });
    answer.start(20);
    QVERIFY(make(path, choose));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), 6 * kPatienceMs);
    QVERIFY(bytesOf(1) == second);
    QVERIFY(bytesOf(2) == third);
    QCOMPARE(QFileInfo(whole.filePath()).lastModified(), drawn);

    const QString movie = pathOf(QStringLiteral("walk.mp4")); // has no room for them
    QVERIFY(make(movie, choose));
    QString said;
    const DialogAnswer refused([&said](QDialog& dialog) {
        const auto* box = qobject_cast<QMessageBox*>(&dialog);
        said = box != nullptr ? box->text() : QString();
        dialog.accept();
    });
    QTRY_VERIFY_WITH_TIMEOUT(refused.hasAnswered() && m_window->isFree(), kPatienceMs);
    QVERIFY2(said.contains(QStringLiteral("room for passes")), qPrintable(said));
    QVERIFY(!QFile::exists(movie));
}

/// As it was seen, whatever the scene is like by now.
void TestMakeMovie::ofWhatHasBeenPlayed()
{
    openScene(walkScene(), QStringLiteral("walk.crowd"));
    auto& transport = m_window->state().transport();
    auto& session = m_window->state().session();
    transport.setSpeed(4.0);
    transport.setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session.isRunning() && transport.seconds() > 2.0, kPatienceMs);
    transport.setPlaying(false);
    const double live = session.liveSeconds();
    const QString path = pathOf(QStringLiteral("run.mp4"));
    int offered = 0;
    QVERIFY(make(path, [&](QDialog& dialog) {
        auto* sources = dialog.findChild<QComboBox*>(QStringLiteral("movieSources"));
        offered = sources->count();
        auto* from = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieFrom"));
        auto* to = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"));
        QVERIFY(std::abs(to->value() - live) < 0.01 && from->value() < 0.1);
        from->setValue(1.0);
        to->setValue(1.5);
    }));
    QCOMPARE(offered, 2);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree(), 6 * kPatienceMs);
    const auto pictures = picturesOf(path, kWidth, kHeight);
    QCOMPARE(pictures.size(), std::size_t{15}); // 30 a second
    QVERIFY(pictures.front() != pictures.back());
    QVERIFY(session.isRunning()); // and goes on
    QCOMPARE(session.liveSeconds(), live);
}

void TestMakeMovie::nothingStaysOfWhatIsCancelled()
{
    openScene(walkScene(), QStringLiteral("walk.crowd"));
    const QString path = pathOf(QStringLiteral("long.mp4"));
    QVERIFY(make(path, [](QDialog& dialog) {
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->setValue(600.0);
    }));
    QProgressDialog* progress = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((progress = m_window->findChild<QProgressDialog*>()) != nullptr &&
                                 progress->isVisible(),
                             kPatienceMs);
    const QString part = pathOf(QStringLiteral(".long.mp4.part"));
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(part), kPatienceMs);
    progress->findChild<QPushButton*>()->click();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->isFree() && !QFileInfo::exists(part), kPatienceMs);
    QVERIFY(!QFileInfo::exists(path));
}

void TestMakeMovie::saysWhereFfmpegIsNot()
{
    openScene(walkScene(), QStringLiteral("walk.crowd"));
    qputenv("CROWDBRUSH_FFMPEG", "/nonexistent/ffmpeg");
    QVERIFY(make(pathOf(QStringLiteral("walk.gif")), [](QDialog& dialog) {
        dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"))->setValue(0.1);
    }));
    QString said;
    const DialogAnswer warning([&said](QDialog& dialog) {
        const auto* box = qobject_cast<QMessageBox*>(&dialog);
        said = box != nullptr ? box->text() : QString();
        dialog.accept();
    });
    QTRY_VERIFY_WITH_TIMEOUT(warning.hasAnswered(), kPatienceMs);
    QVERIFY2(said.contains(QStringLiteral("ffmpeg")), qPrintable(said));
    QVERIFY(!QFileInfo::exists(pathOf(QStringLiteral("walk.gif"))));
}

CROWD_WINDOW_TEST(TestMakeMovie)
#include "tst_MakeMovie.moc"
