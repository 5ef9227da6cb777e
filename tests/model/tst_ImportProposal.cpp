// SPDX-License-Identifier: MIT
#include "model/gltf/ImportProposal.h"
#include "tests/model/Near.h"
#include "tests/program/Test.h"

#include <cmath>

#include <QtTest/QTest>

using namespace crowd::model;
using crowd::testing::near;

namespace {

/// A box of points with a left and a right hand, standing in a template of its own.
Template box(const glm::vec3& low, const glm::vec3& high, const glm::vec3& left = {0, 0, 0})
{
    Template asset;
    asset.nodes.resize(3);
    asset.nodes[1].name = "Hand.L";
    asset.nodes[1].translation = left;
    asset.nodes[2].name = "Hand.R";
    asset.nodes[2].translation = -left;
    asset.clips.resize(1);
    asset.bounds.add(low);
    asset.bounds.add(high);
    asset.height = asset.bounds.size().y;
    return asset;
}

glm::vec3 apply(const ImportSettings& settings, const glm::vec3& point)
{
    return settings.rotation * (point * settings.scale) + glm::vec3(0, settings.groundOffset, 0);
}

} // namespace

class tst_ImportProposal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesPlausibleFilesAlone();
    void bringsUnitsToMetres_data();
    void bringsUnitsToMetres();
    void standsUpWhatLies();
    void turnsToTheFront_data();
    void turnsToTheFront();
    void leavesMirroredCharactersFacingTheirWay();
    void liftsWhatSinks();
    void saysNumbersThatCount();
};

void tst_ImportProposal::leavesPlausibleFilesAlone()
{
    for (const float height : {0.2F, 1.8F, 4.5F}) {
        const Template asset = box({-0.4F * height, 0, -0.1F * height},
                                   {0.4F * height, height, 0.1F * height}, {0.3F * height, 0, 0});
        const ImportProposal proposal = proposeImport(asset);
        QVERIFY(proposal.settings == ImportSettings{});
        QVERIFY(proposal.reasons.empty());
        QCOMPARE(proposal.height, height);
    }
}

void tst_ImportProposal::bringsUnitsToMetres_data()
{
    QTest::addColumn<float>("height");
    QTest::addColumn<float>("scale");
    QTest::newRow("fox in centimetres") << 79.0F << 0.01F;
    QTest::newRow("man in millimetres") << 1800.0F << 0.001F;
    QTest::newRow("man in inches") << 70.0F << 0.0254F;
    QTest::newRow("man scaled down by 100") << 0.018F << 100.0F;
}

void tst_ImportProposal::bringsUnitsToMetres()
{
    QFETCH(const float, height);
    QFETCH(const float, scale);
    const float depth = scale == 0.01F ? 155.0F : height * 0.2F;
    const ImportProposal proposal =
        proposeImport(box({-height / 6, 0, -depth / 2}, {height / 6, height, depth / 2}));
    QCOMPARE(proposal.settings.scale, scale);
    QCOMPARE(proposal.reasons.size(), std::size_t{1});
    QVERIFY(std::abs(proposal.height - height * scale) < 1e-4F);
}

void tst_ImportProposal::standsUpWhatLies()
{
    // Z up, facing -Y as in Blender.
    const Template asset = box({-0.8F, -0.15F, 0.0F}, {0.8F, 0.15F, 1.8F}, {0.7F, 0.0F, 0.0F});
    const ImportProposal proposal = proposeImport(asset);
    QVERIFY(near(apply(proposal.settings, {0, 0, 1.8F}), {0, 1.8F, 0}));
    QVERIFY(near(apply(proposal.settings, {0, -1, 0}), {0, 0, 1}));
    QVERIFY(std::abs(proposal.height - 1.8F) < 1e-4F);
}

void tst_ImportProposal::turnsToTheFront_data()
{
    QTest::addColumn<float>("x");
    QTest::addColumn<float>("z");
    QTest::newRow("faces +Z") << 1.0F << 0.0F;
    QTest::newRow("faces -Z") << -1.0F << 0.0F;
    QTest::newRow("faces +X") << 0.0F << -1.0F;
    QTest::newRow("faces -X, a little turned") << 0.2F << 1.0F;
}

void tst_ImportProposal::turnsToTheFront()
{
    QFETCH(const float, x);
    QFETCH(const float, z);
    const Template asset = box({-1, 0, -1}, {1, 2, 1}, {x, 0, z});
    const ImportProposal proposal = proposeImport(asset);
    const glm::vec3 left = proposal.settings.rotation * glm::normalize(glm::vec3(x, 0, z));
    QVERIFY(left.x > 0.9F);
    QCOMPARE(proposal.reasons.size(), std::size_t{x > 0.5F ? 0U : 1U});
}

void tst_ImportProposal::liftsWhatSinks()
{
    const ImportProposal sunk = proposeImport(box({-1, -1, -1}, {1, 1, 1}));
    QCOMPARE(sunk.settings.groundOffset, 1.0F);
    const ImportProposal hovering = proposeImport(box({-1, 0.2F, -1}, {1, 2, 1}));
    QCOMPARE(hovering.settings.groundOffset, 0.0F);
}

/// As a whole by a root of negative scale: what is called left is at its right.
void tst_ImportProposal::leavesMirroredCharactersFacingTheirWay()
{
    Template asset = box({-1, 0, -1}, {1, 2, 1}, {1, 1, 0});
    asset.nodes[0].scale = {-1, 1, 1};
    asset.nodes[1].parent = 0;
    asset.nodes[2].parent = 0;
    QVERIFY(proposeImport(asset).settings == ImportSettings{});
    asset.nodes[0].scale = {1, 1, -1}; // and now it looks backwards
    QVERIFY(near(proposeImport(asset).settings.rotation * glm::vec3(0, 0, -1), {0, 0, 1}));
    asset.nodes[0].scale = {1, 1, 1}; // one arm made of the other
    asset.nodes[2].scale = {-1, 1, 1};
    QVERIFY(proposeImport(asset).settings == ImportSettings{});
}

void tst_ImportProposal::saysNumbersThatCount()
{
    const auto reasons = [](const glm::vec3& low, const glm::vec3& high) {
        std::string text;
        for (const Message& reason : proposeImport(box(low, high)).reasons) {
            text += reason.english();
        }
        return QString::fromStdString(text);
    };
    // Flat, and a hair's breadth below or above the ground.
    QVERIFY(reasons({-1, -0.0002F, -1}, {1, 0, 1}).isEmpty());
    QVERIFY(reasons({-1, 0.0002F, -1}, {1, 0.0003F, 1}).isEmpty());
    QVERIFY(reasons({-1, -0.5F, -1}, {1, 0.5F, 1}).contains(QStringLiteral("offset it by 0.5 m")));
    const QString tiny = reasons({-2e-5F, 0, -1e-5F}, {2e-5F, 3e-5F, 1e-5F});
    QVERIFY2(tiny.contains(QStringLiteral("It is 0.00004 m large")), qPrintable(tiny));
}

CROWD_TEST(tst_ImportProposal)
#include "tst_ImportProposal.moc"
