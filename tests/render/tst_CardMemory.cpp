// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>

#include "render/gl/CardMemory.h"
#include "render/gl/ShaderProgram.h"
#include "tests/program/Test.h"
#include "tests/render/PictureBench.h"

using namespace crowd;
using namespace crowd::testing;
namespace card_memory = render::card_memory;

namespace {

/// Of four levels, with a large picture.
model::TemplatePtr makeHeavyMan()
{
    auto man = makeBoxMan(4);
    constexpr int kSide = 1024;
    man->images.push_back(
        {"cloth", kSide, kSide, std::vector<std::uint8_t>(std::size_t{kSide} * kSide * 4, 200)});
    for (model::Slot& slot : man->slots) {
        for (model::MaterialChoice& choice : slot.choices) {
            choice.image = 0;
        }
    }
    return man;
}

/// In bytes, over all pixels.
double meanDifference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i]));
    }
    return sum / static_cast<double>(a.size());
}

} // namespace

/// Cards that have no room for a scene, and drivers that refuse what they are given.
class TestCardMemory : public PictureBench
{
    Q_OBJECT

private Q_SLOTS:
    void init() { open(); }
    void cleanup()
    {
        card_memory::limitTo(card_memory::kNoLimit);
        m_renderer->destroy();
    }
    void whatIsTakenIsCounted();
    void aSmallCardDrawsCoarser();
    void whatFitsAgainIsDrawnInFull();
    void tooSmallACardSaysSo();
    void shadersSayTheLineThatFails();

private:
    [[nodiscard]] render::RenderInput heavy();
};

render::RenderInput TestCardMemory::heavy()
{
    render::RenderInput input(frontView(glm::vec2(kPixels)), *m_keyframes);
    input.frame = frameOf(makeRow(1), {entryFor(m_man)});
    return input;
}

void TestCardMemory::whatIsTakenIsCounted()
{
    const std::int64_t before = card_memory::bytes();
    m_man = makeHeavyMan();
    draw(heavy());
    constexpr std::int64_t kPicture = 1024 * 1024 * 4;
    QVERIFY(m_renderer->statistics().cardBytes > before + 2 * kPicture); // white, and the picture
    QCOMPARE(m_renderer->statistics().cardBytes, card_memory::bytes());
    QCOMPARE(m_renderer->statistics().reduction, 0);
    m_renderer->destroy();
    QVERIFY(card_memory::bytes() <= before);
}

void TestCardMemory::aSmallCardDrawsCoarser()
{
    m_man = makeHeavyMan();
    const std::int64_t before = card_memory::bytes();
    draw(heavy());
    const std::vector<std::uint8_t> full = m_pixels;
    const std::int64_t needed = card_memory::bytes() - before;
    m_renderer->destroy();
    QVERIFY(m_renderer->initialize().isOk());
    card_memory::limitTo(card_memory::bytes() + needed / 2);
    draw(heavy());
    QVERIFY(m_renderer->statistics().reduction > 0);
    QVERIFY(card_memory::bytes() <= before + needed / 2);
    // The same man, without smooth edges.
    QVERIFY2(meanDifference(m_pixels, full) < 3.0,
             qPrintable(QString::number(meanDifference(m_pixels, full))));
    const auto numbers = m_renderer->drawAovs(heavy());
    QVERIFY(numbers.isOk());
    QVERIFY(std::ranges::count(numbers.value().rows, 0) > kPixels);
}

/// In the next picture after somebody has said that what is not shown may go.
void TestCardMemory::whatFitsAgainIsDrawnInFull()
{
    m_man = makeHeavyMan();
    draw(heavy());
    const std::vector<std::uint8_t> full = m_pixels;
    m_renderer->destroy();
    QVERIFY(m_renderer->initialize().isOk());
    card_memory::limitTo(card_memory::bytes() + 4'000'000);
    draw(heavy());
    QVERIFY(m_renderer->statistics().reduction > 0);
    card_memory::limitTo(card_memory::kNoLimit);
    draw(heavy());
    QVERIFY(m_renderer->statistics().reduction > 0); // not tried with every picture
    m_renderer->releaseUnused();
    draw(heavy());
    QCOMPARE(m_renderer->statistics().reduction, 0);
    QVERIFY(m_pixels == full);
}

void TestCardMemory::tooSmallACardSaysSo()
{
    m_man = makeHeavyMan();
    card_memory::limitTo(card_memory::bytes() + 1000);
    const auto drawn = m_renderer->draw(heavy());
    QVERIFY(!drawn.isOk());
    QVERIFY2(drawn.error().message.find("memory of the graphics card") != std::string::npos,
             drawn.error().message.c_str());
    QVERIFY(!m_renderer->drawAovs(heavy()).isOk());
    card_memory::limitTo(card_memory::kNoLimit);
    draw(heavy()); // what was refused is not missed for ever
    m_renderer->releaseUnused();
    draw(heavy());
    QCOMPARE(m_renderer->statistics().reduction, 0);
}

void TestCardMemory::shadersSayTheLineThatFails()
{
    const auto built = render::ShaderProgram::build("stage", "TEXTURED baseColor=1.0)");
    QVERIFY(!built.isOk());
    const std::string& said = built.error().message;
    QVERIFY2(said.find("stage.") != std::string::npos, said.c_str());
    QVERIFY2(said.find(": uniform vec4 baseColor;") != std::string::npos, said.c_str());
}

CROWD_TEST(TestCardMemory)
#include "tst_CardMemory.moc"
