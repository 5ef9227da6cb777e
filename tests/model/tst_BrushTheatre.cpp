// SPDX-License-Identifier: MIT
#include <set>

#include <QtTest/QTest>

#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"
#include "model/gltf/GltfImport.h"
#include "model/pick/ScenePicker.h"
#include "model/project/ProjectFile.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

std::string builtinFile(const std::string& path)
{
    const std::string prefix = "builtin:";
    return std::string(CROWD_RESOURCES "/") +
           (path.starts_with(prefix) ? path.substr(prefix.size()) : path);
}

} // namespace

/// The scene that the program opens with, painted in its first camera.
class tst_BrushTheatre : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void firstStrokeFillsFreeSeats();
    void recolouringAndUndoKeepEveryByte();
    void picksWhoIsVisible();

private:
    [[nodiscard]] BrushContext context() { return {m_view, m_keyframes, m_stage}; }
    StrokeOutcome paint(const BrushSettings& settings);

    Scene m_loaded;
    SceneDocument m_document;
    KeyframeStore m_keyframes;
    StageRays m_stage;
    View m_view{Camera{}, {1280.0F, 720.0F}};
};

void tst_BrushTheatre::initTestCase()
{
    auto scene = readProject(QStringLiteral(CROWD_RESOURCES "/scenes/theatre.crowd"));
    QVERIFY2(scene.isOk(), scene ? "" : scene.error().message.c_str());
    m_loaded = scene.value();
    for (TemplateEntry& entry : m_loaded.templates) {
        const auto asset = importTemplate(builtinFile(entry.path), entry.import);
        QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
        entry.asset = asset.value();
    }
    for (StageEntry& entry : m_loaded.stages) {
        const auto asset = importStage(builtinFile(entry.path));
        QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
        entry.asset = asset.value();
    }
    QVERIFY(!m_loaded.cameras.empty());
    m_view = View(m_loaded.cameras.front().camera, {1280.0F, 720.0F});
}

void tst_BrushTheatre::init()
{
    m_document.replaceScene(m_loaded, {});
    m_stage.setStages(m_document.scene().stages);
    ScenePicker warm(m_keyframes, m_stage);
    warm.update(m_document.frame(0.0), m_document.scene().worldSeats(), m_view);
    m_keyframes.waitForAll();
}

StrokeOutcome tst_BrushTheatre::paint(const BrushSettings& settings)
{
    const auto stroke =
        Stroke::begin(m_document, context(), settings, 3, PointerInput::at({2.0, 2.0}, 0.0));
    stroke->move(PointerInput::at({1278.0, 718.0}, 0.2));
    return stroke->finish();
}

void tst_BrushTheatre::firstStrokeFillsFreeSeats()
{
    BrushSettings settings;
    settings.selection = BrushSelection::Rectangle;
    for (const TemplateEntry& entry : m_document.scene().templates) {
        settings.as<CreateSettings>().mix.push_back({entry.id, 1.0F});
    }
    const std::size_t before = m_document.scene().population.size();
    const StrokeOutcome outcome = paint(settings);
    QVERIFY2(outcome.affected >= 20, qPrintable(outcome.message));
    const Population& people = m_document.scene().population;
    QCOMPARE(people.size(), before + static_cast<std::size_t>(outcome.affected));
    std::set<SeatId> seats;
    std::size_t seated = 0;
    for (const SeatId seat : people.column(columns::seat)) {
        seated += seat != kNoSeat ? 1 : 0;
        seats.insert(seat);
    }
    seats.erase(kNoSeat);
    QCOMPARE(seats.size(), seated);
    const StrokeOutcome again = paint(settings);
    QCOMPARE(again.reason, StrokeReason::NoFreeSeat);
}

void tst_BrushTheatre::recolouringAndUndoKeepEveryByte()
{
    const Population before = m_document.scene().population;
    BrushSettings settings;
    settings.setKind(BrushKind::Colour);
    settings.selection = BrushSelection::Rectangle;
    settings.op = BrushOperator::Gradient;
    QVERIFY(paint(settings).affected > 100);
    const Population after = m_document.scene().population;
    m_document.undoStack().undo();
    QVERIFY(m_document.scene().population == before);
    m_document.undoStack().redo();
    QVERIFY(m_document.scene().population == after);
}

void tst_BrushTheatre::picksWhoIsVisible()
{
    ScenePicker picker(m_keyframes, m_stage);
    picker.update(m_document.frame(0.7), m_document.scene().worldSeats(), m_view);
    const auto everywhere = ScreenArea::rectangle({0.0, 0.0}, {1280.0, 720.0});
    const auto seen = picker.individualsInArea(everywhere, AreaMode::Visible);
    QVERIFY(seen.size() > 100);
    const Population& people = m_document.scene().population;
    const std::size_t row = people.rowOf(seen[seen.size() / 2]);
    const glm::vec3 middle =
        m_view.project(people.column(columns::position)[row] + glm::vec3(0.0F, 1.0F, 0.0F)).value();
    const glm::ivec2 at(middle);
    const auto area = ScreenArea::circle(glm::dvec2(at), 70.0);
    std::set<IndividualId> atPixels;
    for (int y = at.y - 71; y < at.y + 71; ++y) {
        for (int x = at.x - 71; x < at.x + 71; ++x) {
            if (area.contains({x + 0.5, y + 0.5})) {
                if (const auto hit = picker.individualAt({x + 0.5, y + 0.5})) {
                    atPixels.insert(hit->id);
                }
            }
        }
    }
    const auto ids = picker.individualsInArea(area, AreaMode::Visible);
    QVERIFY(atPixels.size() > 3);
    // Edges of triangles may fall either way between a ray and a sample: one pixel of somebody.
    std::size_t differences = 0;
    for (const IndividualId id : ids) {
        differences += atPixels.erase(id) == 0 ? 1 : 0;
    }
    differences += atPixels.size();
    QVERIFY2(differences <= 1, qPrintable(QString::number(differences)));
}

CROWD_TEST(tst_BrushTheatre)
#include "tst_BrushTheatre.moc"
