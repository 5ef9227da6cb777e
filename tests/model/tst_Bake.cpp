// SPDX-License-Identifier: MIT
#include <QtTest/QtTest>

#include <atomic>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "model/bake/ClipBaker.h"
#include "model/bake/DrawLevels.h"
#include "model/bake/KeyframeStore.h"
#include "model/bake/KeyframeTime.h"
#include "model/bake/Octahedral.h"
#include "model/base/Random.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::model;

namespace {

/// A bumpy tube 1.8 m high that bends at half its height, with two influences a vertex, and
/// `clips` clips of the given length.
TemplatePtr makeTube(float seconds, int clips = 1, int rings = 24)
{
    auto asset = std::make_shared<Template>();
    asset->nodes.resize(2);
    asset->nodes[1].parent = 0;
    asset->nodes[1].translation = {0.0F, 0.9F, 0.0F};
    asset->bones = {{0, glm::mat4(1.0F)},
                    {1, glm::translate(glm::mat4(1.0F), glm::vec3(0.0F, -0.9F, 0.0F))}};
    constexpr int kSegments = 12;
    Mesh mesh;
    mesh.influencesPerVertex = 2;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment < kSegments; ++segment) {
            const float angle = 6.2831853F * static_cast<float>(segment) / kSegments;
            const float y = 1.8F * static_cast<float>(ring) / static_cast<float>(rings);
            const float bump = 0.2F + 0.02F * unitFloat(hashKeys(ring, segment));
            mesh.positions.emplace_back(bump * std::sin(angle), y, bump * std::cos(angle));
            mesh.normals.emplace_back(std::sin(angle), 0.0F, std::cos(angle));
            mesh.uv.emplace_back(0.0F);
            mesh.colors.emplace_back(255, 255, 255, 255);
            const float upper = std::clamp(y - 0.4F, 0.0F, 1.0F);
            mesh.bones.insert(mesh.bones.end(), {0, 1});
            mesh.weights.insert(mesh.weights.end(), {1.0F - upper, upper});
        }
    }
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < kSegments; ++segment) {
            const auto a = static_cast<std::uint32_t>(ring * kSegments + segment);
            const auto b = static_cast<std::uint32_t>(ring * kSegments + (segment + 1) % kSegments);
            mesh.indices.insert(mesh.indices.end(),
                                {a, b, a + kSegments, a + kSegments, b, b + kSegments});
        }
    }
    mesh.submeshes = {{0, -1, 0, static_cast<std::uint32_t>(mesh.indices.size())}};
    asset->levels = {mesh};
    asset->slots = {{"all", true, true, {MaterialChoice{}}}};
    for (int i = 0; i < clips; ++i) {
        Clip clip;
        clip.name = "bend " + std::to_string(i);
        clip.startSeconds = 0.25F;
        clip.seconds = seconds;
        const float half = std::sin(0.5F);
        clip.channels.push_back({1,
                                 ChannelPath::Rotation,
                                 Interpolation::Linear,
                                 {0.25F, 0.25F + seconds},
                                 {0.0F, 0.0F, 0.0F, 1.0F, half, 0.0F, 0.0F, std::cos(0.5F)}});
        asset->clips.push_back(std::move(clip));
    }
    return asset;
}

} // namespace

/// Keyframes: when they are, what is in them, and how the store hands them out.
class TestBake : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keyframesLieOnTheirTimes_data();
    void keyframesLieOnTheirTimes();
    void placesAreBetweenKeyframes_data();
    void placesAreBetweenKeyframes();
    void octahedralNormalsAreCloseAndAxesExact();
    void packingKeepsATenthOfAMillimetre();
    void lastKeyframeIsTheEndOfTheClip();
    void boundsHoldEveryVertex();
    void bakingTwiceGivesTheSameBytes();
    void storesShareWhatOneHasBaked();
    void firstKeyframeIsThereAtOnce();
    void poseIsCompleteAtOnce();
    void budgetKeepsTheFirstKeyframe();
    void forgottenTemplatesFreeTheBudget();
    void whatDidNotFitIsBakedWhenThereIsSpace();
    void aLargerBudgetBakesWhatDidNotFit();
    void pausingGivesUpUntilItIsAskedForAgain();
    void callbackComesForEachClip();
    void bakingEndsWithTheKeyframeAtWhichItIsCancelled();
    void storeMayDieWhileBaking();
    void loneLevelIsSimplified();
    void smallMeshesStay();
};

void TestBake::keyframesLieOnTheirTimes_data()
{
    QTest::addColumn<float>("seconds");
    QTest::addColumn<int>("count");
    QTest::addColumn<float>("lastButOne");
    QTest::newRow("a second") << 1.0F << 33 << 31.0F / 32.0F;
    QTest::newRow("a little more than a keyframe's multiple") << 1.01F << 33 << 31.0F / 32.0F;
    QTest::newRow("a little less") << 1.025F << 34 << 1.0F;
    QTest::newRow("one interval") << 0.03125F << 2 << 0.0F;
    QTest::newRow("two and a half intervals") << 0.078125F << 4 << 0.0625F;
}

void TestBake::keyframesLieOnTheirTimes()
{
    QFETCH(float, seconds);
    QFETCH(int, count);
    QFETCH(float, lastButOne);
    Clip clip;
    clip.seconds = seconds;
    QCOMPARE(clip.keyframeCount(), count);
    for (int k = 0; k + 1 < count; ++k) {
        QCOMPARE(clip.keyframeSeconds(k), static_cast<float>(k) / 32.0F);
    }
    QCOMPARE(clip.keyframeSeconds(count - 2), lastButOne);
    QCOMPARE(clip.keyframeSeconds(count - 1), seconds);
    QVERIFY(clip.keyframeSeconds(count - 2) < seconds);
}

void TestBake::placesAreBetweenKeyframes_data()
{
    QTest::addColumn<float>("seconds");
    QTest::addColumn<float>("phase");
    QTest::addColumn<int>("first");
    QTest::addColumn<float>("blend");
    QTest::newRow("start") << 1.0F << 0.0F << 0 << 0.0F;
    QTest::newRow("half way between two") << 1.0F << 1.5F / 32.0F << 1 << 0.5F;
    QTest::newRow("last interval") << 1.0F << 31.25F / 32.0F << 31 << 0.25F;
    QTest::newRow("end") << 1.0F << 1.0F << 31 << 1.0F;
    QTest::newRow("longer last interval") << 1.25F / 32.0F << 0.5F << 0 << 0.5F;
    QTest::newRow("shorter last interval") << 1.75F / 32.0F << 1.375F / 1.75F << 1 << 0.5F;
    QTest::newRow("pose") << 0.0F << 0.7F << 0 << 0.0F;
}

void TestBake::placesAreBetweenKeyframes()
{
    QFETCH(float, seconds);
    QFETCH(float, phase);
    QFETCH(int, first);
    QFETCH(float, blend);
    Clip clip;
    clip.seconds = seconds;
    const KeyframePlace place = keyframePlace(clip, phase);
    QCOMPARE(place.first, first);
    QVERIFY(place.second < clip.keyframeCount());
    QVERIFY2(std::abs(place.blend - blend) < 1e-4F, qPrintable(QString::number(place.blend)));
}

void TestBake::octahedralNormalsAreCloseAndAxesExact()
{
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                 glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)}) {
        QVERIFY(octahedralDecode(octahedralEncode(axis)) == axis);
    }
    float worst = 1.0F;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 n =
            glm::normalize(glm::vec3(unitFloat(hashKeys(i, 0)), unitFloat(hashKeys(i, 1)),
                                     unitFloat(hashKeys(i, 2))) -
                           0.5F + glm::vec3(1e-4F));
        worst = std::min(worst, glm::dot(octahedralDecode(octahedralEncode(n)), n));
    }
    QVERIFY2(worst > std::cos(glm::radians(1.0F)),
             qPrintable(QString::number(glm::degrees(std::acos(worst)))));
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const std::uint16_t up = octahedralEncode(glm::vec3(0, 1, 0));
    for (const glm::vec3 odd : {glm::vec3(0), glm::vec3(kNan, 0, 1), glm::vec3(0, kInfinity, 0)}) {
        QCOMPARE(octahedralEncode(odd), up);
    }
}

void TestBake::packingKeepsATenthOfAMillimetre()
{
    const TemplatePtr asset = makeTube(1.3F);
    const BakedClipPtr baked = bakeClip(*asset, 0, asset->clips[0].keyframeCount());
    float worst = 0.0F;
    for (int k = 0; k < baked->keyframes; ++k) {
        const std::vector<glm::vec3> exact = exactKeyframe(*asset, 0, k).positions;
        for (std::size_t v = 0; v < exact.size(); ++v) {
            worst = std::max(worst, glm::length(baked->position(0, k, v) - exact[v]));
        }
    }
    QVERIFY2(worst <= 0.0001F, qPrintable(QString::number(worst)));
}

void TestBake::lastKeyframeIsTheEndOfTheClip()
{
    const TemplatePtr asset = makeTube(1.01F);
    const int last = asset->clips[0].keyframeCount() - 1;
    const std::vector<glm::vec3> end = exactKeyframe(*asset, 0, last).positions;
    // The tube's top, bent by one radian about X at 0.9 m.
    const glm::vec3 rest = asset->levels[0].positions.back();
    const float angle = 1.0F;
    const glm::vec3 about(rest.x, rest.y - 0.9F, rest.z);
    const glm::vec3 bent(about.x, 0.9F + about.y * std::cos(angle) - about.z * std::sin(angle),
                         about.y * std::sin(angle) + about.z * std::cos(angle));
    const float upper = std::clamp(rest.y - 0.4F, 0.0F, 1.0F);
    QVERIFY(glm::length(end.back() - glm::mix(rest, bent, upper)) < 1e-5F);
}

void TestBake::boundsHoldEveryVertex()
{
    const TemplatePtr asset = makeTube(1.0F);
    const BakedClipPtr baked = bakeClip(*asset, 0, 33);
    QCOMPARE(baked->keyframeBounds.size(), std::size_t{33});
    for (int k = 0; k < 33; k += 8) {
        const Bounds& box = baked->keyframeBounds[static_cast<std::size_t>(k)];
        const ExactKeyframe exact = exactKeyframe(*asset, 0, k);
        for (const glm::vec3& p : exact.positions) {
            QVERIFY(glm::all(glm::greaterThanEqual(p, box.low)));
            QVERIFY(glm::all(glm::lessThanEqual(p, box.high)));
        }
        QVERIFY(glm::all(glm::greaterThanEqual(box.low, baked->bounds.low)));
        QVERIFY(glm::all(glm::lessThanEqual(box.high, baked->bounds.high)));
    }
}

void TestBake::bakingTwiceGivesTheSameBytes()
{
    const TemplatePtr asset = makeTube(1.0F);
    const BakedClipPtr alone = bakeClip(*asset, 0, 33);
    KeyframeStore store;
    (void)store.clip(asset, 0);
    store.waitForAll();
    const BakedClipPtr stored = store.clip(asset, 0).clip;
    QCOMPARE(stored->levels[0].size(), alone->levels[0].size());
    QVERIFY(std::memcmp(stored->levels[0].data(), alone->levels[0].data(),
                        alone->levels[0].size() * sizeof(PackedVertex)) == 0);
}

void TestBake::storesShareWhatOneHasBaked()
{
    const TemplatePtr asset = makeTube(1.0F, 2);
    KeyframeStore other;
    {
        KeyframeStore first;
        (void)first.clip(asset, 0);
        (void)first.clip(asset, 1);
        first.waitForAll();
        QVERIFY(other.clip(asset, 0).isComplete);
        QVERIFY(other.clip(asset, 0).clip == first.clip(asset, 0).clip);
        QCOMPARE(other.progress().bytes, bakedBytes(*asset, 0));
        QVERIFY(!other.clip(makeTube(1.0F, 2), 0).isComplete); // as long, but another one
    }
    KeyframeStore later;
    QVERIFY(later.clip(asset, 0).isComplete);
    QVERIFY(!later.clip(asset, 1).isComplete); // nobody kept it
    later.waitForAll();
    QVERIFY(later.clip(asset, 1).isComplete);
}

void TestBake::firstKeyframeIsThereAtOnce()
{
    const TemplatePtr asset = makeTube(2.0F, 3);
    KeyframeStore store;
    std::vector<KeyframeStore::Entry> entries;
    for (int clip = 0; clip < 3; ++clip) {
        entries.push_back(store.clip(asset, clip));
        QVERIFY(entries.back().clip != nullptr);
    }
    QCOMPARE(entries[2].clip->keyframes, 1);
    QVERIFY(!entries[2].isComplete);
    store.waitForAll();
    for (int clip = 0; clip < 3; ++clip) {
        const KeyframeStore::Entry entry = store.clip(asset, clip);
        QVERIFY(entry.isComplete);
        QCOMPARE(entry.clip->keyframes, 65);
    }
    QCOMPARE(store.progress().finishedClips, 3);
    QCOMPARE(store.progress().pendingClips, 0);
    QCOMPARE(store.version(), std::uint64_t{3});
}

void TestBake::poseIsCompleteAtOnce()
{
    const TemplatePtr asset = makeTube(0.0F);
    KeyframeStore store;
    QVERIFY(store.clip(asset, 0).isComplete);
    QCOMPARE(store.progress().pendingClips, 0);
}

void TestBake::budgetKeepsTheFirstKeyframe()
{
    const TemplatePtr asset = makeTube(2.0F, 3);
    const std::size_t one = bakedBytes(*asset, 0);
    KeyframeStore store(one * 2);
    for (int clip = 0; clip < 3; ++clip) {
        (void)store.clip(asset, clip);
    }
    store.waitForAll();
    QVERIFY(store.clip(asset, 0).isComplete);
    QVERIFY(store.clip(asset, 1).isComplete);
    QVERIFY(!store.clip(asset, 2).isComplete);
    QCOMPARE(store.clip(asset, 2).clip->keyframes, 1);
    QVERIFY(store.progress().isBudgetReached);
    QVERIFY(store.progress().bytes < one * 2 + one / 10); // first keyframes are always there
}

void TestBake::forgottenTemplatesFreeTheBudget()
{
    TemplatePtr asset = makeTube(2.0F);
    KeyframeStore store(bakedBytes(*asset, 0) + 10000);
    (void)store.clip(asset, 0);
    store.waitForAll();
    asset = nullptr;
    const TemplatePtr next = makeTube(2.0F);
    (void)store.clip(next, 0);
    store.waitForAll();
    QVERIFY(store.clip(next, 0).isComplete);
}

void TestBake::whatDidNotFitIsBakedWhenThereIsSpace()
{
    TemplatePtr first = makeTube(2.0F);
    const TemplatePtr second = makeTube(2.0F);
    KeyframeStore store(bakedBytes(*first, 0) + 10000);
    (void)store.clip(first, 0);
    QVERIFY(!store.clip(second, 0).isComplete);
    store.waitForAll();
    QVERIFY(!store.clip(second, 0).isComplete);
    QVERIFY(store.progress().isBudgetReached);
    first = nullptr;
    QVERIFY(!store.clip(second, 0).isComplete);
    QVERIFY(!store.progress().isBudgetReached);
    store.waitForAll();
    QVERIFY(store.clip(second, 0).isComplete);
}

void TestBake::aLargerBudgetBakesWhatDidNotFit()
{
    const TemplatePtr asset = makeTube(2.0F, 2);
    KeyframeStore store(bakedBytes(*asset, 0) + 10000);
    (void)store.clip(asset, 0);
    (void)store.clip(asset, 1);
    store.waitForAll();
    QVERIFY(!store.clip(asset, 1).isComplete);
    store.setBudget(std::size_t{64} << 20U);
    QVERIFY(!store.progress().isBudgetReached);
    (void)store.clip(asset, 1);
    store.waitForAll();
    QVERIFY(store.clip(asset, 1).isComplete);
}

void TestBake::pausingGivesUpUntilItIsAskedForAgain()
{
    const TemplatePtr asset = makeTube(2.0F, 6);
    KeyframeStore store;
    store.setPaused(true);
    for (int clip = 0; clip < 6; ++clip) {
        QCOMPARE(store.clip(asset, clip).clip->keyframes, 1);
    }
    QCOMPARE(store.progress().pendingClips, 0);
    const std::size_t atRest = store.progress().bytes;
    store.setPaused(false);
    for (int clip = 0; clip < 6; ++clip) {
        (void)store.clip(asset, clip);
    }
    store.setPaused(true); // some wait, some may be under way or done
    store.waitForAll();
    QCOMPARE(store.progress().pendingClips, 0);
    const auto done = static_cast<std::size_t>(store.progress().finishedClips);
    QVERIFY(store.progress().bytes <= atRest + done * bakedBytes(*asset, 0));
    store.setPaused(false);
    for (int clip = 0; clip < 6; ++clip) {
        (void)store.clip(asset, clip);
    }
    store.waitForAll();
    for (int clip = 0; clip < 6; ++clip) {
        QVERIFY(store.clip(asset, clip).isComplete);
    }
}

void TestBake::callbackComesForEachClip()
{
    std::atomic<int> calls = 0;
    const TemplatePtr asset = makeTube(1.0F, 4);
    KeyframeStore store;
    store.setFinishedCallback([&calls] { ++calls; });
    for (int clip = 0; clip < 4; ++clip) {
        (void)store.clip(asset, clip);
    }
    store.waitForAll();
    QTRY_COMPARE(calls.load(), 4);
}

void TestBake::bakingEndsWithTheKeyframeAtWhichItIsCancelled()
{
    const TemplatePtr asset = makeTube(1.0F);
    const int keyframes = asset->clips[0].keyframeCount();
    int asked = 0;
    QVERIFY(bakeClip(*asset, 0, keyframes, [&asked] { return ++asked < 0; }) != nullptr);
    QCOMPARE(asked, keyframes);
    asked = 0;
    QVERIFY(bakeClip(*asset, 0, keyframes, [&asked] { return ++asked > 3; }) == nullptr);
    QCOMPARE(asked, 4);
}

void TestBake::storeMayDieWhileBaking()
{
    const TemplatePtr asset = makeTube(60.0F, 4, 400);
    KeyframeStore store;
    for (int clip = 0; clip < 4; ++clip) {
        (void)store.clip(asset, clip);
    }
}

void TestBake::loneLevelIsSimplified()
{
    const TemplatePtr asset = makeTube(1.0F, 1, 60);
    const std::vector<DrawLevel> levels = drawLevels(*asset);
    QCOMPARE(levels.size(), std::size_t{kMaxLevels});
    const std::size_t vertices = asset->levels[0].positions.size();
    for (std::size_t i = 1; i < levels.size(); ++i) {
        QVERIFY(levels[i].indices.size() < levels[i - 1].indices.size());
        QCOMPARE(levels[i].vertexLevel, 0);
        QVERIFY(std::ranges::all_of(levels[i].indices,
                                    [vertices](std::uint32_t v) { return v < vertices; }));
    }
    QVERIFY(levels[3].indices.size() <= levels[0].indices.size() / 5);
}

void TestBake::smallMeshesStay()
{
    const TemplatePtr asset = makeTube(1.0F, 1, 2);
    QCOMPARE(drawLevels(*asset).size(), std::size_t{1});
}

CROWD_TEST(TestBake)
#include "tst_Bake.moc"
