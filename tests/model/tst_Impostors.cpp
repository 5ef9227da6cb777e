// SPDX-License-Identifier: MIT
#include <QtTest/QtTest>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "model/bake/ClipBaker.h"
#include "model/bake/Impostor.h"
#include "model/bake/Octahedral.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::model;

namespace {

/// A box a metre wide, two high and a metre deep, of which the upper half is of a second slot and
/// wears a part: a plate a hand's breadth before its front. Clip 0 stands, clip 1 rises by so much.
std::shared_ptr<Template> makeBlock(float risesBy = 1.0F)
{
    auto asset = std::make_shared<Template>();
    asset->nodes.emplace_back();
    asset->bones = {{0, glm::mat4(1.0F)}};
    Mesh mesh;
    const auto addFace = [&](const glm::vec3& middle, const glm::vec3& u, const glm::vec3& v,
                             int slot, int part) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int corner = 0; corner < 4; ++corner) {
            const float a = (corner & 1) != 0 ? 1.0F : -1.0F;
            const float b = (corner & 2) != 0 ? 1.0F : -1.0F;
            mesh.positions.push_back(middle + u * a + v * b);
            mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
            mesh.uv.emplace_back(a * 0.25F + 0.5F, b * 0.25F + 0.5F);
            mesh.colors.emplace_back(255, 255, 255, 255);
            mesh.bones.push_back(0);
            mesh.weights.push_back(1.0F);
        }
        mesh.submeshes.push_back({slot, part, static_cast<std::uint32_t>(mesh.indices.size()), 6});
        for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) {
            mesh.indices.push_back(first + corner);
        }
    };
    for (const int half : {0, 1}) {
        const float y = static_cast<float>(half) + 0.5F;
        const glm::vec3 up(0.0F, 0.5F, 0.0F);
        addFace({0.0F, y, 0.5F}, {0.5F, 0.0F, 0.0F}, up, half, -1);
        addFace({0.5F, y, 0.0F}, {0.0F, 0.0F, -0.5F}, up, half, -1);
        addFace({0.0F, y, -0.5F}, {-0.5F, 0.0F, 0.0F}, up, half, -1);
        addFace({-0.5F, y, 0.0F}, {0.0F, 0.0F, 0.5F}, up, half, -1);
    }
    addFace({0.0F, 1.5F, 0.6F}, {0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F}, 2, 0);
    asset->levels = {mesh};
    asset->slots = {{"lower", true, true, {MaterialChoice{}}},
                    {"upper", true, true, {MaterialChoice{}}},
                    {"plate", true, true, {MaterialChoice{}}}};
    asset->parts = {{"plate", true}};
    Clip stand;
    Clip rise;
    rise.seconds = 1.0F;
    rise.loop = false;
    rise.channels.push_back({0,
                             ChannelPath::Translation,
                             Interpolation::Linear,
                             {0.0F, 1.0F},
                             {0.0F, 0.0F, 0.0F, 0.0F, risesBy, 0.0F}});
    asset->clips = {stand, rise};
    asset->height = 2.0F;
    return asset;
}

BakedClipPtr whole(const Template& asset, int clip)
{
    return bakeClip(asset, clip, asset.clips[static_cast<std::size_t>(clip)].keyframeCount());
}

ImpostorTexel texel(const ImpostorSet& set, int azimuth, glm::vec2 share, int layer = 0)
{
    const glm::ivec2 size = set.layout.texels;
    const ImpostorCard& card = set.cards[static_cast<std::size_t>(azimuth)];
    const glm::ivec4 shown(card.shown);
    const glm::ivec2 at = glm::ivec2(share * glm::vec2(size)) - glm::ivec2(shown);
    const glm::ivec2 kept(shown.z - shown.x, shown.w - shown.y);
    if (at.x < 0 || at.y < 0 || at.x >= kept.x || at.y >= kept.y) {
        return {}; // nothing is there
    }
    const int within = (layer * kept.y + at.y) * kept.x + at.x;
    return set.texels[card.first + static_cast<std::size_t>(within)];
}

/// Of a texel of a card, metres towards the eye.
float towardsOf(const ImpostorLayout& layout, const ImpostorTexel& texel)
{
    return layout.nearest - static_cast<float>(texel.kind & 255U) / 255.0F * layout.depth;
}

std::uint32_t slotOf(const ImpostorTexel& texel)
{
    return texel.kind >> 8U & 63U;
}

constexpr int kLevelBand = 1; ///< seen from the side

} // namespace

/// Pictures of templates from all around.
class TestImpostors : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cardsShowWhatIsThere();
    void behindPartsIsWhatTheyHide();
    void axesStandOnEachOther();
    void planesLieOnWhatIsShown();
    void phasesAreAsFarApartAsItMoves();
    void phasesFollowKeyframes();
    void theSameBitsEachTime();
    void whatCannotHaveAnyHasNone_data();
    void whatCannotHaveAnyHasNone();
    void oddTemplatesDoNoHarm();
    void theStoreBakesThemBehind();
    void theyGiveWayToKeyframes();
};

void TestImpostors::cardsShowWhatIsThere()
{
    const auto asset = makeBlock();
    const ImpostorSetPtr set = bakeImpostors(*asset, 0, *whole(*asset, 0), kLevelBand);
    QCOMPARE(set->layout.phases, 1);
    QCOMPARE(set->layout.layers, 2);
    QCOMPARE(set->cards.size(), set->layout.cardCount());
    QVERIFY(!set->texels.empty() && set->texels.size() < set->layout.texelCount());
    QVERIFY(set->bytes() < set->layout.mostBytes());
    const int side = kImpostorAzimuths / 4;
    QCOMPARE(slotOf(texel(*set, side, {0.5F, 0.25F})), 0U);
    QCOMPARE(slotOf(texel(*set, side, {0.5F, 0.75F})), 1U);
    QCOMPARE(slotOf(texel(*set, side, {0.02F, 0.5F})), ImpostorTexel::kNoSlot);
    QCOMPARE(slotOf(texel(*set, 0, {0.5F, 0.75F})), 2U); // the plate
    const ImpostorTexel found = texel(*set, side, {0.5F, 0.25F});
    const glm::vec3 normal = octahedralDecode(static_cast<std::uint16_t>(found.surface >> 16U));
    QVERIFY(glm::dot(normal, cardAxes(side, kLevelBand).towards) > 0.99F);
    QVERIFY(std::abs(towardsOf(set->layout, found) - 0.5F) < 0.02F);
    const float u = (static_cast<float>(found.surface & 255U) + 0.5F) / 256.0F;
    QVERIFY2(std::abs(u - 0.5F) < 0.05F, qPrintable(QString::number(u)));
    QCOMPARE(found.kind >> 20U, 0xFFFU); // white
}

void TestImpostors::behindPartsIsWhatTheyHide()
{
    const auto asset = makeBlock();
    const ImpostorSetPtr set = bakeImpostors(*asset, 0, *whole(*asset, 0), kLevelBand);
    const ImpostorTexel plate = texel(*set, 0, {0.5F, 0.75F}, 0);
    QCOMPARE(plate.kind >> 14U & 63U, 0U);
    const ImpostorTexel behind = texel(*set, 0, {0.5F, 0.75F}, 1);
    QCOMPARE(slotOf(behind), 1U);
    QCOMPARE(behind.kind >> 14U & 63U, ImpostorTexel::kNoPart);
    QCOMPARE(texel(*set, 0, {0.5F, 0.25F}, 0), texel(*set, 0, {0.5F, 0.25F}, 1));
}

void TestImpostors::axesStandOnEachOther()
{
    for (int band = 0; band < static_cast<int>(kImpostorBands.size()); ++band) {
        for (int azimuth = 0; azimuth < kImpostorAzimuths; ++azimuth) {
            const CardAxes axes = cardAxes(azimuth, band);
            QVERIFY(std::abs(glm::length(axes.up) - 1.0F) < 1e-5F);
            QVERIFY(std::abs(glm::dot(axes.up, axes.towards)) < 1e-5F);
            QVERIFY(std::abs(glm::dot(axes.right, axes.towards)) < 1e-5F);
            QVERIFY(axes.up.y > 0.0F);
        }
    }
    QVERIFY(glm::distance(cardAxes(0, kLevelBand).towards, {0.0F, 0.0F, 1.0F}) < 1e-6F);
    QVERIFY(glm::distance(cardAxes(kImpostorAzimuths / 4, kLevelBand).towards, {1.0F, 0.0F, 0.0F}) <
            1e-6F);
}

void TestImpostors::planesLieOnWhatIsShown()
{
    const auto asset = makeBlock();
    constexpr int kSide = kImpostorAzimuths / 4;
    const auto level = bakeImpostors(*asset, 0, *whole(*asset, 0), kLevelBand);
    const ImpostorCard& upright = level->cards[kSide];
    QVERIFY(glm::distance(upright.plane, {0.5F, 0.0F, 0.0F}) < 0.02F);
    QVERIFY(upright.shown.x < upright.shown.z && upright.shown.y < upright.shown.w);
    // From above an upright side leans towards the eye.
    constexpr int kAbove = 4;
    const auto set = bakeImpostors(*asset, 0, *whole(*asset, 0), kAbove);
    const glm::vec3 leaning = set->cards[kSide].plane;
    QVERIFY(std::abs(leaning.y) < 0.02F);
    QVERIFY(std::abs(leaning.z - std::tan(kImpostorBands[kAbove].radians)) < 0.05F);
    const float middle = towardsOf(set->layout, texel(*set, kSide, {0.5F, 0.5F}));
    const float up = set->layout.low.y + 0.5F * set->layout.size.y;
    QVERIFY(std::abs(leaning.x + leaning.z * up - middle) < 0.05F);
}

void TestImpostors::phasesAreAsFarApartAsItMoves()
{
    const auto slow = makeBlock(0.01F);
    const auto quick = makeBlock(4.0F);
    const auto layout = [](const Template& asset) {
        return impostorLayout(asset, 1, *whole(asset, 1), kLevelBand);
    };
    QCOMPARE(layout(*slow).keyframesPerPhase, 8);
    QCOMPARE(layout(*slow).phases, 5); // of 32 intervals, and the end
    QCOMPARE(layout(*quick).keyframesPerPhase, 1);
    QCOMPARE(layout(*quick).phases, 33);
}

void TestImpostors::phasesFollowKeyframes()
{
    ImpostorLayout layout;
    layout.keyframesPerPhase = 4;
    layout.phases = 5;
    QCOMPARE(layout.phaseOf(0.0F, true), 0);
    QCOMPARE(layout.phaseOf(1.9F, true), 0);
    QCOMPARE(layout.phaseOf(2.1F, true), 1);
    QCOMPARE(layout.phaseOf(18.1F, true), 0); // the end of a loop is its beginning
    QCOMPARE(layout.phaseOf(18.1F, false), 4);
    QCOMPARE(layout.phaseOf(-3.0F, true), 0);
}

void TestImpostors::theSameBitsEachTime()
{
    const auto asset = makeBlock();
    const BakedClipPtr clip = whole(*asset, 1);
    QVERIFY(bakeImpostors(*asset, 1, *clip, 2)->texels ==
            bakeImpostors(*asset, 1, *clip, 2)->texels);
    std::atomic<int> asked{0};
    QVERIFY(!bakeImpostors(*asset, 1, *clip, 2, [&asked] { return ++asked > 40; }));
    QCOMPARE(asked.load(), 41);
}

void TestImpostors::whatCannotHaveAnyHasNone_data()
{
    QTest::addColumn<int>("change");
    QTest::newRow("seen through") << 0;
    QTest::newRow("cut out") << 1;
    QTest::newRow("too many slots") << 2;
    QTest::newRow("beyond a clamped picture") << 3;
    QTest::newRow("no vertices") << 4;
}

void TestImpostors::whatCannotHaveAnyHasNone()
{
    QFETCH(int, change);
    const auto asset = makeBlock();
    QVERIFY(canHaveImpostors(*asset));
    MaterialChoice& choice = asset->slots[0].choices[0];
    switch (change) {
    case 0:
        choice.alphaMode = AlphaMode::Blend;
        break;
    case 1:
        choice.alphaMode = AlphaMode::Mask;
        break;
    case 2:
        asset->slots.resize(ImpostorTexel::kNoSlot, asset->slots[0]);
        break;
    case 3:
        choice.wrapU = Wrap::Clamp;
        QVERIFY(canHaveImpostors(*asset)); // as long as it stays within it
        asset->levels[0].uv[0].x = 1.5F;
        break;
    default:
        asset->levels[0] = {};
        break;
    }
    QVERIFY(!canHaveImpostors(*asset));
    QVERIFY(impostorLayout(*asset, 0, *whole(*asset, 0), 0).isEmpty());
}

/// Flat, endless, or no number at all.
void TestImpostors::oddTemplatesDoNoHarm()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float odd : {nan, std::numeric_limits<float>::infinity(), 1e30F, -1e20F}) {
        for (const bool isAll : {false, true}) {
            const auto asset = makeBlock();
            for (glm::vec3& p : asset->levels[0].positions) {
                p = glm::vec3(odd, p.y, odd);
                if (!isAll) {
                    break;
                }
            }
            asset->levels[0].uv[0] = glm::vec2(odd);
            for (int band = 0; band < static_cast<int>(kImpostorBands.size()); ++band) {
                const auto set = bakeImpostors(*asset, 0, *whole(*asset, 0), band);
                QVERIFY(set);
                QCOMPARE(set->cards.size(), set->layout.isEmpty() ? 0 : set->layout.cardCount());
                QVERIFY(set->texels.size() <= set->layout.texelCount());
            }
        }
    }
    const auto flat = makeBlock();
    flat->height = 0.0F;
    QVERIFY(bakeImpostors(*flat, 0, *whole(*flat, 0), 0)->layout.isEmpty());
    const auto wide = makeBlock();
    for (glm::vec3& p : wide->levels[0].positions) {
        p.x *= 100.0F;
    }
    QVERIFY(impostorLayout(*wide, 0, *whole(*wide, 0), 0).isEmpty());
}

void TestImpostors::theStoreBakesThemBehind()
{
    KeyframeStore store;
    const TemplatePtr asset = makeBlock();
    (void)store.clip(asset, 1);
    store.waitForAll();
    const BakedClipPtr clip = store.clip(asset, 1).clip;
    const std::size_t before = store.progress().bytes;
    (void)store.impostors(asset, 1, clip, 0);
    QVERIFY(store.progress().bytes > before);
    QCOMPARE(store.progress().pendingClips, 0); // nobody waits for them
    store.waitForAll();
    QCOMPARE(store.progress().finishedClips, 1);
    const ImpostorSetPtr set = store.impostors(asset, 1, clip, 0);
    QVERIFY(set);
    QCOMPARE(store.progress().bytes, before + set->bytes());
    QCOMPARE(set->band, 0);
    QVERIFY(store.impostors(asset, 1, clip, 0) == set);
    QVERIFY(store.clip(asset, 1).clip == clip);
}

/// Triangles are drawn without cards, but nothing without keyframes.
void TestImpostors::theyGiveWayToKeyframes()
{
    const TemplatePtr first = makeBlock();
    const TemplatePtr second = makeBlock(1.5F);
    const BakedClipPtr clip = whole(*first, 1);
    const std::size_t most = impostorLayout(*first, 1, *clip, 0).mostBytes();
    KeyframeStore store(clip->bytes() + most); // cards beside one clip, but not beside two
    (void)store.clip(first, 1);
    store.waitForAll();
    (void)store.impostors(first, 1, clip, 0);
    store.waitForAll();
    QVERIFY(store.impostors(first, 1, clip, 0));
    const std::size_t bytes = store.progress().bytes;
    store.setBudget(bytes + clip->bytes() - 1);
    (void)store.clip(second, 1); // no room beside the cards
    store.waitForAll();
    QVERIFY(store.clip(second, 1).isComplete);
    QVERIFY(!store.progress().isBudgetReached);
    QVERIFY(!store.impostors(first, 1, clip, 0)); // no room any more
    store.waitForAll();
    QVERIFY(!store.impostors(first, 1, clip, 0));
    QVERIFY(!store.progress().isBudgetReached);
}

CROWD_TEST(TestImpostors)
#include "tst_Impostors.moc"
