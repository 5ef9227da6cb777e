// SPDX-License-Identifier: MIT
#include "model/brush/Sampler.h"

#include <numeric>

#include <QtTest/QTest>

#include "model/base/Random.h"
#include "model/brush/BrushSettings.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

PointerInput inputAt(glm::ivec2 grid, double time, float pressure)
{
    PointerInput input;
    input.grid = grid;
    input.timeSeconds = time;
    input.shownSeconds = 3.0 + time;
    input.pressure = pressure;
    return input;
}

/// A way of long straight pieces between grid points, with pauses.
std::vector<PointerInput> randomWay(std::uint64_t key)
{
    std::vector<PointerInput> way;
    glm::ivec2 at(100000, 80000);
    double time = 12.345;
    for (std::uint64_t i = 0; i < 40; ++i) {
        way.push_back(inputAt(at, time, unitFloat(hashKeys(key, i, 1))));
        // Multiples of 24 leave whole grid points to split at.
        at.x += 24 * (static_cast<int>(hashKeys(key, i, 2) % 401) - 200);
        at.y += 24 * (static_cast<int>(hashKeys(key, i, 3) % 401) - 200);
        time += 0.004 + 0.1 * unitDouble(hashKeys(key, i, 4));
    }
    return way;
}

/// The same way with grid points inserted, time and pressure linear between.
std::vector<PointerInput> splitWay(const std::vector<PointerInput>& way, std::uint64_t key)
{
    std::vector<PointerInput> split{way.front()};
    for (std::size_t i = 1; i < way.size(); ++i) {
        const PointerInput& a = way[i - 1];
        const PointerInput& b = way[i];
        const glm::ivec2 move = b.grid - a.grid;
        const int steps = std::gcd(move.x, move.y);
        for (int k = 1; k < steps; ++k) {
            if (hashKeys(key, i, k) % 5 != 0) {
                continue;
            }
            const double share = static_cast<double>(k) / steps;
            PointerInput between = inputAt(a.grid + move / steps * k, 0.0, 1.0F);
            between.timeSeconds = a.timeSeconds + (b.timeSeconds - a.timeSeconds) * share;
            between.shownSeconds = a.shownSeconds + (b.shownSeconds - a.shownSeconds) * share;
            between.pressure = static_cast<float>(
                a.pressure + (static_cast<double>(b.pressure) - a.pressure) * share);
            split.push_back(between);
        }
        split.push_back(b);
    }
    return split;
}

std::vector<Dab> dabsOf(Sampler sampler, const std::vector<PointerInput>& way)
{
    std::vector<Dab> dabs;
    for (const PointerInput& input : way) {
        const std::vector<Dab> added = sampler.add(input);
        dabs.insert(dabs.end(), added.begin(), added.end());
    }
    return dabs;
}

void compareDabs(const std::vector<Dab>& a, const std::vector<Dab>& b)
{
    QCOMPARE(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        QCOMPARE(a[i].index, b[i].index);
        QVERIFY2(a[i].grid == b[i].grid, qPrintable(QString::number(i)));
        QVERIFY(a[i].pressure == b[i].pressure);
        QVERIFY(a[i].shownSeconds == b[i].shownSeconds);
        QCOMPARE(a[i].points, b[i].points);
    }
}

} // namespace

class tst_BrushSampler : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void spacesDabsEvenly();
    void carriesTheRestRoundABend();
    void splittingAWayChangesNothing_data();
    void splittingAWayChangesNothing();
    void sprayTicksFollowTheClock();
    void aStillPointerGoesOnSpraying();
    void pressureScalesTheRate();
    void drawsTheDistribution();
};

void tst_BrushSampler::spacesDabsEvenly()
{
    const auto dabs = dabsOf(Sampler::alongWay(10.0), {PointerInput::at({0.0, 0.0}, 0.0),
                                                       PointerInput::at({35.0, 0.0}, 1.0)});
    QCOMPARE(dabs.size(), std::size_t{4});
    for (std::size_t i = 0; i < dabs.size(); ++i) {
        QCOMPARE(dabs[i].pixels().x, 10.0 * static_cast<double>(i));
        QCOMPARE(dabs[i].index, static_cast<std::uint32_t>(i));
    }
}

void tst_BrushSampler::carriesTheRestRoundABend()
{
    const auto dabs = dabsOf(Sampler::alongWay(10.0),
                             {PointerInput::at({0.0, 0.0}, 0.0), PointerInput::at({7.0, 0.0}, 1.0),
                              PointerInput::at({7.0, 14.0}, 2.0)});
    QCOMPARE(dabs.size(), std::size_t{3});
    QCOMPARE(dabs[1].pixels().x, 7.0);
    QCOMPARE(dabs[1].pixels().y, 3.0);
    QCOMPARE(dabs[2].pixels().y, 13.0);
}

void tst_BrushSampler::splittingAWayChangesNothing_data()
{
    QTest::addColumn<double>("spacing");
    QTest::addColumn<quint64>("key");
    for (quint64 key = 1; key <= 20; ++key) {
        QTest::addRow("dabs every %d pixels, way %d", 7, static_cast<int>(key)) << 7.3 << key;
        QTest::addRow("spray, way %d", static_cast<int>(key)) << 0.0 << key;
    }
}

void tst_BrushSampler::splittingAWayChangesNothing()
{
    QFETCH(double, spacing);
    QFETCH(quint64, key);
    const std::vector<PointerInput> way = randomWay(key);
    const std::vector<PointerInput> split = splitWay(way, key);
    QVERIFY(split.size() > way.size() + 20);
    const Sampler sampler = spacing > 0.0 ? Sampler::alongWay(spacing) : Sampler::spray(37.0, true);
    const std::vector<Dab> dabs = dabsOf(sampler, way);
    QVERIFY(dabs.size() > 50);
    compareDabs(dabs, dabsOf(sampler, split));
}

void tst_BrushSampler::sprayTicksFollowTheClock()
{
    const auto dabs =
        dabsOf(Sampler::spray(60.0, false), {PointerInput::at({0.0, 0.0}, 5.0),
                                             PointerInput::at({120.0, 0.0}, 5.0 + 6.5 / 60.0)});
    QCOMPARE(dabs.size(), std::size_t{7});
    int points = 0;
    for (const Dab& dab : dabs) {
        points += dab.points;
    }
    QCOMPARE(points, 7);
    QVERIFY(std::abs(dabs[3].pixels().x - 120.0 * 3.0 / 6.5) < 0.01);
}

void tst_BrushSampler::aStillPointerGoesOnSpraying()
{
    std::vector<PointerInput> inputs;
    for (int tick = 0; tick <= 60; ++tick) {
        inputs.push_back(PointerInput::at({50.0, 50.0}, 2.0 + tick / 60.0));
    }
    int points = 0;
    for (const Dab& dab : dabsOf(Sampler::spray(20.0, false), inputs)) {
        points += dab.points;
    }
    QVERIFY2(points >= 20 && points <= 21, qPrintable(QString::number(points)));
}

void tst_BrushSampler::pressureScalesTheRate()
{
    const auto pointsAt = [](float pressure) {
        PointerInput press = PointerInput::at({0.0, 0.0}, 0.0);
        PointerInput later = PointerInput::at({0.0, 0.0}, 1.0);
        press.pressure = later.pressure = pressure;
        int points = 0;
        for (const Dab& dab : dabsOf(Sampler::spray(80.0, true), {press, later})) {
            points += dab.points;
        }
        return points;
    };
    QVERIFY(std::abs(pointsAt(1.0F) - 81) <= 1);
    QVERIFY(std::abs(pointsAt(0.5F) - 41) <= 1);
}

void tst_BrushSampler::drawsTheDistribution()
{
    DistributionCurve curve;
    QCOMPARE(curve.sample(0.25), 0.25);
    curve.weights.fill(0.0F);
    QCOMPARE(curve.sample(0.7), 0.7);
    curve.weights[4] = 1.0F;
    curve.weights[12] = 3.0F;
    QCOMPARE(curve.sample(0.125), (4.0 + 0.5) / 16.0);
    QCOMPARE(curve.sample(0.25 + 0.375), (12.0 + 0.5) / 16.0);
}

CROWD_TEST(tst_BrushSampler)
#include "tst_BrushSampler.moc"
