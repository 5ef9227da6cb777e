// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include <QtTest/QTest>

#include "behavior/surface/WalkSurface.h"
#include "model/gltf/GltfImport.h"
#include "model/pick/StageRays.h"
#include "tests/program/Test.h"

using namespace crowd;

namespace {

constexpr float kHalfAngle = 1.74533F; ///< of the seating, as it is authored
constexpr int kAisles = 11;
constexpr float kLowestRank = 8.2F; ///< metres from the middle of the orchestra
constexpr float kHighestRank = 18.5F;

glm::vec3 inAisle(int aisle, float metres)
{
    const float angle = kHalfAngle * (2.0F * static_cast<float>(aisle) / (kAisles - 1) - 1.0F);
    return {std::sin(angle) * metres, 20.0F, -std::cos(angle) * metres};
}

} // namespace

/// Where one walks in the theatre that the program brings.
class tst_SurfaceTheatre : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void aislesAreClimbed_data();
    void aislesAreClimbed();

private:
    [[nodiscard]] glm::vec3 onStage(const glm::vec3& above) const
    {
        const auto hit = m_rays.hit({above, {0.0F, -1.0F, 0.0F}});
        return hit ? hit->point : glm::vec3(0.0F);
    }

    model::StageEntry m_theatre;
    model::StageRays m_rays;
    std::shared_ptr<const behavior::WalkSurface> m_surface;
};

void tst_SurfaceTheatre::initTestCase()
{
    const auto asset = model::importStage(CROWD_RESOURCES "/stages/theatre.glb");
    QVERIFY(asset.isOk());
    m_theatre.asset = asset.value();
    m_rays.setStages({&m_theatre, 1});
    behavior::WalkSurface::Progress progress;
    auto built = behavior::WalkSurface::build({{m_theatre}, {}, {}, {}}, progress);
    QVERIFY(built.isOk());
    m_surface = built.value();
}

void tst_SurfaceTheatre::aislesAreClimbed_data()
{
    QTest::addColumn<int>("aisle");
    for (int aisle = 1; aisle + 1 < kAisles; ++aisle) { // walls stand beside the outermost
        QTest::addRow("%d", aisle) << aisle;
    }
}

void tst_SurfaceTheatre::aislesAreClimbed()
{
    QFETCH(int, aisle);
    for (float metres = kLowestRank + 0.2F; metres < kHighestRank; metres += 0.3F) {
        const glm::vec3 step = onStage(inAisle(aisle, metres));
        QVERIFY2(m_surface->isWalkable(step),
                 qPrintable(QStringLiteral("%1 m out, %2 m up").arg(metres).arg(step.y)));
    }
    const glm::vec3 low = onStage(inAisle(aisle, 6.0F));
    const glm::vec3 high = onStage(inAisle(aisle, kHighestRank));
    const auto metres = m_surface->wayMetres(low, high, 0.5F);
    QVERIFY(metres.has_value());
    QVERIFY2(*metres < 1.3F * (kHighestRank - 6.0F), qPrintable(QString::number(*metres)));
}

CROWD_TEST(tst_SurfaceTheatre)
#include "tst_SurfaceTheatre.moc"
