// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <limits>
#include <random>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "behavior/session/MotionReader.h"
#include "behavior/takes/TakeFile.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::MotionBudget;
using behavior::MotionCache;
using behavior::MotionReader;
using behavior::SessionPose;
using behavior::SessionPosePtr;

namespace {

using CachePtr = std::shared_ptr<MotionCache>;
using Change = std::function<void(SessionPose& pose)>;

constexpr double kTakeRate = 30.0;
constexpr std::uint64_t kTakeSteps = 100;
constexpr std::size_t kTakePeople = 12;

std::shared_ptr<SessionPose> walkersAt(std::uint64_t step)
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = step;
    pose->seconds = 2.0 + static_cast<double>(step) / kTakeRate;
    for (std::size_t i = 0; i < kTakePeople; ++i) {
        const auto own = static_cast<float>(i);
        const auto time = static_cast<float>(step) * 0.05F;
        pose->ids.push_back(static_cast<model::IndividualId>(2 * i + 1));
        pose->x.push_back(own + time);
        pose->y.push_back(0.0F);
        pose->z.push_back(own - time);
        pose->headings.push_back(0.2F * own);
        pose->clips.push_back(static_cast<std::uint16_t>(i % 3));
        pose->rates.push_back(1.0F);
        pose->clipSeconds.push_back(1.5F);
        pose->places.push_back(0.01F * time);
        pose->flags.push_back(1);
    }
    return pose;
}

/// All that a step can hold beside its columns, shared as a session shares it.
struct Extras
{
    std::shared_ptr<const behavior::OverrideColumns> overrides;
    std::shared_ptr<const behavior::FadeColumns> fades;
    std::shared_ptr<const model::LightCues> cues;
    std::shared_ptr<const std::vector<behavior::OwnNumber>> numbers;

    Extras()
    {
        auto set = std::make_shared<behavior::OverrideColumns>();
        set->put(model::ColumnId::Height, {{3, 5}, std::vector<std::byte>(8, std::byte{0x3F})});
        overrides = set;
        auto times = std::make_shared<behavior::FadeTimes>();
        times->ids = {1, 7};
        times->begins = {2.5, 3.0};
        times->areWhole = {0, 1};
        times->seconds = 1.0;
        times->end = 4.0;
        auto column = std::make_shared<behavior::FadeColumn>();
        column->times = times;
        column->bytes.resize(4);
        column->phases = {0.25F, 0.5F};
        column->rates = {1.0F, 2.0F};
        fades = std::make_shared<const behavior::FadeColumns>(behavior::FadeColumns{column});
        cues = std::make_shared<const model::LightCues>(
            model::LightCues{{3, 0.25F, 1.0F, 2.0, 1.5F, 3.0, 0.5F, 4.0, 2.0F}});
        numbers = std::make_shared<const std::vector<behavior::OwnNumber>>(
            std::vector<behavior::OwnNumber>{{1, 5, 7.5F}});
    }
    void putInto(SessionPose& pose) const
    {
        if (pose.step > 40) {
            pose.overrides = overrides;
            pose.stateFades = fades;
            pose.recalled = pose.step > 60 ? overrides : nullptr;
        }
        pose.lightCues = cues;
        pose.numbers = numbers;
        pose.gone = pose.step / 10;
        pose.lit = {5};
    }
};

CachePtr playedRun(const MotionBudget& budget = {}, const Change& change = {})
{
    const Extras extras;
    auto cache = std::make_shared<MotionCache>(budget);
    for (std::uint64_t step = 0; step < kTakeSteps; ++step) {
        auto pose = walkersAt(step);
        extras.putInto(*pose);
        if (change) {
            change(*pose);
        }
        cache->add(pose);
    }
    return cache;
}

bool areSame(const behavior::OverrideColumns* a, const behavior::OverrideColumns* b)
{
    if (a == nullptr || b == nullptr) {
        return a == b;
    }
    for (std::size_t i = 0; i < model::kColumnCount; ++i) {
        const auto* one = a->column(static_cast<model::ColumnId>(i));
        const auto* other = b->column(static_cast<model::ColumnId>(i));
        const bool isSame = one == nullptr || other == nullptr
                                ? one == other
                                : one->ids == other->ids && one->bytes == other->bytes;
        if (!isSame) {
            return false;
        }
    }
    return true;
}

bool areSame(const behavior::FadeColumns* a, const behavior::FadeColumns* b)
{
    if (a == nullptr || b == nullptr) {
        return a == b;
    }
    return std::ranges::equal(*a, *b, [](const auto& one, const auto& other) {
        return one->column == other->column && one->bytes == other->bytes &&
               one->phases == other->phases && one->rates == other->rates &&
               one->times->ids == other->times->ids && one->times->begins == other->times->begins &&
               one->times->areWhole == other->times->areWhole &&
               one->times->seconds == other->times->seconds && one->times->end == other->times->end;
    });
}

void compareTakes(const CachePtr& run, const CachePtr& take)
{
    MotionReader played(run);
    MotionReader kept(take);
    for (std::uint64_t step = 0; step < kTakeSteps; ++step) {
        const double seconds = 2.0 + (static_cast<double>(step) + 0.5) / kTakeRate;
        const SessionPosePtr a = played.around(seconds).first;
        const SessionPosePtr b = kept.around(seconds).first;
        QVERIFY2(a && b, qPrintable(QString::number(step)));
        QCOMPARE(b->step, a->step);
        QCOMPARE(b->seconds, a->seconds);
        QVERIFY(a->ids == b->ids && a->x == b->x && a->z == b->z && a->clips == b->clips);
        QVERIFY(a->headings == b->headings && a->places == b->places && a->lit == b->lit);
        QCOMPARE(b->gone, a->gone);
        QVERIFY(areSame(a->overrides.get(), b->overrides.get()));
        QVERIFY(areSame(a->recalled.get(), b->recalled.get()));
        QVERIFY(areSame(a->stateFades.get(), b->stateFades.get()));
        QVERIFY(*a->lightCues == *b->lightCues);
        QCOMPARE(b->numbers->front().value, a->numbers->front().value);
    }
}

QByteArray takeBytes(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestTakeFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void whatWasPlayedIsThereAgain();
    void whatWasSpilledIsPartOfIt();
    void theSameRunIsTheSameFile();
    void nothingPlayedIsNoTake();
    void aFolderThatCannotBeMadeIsSaid();
    void itCanBeGivenUp();
    void whatIsCutOffIsRefused();
    void whatIsDamagedIsRefused();
    void whatMakesNoSenseIsNotShown_data();
    void whatMakesNoSenseIsNotShown();

private:
    [[nodiscard]] QString folder() const { return m_folder->filePath(QStringLiteral("a.takes")); }
    [[nodiscard]] model::Take written(const MotionCache& run) const;
    [[nodiscard]] CachePtr opened(const QByteArray& bytes) const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

model::Take TestTakeFile::written(const MotionCache& run) const
{
    auto take = behavior::writeTake(run, folder());
    if (!take) {
        qFatal("%s", take.error().message.c_str());
    }
    return take.value();
}

/// Null: refused, with a message that names the file.
CachePtr TestTakeFile::opened(const QByteArray& bytes) const
{
    const QString path = m_folder->filePath(QStringLiteral("odd.take"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.flush()) {
        qFatal("no room for the test");
    }
    const auto motion = behavior::openTake(model::MotionFile::open(path).value());
    if (!motion && motion.error().message.find("odd.take") == std::string::npos) {
        qFatal("%s", motion.error().message.c_str());
    }
    return motion ? motion.value() : nullptr;
}

void TestTakeFile::whatWasPlayedIsThereAgain()
{
    const CachePtr run = playedRun();
    const model::Take take = written(*run);
    QCOMPARE(take.people, static_cast<int>(kTakePeople));
    QCOMPARE(take.begin, 2.0);
    QCOMPARE(take.end, 2.0 + static_cast<double>(kTakeSteps - 1) / kTakeRate);
    const auto read = behavior::openTake(take.motion);
    QVERIFY(read.isOk());
    QCOMPARE(read.value()->extent().steps, run->extent().steps);
    compareTakes(run, read.value());
    // Columns that steps share are shared again.
    MotionReader reader(read.value());
    const auto early = reader.around(2.0 + 50.0 / kTakeRate).first->overrides;
    QCOMPARE(reader.around(2.0 + 90.0 / kTakeRate).first->overrides, early);
}

void TestTakeFile::whatWasSpilledIsPartOfIt()
{
    MotionBudget budget;
    budget.memoryBytes = 60'000; // the steps themselves
    budget.reserveBytes = 0;
    const CachePtr run = playedRun(budget);
    QVERIFY(run->bytes().second > 0);
    const auto read = behavior::openTake(written(*run).motion);
    QVERIFY(read.isOk());
    compareTakes(run, read.value());
}

void TestTakeFile::theSameRunIsTheSameFile()
{
    const model::Take first = written(*playedRun());
    const QByteArray bytes = takeBytes(first.motion->path());
    const model::Take second = written(*playedRun());
    QCOMPARE(second.file, first.file);
    QCOMPARE(takeBytes(second.motion->path()), bytes);
    QCOMPARE(QDir(folder()).entryList(QDir::Files).size(), 1);
    const model::Take other = written(*playedRun({}, [](SessionPose& pose) { pose.x[3] += 1.0F; }));
    QVERIFY(other.file != first.file);
}

void TestTakeFile::nothingPlayedIsNoTake()
{
    const auto none = behavior::writeTake(MotionCache(), folder());
    QVERIFY(!none);
    QVERIFY(none.error().message.find("Play first") != std::string::npos);
}

void TestTakeFile::aFolderThatCannotBeMadeIsSaid()
{
    QFile file(folder());
    QVERIFY(file.open(QIODevice::WriteOnly)); // in the way
    const auto none = behavior::writeTake(*playedRun(), folder());
    QVERIFY(!none);
    QVERIFY(none.error().message.find("a.takes") != std::string::npos);
}

void TestTakeFile::itCanBeGivenUp()
{
    int asked = 0;
    const auto none = behavior::writeTake(*playedRun(), folder(), [&asked](double share) {
        return share >= 0.0 && share <= 1.0 && ++asked < 6; // some pieces are written by then
    });
    QVERIFY(!none);
    QVERIFY(QDir(folder()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void TestTakeFile::whatIsCutOffIsRefused()
{
    const QByteArray bytes = takeBytes(written(*playedRun()).motion->path());
    QVERIFY(opened(bytes));
    for (qsizetype size = 0; size < bytes.size(); size += 1 + size / 9) {
        QVERIFY2(!opened(bytes.left(size)), qPrintable(QString::number(size)));
    }
    QVERIFY(!opened(bytes.left(bytes.size() - 1)));
    QVERIFY(!opened(bytes + QByteArray(1, 'x')));
}

/// Either at once, or where the damaged step is to be shown.
void TestTakeFile::whatIsDamagedIsRefused()
{
    const QByteArray bytes = takeBytes(written(*playedRun()).motion->path());
    std::mt19937 random(11);
    for (int round = 0; round < 300; ++round) {
        QByteArray bad = bytes;
        const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()));
        bad[at] = static_cast<char>(bad[at] ^ static_cast<char>(1U << random() % 8));
        const CachePtr take = opened(bad);
        int missing = take ? 0 : 1;
        for (std::uint64_t step = 0; step < kTakeSteps && take; ++step) {
            const double seconds = 2.0 + static_cast<double>(step) / kTakeRate;
            missing += MotionReader(take).around(seconds).first ? 0 : 1;
        }
        QVERIFY2(missing > 0, qPrintable(QString::number(at)));
    }
}

void TestTakeFile::whatMakesNoSenseIsNotShown_data()
{
    QTest::addColumn<Change>("change");
    const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
    constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
    row("no number", [](SessionPose& pose) { pose.x[2] = kNoNumber; });
    row("too far", [](SessionPose& pose) { pose.z[2] = 1e30F; });
    row("no angle", [](SessionPose& pose) { pose.headings[0] = kNoNumber; });
    row("somebody twice", [](SessionPose& pose) { pose.ids[3] = pose.ids[2]; });
    row("fade of nobody", [](SessionPose& pose) { pose.fades = {{900, {}, 2.0}}; });
    row("fades out of order", [](SessionPose& pose) { pose.fades = {{4, {}, 2.0}, {4, {}, 2.0}}; });
    row("fade without a time", [](SessionPose& pose) {
        pose.fades = {{4, {}, std::numeric_limits<double>::infinity()}};
    });
    row("too few seats", [](SessionPose& pose) {
        pose.hasSeats = true;
        pose.seats = {7};
    });
    row("no seats", [](SessionPose& pose) { pose.hasSeats = true; });
    row("heights for others", [](SessionPose& pose) {
        auto set = std::make_shared<behavior::OverrideColumns>();
        set->put(model::ColumnId::Height, {{3, 5}, std::vector<std::byte>(4)});
        pose.overrides = set;
    });
    row("heights without order", [](SessionPose& pose) {
        auto set = std::make_shared<behavior::OverrideColumns>();
        set->put(model::ColumnId::Height, {{5, 3}, std::vector<std::byte>(8)});
        pose.recalled = set;
    });
    row("heights that are none", [](SessionPose& pose) {
        auto set = std::make_shared<behavior::OverrideColumns>();
        set->put(model::ColumnId::Height, {{3}, std::vector<std::byte>(4, std::byte{0xFF})});
        pose.overrides = set;
    });
    row("lights without end", [](SessionPose& pose) {
        pose.lightCues =
            std::make_shared<const model::LightCues>(model::LightCues{{3, kNoNumber, 1.0F}});
    });
    row("changes over without a time", [](SessionPose& pose) {
        auto times = std::make_shared<behavior::FadeTimes>();
        times->ids = {1};
        times->begins = {std::numeric_limits<double>::quiet_NaN()};
        times->areWhole = {0};
        auto column = std::make_shared<behavior::FadeColumn>();
        column->column = model::ColumnId::Height;
        column->times = times;
        column->bytes.resize(4);
        pose.stateFades =
            std::make_shared<const behavior::FadeColumns>(behavior::FadeColumns{column});
    });
    row("a time that is none",
        [](SessionPose& pose) { pose.seconds += pose.step > 50 ? 1e12 : 0.0; });
}

/// As a file that somebody made: all checksums are right.
void TestTakeFile::whatMakesNoSenseIsNotShown()
{
    QFETCH(const Change, change);
    const CachePtr run = playedRun({}, change);
    const QString path = m_folder->filePath(QStringLiteral("made.takes"));
    const auto take = behavior::writeTake(*run, path);
    if (!take) {
        return;
    }
    const auto read = behavior::openTake(take.value().motion);
    if (read) {
        QVERIFY(!MotionReader(read.value()).around(2.0 + 60.0 / kTakeRate).first);
        return;
    }
    QVERIFY(read.error().message.find(".take") != std::string::npos);
}

CROWD_TEST(TestTakeFile)
#include "tst_TakeFile.moc"
