// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include <QtTest/QTest>

#include "model/states/StateKeeping.h"
#include "tests/model/LivelyBrush.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

constexpr auto kAll = BrushSelection::Rectangle;

/// A rectangle over the whole crowd.
StrokeOutcome paintAll(LivelyScene& scene, const BrushSettings& settings, std::uint64_t seed = 7)
{
    return scene.paint(fromAbove(), settings, {{200, 100}, {1100, 700}}, seed);
}

template<class T>
std::vector<T> sortedOf(const LivelyScene& scene, ColumnKey<T> key, TemplateId id)
{
    std::vector<T> values;
    for (std::size_t row = 0; row < scene.people().size(); ++row) {
        if (scene.people().column(columns::templateId)[row] == id) {
            values.push_back(scene.people().column(key)[row]);
        }
    }
    std::ranges::sort(values);
    return values;
}

} // namespace

/// Brushes that exchange who people are and what they have, or give it back.
class tst_BrushExchange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void templatesKeepWhatFitsByName();
    void templatesByTheLine();
    void missingTemplatesAreSaid();
    void shuffleGivesEachValueOnOnce();
    void shuffleKeepsWhatIsNotChosen();
    void restoreIsAsTheTemplateHasIt();
    void restoreIsAsItWasEarlier();
    void statesAreGivenBack();
    void nothingChosenIsSaid();
};

void tst_BrushExchange::templatesKeepWhatFitsByName()
{
    LivelyScene scene;
    const Ids ids = scene.addCrowd();
    const Population before = scene.people();
    BrushSettings settings = brush(BrushKind::Template, kAll);
    settings.as<TemplateSettings>().templates = {kOtherMan};
    const StrokeOutcome outcome = paintAll(scene, settings);
    QCOMPARE(outcome.affected, 30);
    const Population& after = scene.people();
    for (const IndividualId id : ids) {
        const std::size_t row = after.rowOf(id);
        QCOMPARE(after.column(columns::templateId)[row], kOtherMan);
        const bool isNew = before.column(columns::templateId)[row] == 1;
        const auto choices = after.column(columns::materialChoices)[row];
        const auto had = before.column(columns::materialChoices)[row];
        QCOMPARE(choices[0], isNew ? had[2] : had[0]); // "bottom" is the other man's first slot
        QCOMPARE(choices[2], isNew ? had[0] : had[2]);
        QCOMPARE(after.column(columns::parts)[row] & 3U, before.column(columns::parts)[row] & 3U);
        QVERIFY(after.column(columns::tint(1))[row] == before.column(columns::tint(1))[row]);
        QCOMPARE(after.column(columns::height)[row], before.column(columns::height)[row]);
        QVERIFY(after.column(columns::position)[row] == before.column(columns::position)[row]);
    }
    QCOMPARE(paintAll(scene, settings).reason, StrokeReason::Unchanged);
}

void tst_BrushExchange::templatesByTheLine()
{
    LivelyScene scene;
    scene.addCrowd();
    BrushSettings settings = brush(BrushKind::Template, kAll);
    settings.op = BrushOperator::Gradient;
    settings.as<TemplateSettings>().templates = {1, kOtherMan};
    QVERIFY(scene.paint(fromAbove(), settings, {{200, 100}, {1100, 700}}).isCommitted);
    const auto positions = scene.people().column(columns::position);
    const auto templates = scene.people().column(columns::templateId);
    for (std::size_t row = 0; row < positions.size(); ++row) {
        if (positions[row].x < -4.0F && positions[row].z < -2.0F) {
            QCOMPARE(templates[row], TemplateId{1});
        } else if (positions[row].x > 4.0F && positions[row].z > 2.0F) {
            QCOMPARE(templates[row], kOtherMan);
        }
    }
}

void tst_BrushExchange::missingTemplatesAreSaid()
{
    LivelyScene scene;
    scene.addCrowd();
    BrushSettings settings = brush(BrushKind::Template, kAll);
    QCOMPARE(paintAll(scene, settings).reason, StrokeReason::NothingChosen);
    settings.as<TemplateSettings>().templates = {77};
    QCOMPARE(paintAll(scene, settings).reason, StrokeReason::TemplateNotLoaded);
}

void tst_BrushExchange::shuffleGivesEachValueOnOnce()
{
    LivelyScene scene;
    scene.addCrowd();
    const Population before = scene.people();
    BrushSettings settings = brush(BrushKind::Shuffle, kAll);
    settings.as<ShuffleSettings>() = {true, true, true, true, true};
    for (const TemplateId id : {TemplateId{1}, kOtherMan}) {
        const auto heights = sortedOf(scene, columns::height, id);
        const auto phases = sortedOf(scene, columns::phase, id);
        QVERIFY(paintAll(scene, settings).isCommitted);
        QVERIFY(sortedOf(scene, columns::height, id) == heights);
        QVERIFY(sortedOf(scene, columns::phase, id) == phases);
    }
    const auto now = scene.people().column(columns::phase);
    const auto had = before.column(columns::phase);
    const int moved = std::inner_product(now.begin(), now.end(), had.begin(), 0, std::plus<>(),
                                         std::not_equal_to<>());
    QVERIFY2(moved > 40, qPrintable(QString::number(moved)));
}

void tst_BrushExchange::shuffleKeepsWhatIsNotChosen()
{
    LivelyScene scene;
    scene.addCrowd();
    const Population before = scene.people();
    BrushSettings settings = brush(BrushKind::Shuffle, kAll);
    settings.as<ShuffleSettings>() = {false, true, false, false, false};
    QVERIFY(paintAll(scene, settings).isCommitted);
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const auto column = static_cast<ColumnId>(c);
        const bool isSize = column == ColumnId::Height || column == ColumnId::Girth;
        const auto now = scene.people().columnBytes(column);
        const auto had = before.columnBytes(column);
        QCOMPARE(!std::ranges::equal(now, had), isSize);
    }
    // Height and girth of one go on together.
    std::map<float, float> girths;
    for (std::size_t row = 0; row < before.size(); ++row) {
        girths[before.column(columns::height)[row]] = before.column(columns::girth)[row];
    }
    for (std::size_t row = 0; row < before.size(); ++row) {
        QCOMPARE(scene.people().column(columns::girth)[row],
                 girths.at(scene.people().column(columns::height)[row]));
    }
}

void tst_BrushExchange::restoreIsAsTheTemplateHasIt()
{
    LivelyScene scene;
    const Ids ids = scene.addCrowd();
    const auto edit = scene.document.beginEdit().value();
    const std::vector<std::uint16_t> cheering(ids.size(), 2);
    edit->setColumn(columns::clip, ids, std::span<const std::uint16_t>(cheering));
    edit->commit(QStringLiteral("Cheer"));
    BrushSettings settings = brush(BrushKind::Restore, kAll);
    settings.as<RestoreSettings>() = {
        RestoreSource::Template, 0, true, true, true, true, true, true};
    QVERIFY(paintAll(scene, settings).isCommitted);
    const Population& people = scene.people();
    for (std::size_t row = 0; row < people.size(); ++row) {
        QVERIFY(people.column(columns::tint(1))[row] == Tint());
        QVERIFY(people.column(columns::materialChoices)[row] == MaterialChoices());
        QCOMPARE(people.column(columns::parts)[row] & 3U, 1U); // the hat, as by default
        QCOMPARE(people.column(columns::height)[row], 1.0F);
        QCOMPARE(people.column(columns::girth)[row], 1.0F);
        QCOMPARE(people.column(columns::playbackSpeed)[row], 1.0F);
        const bool isOther = people.column(columns::templateId)[row] == kOtherMan;
        QCOMPARE(people.column(columns::clip)[row], std::uint16_t(isOther ? 2 : 0)); // idle
    }
    QCOMPARE(paintAll(scene, settings).reason, StrokeReason::Unchanged);
}

/// Whitened three times over: what was there at creation, at the last save and before the brush
/// comes back, to whom was there then.
void tst_BrushExchange::restoreIsAsItWasEarlier()
{
    LivelyScene scene;
    const Ids ids = scene.addCrowd();
    const auto tints = [&scene] {
        const auto column = scene.people().column(columns::tint(1));
        return std::vector<Tint>(column.begin(), column.end());
    };
    const auto paint = [&](const Tint& tint) {
        const std::vector<Tint> all(scene.people().size(), tint);
        const auto edit = scene.document.beginEdit().value();
        const Ids everybody(scene.people().ids().begin(), scene.people().ids().end());
        edit->setColumn(columns::tint(1), everybody, std::span<const Tint>(all));
        edit->commit(QStringLiteral("Paint"));
        return all;
    };
    const auto restored = [&](RestoreSource source) {
        BrushSettings settings = brush(BrushKind::Restore, kAll);
        settings.as<RestoreSettings>() = {source, 0, true, true, false, false, false, false};
        (void)paintAll(scene, settings);
        return tints();
    };
    std::vector<Tint> created(ids.size()); // then nobody wore anything
    const std::vector<Tint> saved = paint({10, 20, 30, 255});
    for (std::size_t row = 0; row < ids.size(); ++row) { // who became somebody else stays so
        const bool isOther = scene.people().column(columns::templateId)[row] == kOtherMan;
        created[row] = isOther ? saved[row] : created[row];
    }
    scene.document.markSaved({});
    const std::vector<Tint> before = paint({40, 50, 60, 255});
    scene.document.rememberPeople();
    const std::vector<Tint> now = paint({70, 80, 90, 255});
    QVERIFY(restored(RestoreSource::Before) == before);
    scene.document.undoStack().undo();
    QVERIFY(restored(RestoreSource::Saved) == saved);
    QVERIFY(restored(RestoreSource::Created) == created);
    QVERIFY(restored(RestoreSource::Template) == std::vector<Tint>(ids.size()));
    const Ids late = scene.addPeople({{0.0F, 0.0F, 0.0F}});
    QVERIFY(paint(now.front()) == std::vector<Tint>(ids.size() + 1, now.front()));
    std::vector<Tint> expected = saved; // who came later keeps what he has
    expected.push_back(now.front());
    QVERIFY(restored(RestoreSource::Saved) == expected);
    scene.document.undoStack().undo();
    BrushSettings settings = brush(BrushKind::Restore, kAll);
    settings.as<RestoreSettings>().source = RestoreSource::Created;
    bool isExact = true; // a script cannot say it again
    const auto connection =
        QObject::connect(&scene.document, &SceneDocument::stepCommitted,
                         [&isExact](const StepCommitted& step) { isExact = step.stroke->isExact; });
    QVERIFY(paintAll(scene, settings).isCommitted);
    QVERIFY(!isExact);
    QObject::disconnect(connection);
}

void tst_BrushExchange::statesAreGivenBack()
{
    LivelyScene scene;
    const Ids ids = scene.addCrowd();
    const auto put = [&](float height, Tint tint) {
        scene.document.edit(QStringLiteral("Put"), [&](SceneEdit& edit) {
            edit.setColumn(columns::height, ids, std::span<const float>(&height, 1));
            edit.setColumn(columns::tint(0), ids, std::span<const Tint>(&tint, 1));
        });
    };
    put(1.25F, {1, 2, 3, 255});
    scene.document.edit(QStringLiteral("Keep"), [&](SceneEdit& edit) {
        putState(edit, keepState(edit.scene(), "small", usualStateColumns(),
                                 std::span(ids).first(ids.size() - 1)));
    });
    put(2.0F, {9, 9, 9, 255});
    const Population before = scene.people();
    BrushSettings restore = brush(BrushKind::Restore, kAll);
    restore.as<RestoreSettings>().source = RestoreSource::State;
    QCOMPARE(paintAll(scene, restore).reason, StrokeReason::NoState);
    restore.as<RestoreSettings>().state = 1;
    scene.keyframes.waitForAll(); // who is on screen has his clip
    bool isExact = false;
    const auto connection =
        QObject::connect(&scene.document, &SceneDocument::stepCommitted,
                         [&isExact](const StepCommitted& step) { isExact = step.stroke->isExact; });
    QVERIFY(paintAll(scene, restore).isCommitted);
    QObject::disconnect(connection);
    QVERIFY2(isExact, "the state is in the scene: a script can say it again");
    QCOMPARE(scene.people().column(columns::height)[0], 1.25F);
    QCOMPARE(scene.people().column(columns::tint(0))[0], (Tint{1, 2, 3, 255}));
    QCOMPARE(scene.people().column(columns::height).back(), 2.0F); // is not in it
    QVERIFY(paintAll(scene, restore).reason == StrokeReason::Unchanged);
    scene.document.undoStack().undo();
    QCOMPARE(scene.people(), before);
    // What is ticked alone.
    restore.as<RestoreSettings>().isWhole = false;
    restore.as<RestoreSettings>().materials = false;
    restore.as<RestoreSettings>().parts = false;
    QVERIFY(paintAll(scene, restore).isCommitted);
    QCOMPARE(scene.people().column(columns::height)[0], 2.0F);
    QCOMPARE(scene.people().column(columns::tint(0))[0], (Tint{1, 2, 3, 255}));
}

void tst_BrushExchange::nothingChosenIsSaid()
{
    LivelyScene scene;
    scene.addCrowd();
    BrushSettings restore = brush(BrushKind::Restore, kAll);
    restore.as<RestoreSettings>() = {
        RestoreSource::Template, 0, true, false, false, false, false, false};
    QCOMPARE(paintAll(scene, restore).reason, StrokeReason::NothingChosen);
    BrushSettings shuffle = brush(BrushKind::Shuffle, kAll);
    shuffle.as<ShuffleSettings>() = {false, false, false, false, false};
    QCOMPARE(paintAll(scene, shuffle).reason, StrokeReason::NothingChosen);
}

CROWD_TEST(tst_BrushExchange)
#include "tst_BrushExchange.moc"
