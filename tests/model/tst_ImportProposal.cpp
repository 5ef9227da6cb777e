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
    void knowsHowLargeItsLikeIs_data();
    void knowsHowLargeItsLikeIs();
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

void tst_ImportProposal::knowsHowLargeItsLikeIs_data()
{
    using Names = std::vector<const char*>;
    QTest::addColumn<Names>("nodes");
    QTest::addColumn<Names>("clips");
    QTest::addColumn<float>("height");
    QTest::addColumn<float>("length");
    QTest::addColumn<float>("scale");
    QTest::addColumn<bool>("isSaid");
    const Names body{"LeftForeArm", "RightUpLeg", "Head"};
    const Names legs{"front_leg.L", "hind_leg.R", "tail"};
    const auto row = [](const char* name, const Names& nodes, const Names& clips, float height,
                        float length, float scale, bool isSaid) {
        QTest::newRow(name) << nodes << clips << height << length << scale << isSaid;
    };
    row("somebody", body, {"Idle"}, 1.8F, 0.4F, 1.0F, false);
    row("a child", body, {"Idle"}, 1.1F, 0.4F, 1.0F, false);
    row("a robot of 4.5 m", body, {"Idle"}, 4.5F, 1.2F, 0.39F, true);
    row("somebody of 9.9 m", body, {"Idle"}, 9.9F, 2.0F, 0.18F, true);
    row("somebody in centimetres", body, {"Idle"}, 178.0F, 40.0F, 0.01F, true);
    row("a horse of 4.8 m", legs, {"Horse_Gallop"}, 3.6F, 4.8F, 0.5F, true);
    row("a horse", legs, {"Horse_Gallop"}, 1.7F, 2.4F, 1.0F, false);
    row("a rat of 2.3 m", legs, {"Rat_Run"}, 1.0F, 2.3F, 1.0F, true); // games have such
    row("some animal of 9 m", legs, {"Gallop"}, 5.0F, 9.0F, 0.16F, true);
    row("a tank", {"Turret", "wheel_01"}, {"Drive"}, 2.4F, 7.5F, 1.0F, false);
    row("a lorry", {"Chassis", "Wheel.FL"}, {"Drive"}, 4.0F, 16.0F, 1.0F, false);
    row("a tank in centimetres", {"Turret", "wheel_01"}, {"Drive"}, 240.0F, 750.0F, 0.01F, true);
    row("a helicopter", {"MainRotor"}, {"Fly"}, 3.5F, 14.0F, 1.0F, false);
}

void tst_ImportProposal::knowsHowLargeItsLikeIs()
{
    using Names = std::vector<const char*>;
    QFETCH(const Names, nodes);
    QFETCH(const Names, clips);
    QFETCH(const float, height);
    QFETCH(const float, length);
    QFETCH(const float, scale);
    QFETCH(const bool, isSaid);
    Template asset;
    asset.nodes.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        asset.nodes[i].name = nodes[i];
    }
    asset.clips.resize(clips.size());
    for (std::size_t i = 0; i < clips.size(); ++i) {
        asset.clips[i].name = clips[i];
    }
    asset.bounds.add({-0.2F * height, 0.0F, -0.5F * length});
    asset.bounds.add({0.2F * height, height, 0.5F * length});
    asset.height = height;
    const ImportProposal proposal = proposeImport(asset);
    QVERIFY2(std::abs(proposal.settings.scale - scale) < 0.01F * scale,
             qPrintable(QString::number(static_cast<double>(proposal.settings.scale))));
    QCOMPARE(!proposal.reasons.empty(), isSaid);
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
