// SPDX-License-Identifier: MIT
#include <array>

#include <QtCore/QProcess>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtGui/QClipboard>
#include <QtTest/QSignalSpy>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QToolButton>

#include "app/console/ConsoleDock.h"
#include "behavior/takes/TakeFile.h"
#include "model/brush/IndividualEdits.h"
#include "model/document/SceneEdit.h"
#include "model/features/FeatureWriting.h"
#include "model/states/StateKeeping.h"
#include "tests/gui/Editor.h"
#include "tests/program/FileContent.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/IndividualDock.h"
#include "widgets/forms/NumberField.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::contentOf;
using crowd::testing::copyOfTheatre;
using crowd::testing::Editor;

namespace {

constexpr int kReplayPatienceMs = 120'000;

/// Runs a script in an interpreter of its own, without a display; what it printed as errors.
QString runAlone(const QString& program, const QStringList& arguments)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PYTHONPATH"), QStringLiteral(CROWD_PYTHON_FOLDER));
    environment.remove(QStringLiteral("DISPLAY"));
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    if (!process.waitForFinished(kReplayPatienceMs)) {
        return QStringLiteral("it does not end");
    }
    const QString said = QString::fromUtf8(process.readAllStandardError());
    return process.exitCode() == 0 ? said : said + QStringLiteral("failed");
}

/// What it said, empty if all went well.
QString replayInProgram(const QString& script, const QString& scene)
{
    return runAlone(QStringLiteral(CROWD_PROGRAM), {QStringLiteral("script"), script, scene});
}

/// In a plain python3. The sanitizers' runtime cannot be loaded into one: then in the program's
/// own.
QString replay(const QString& script, const QString& scene)
{
#ifdef CROWD_SANITIZED
    return replayInProgram(script, scene);
#else
    return runAlone(QStringLiteral(CROWD_PYTHON), {script, scene});
#endif
}

/// A recording, what it begins with and what it makes, for tests/golden/window, where
/// CROWD_KEEP_RECORDINGS names a folder.
void keepWhereWanted(const QString& script, const QString& scene)
{
    const QString folder = qEnvironmentVariable("CROWD_KEEP_RECORDINGS");
    if (folder.isEmpty()) {
        return;
    }
    const QString base = script.chopped(3);
    const QString kept = folder + u'/' + QFileInfo(base).fileName();
    for (const auto& [from, ending] : {std::pair{script, ".py"},
                                       {base + QStringLiteral("-start.crowd"), "-start.crowd"},
                                       {scene, ".crowd"}}) {
        QFile::remove(kept + QLatin1String(ending));
        QVERIFY2(QFile::copy(from, kept + QLatin1String(ending)), qPrintable(from));
    }
}

/// Nobody but a row of people who set out along a path, and no stage in their way.
void makeWalkers(model::SceneDocument& document)
{
    const auto edit = document.beginEdit().value();
    const model::Scene& scene = edit->scene();
    const auto all = std::vector(scene.population.ids().begin(), scene.population.ids().end());
    const auto walking = std::span(all).first(20);
    edit->removeIndividuals(std::span(all).subspan(20));
    model::Path path;
    for (const float z : {-4.0F, 30.0F}) {
        model::Place place;
        place.position = {0.0F, 0.0F, z};
        path.places.push_back(edit->addPlace(place));
    }
    const model::PathId id = edit->addPath(path);
    std::vector<glm::vec3> feet;
    for (int i = 0; i < 20; ++i) {
        feet.emplace_back(static_cast<float>(i) - 10.0F, 0.0F, -6.0F);
    }
    edit->removeStage(scene.stages.front().id);
    const model::SeatId none = model::kNoSeat;
    edit->setColumn(model::columns::seat, walking, std::span<const model::SeatId>(&none, 1));
    edit->setColumn(model::columns::position, walking, std::span<const glm::vec3>(feet));
    edit->setColumn(model::columns::path, walking, std::span<const model::PathId>(&id, 1));
    QVERIFY(edit->commit(QStringLiteral("Walkers")));
}

/// Whether somebody is two metres from where the scene has him.
bool hasLeft(Editor& editor)
{
    const auto now = editor.state().frame()->population.column(model::columns::position);
    const auto then = editor.state().scene().population.column(model::columns::position);
    return glm::distance(now.front(), then.front()) > 2.0F;
}

/// A step of a run in which two people are there, as a file.
model::Take takeIn(const QString& folder, model::TakeId id, const char* name, double seconds)
{
    behavior::MotionCache run;
    for (int step = 0; step < 2; ++step) {
        auto pose = std::make_shared<behavior::SessionPose>();
        pose->step = static_cast<std::uint64_t>(step);
        pose->seconds = seconds + step / 30.0;
        pose->ids = {1, 2};
        pose->x = pose->y = pose->z = pose->headings = {0.0F, 1.0F};
        pose->rates = pose->clipSeconds = pose->places = {0.0F, 0.0F};
        pose->clips = {0, 0};
        pose->flags = {1, 1};
        run.add(pose);
    }
    model::Take take = behavior::writeTake(run, folder).value();
    take.id = id;
    take.name = name;
    return take;
}

/// Takes kept, renamed, shown and deleted.
template<class Edit>
void recordTakes(const Edit& edit, const QString& folder)
{
    using Takes = model::members::Takes;
    model::Takes all{takeIn(folder, 2, "Try \"one\"", 1.5), takeIn(folder, 5, "Try two", 3.0)};
    edit("Takes kept", [&](model::SceneEdit& open) { open.set<Takes>(all); });
    all[0].name = "Rehearsal";
    all[1].isShown = true;
    edit("A take shown, another renamed", [&](model::SceneEdit& open) { open.set<Takes>(all); });
    model::HandEdit still;
    still.pace = 0.0F;
    still.people = {1, 2};
    still.begin = 0.1;
    all[0].edits = {still};
    edit("People of a take edited by hand", [&](model::SceneEdit& open) { open.set<Takes>(all); });
    all[0].areEditsOn = false;
    edit("Edits switched off", [&](model::SceneEdit& open) { open.set<Takes>(all); });
    all.push_back(takeIn(folder, 6, "Third", 8.0));
    all.back().edits = {still, still};
    all[1].isShown = false;
    edit("No take shown", [&](model::SceneEdit& open) { open.set<Takes>(all); });
    all.erase(all.begin() + 1);
    all[1].isShown = true;
    edit("A take deleted", [&](model::SceneEdit& open) { open.set<Takes>(all); });
}

/// Features made, borne, changed with their bearers, and removed.
template<class Edit>
void recordFeatures(const Edit& edit, const model::Scene& scene,
                    std::span<const model::IndividualId> people)
{
    edit("A feature made", [&](model::SceneEdit& open) {
        auto kinds = scene.features;
        model::FeatureKind team;
        team.id = 4;
        team.name = "team \"west\"";
        team.values.resize(2);
        team.values[0].id = 40;
        team.values[0].name = "home";
        team.values[0].clips = {{"cheer", 2.5F}};
        team.values[1].id = 41;
        team.values[1].name = "guest";
        kinds.push_back(team);
        changeFeatures(open, kinds, false);
    });
    edit("Features borne", [&](model::SceneEdit& open) {
        const std::vector<model::FeatureId> home(people.size(), 40);
        (void)setFeature(open, scene.features.back(), people, home, 3);
        const std::vector<model::FeatureId> sad(people.size(), 2);
        (void)setFeature(open, scene.features.front(), people, sad, 3);
    });
    edit("A feature changed with its bearers", [&](model::SceneEdit& open) {
        auto kinds = scene.features;
        kinds.back().values[0].setsHeight = true;
        kinds.back().values[0].height = {1.25F, 1.25F};
        changeFeatures(open, kinds, true);
    });
    edit("Values removed", [&](model::SceneEdit& open) {
        auto kinds = scene.features;
        kinds.back().values.erase(kinds.back().values.begin());
        kinds.front().values.erase(kinds.front().values.begin() + 1);
        changeFeatures(open, kinds, false);
    });
}

/// A session with mouse and keys: every kind of brush, some of it while it plays, the selection,
/// the individual panel, undo and redo.
class Session
{
public:
    explicit Session(Editor& editor) : m_editor(editor), m_size(editor.view().size()) {}

    void clearTheMiddle()
    {
        brush(model::BrushKind::Delete, model::BrushSelection::Rectangle);
        m_editor.drag(at(0.2, 0.2), at(0.8, 0.8));
    }
    void paint()
    {
        auto settings = brush(model::BrushKind::Create, model::BrushSelection::AllInCircle);
        settings.radiusPixels = 31.7F;
        m_editor.state().setBrush(settings);
        for (const double y : {0.35, 0.45, 0.55, 0.65}) {
            m_editor.drag(at(0.15, y), at(0.85, y + 0.03));
        }
        settings.selection = model::BrushSelection::Spray;
        settings.ratePerSecond = 120.0F;
        m_editor.state().setBrush(settings);
        m_editor.drag(at(0.5, 0.7), at(0.3, 0.4));
    }
    void recolour()
    {
        auto settings = brush(model::BrushKind::Colour, model::BrushSelection::AllInCircle);
        settings.op = model::BrushOperator::Random;
        settings.as<crowd::model::ColourSettings>().colors = {{200, 30, 60}, {20, 120, 220}};
        settings.as<crowd::model::ColourSettings>().strength = 0.73F;
        settings.as<crowd::model::ColourSettings>().blends = true;
        m_editor.state().setBrush(settings);
        m_editor.drag(at(0.2, 0.5), at(0.8, 0.55));
    }
    void shade()
    {
        auto settings = brush(model::BrushKind::Colour, model::BrushSelection::Rectangle);
        settings.op = model::BrushOperator::Gradient;
        m_editor.state().setBrush(settings);
        m_editor.drag(at(0.1, 0.1), at(0.9, 0.9));
    }
    void rotate()
    {
        brush(model::BrushKind::Orientation, model::BrushSelection::AllInCircle);
        m_editor.drag(at(0.3, 0.6), at(0.7, 0.4));
    }
    void animate()
    {
        auto settings = brush(model::BrushKind::Animation, model::BrushSelection::Rectangle);
        settings.as<crowd::model::AnimationSettings>().clips = {{"sit_clap", 1.0F},
                                                                {"sit_cheer", 0.3F}};
        m_editor.state().setBrush(settings);
        m_editor.drag(at(0.4, 0.4), at(0.7, 0.6));
    }
    /// As brushes do whose group was removed since.
    void nameWhatIsGone(std::uint32_t group)
    {
        auto colour = brush(model::BrushKind::Colour, model::BrushSelection::Rectangle);
        colour.mask.groups = {0, static_cast<int>(group)};
        m_editor.state().setBrush(colour);
        m_editor.drag(at(0.2, 0.2), at(0.8, 0.8));
        auto into = brush(model::BrushKind::Group, model::BrushSelection::Rectangle);
        into.as<crowd::model::GroupSettings>().group = group;
        m_editor.state().setBrush(into);
        m_editor.drag(at(0.4, 0.4), at(0.6, 0.6));
    }
    void remove()
    {
        m_editor.state().setTool(ToolId::Select);
        const auto ids = m_editor.window.document().scene().population.ids();
        m_editor.state().selection().set(std::array{ids[3], ids[7], ids[8]});
        QTest::keyClick(&m_editor.view(), Qt::Key_Delete);
    }
    /// With the individual panel, by numbers.
    void move()
    {
        auto* panel = m_editor.window.findChild<IndividualDock*>();
        panel->show();
        panel->raise();
        const auto ids = m_editor.window.document().scene().population.ids();
        m_editor.state().selection().set(std::array{ids[5], ids[6]});
        NumberField* height = nullptr;
        QTRY_VERIFY((height = testing::fieldBeside<NumberField>(*panel, QStringLiteral("Height"))));
        testing::type(*height, QLocale().toString(1.25, 'f', 2));
        m_editor.state().selection().set(std::array{ids[5]});
        NumberField* x = nullptr;
        for (NumberField* each : panel->findChildren<NumberField*>()) {
            x = each->toolTip().endsWith(QStringLiteral("along X")) ? each : x;
        }
        QVERIFY(x != nullptr);
        testing::type(*x, QLocale().toString(1.1, 'f', 1));
        panel->hide();
    }
    void act(const char* action) { m_editor.window.actions().action(action)->trigger(); }

private:
    model::BrushSettings brush(model::BrushKind kind, model::BrushSelection selection)
    {
        model::BrushSettings settings = m_editor.state().brush(kind);
        settings.selection = selection;
        settings.through = true;
        m_editor.state().setBrush(settings);
        m_editor.state().setTool(toolOf(kind));
        return settings;
    }
    [[nodiscard]] QPoint at(double x, double y) const
    {
        return {qRound(m_size.width() * x), qRound(m_size.height() * y)};
    }

    Editor& m_editor;
    QSize m_size;
};

} // namespace

class TestRecording : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void aSessionIsReplayedToTheSameBytesAndPicture();
    void strokesOnWalkersAreStrokes();
    void everyKindOfEditHasItsLines();
    void brushesMayNameWhatIsGone();
    void undoingWhatCameBeforeStartsAnew();
    void redoingBringsItBack();
    void anotherSceneEndsIt();

private:
    QTemporaryDir m_folder;
};

void TestRecording::init()
{
    QVERIFY(m_folder.isValid());
}

void TestRecording::aSessionIsReplayedToTheSameBytesAndPicture()
{
    const QString path = copyOfTheatre(m_folder);
    const QString script = m_folder.filePath(QStringLiteral("session.py"));
    QImage painted;
    {
        Editor editor;
        QVERIFY(editor.open(path));
        (void)editor.picture(); // all animations are there
        editor.window.actions().action("script-record")->trigger();
        QVERIFY(editor.window.recorder().isRecording());
        Session session(editor);
        session.clearTheMiddle();
        session.paint();
        (void)editor.picture();
        editor.state().transport().setPlaying(true); // people move while they are painted
        QTest::qWait(120);
        session.recolour();
        editor.state().transport().setPlaying(false);
        session.rotate();
        session.animate();
        session.remove();
        session.move();
        session.act("camera-add");
        session.act("undo");
        session.act("undo");
        session.act("undo");
        session.act("redo");
        session.act("redo");
        auto* view = editor.window.findChild<QPlainTextEdit*>(QStringLiteral("recordedScript"));
        QVERIFY(view != nullptr);
        const QString shown = view->toPlainText();
        for (const char* part : {"scene.stroke(create_brush", "scene.stroke(colour_brush",
                                 "scene.stroke(orientation_brush", "scene.remove(", "height=1.25",
                                 "scene.undo()", "scene.redo()"}) {
            QVERIFY2(shown.contains(QLatin1String(part)), part);
        }
        editor.window.actions().action("script-record")->trigger();
        QVERIFY(!editor.window.recorder().isRecording());
        const auto saved = editor.window.recorder().save(script);
        QVERIFY2(saved, saved ? "" : saved.error().message.c_str());
        QVERIFY(editor.window.files().save());
        editor.state().selection().clear();
        editor.state().setTool(ToolId::BrushCreate);
        editor.state().transport().rewind();
        editor.window.console().hide(); // as it is in another window
        painted = editor.picture();
    }
    const QByteArray wanted = contentOf(path);
    QVERIFY(!wanted.isEmpty());
    const QString plain = m_folder.filePath(QStringLiteral("plain.crowd"));
    QCOMPARE(replay(script, plain), QString());
    QVERIFY2(contentOf(plain) == wanted, "plain python3 gives another scene");
    const QString own = m_folder.filePath(QStringLiteral("own.crowd"));
    QCOMPARE(replayInProgram(script, own), QString());
    QVERIFY2(contentOf(own) == wanted, "crowdbrush script gives another scene");
    keepWhereWanted(script, own);
    Editor replayed;
    QVERIFY(replayed.open(plain));
    replayed.state().setTool(ToolId::BrushCreate);
    const QImage again = replayed.picture();
    QCOMPARE(again.size(), painted.size());
    QVERIFY2(again == painted, "the replayed scene looks different");
}

/// What a stroke says of people goes by whom it met; where it goes by where they were, it is said.
void TestRecording::strokesOnWalkersAreStrokes()
{
    QTemporaryDir folder; // the theatre is another one then
    const QString path = copyOfTheatre(folder);
    const QString script = folder.filePath(QStringLiteral("walkers.py"));
    {
        Editor editor;
        QVERIFY(editor.open(path));
        makeWalkers(editor.window.document());
        QVERIFY(editor.window.files().save());
        (void)editor.picture();
        editor.window.recorder().setRecording(true);
        QSignalSpy remarks(&editor.window.recorder(), &app::Recorder::remarked);
        editor.state().transport().setPlaying(true);
        QTRY_VERIFY_WITH_TIMEOUT(hasLeft(editor), 20'000);
        editor.state().transport().setPlaying(false);
        Session session(editor);
        session.paint();
        session.recolour();
        session.animate();
        QCOMPARE(remarks.count(), 0);
        session.shade(); // by where they are on screen
        QTRY_COMPARE(remarks.count(), 1);
        QVERIFY2(remarks.front().front().toString().contains(QStringLiteral("what came of it")),
                 qPrintable(remarks.front().front().toString()));
        editor.window.recorder().setRecording(false);
        QVERIFY(editor.window.recorder().save(script));
        QVERIFY(editor.window.files().save());
    }
    const QByteArray said = contentOf(script);
    for (const char* part : {"scene.stroke(create_brush", "scene.stroke(colour_brush",
                             "scene.stroke(animation_brush", "selected={"}) {
        QVERIFY2(said.contains(part), part);
    }
    QCOMPARE(said.count("scene.stroke(colour_brush"), 1);
    const QString again = folder.filePath(QStringLiteral("again.crowd"));
    QCOMPARE(replayInProgram(script, again), QString());
    QVERIFY2(contentOf(again) == contentOf(path), "the replay gives another scene");
}

/// Edits as the editor's parts make them, and odd ones: ids given out and taken back, seats and
/// templates exchanged, everything in one step.
void TestRecording::everyKindOfEditHasItsLines()
{
    const QString path = copyOfTheatre(m_folder);
    const QString script = m_folder.filePath(QStringLiteral("edits.py"));
    Editor editor;
    QVERIFY(editor.open(path));
    model::SceneDocument& document = editor.window.document();
    const model::Scene& scene = document.scene();
    editor.window.recorder().setRecording(true);
    const auto edit = [&document](const char* text, const auto& work) {
        const auto open = document.beginEdit().value();
        work(*open);
        QVERIFY2(open->commit(QLatin1String(text)), text);
    };
    const auto ids = std::vector(scene.population.ids().begin(), scene.population.ids().end());
    const std::array two{ids[2], ids[9]};
    edit("Two seats exchanged", [&](model::SceneEdit& open) {
        const model::IndividualRows rows = scene.population.rows(two);
        for (const auto column : {model::ColumnId::Seat, model::ColumnId::Position}) {
            auto bytes = rows.bytes[static_cast<std::size_t>(column)];
            std::rotate(bytes.begin(), bytes.begin() + static_cast<long>(bytes.size() / 2),
                        bytes.end());
            open.setColumn(column, two, bytes);
        }
    });
    edit("Another \"template\" \\ and clip", [&](model::SceneEdit& open) {
        for (const model::TemplateEntry& entry : scene.templates) {
            model::changeTemplate(open, std::span(ids).subspan(20, 5), entry.id);
        }
        const std::uint16_t clip = 1;
        open.setColumn(model::columns::clip, std::span(ids).subspan(22, 6),
                       std::span<const std::uint16_t>(&clip, 1));
    });
    edit("Ids with holes", [&](model::SceneEdit& open) {
        const auto made = open.addIndividuals(scene.population.rows(std::span(ids).first(6)));
        const model::SeatId none = model::kNoSeat;
        open.setColumn(model::columns::seat, made, std::span<const model::SeatId>(&none, 1));
        open.removeIndividuals(std::array{made[0], made[3], made[5]});
    });
    edit("Tags, groups, tints", [&](model::SceneEdit& open) {
        const std::uint64_t tags = 1ULL << 63U | 5U;
        open.setColumn(model::columns::tags, two, std::span<const std::uint64_t>(&tags, 1));
        const std::uint32_t group = 4'000'000'000U;
        open.setColumn(model::columns::group, std::span(ids).first(50),
                       std::span<const std::uint32_t>(&group, 1));
        const model::Tint tint{1, 2, 3, 4};
        open.setColumn(model::columns::tint(6), std::span(ids).subspan(3, 40),
                       std::span<const model::Tint>(&tint, 1));
    });
    edit("Template", [&](model::SceneEdit& open) {
        model::TemplateEntry entry = scene.templates.front();
        entry.id = 0;
        entry.name = "copy of 男";
        (void)open.addTemplate(entry);
    });
    edit("Template renamed", [&](model::SceneEdit& open) {
        model::TemplateEntry entry = scene.templates.back();
        entry.name = "renamed";
        open.changeTemplate(entry);
    });
    edit("Stage moved", [&](model::SceneEdit& open) {
        model::StageEntry entry = scene.stages.front();
        entry.name = "moved";
        entry.position = {0.1F, 0.2F, -1e-7F};
        entry.headingRadians = 0.333F;
        open.changeStage(entry);
    });
    edit("Second stage", [&](model::SceneEdit& open) {
        model::StageEntry entry = scene.stages.front();
        entry.id = 0;
        (void)open.addStage(entry);
    });
    edit("First stage away",
         [&](model::SceneEdit& open) { open.removeStage(scene.stages.back().id); });
    edit("Light and cameras", [&](model::SceneEdit& open) {
        model::Lighting light = scene.lighting;
        light.sunStrength = 0.1F;
        light.ground = {0.7F, 1.0F / 3.0F, 0.0F};
        light.showGroundGrid = !light.showGroundGrid;
        open.setLighting(light);
        auto cameras = scene.cameras;
        std::reverse(cameras.begin(), cameras.end());
        cameras.push_back({"flat", cameras.front().camera});
        cameras.back().camera.projection = model::Projection::Orthographic;
        open.setCameras(cameras);
    });
    edit("Places and a path", [&](model::SceneEdit& open) {
        model::Path round;
        for (const float x : {0.1F, 4.7F, 9.3F}) {
            model::Place place;
            place.name = "place \"" + std::to_string(x) + '"';
            place.position = {x, 0.0F, x * 0.3F};
            round.places.push_back(open.addPlace(place));
        }
        const model::PathId id = open.addPath(round);
        open.setColumn(model::columns::path, two, std::span<const model::PathId>(&id, 1));
        open.setTags({{3, "happy", {1, 2, 3}}});
        model::Rule rule;
        rule.id = 1;
        rule.name = "cheer";
        model::actions::PlayClip play;
        play.seconds = 0.7F;
        rule.actions = {play};
        open.setRules({rule});
    });
    edit("A place away",
         [&](model::SceneEdit& open) { open.removePlace(scene.paths.front().places.front()); });
    edit("The path away", [&](model::SceneEdit& open) { open.removePath(scene.paths.front().id); });
    edit("States kept", [&](model::SceneEdit& open) {
        for (const char* name : {"calm", "\"wild\"", "gone"}) {
            putState(open, keepState(scene, name, model::usualStateColumns(), two));
        }
    });
    edit("A state as it is no more", [&](model::SceneEdit& open) {
        putState(open, keepState(scene, "calm", {model::ColumnId::Phase}, std::span(ids).first(9)));
        const float phase = 0.375F;
        open.setColumn(model::columns::phase, two, std::span<const float>(&phase, 1));
    });
    edit("States changed", [&](model::SceneEdit& open) {
        auto states = scene.states;
        states.pop_back();
        std::swap(states[0], states[1]);
        states[1].name = "quiet";
        open.setStates(std::move(states));
    });
    edit("A state recalled", [&](model::SceneEdit& open) {
        (void)recallState(open, scene.states[1], scene.states[1].columns);
    });
    recordFeatures(edit, scene, two);
    recordTakes(edit, m_folder.filePath(QStringLiteral("kept.takes")));
    edit("Everybody moved", [&](model::SceneEdit& open) {
        auto all = std::vector(scene.population.ids().begin(), scene.population.ids().end());
        auto rows = scene.population.rows(all);
        for (glm::vec3& each : rows.column(model::columns::position)) {
            each = each * 1.0001F + glm::vec3(0.1F, 0.0F, 1e-9F);
        }
        open.setColumn(model::columns::position, all,
                       std::span<const glm::vec3>(rows.column(model::columns::position)));
    });
    editor.window.recorder().setRecording(false);
    QVERIFY(editor.window.recorder().save(script));
    QVERIFY(editor.window.files().save());
    const QString plain = m_folder.filePath(QStringLiteral("edits.crowd"));
    QCOMPARE(replay(script, plain), QString());
    QVERIFY(contentOf(plain) == contentOf(path));
    keepWhereWanted(script, plain);
}

void TestRecording::brushesMayNameWhatIsGone()
{
    const QString path = copyOfTheatre(m_folder);
    const QString script = m_folder.filePath(QStringLiteral("gone.py"));
    Editor editor;
    QVERIFY(editor.open(path));
    (void)editor.picture(); // all animations are there
    editor.window.recorder().setRecording(true);
    Session session(editor);
    session.nameWhatIsGone(77);
    editor.window.recorder().setRecording(false);
    QVERIFY(editor.window.recorder().save(script));
    QVERIFY(editor.window.files().save());
    QCOMPARE(contentOf(script).count("scene.stroke("), 2);
    QCOMPARE(contentOf(script).count("allow_missing=True"), 2);
    const QString plain = m_folder.filePath(QStringLiteral("gone.crowd"));
    QCOMPARE(replay(script, plain), QString());
    QVERIFY(contentOf(plain) == contentOf(path));
}

void TestRecording::undoingWhatCameBeforeStartsAnew()
{
    const QString path = copyOfTheatre(m_folder);
    const QString script = m_folder.filePath(QStringLiteral("anew.py"));
    Editor editor;
    QVERIFY(editor.open(path));
    Session session(editor);
    session.clearTheMiddle();
    session.act("script-record");
    session.remove();
    session.act("undo");
    session.act("undo"); // of what was done before
    QVERIFY(editor.window.recorder().isRecording());
    QVERIFY(editor.window.recorder().isEmpty());
    session.remove();
    session.act("script-record");
    QVERIFY(editor.window.recorder().save(script));
    QVERIFY(editor.window.files().save());
    const QString plain = m_folder.filePath(QStringLiteral("anew.crowd"));
    QCOMPARE(replay(script, plain), QString());
    QVERIFY(contentOf(plain) == contentOf(path));
}

void TestRecording::redoingBringsItBack()
{
    const QString path = copyOfTheatre(m_folder);
    const QString script = m_folder.filePath(QStringLiteral("back.py"));
    Editor editor;
    QVERIFY(editor.open(path));
    Session session(editor);
    session.clearTheMiddle();
    session.remove();
    session.act("script-record");
    session.paint();
    session.remove();
    const int made = editor.window.document().undoStack().count() - 2;
    const auto stepMany = [&session](const char* action, int count) {
        for (int i = 0; i < count; ++i) {
            session.act(action);
        }
    };
    stepMany("undo", made);
    const auto* view = editor.window.findChild<QPlainTextEdit*>(QStringLiteral("recordedScript"));
    const QString shown = view->toPlainText();
    const std::string before = editor.window.recorder().script();
    stepMany("undo", 2); // of what was done before
    QVERIFY(editor.window.recorder().isEmpty());
    stepMany("redo", 2);
    QCOMPARE(editor.window.recorder().script(), before);
    QCOMPARE(view->toPlainText(), shown);
    stepMany("redo", made);
    session.act("script-record");
    QVERIFY(editor.window.recorder().save(script));
    QVERIFY(editor.window.files().save());
    const QString plain = m_folder.filePath(QStringLiteral("back.crowd"));
    QCOMPARE(replay(script, plain), QString());
    QVERIFY(contentOf(plain) == contentOf(path));
}

void TestRecording::anotherSceneEndsIt()
{
    const QString path = copyOfTheatre(m_folder);
    Editor editor;
    QVERIFY(editor.open(path));
    Session session(editor);
    session.act("script-record");
    session.remove();
    editor.window.document().undoStack().setClean();
    QVERIFY(editor.open(path));
    QVERIFY(!editor.window.recorder().isRecording());
    QVERIFY2(!editor.window.recorder().isEmpty(), "what was recorded stays");
    const auto buttons = editor.window.console().findChildren<QToolButton*>();
    const auto copy = std::find_if(buttons.begin(), buttons.end(), [](const QToolButton* button) {
        return button->text() == QStringLiteral("Copy");
    });
    QVERIFY(copy != buttons.end());
    (*copy)->click();
    QVERIFY(QApplication::clipboard()->text().contains(QStringLiteral("scene.remove(")));
}

CROWD_WINDOW_TEST(TestRecording)
#include "tst_Recording.moc"
