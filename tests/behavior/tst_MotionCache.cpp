// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <random>

#include <QtTest/QTest>

#include "behavior/session/FrameBlocks.h"
#include "behavior/session/MotionCache.h"
#include "behavior/session/MotionReader.h"
#include "behavior/session/PackKernel.h"
#include "behavior/session/PoseBytes.h"
#include "model/base/Random.h"
#include "tests/program/Test.h"

using namespace crowd;
using behavior::MotionBudget;
using behavior::MotionCache;
using behavior::MotionReader;
using behavior::PoseColumns;
using behavior::PoseWriter;
using behavior::SessionPose;
using behavior::SessionPosePtr;

namespace {

constexpr double kRate = 30.0;
/// Nothing but the last piece fits.
constexpr std::uint64_t kNoMemory = 1;

/// People who go on, some of whom come and leave, change clips and seats.
SessionPosePtr poseOf(std::uint64_t step, std::size_t people)
{
    auto pose = std::make_shared<SessionPose>();
    pose->step = step;
    pose->seconds = static_cast<double>(step) / kRate;
    pose->gone = step / 7;
    pose->hasSeats = step > 50;
    const std::size_t count = people - (step > 70 ? 3 : 0);
    for (std::size_t i = 0; i < count; ++i) {
        const auto time = static_cast<float>(pose->seconds);
        const auto own = static_cast<float>(i);
        pose->ids.push_back(static_cast<model::IndividualId>(3 * i + 1));
        pose->x.push_back(own + time * 1.31F);
        pose->y.push_back(i % 5 == 0 ? -0.0F : 0.25F);
        pose->z.push_back(own * 0.5F - time * (0.7F + 0.001F * own));
        pose->headings.push_back(0.3F + 0.01F * std::sin(time + own));
        pose->clips.push_back(static_cast<std::uint16_t>((i + step / 40) % 700));
        pose->rates.push_back(1.0F + 0.001F * own);
        pose->clipSeconds.push_back(1.2F);
        pose->places.push_back(std::fmod(time / 1.2F, 1.0F));
        pose->flags.push_back(static_cast<std::uint8_t>(1 + i % 2));
        if (pose->hasSeats) {
            pose->seats.push_back(static_cast<model::SeatId>(i + 9));
        }
        if ((i + step) % 4 == 0) {
            pose->fades.push_back(
                {static_cast<std::uint32_t>(i),
                 {static_cast<std::uint16_t>(i % 3), i % 2 == 0, 1.5F, 2.0F, 0.25},
                 pose->seconds - 0.1});
        }
    }
    pose->lit = {1};
    return pose;
}

template<typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool areSameFades(const std::vector<behavior::PoseFade>& a,
                  const std::vector<behavior::PoseFade>& b)
{
    return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
        return one.person == other.person && one.from.clip == other.from.clip &&
               one.from.isLooped == other.from.isLooped && one.from.rate == other.from.rate &&
               one.from.clipSeconds == other.from.clipSeconds &&
               one.from.place == other.from.place && one.begin == other.begin;
    });
}

bool areSame(const SessionPose& a, const SessionPose& b)
{
    return a.step == b.step && a.seconds == b.seconds && a.gone == b.gone &&
           a.hasSeats == b.hasSeats && a.lit == b.lit && a.ids == b.ids && sameBits(a.x, b.x) &&
           sameBits(a.y, b.y) && sameBits(a.z, b.z) && sameBits(a.headings, b.headings) &&
           a.clips == b.clips && sameBits(a.rates, b.rates) &&
           sameBits(a.clipSeconds, b.clipSeconds) && sameBits(a.places, b.places) &&
           a.flags == b.flags && a.seats == b.seats && areSameFades(a.fades, b.fades);
}

constexpr std::size_t kPosed = 60;
constexpr std::uint64_t kSteps = 200;

using CachePtr = std::shared_ptr<MotionCache>;

void fill(MotionCache& cache, std::uint64_t steps = kSteps, std::size_t people = kPosed)
{
    for (std::uint64_t step = 0; step < steps; ++step) {
        cache.add(poseOf(step, people));
    }
}

/// Every step that is there, in some order.
void compareAll(const CachePtr& cache, std::uint64_t first, std::uint64_t increment)
{
    MotionReader reader(cache);
    const std::uint64_t count = kSteps - first;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t step = first + i * increment % count;
        const auto [now, next] = reader.around((static_cast<double>(step) + 0.5) / kRate);
        QVERIFY2(now && next, qPrintable(QString::number(step)));
        QVERIFY(areSame(*now, *poseOf(step, kPosed)));
        QVERIFY(areSame(*next, *poseOf(std::min(step + 1, kSteps - 1), kPosed)));
    }
}

std::vector<std::byte> packedBytes(PoseWriter& writer, const SessionPose& pose,
                                   const SessionPose* before)
{
    const auto bytes = writer.packed(pose, before).bytes;
    return {bytes.begin(), bytes.end()};
}

} // namespace

class TestMotionCache : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsThereAtFirst();
    void stepsAreAsTheyWere();
    void timesOutsideAreTheNearestSteps();
    void whatDoesNotFitGoesToDisk();
    void whatDoesNotFitThereIsForgotten();
    void aFullDiskForgetsTheEarliest();
    void fewBytesAreKept();
    void theSameTwice();
    void whatIsKeptStays();
    void processorsPackTheSame();
    void damagedBytesAreNoPose_data();
    void damagedBytesAreNoPose();
};

void TestMotionCache::nothingIsThereAtFirst()
{
    const auto cache = std::make_shared<MotionCache>();
    QCOMPARE(cache->extent().steps, std::size_t{0});
    QVERIFY(!MotionReader(cache).around(0.0).first);
    cache->add(poseOf(0, 0)); // nor does anybody live here
    const auto [now, next] = MotionReader(cache).around(5.0);
    QVERIFY(now && now == next && now->ids.empty());
    cache->add(poseOf(1, 0));
    QVERIFY(MotionReader(cache).around(5.0).first->ids.empty());
    QCOMPARE(MotionReader(cache).around(5.0).first->step, std::uint64_t{1});
}

void TestMotionCache::stepsAreAsTheyWere()
{
    const auto cache = std::make_shared<MotionCache>();
    fill(*cache);
    QCOMPARE(cache->extent().steps, std::size_t{kSteps});
    compareAll(cache, 0, 1);
    compareAll(cache, 0, kSteps - 1); // backwards
    compareAll(cache, 0, 77);
}

void TestMotionCache::timesOutsideAreTheNearestSteps()
{
    const auto cache = std::make_shared<MotionCache>();
    fill(*cache);
    QCOMPARE(MotionReader(cache).around(-3.0).first->step, std::uint64_t{0});
    const auto [last, next] = MotionReader(cache).around(1000.0);
    QCOMPARE(last->step, kSteps - 1);
    QVERIFY(last == next);
    // A step's own time shows that step.
    QCOMPARE(MotionReader(cache).around(40.0 / kRate).first->step, std::uint64_t{40});
    QCOMPARE(cache->extent().last, static_cast<double>(kSteps - 1) / kRate);
}

void TestMotionCache::whatDoesNotFitGoesToDisk()
{
    MotionBudget budget;
    budget.memoryBytes = 150'000; // the steps themselves, a piece or two
    budget.reserveBytes = 0;
    const auto cache = std::make_shared<MotionCache>(budget);
    fill(*cache);
    QVERIFY(cache->bytes().second > 0);
    QCOMPARE(cache->extent().steps, std::size_t{kSteps});
    compareAll(cache, 0, 1);
    compareAll(cache, 0, 77);
}

void TestMotionCache::whatDoesNotFitThereIsForgotten()
{
    MotionBudget budget;
    budget.memoryBytes = 150'000;
    budget.diskBytes = 30'000;
    budget.reserveBytes = 0;
    const auto cache = std::make_shared<MotionCache>(budget);
    fill(*cache);
    const auto [first, last, steps] = cache->extent();
    QVERIFY(steps < kSteps && steps > 32);
    QVERIFY(cache->bytes().second <= budget.diskBytes);
    compareAll(cache, kSteps - steps, 1);
    QCOMPARE(MotionReader(cache).around(0.0).first->seconds, first);
}

void TestMotionCache::aFullDiskForgetsTheEarliest()
{
    MotionBudget budget;
    budget.memoryBytes = kNoMemory;
    budget.reserveBytes = ~std::uint64_t{0} / 2; // no disk has so much
    const auto cache = std::make_shared<MotionCache>(budget);
    fill(*cache);
    QCOMPARE(cache->bytes().second, std::uint64_t{0});
    const std::size_t steps = cache->extent().steps;
    QVERIFY(steps > 0 && steps <= 32);
    compareAll(cache, kSteps - steps, 1);
    budget.reserveBytes = 0;
    budget.folder = QStringLiteral("/nonexistent/folder");
    MotionCache nowhere(budget);
    fill(nowhere);
    QVERIFY(nowhere.extent().steps > 0);
}

/// Of forty bytes each most stay.
void TestMotionCache::fewBytesAreKept()
{
    constexpr std::size_t kMany = 2000;
    const auto cache = std::make_shared<MotionCache>();
    fill(*cache, 64, kMany);
    const auto each = static_cast<double>(cache->bytes().first) / (64.0 * kMany);
    QVERIFY2(each < 24.0, qPrintable(QString::number(each)));
}

/// Also when what was kept before is let go, and where one is larger than the others together.
void TestMotionCache::whatIsKeptStays()
{
    behavior::FrameBlocks blocks;
    const auto piece = [](std::size_t number) {
        const std::size_t size = number == 50 ? 5'000'000 : 1 + number * 977;
        return std::vector<std::byte>(size, static_cast<std::byte>(number));
    };
    std::deque<behavior::FrameBlocks::Bytes> kept;
    constexpr std::size_t kKept = 30;
    for (std::size_t number = 0; number < 100; ++number) {
        kept.push_back(blocks.keep(piece(number)));
        if (kept.size() > kKept) {
            kept.pop_front();
        }
    }
    for (std::size_t i = 0; i < kKept; ++i) {
        const auto bytes = piece(100 - kKept + i);
        QVERIFY(std::equal(bytes.begin(), bytes.end(), kept[i].get()));
    }
    QVERIFY(blocks.keep({}) != nullptr);
}

void TestMotionCache::theSameTwice()
{
    const SessionPosePtr before = poseOf(60, kPosed);
    const SessionPosePtr now = poseOf(61, kPosed);
    PoseWriter writer;
    PoseWriter other;
    QVERIFY(other.packed(*before, nullptr).bytes.size() > 100); // what was done before is nothing
    QVERIFY(writer.packed(*now, before.get()).isDifference);
    QCOMPARE(packedBytes(writer, *now, before.get()), packedBytes(other, *now, before.get()));
    QVERIFY(!writer.packed(*poseOf(71, kPosed), now.get()).isDifference); // fewer
}

/// Whatever instructions there are.
void TestMotionCache::processorsPackTheSame()
{
    constexpr std::size_t kGroups = 500;
    std::vector<std::uint32_t> now(kGroups * 4);
    std::vector<std::uint32_t> before(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) { // of every length, and borders between them
        const auto random = static_cast<std::uint32_t>(model::mixBits(i));
        const std::uint32_t borders[] = {0U, 0xFFFFU, 0x10000U, 0xFFFFFFU, 0x1000000U, ~0U};
        before[i] = random;
        now[i] = i % 3 == 0 ? random ^ borders[i / 3 % 6] : random ^ (random >> (i % 32));
    }
    const auto* values = reinterpret_cast<const std::byte*>(now.data());
    for (const bool isCompared : {false, true}) {
        const auto* then = isCompared ? reinterpret_cast<const std::byte*>(before.data()) : nullptr;
        std::vector<std::byte> packed[2];
        for (const bool isPlain : {false, true}) {
            std::vector<std::byte>& bytes = packed[isPlain ? 1 : 0];
            bytes.resize(kGroups * 17 + behavior::kPackedGroupBytes);
            const behavior::PackPlaces end = behavior::packGroups(
                {bytes.data(), bytes.data() + kGroups}, values, then, kGroups, isPlain);
            QVERIFY(end.codes == bytes.data() + kGroups);
            bytes.resize(static_cast<std::size_t>(end.data - bytes.data()));
        }
        QVERIFY(packed[0].size() > kGroups * 2);
        QVERIFY(packed[0] == packed[1]);
    }
}

void TestMotionCache::damagedBytesAreNoPose_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("cut off") << 0;
    QTest::newRow("one bit") << 1;
    QTest::newRow("empty") << 2;
    QTest::newRow("huge counts") << 3;
    QTest::newRow("against others") << 4;
}

void TestMotionCache::damagedBytesAreNoPose()
{
    QFETCH(const int, kind);
    const SessionPosePtr before = poseOf(60, kPosed);
    PoseWriter writer;
    const auto bytes = packedBytes(writer, *poseOf(61, kPosed), before.get());
    const auto columnsOf = [](const SessionPose& pose) {
        PoseColumns columns;
        if (!columns.read(PoseWriter().packed(pose, nullptr).bytes, false)) {
            qFatal("what was written is not read");
        }
        return columns;
    };
    QVERIFY(columnsOf(*before).read(bytes, true));
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::byte> bad = bytes;
        switch (kind) {
        case 0:
            bad.resize(random() % bytes.size());
            break;
        case 1:
            bad[random() % bytes.size()] ^=
                std::byte{static_cast<unsigned char>(1U << random() % 8)};
            break;
        case 2:
            bad.clear();
            break;
        case 3:
            std::fill_n(bad.begin(), 4 + random() % 8, std::byte{0xFF});
            break;
        default:
            break;
        }
        PoseColumns columns = columnsOf(*poseOf(60, kPosed - (kind == 4 ? 1 : 0)));
        QVERIFY(!columns.read(bad, true));
    }
}

CROWD_TEST(TestMotionCache)
#include "tst_MotionCache.moc"
