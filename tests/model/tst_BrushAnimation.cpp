// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <QtTest/QTest>

#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

class tst_BrushAnimation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void animatesWithClipsOfTheTemplate();
    void stylesAreClipsToWalkWith();
};

void tst_BrushAnimation::animatesWithClipsOfTheTemplate()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    BrushSettings settings = brush(BrushKind::Animation, BrushSelection::Rectangle);
    settings.op = BrushOperator::Random;
    settings.as<AnimationSettings>().clips = {
        {"idle", 1.0F}, {"cheer", 3.0F}, {"sit", 5.0F}, {"no such clip", 9.0F}};
    settings.as<AnimationSettings>().setsSpeed = true;
    settings.as<AnimationSettings>().speed = {0.5F, 1.5F};
    QCOMPARE(scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}}).affected, 60);
    std::array<int, 3> clips{};
    for (std::size_t row = 0; row < ids.size(); ++row) {
        ++clips[scene.people().column(columns::clip)[row]];
        const float phase = scene.people().column(columns::phase)[row];
        const float speed = scene.people().column(columns::playbackSpeed)[row];
        QVERIFY(phase >= 0.0F && phase < 1.0F && speed >= 0.5F && speed < 1.5F);
    }
    QCOMPARE(clips[1], 0); // nobody has a seat
    QVERIFY(clips[0] >= 5 && clips[0] <= 26);
    settings.op = BrushOperator::Uniform;
    settings.as<AnimationSettings>().phase = {0.25F, 1.0F};
    scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}});
    QCOMPARE(scene.people().column(columns::clip)[9], std::uint16_t{0});
    QCOMPARE(scene.people().column(columns::phase)[9], 0.25F);
    settings.as<AnimationSettings>().clips = {{"sit", 1.0F}}; // who wants nothing else gets it
    scene.paint(fromAbove(), settings, {{1.0, 1.0}, {1279.0, 767.0}});
    QCOMPARE(scene.people().column(columns::clip)[9], std::uint16_t{1});
}

void tst_BrushAnimation::stylesAreClipsToWalkWith()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    const View view = fromAbove();
    const std::vector<glm::dvec2> all{{1.0, 1.0}, {1279.0, 767.0}};
    BrushSettings settings = brush(BrushKind::Style, BrushSelection::Rectangle);
    settings.as<StyleSettings>().clips = {{"idle", 1.0F}, {"cheer", 1.0F}};
    settings.as<StyleSettings>().setsSpeed = false;
    // Nobody gets anywhere with a clip that stays in place.
    QCOMPARE(scene.paint(view, settings, {all[0], all[1]}).affected, 0);
    TemplateEntry entry = scene.document.scene().templates[0];
    entry.clipSpeeds = {0.0F, 0.0F, 1.5F};
    auto edit = scene.document.beginEdit().value();
    edit->changeTemplate(entry);
    edit->commit(QStringLiteral("Speed"));
    settings.as<StyleSettings>().clips = {{"cheer", 1.0F}};
    settings.as<StyleSettings>().setsSpeed = true;
    settings.as<StyleSettings>().speed = {2.0F, 3.0F};
    QCOMPARE(QByteArray(settings.mainNumber().label), QByteArray("Walking speed, m/s"));
    QCOMPARE(settings.withMainNumber(4.0).as<StyleSettings>().speed, (ValueRange{4.0F, 5.0F}));
    QCOMPARE(scene.paint(view, settings, {all[0], all[1]}).affected, 60);
    float slowest = 9.0F;
    float fastest = 0.0F;
    for (std::size_t row = 0; row < ids.size(); ++row) {
        QCOMPARE(scene.people().column(columns::walkStyle)[row], std::uint16_t{3});
        slowest = std::min(slowest, scene.people().column(columns::walkSpeed)[row]);
        fastest = std::max(fastest, scene.people().column(columns::walkSpeed)[row]);
    }
    QVERIFY(slowest >= 2.0F && fastest <= 3.0F && fastest - slowest > 0.7F);
    // None ticked: what fits the speed again, and the speed stays.
    settings.as<StyleSettings>().clips.clear();
    settings.as<StyleSettings>().setsSpeed = false;
    QCOMPARE(scene.paint(view, settings, {all[0], all[1]}).affected, 60);
    QCOMPARE(scene.people().column(columns::walkStyle)[7], std::uint16_t{0});
    scene.document.undoStack().undo();
    QCOMPARE(scene.people().column(columns::walkStyle)[7], std::uint16_t{3});
}

CROWD_TEST(tst_BrushAnimation)
#include "tst_BrushAnimation.moc"
