// SPDX-License-Identifier: MIT
#include <cmath>
#include <numeric>

#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

constexpr int kClips = 300;

/// A column of so many by so many quads, 1.8 m high, of one bone and slot.
model::TemplatePtr makeColumn(int around, int up, int clips)
{
    auto asset = std::make_shared<model::Template>();
    asset->name = "column";
    asset->nodes.emplace_back().name = "root";
    asset->bones.push_back({0, glm::mat4(1.0F)});
    model::Mesh mesh;
    for (int y = 0; y <= up; ++y) {
        for (int i = 0; i <= around; ++i) {
            const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(around);
            const glm::vec3 out(std::sin(angle), 0.0F, std::cos(angle));
            const float height = 1.8F * static_cast<float>(y) / static_cast<float>(up);
            mesh.positions.push_back(0.3F * out + glm::vec3(0.0F, height, 0.0F));
            mesh.normals.push_back(out);
            mesh.uv.emplace_back(0.0F);
            mesh.colors.emplace_back(255, 255, 255, 255);
            mesh.bones.push_back(0);
            mesh.weights.push_back(1.0F);
        }
    }
    const auto row = static_cast<std::uint32_t>(around + 1);
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(up); ++y) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = y * row + i;
            mesh.indices.insert(mesh.indices.end(),
                                {a, a + 1, a + row, a + row, a + 1, a + row + 1});
        }
    }
    mesh.submeshes.push_back({0, -1, 0, static_cast<std::uint32_t>(mesh.indices.size())});
    asset->levels.push_back(std::move(mesh));
    asset->slots = {{"all", true, true, {model::MaterialChoice()}}};
    for (int i = 0; i < clips; ++i) {
        model::Clip clip;
        clip.name = "clip" + std::to_string(i);
        clip.seconds = 1.0F;
        asset->clips.push_back(clip);
    }
    asset->bounds.add(glm::vec3(-0.3F, 0.0F, -0.3F));
    asset->bounds.add(glm::vec3(0.3F, 1.8F, 0.3F));
    asset->height = 1.8F;
    return asset;
}

} // namespace

/// Templates with far more than people have, and with far less.
class TestHeavyTemplates : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { open(); }
    void cleanupTestCase() { m_renderer->destroy(); }
    void ofOneTriangle();
    void ofManyTriangles();
    void ofManyClipsWithinABudget();

private:
    [[nodiscard]] int coveredPixels() const;
};

/// Darker or lighter than the corner of the picture.
int TestHeavyTemplates::coveredPixels() const
{
    int count = 0;
    for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
        count += std::abs(static_cast<int>(m_pixels[i]) - static_cast<int>(m_pixels[0])) > 8;
    }
    return count;
}

void TestHeavyTemplates::ofOneTriangle()
{
    auto asset = std::make_shared<model::Template>(*makeColumn(3, 1, 1));
    asset->levels[0].indices.resize(3);
    asset->levels[0].submeshes[0].indexCount = 3;
    render::RenderInput input(above(), *m_keyframes);
    input.frame = frameOf(makeRow(3), {entryFor(asset)});
    input.samples = 0;
    draw(input);
    QCOMPARE(m_renderer->statistics().visible, 3);
}

/// Near they are drawn in full, far by a share of them.
void TestHeavyTemplates::ofManyTriangles()
{
    const model::TemplatePtr asset = makeColumn(400, 250, 1);
    const auto triangles = static_cast<std::int64_t>(asset->levels[0].indices.size() / 3);
    QCOMPARE(triangles, std::int64_t{200'000});
    for (const float distance : {1.6F, 60.0F}) {
        render::RenderInput input(frontView(glm::vec2(kPixels), distance), *m_keyframes);
        input.frame = frameOf(makeRow(1), {entryFor(asset)});
        input.samples = 0;
        input.showShadows = false;
        input.levels.impostorPixels = 0.0F;
        draw(input);
        QCOMPARE(m_renderer->statistics().visible, 1);
        const std::int64_t drawn = m_renderer->statistics().triangles;
        if (distance < 10.0F) {
            QVERIFY(drawn >= triangles);
            QVERIFY(coveredPixels() > kPixels * kPixels / 8);
        } else {
            QVERIFY2(drawn < triangles / 4, qPrintable(QString::number(drawn)));
        }
    }
}

/// Everybody is in another clip, which the memory is not enough for: some stand still, and all are
/// drawn.
void TestHeavyTemplates::ofManyClipsWithinABudget()
{
    constexpr std::size_t kBudget = 4'000'000;
    model::KeyframeStore store(kBudget);
    const model::TemplatePtr asset = makeColumn(40, 40, kClips);
    model::Population people = makeRow(kClips);
    for (int i = 0; i < kClips; ++i) {
        const std::vector<model::IndividualId> id{static_cast<model::IndividualId>(i + 1)};
        const std::vector<std::uint16_t> clip{static_cast<std::uint16_t>(i)};
        people.setValues(model::columns::clip, id, std::span<const std::uint16_t>(clip));
        const std::vector<glm::vec3> place{
            {static_cast<float>(i % 20) - 10.0F, 0.0F, -static_cast<float>(i / 20)}};
        people.setValues(model::columns::position, id, std::span<const glm::vec3>(place));
    }
    const model::Camera camera =
        model::Camera::lookingAt({0.0F, 12.0F, 22.0F}, {0.0F, 0.0F, -6.0F});
    render::RenderInput input(model::View(camera, glm::vec2(kPixels)), store);
    input.frame = frameOf(people, {entryFor(asset)});
    input.samples = 0;
    for (int pass = 0; pass < 2; ++pass) {
        const auto drawn = m_renderer->draw(input);
        QVERIFY2(drawn.isOk(), drawn ? "" : drawn.error().message.c_str());
        store.waitForAll();
    }
    QVERIFY(store.progress().isBudgetReached);
    QCOMPARE(m_renderer->statistics().visible, kClips);
    QVERIFY(m_renderer->statistics().areKeyframesMissing);
}

CROWD_TEST(TestHeavyTemplates)
#include "tst_HeavyTemplates.moc"
