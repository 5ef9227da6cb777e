// SPDX-License-Identifier: MIT
#include "model/template/SlotColour.h"

#include <QtTest/QTest>

#include "model/base/Color.h"
#include "tests/program/Test.h"

using namespace crowd;
using namespace crowd::model;

namespace {

/// A slot of a right angled triangle of each size, metres, over the left or the right half of a
/// picture of two texels: brown and white.
struct Half
{
    bool isRight = false;
    float metres = 1.0F;
};

Template paintedWith(const std::vector<Half>& halves)
{
    Template asset;
    asset.images.push_back({"halves", 2, 1, {120, 60, 30, 255, 255, 255, 255, 255}});
    MaterialChoice material;
    material.image = 0;
    asset.slots = {{"skin", true, true, {MaterialChoice(), material}}};
    Mesh mesh;
    for (const Half& half : halves) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(
            mesh.positions.end(),
            {glm::vec3(0.0F), {half.metres, 0.0F, 0.0F}, {0.0F, half.metres, 0.0F}});
        mesh.uv.insert(mesh.uv.end(), 3, glm::vec2(half.isRight ? 0.75F : 0.25F, 0.5F));
        mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
    }
    mesh.submeshes = {{0, -1, 0, static_cast<std::uint32_t>(mesh.indices.size())}};
    asset.levels = {std::move(mesh)};
    return asset;
}

const glm::vec3 kBrown = linearFromSrgb(glm::vec3(120.0F, 60.0F, 30.0F) * (1.0F / 255.0F));

bool isAlike(const glm::vec3& a, const glm::vec3& b)
{
    return glm::length(a - b) < 1e-4F;
}

} // namespace

class TestSlotColour : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thePictureCounts();
    void asMuchAsThereIsOfIt();
    void thePictureLiesAsTheMaterialSays();
    void factorAndVerticesCountToo();
    void whatHasNoSurfaceHasTheFactor();
};

void TestSlotColour::thePictureCounts()
{
    const Template asset = paintedWith({{false}});
    QVERIFY(isAlike(slotColour(asset, 0, 1), kBrown));
    QVERIFY(isAlike(slotColour(asset, 0, 0), glm::vec3(1.0F))); // has none
}

void TestSlotColour::asMuchAsThereIsOfIt()
{
    const Template asset = paintedWith({{false, 2.0F}, {true, 1.0F}});
    QVERIFY(isAlike(slotColour(asset, 0, 1), (4.0F * kBrown + glm::vec3(1.0F)) / 5.0F));
}

void TestSlotColour::thePictureLiesAsTheMaterialSays()
{
    Template asset = paintedWith({{false}});
    MaterialChoice& material = asset.slots[0].choices[1];
    material.uvTransform = {1, 0, 0.5F, 0, 1, 0};
    QVERIFY(isAlike(slotColour(asset, 0, 1), glm::vec3(1.0F)));
    material.uvTransform = {1, 0, 1.0F, 0, 1, 0};
    QVERIFY(isAlike(slotColour(asset, 0, 1), kBrown)); // repeated
    material.wrapU = Wrap::Mirror;
    QVERIFY(isAlike(slotColour(asset, 0, 1), glm::vec3(1.0F)));
    material.wrapU = Wrap::Clamp;
    material.uvTransform = {1, 0, -5.0F, 0, 1, 0};
    QVERIFY(isAlike(slotColour(asset, 0, 1), kBrown));
}

void TestSlotColour::factorAndVerticesCountToo()
{
    Template asset = paintedWith({{false}});
    asset.slots[0].choices[1].baseColor = {0.5F, 1.0F, 1.0F, 1.0F};
    asset.levels[0].colors.assign(3, glm::u8vec4(255, 51, 255, 255));
    QVERIFY(isAlike(slotColour(asset, 0, 1), kBrown * glm::vec3(0.5F, 0.2F, 1.0F)));
}

void TestSlotColour::whatHasNoSurfaceHasTheFactor()
{
    Template asset = paintedWith({});
    asset.slots[0].choices[1].baseColor = {0.5F, 0.25F, 1.0F, 1.0F};
    QVERIFY(isAlike(slotColour(asset, 0, 1), glm::vec3(0.5F, 0.25F, 1.0F)));
}

CROWD_TEST(TestSlotColour)
#include "tst_SlotColour.moc"
