// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <QtTest/QTest>
#include <glm/geometric.hpp>

#include "model/brush/TakenFrom.h"
#include "model/scene/CrowdFrame.h"
#include "tests/model/LivelyBrush.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

constexpr auto kEverywhere = BrushSelection::Rectangle;

struct Meadow : LivelyScene
{
    Ids ids = addCrowd();

    StrokeOutcome paintAll(const BrushSettings& settings, std::uint64_t seed = 7)
    {
        return paint(fromAbove(), settings, {{200, 100}, {1100, 700}}, seed);
    }
    template<class T>
    [[nodiscard]] T value(ColumnKey<T> key, IndividualId id) const
    {
        return people().column(key)[people().rowOf(id)];
    }
    template<class T>
    void set(ColumnKey<T> key, std::span<const IndividualId> who, const T& value)
    {
        const auto edit = document.beginEdit().value();
        edit->setColumn(key, who, std::span<const T>(&value, 1));
        edit->commit(QStringLiteral("Set"));
    }
    /// Where in its clip somebody is at a time, 0..1.
    [[nodiscard]] float placeAt(IndividualId id, double seconds) const
    {
        const TemplateEntry& entry = *document.scene().findTemplate(value(columns::templateId, id));
        const int clip = entry.asset->clipIndex(entry.clipNames[value(columns::clip, id)]);
        return shownPhase(entry.asset->clips[static_cast<std::size_t>(clip)],
                          value(columns::phase, id), value(columns::playbackSpeed, id), seconds);
    }
    /// The least distance between two people.
    [[nodiscard]] float closest() const
    {
        float least = 1e9F;
        const auto positions = people().column(columns::position);
        for (std::size_t a = 0; a < positions.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                least = std::min(least, glm::distance(positions[a], positions[b]));
            }
        }
        return least;
    }
};

float apartOf(float place)
{
    return std::min(place, 1.0F - place); // of the beginning, forwards or backwards
}

} // namespace

/// Brushes that look at where people are and at those around them: time, clone, smooth, push; and
/// parts.
class tst_BrushNeighbours : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void inStepAllBeginAtOnce();
    void wavesRunAlongTheStroke();
    void ripplesRunFromThePress();
    void rangesOfDelaysAreKept();
    void clonesHaveWhatIsChosen();
    void clonesKeepTheirTemplate();
    void cloningNobodyIsSaid();
    void smoothingBringsValuesTogether();
    void headingsAreSmoothedTheShortWay();
    void peopleArePushedAlong();
    void pushingDependsOnThePlaceInTheCircle();
    void gatheringLeavesRoomForBodies();
    void spreadingMakesRoom();
    void combingTurns();
    void whoSitsIsNotPushed();
    void partsAreShownAndHidden();
    void aShareOfThemGetsTheParts();
    void whatIsTakenIsWhatIsGiven_data();
    void whatIsTakenIsWhatIsGiven();
};

void tst_BrushNeighbours::inStepAllBeginAtOnce()
{
    Meadow meadow;
    BrushSettings settings = brush(BrushKind::Time, kEverywhere);
    settings.as<TimeSettings>().mode = TimeMode::InStep;
    settings.as<TimeSettings>().delay = {0.75F, 2.0F};
    QVERIFY(meadow.paintAll(settings).affected > 50);
    for (const IndividualId id : meadow.ids) {
        QVERIFY(apartOf(meadow.placeAt(id, 0.75)) < 1e-3F);
    }
    QCOMPARE(meadow.paintAll(settings).reason, StrokeReason::Unchanged);
}

void tst_BrushNeighbours::wavesRunAlongTheStroke()
{
    Meadow meadow;
    meadow.set(columns::playbackSpeed, meadow.ids, 0.01F); // one clip lasts longer than the wave
    BrushSettings settings = brush(BrushKind::Time, BrushSelection::AllInCircle);
    settings.radiusPixels = 900.0F;
    settings.as<TimeSettings>().mode = TimeMode::Wave;
    settings.as<TimeSettings>().waveSpeed = 2.0F;
    QCOMPARE(meadow.paint(fromAbove(), settings, {{640, 384}}).reason, StrokeReason::NoDirection);
    // To the right on the screen is +X.
    QVERIFY(meadow.paint(fromAbove(), settings, {{200, 384}, {1000, 384}}).isCommitted);
    for (const IndividualId id : meadow.ids) {
        const double begins = static_cast<double>(meadow.value(columns::position, id).x) / 2.0;
        QVERIFY(apartOf(meadow.placeAt(id, begins)) < 1e-3F);
    }
}

void tst_BrushNeighbours::ripplesRunFromThePress()
{
    Meadow meadow;
    meadow.set(columns::playbackSpeed, meadow.ids, 0.01F);
    BrushSettings settings = brush(BrushKind::Time, BrushSelection::AllInCircle);
    settings.radiusPixels = 900.0F;
    settings.as<TimeSettings>().mode = TimeMode::Ripple;
    settings.as<TimeSettings>().waveSpeed = 4.0F;
    const glm::vec3 middle = meadow.value(columns::position, meadow.ids[24]);
    const glm::dvec2 press = pixelOf(fromAbove(), middle);
    QVERIFY(
        meadow.paint(fromAbove(), settings, {press, press + glm::dvec2(20.0, 5.0)}).isCommitted);
    for (const IndividualId id : meadow.ids) {
        const double begins =
            static_cast<double>(glm::distance(meadow.value(columns::position, id), middle)) / 4.0;
        QVERIFY(apartOf(meadow.placeAt(id, begins)) < 1e-3F);
    }
}

void tst_BrushNeighbours::rangesOfDelaysAreKept()
{
    Meadow meadow;
    meadow.set(columns::playbackSpeed, meadow.ids, 1.0F); // all clips last a second
    BrushSettings settings = brush(BrushKind::Time, kEverywhere);
    settings.op = BrushOperator::Random;
    settings.as<TimeSettings>().delay = {0.2F, 0.6F};
    QVERIFY(meadow.paintAll(settings).isCommitted);
    float least = 1.0F;
    float most = 0.0F;
    for (const IndividualId id : meadow.ids) {
        const float delay = 1.0F - meadow.placeAt(id, 0.0);
        least = std::min(least, delay);
        most = std::max(most, delay);
    }
    QVERIFY2(least >= 0.199F && least < 0.25F, qPrintable(QString::number(least)));
    QVERIFY2(most <= 0.601F && most > 0.55F, qPrintable(QString::number(most)));
}

void tst_BrushNeighbours::clonesHaveWhatIsChosen()
{
    Meadow meadow;
    const IndividualId source = meadow.ids[30];
    const std::uint16_t cheering = 2;
    meadow.set(columns::clip, std::span(&source, 1), cheering);
    const Population before = meadow.people();
    BrushSettings settings = brush(BrushKind::Clone, kEverywhere);
    settings.as<CloneSettings>().source = source;
    QVERIFY(meadow.paintAll(settings).isCommitted);
    for (const IndividualId id : meadow.ids) {
        QCOMPARE(meadow.value(columns::templateId, id), meadow.value(columns::templateId, source));
        QVERIFY(meadow.value(columns::tint(1), id) == meadow.value(columns::tint(1), source));
        QCOMPARE(meadow.value(columns::height, id), meadow.value(columns::height, source));
        QCOMPARE(meadow.value(columns::clip, id), meadow.value(columns::clip, source));
        const std::size_t row = before.rowOf(id);
        QCOMPARE(meadow.value(columns::heading, id), before.column(columns::heading)[row]);
        QVERIFY(meadow.value(columns::position, id) == before.column(columns::position)[row]);
    }
    const Population& people = meadow.people();
    for (const ColumnId column : {ColumnId::Height, ColumnId::Tint1, ColumnId::Parts}) {
        QCOMPARE(people.values(column, std::array{source}),
                 before.values(column, std::array{source})); // who is cloned stays
    }
}

void tst_BrushNeighbours::clonesKeepTheirTemplate()
{
    Meadow meadow;
    const IndividualId source = meadow.ids[30]; // of the box man
    const std::uint16_t cheering = 2;
    const Tint red{250, 0, 0, 255};
    meadow.set(columns::clip, std::span(&source, 1), cheering);
    meadow.set(columns::tint(2), std::span(&source, 1), red); // bottom
    BrushSettings settings = brush(BrushKind::Clone, kEverywhere);
    settings.as<CloneSettings>().source = source;
    settings.as<CloneSettings>().templateToo = false;
    QVERIFY(meadow.paintAll(settings).isCommitted);
    const IndividualId other = meadow.ids[31];
    QCOMPARE(meadow.value(columns::templateId, other), kOtherMan);
    QCOMPARE(meadow.value(columns::clip, other), std::uint16_t{0}); // cheers, there the first
    QVERIFY(meadow.value(columns::tint(0), other) == red);          // bottom, there the first
}

void tst_BrushNeighbours::cloningNobodyIsSaid()
{
    Meadow meadow;
    BrushSettings settings = brush(BrushKind::Clone, kEverywhere);
    QCOMPARE(meadow.paintAll(settings).reason, StrokeReason::NobodyChosen);
    settings.as<CloneSettings>().source = 4711;
    QCOMPARE(meadow.paintAll(settings).reason, StrokeReason::NobodyChosen);
    settings.as<CloneSettings>() = {};
    settings.as<CloneSettings>().source = meadow.ids[3];
    settings.as<CloneSettings>().templateToo = false;
    settings.as<CloneSettings>().looks = false;
    settings.as<CloneSettings>().size = false;
    settings.as<CloneSettings>().clips = false;
    QCOMPARE(meadow.paintAll(settings).reason, StrokeReason::NothingChosen);
}

void tst_BrushNeighbours::smoothingBringsValuesTogether()
{
    Meadow meadow;
    const IndividualId giant = meadow.ids[25];
    meadow.set(columns::height, meadow.ids, 1.0F);
    meadow.set(columns::height, std::span(&giant, 1), 2.0F);
    BrushSettings settings = brush(BrushKind::Smooth, kEverywhere);
    settings.buildUp = true;
    settings.flow = 0.5F;
    settings.as<SmoothSettings>().distance = 1.1F; // four of them
    QVERIFY(meadow.paintAll(settings).isCommitted);
    QCOMPARE(meadow.value(columns::height, giant), 1.5F);
    QCOMPARE(meadow.value(columns::height, meadow.ids[26]), 1.125F); // a quarter of one, halfway
    QCOMPARE(meadow.value(columns::height, meadow.ids[28]), 1.0F);
    QCOMPARE(meadow.value(columns::heading, giant), 3.0F * 25.0F / 60.0F - 1.0F); // not chosen
}

void tst_BrushNeighbours::headingsAreSmoothedTheShortWay()
{
    Meadow meadow;
    const IndividualId one = meadow.ids[25];
    meadow.set(columns::heading, meadow.ids, 3.1F);
    meadow.set(columns::heading, std::span(&one, 1), -3.1F);
    BrushSettings settings = brush(BrushKind::Smooth, kEverywhere);
    settings.as<SmoothSettings>() = {1.1F, false, true, false, false, false};
    QVERIFY(meadow.paintAll(settings).isCommitted);
    QVERIFY(std::abs(meadow.value(columns::heading, one) - 3.1F) < 1e-4F);
    QVERIFY(std::abs(meadow.value(columns::heading, meadow.ids[26])) > 3.0F); // not through 0
}

void tst_BrushNeighbours::peopleArePushedAlong()
{
    Meadow meadow;
    const Population before = meadow.people();
    BrushSettings settings = brush(BrushKind::Push, BrushSelection::AllInCircle);
    settings.buildUp = true;
    settings.radiusPixels = 500.0F; // all of them
    QVERIFY(meadow.paint(fromAbove(), settings, {{600, 384}, {728, 384}}).isCommitted);
    // The pointer went 2 m to the right; in the middle they went about as far.
    const glm::vec3 moved = meadow.value(columns::position, meadow.ids[25]) -
                            before.column(columns::position)[before.rowOf(meadow.ids[25])];
    QVERIFY2(moved.x > 1.0F && moved.x < 2.6F, qPrintable(QString::number(moved.x)));
    QVERIFY(std::abs(moved.z) < 1e-3F && moved.y == 0.0F);
    QVERIFY(meadow.closest() >= 0.39F);
}

void tst_BrushNeighbours::pushingDependsOnThePlaceInTheCircle()
{
    Meadow meadow;
    const Population before = meadow.people();
    BrushSettings settings = brush(BrushKind::Push, BrushSelection::AllInCircle);
    settings.buildUp = true;
    settings.radiusPixels = 150.0F;
    const auto moved = [&](IndividualId id) {
        return meadow.value(columns::position, id).x -
               before.column(columns::position)[before.rowOf(id)].x;
    };
    QVERIFY(meadow.paint(fromAbove(), settings, {{640, 384}, {680, 384}}).isCommitted);
    QVERIFY(moved(meadow.ids[25]) > moved(meadow.ids[15])); // a row further away
    QCOMPARE(moved(meadow.ids[0]), 0.0F);
}

void tst_BrushNeighbours::gatheringLeavesRoomForBodies()
{
    Meadow meadow;
    const auto extent = [&meadow] {
        float most = 0.0F;
        for (const IndividualId id : meadow.ids) {
            most = std::max(most, glm::length(meadow.value(columns::position, id)));
        }
        return most;
    };
    const float wide = extent();
    BrushSettings settings = brush(BrushKind::Push, BrushSelection::AllInCircle);
    settings.as<PushSettings>().mode = PushMode::Gather;
    settings.buildUp = true;
    settings.radiusPixels = 600.0F;
    std::vector<glm::dvec2> way;
    for (int i = 0; i < 20; ++i) {
        way.emplace_back(i % 2 == 0 ? 480 : 800, 384);
    }
    QVERIFY(meadow.paint(fromAbove(), settings, way).isCommitted);
    QVERIFY2(extent() < 0.8F * wide, qPrintable(QString::number(extent())));
    QVERIFY2(meadow.closest() >= 0.39F, qPrintable(QString::number(meadow.closest())));
}

void tst_BrushNeighbours::spreadingMakesRoom()
{
    Meadow meadow;
    meadow.set(columns::position, std::span(meadow.ids).first(5), glm::vec3(0.2F, 0.0F, 0.1F));
    QCOMPARE(meadow.closest(), 0.0F);
    BrushSettings settings = brush(BrushKind::Push, BrushSelection::AllInCircle);
    settings.as<PushSettings>().mode = PushMode::Spread;
    settings.as<PushSettings>().distance = 0.8F;
    settings.buildUp = true;
    settings.radiusPixels = 700.0F;
    std::vector<glm::dvec2> way;
    for (int i = 0; i < 40; ++i) {
        way.emplace_back(i % 2 == 0 ? 480 : 800, 384);
    }
    QVERIFY(meadow.paint(fromAbove(), settings, way).isCommitted);
    QVERIFY2(meadow.closest() > 0.5F, qPrintable(QString::number(meadow.closest())));
}

void tst_BrushNeighbours::combingTurns()
{
    Meadow meadow;
    BrushSettings settings = brush(BrushKind::Push, BrushSelection::AllInCircle);
    settings.as<PushSettings>().mode = PushMode::Comb;
    settings.buildUp = true;
    settings.radiusPixels = 900.0F;
    QVERIFY(meadow.paint(fromAbove(), settings, {{400, 384}, {900, 384}}).isCommitted);
    const float toTheRight = 1.5707964F;
    QVERIFY(std::abs(meadow.value(columns::heading, meadow.ids[25]) - toTheRight) < 0.3F);
}

void tst_BrushNeighbours::whoSitsIsNotPushed()
{
    Meadow meadow;
    const SeatId seat = 7;
    meadow.set(columns::seat, meadow.ids, seat);
    BrushSettings settings = brush(BrushKind::Push, BrushSelection::AllInCircle);
    settings.radiusPixels = 500.0F;
    QCOMPARE(meadow.paint(fromAbove(), settings, {{600, 384}, {728, 384}}).reason,
             StrokeReason::OnlySeated);
}

void tst_BrushNeighbours::partsAreShownAndHidden()
{
    Meadow meadow;
    BrushSettings settings = brush(BrushKind::Parts, kEverywhere);
    settings.as<PartsSettings>().part = "bag";
    QVERIFY(meadow.paintAll(settings).isCommitted);
    for (const IndividualId id : meadow.ids) {
        QVERIFY((meadow.value(columns::parts, id) & 2U) != 0);
    }
    settings.as<PartsSettings>() = {{}, false, 100.0F};
    QCOMPARE(meadow.paintAll(settings).affected, 60);
    for (const IndividualId id : meadow.ids) {
        QCOMPARE(meadow.value(columns::parts, id) & 3U, 0U);
    }
    settings.as<PartsSettings>().part = "sword";
    QCOMPARE(meadow.paintAll(settings).reason, StrokeReason::NoSuchPart);
}

void tst_BrushNeighbours::aShareOfThemGetsTheParts()
{
    Meadow meadow;
    meadow.set(columns::parts, meadow.ids, 0U);
    BrushSettings settings = brush(BrushKind::Parts, kEverywhere);
    settings.as<PartsSettings>() = {"hat", true, 50.0F};
    const int some = meadow.paintAll(settings).affected;
    QVERIFY2(some > 15 && some < 45, qPrintable(QString::number(some)));
}

void tst_BrushNeighbours::whatIsTakenIsWhatIsGiven_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("column");
    const auto add = [](BrushKind kind, ColumnId column) {
        QTest::newRow(brushType(kind).info.id)
            << static_cast<int>(kind) << static_cast<int>(column);
    };
    add(BrushKind::Animation, ColumnId::Clip);
    add(BrushKind::Walk, ColumnId::Path);
    add(BrushKind::Tag, ColumnId::Tags);
    add(BrushKind::Scale, ColumnId::Height);
    add(BrushKind::Material, ColumnId::MaterialChoices);
    add(BrushKind::Group, ColumnId::Group);
    add(BrushKind::Template, ColumnId::Template);
    add(BrushKind::Clone, ColumnId::Tint1);
}

/// Of one, and painted on another.
void tst_BrushNeighbours::whatIsTakenIsWhatIsGiven()
{
    QFETCH(int, kind);
    QFETCH(int, column);
    Meadow meadow;
    const IndividualId from = meadow.ids[30];
    const IndividualId to = meadow.ids[32]; // of the same template
    const auto one = std::span(&from, 1);
    meadow.set(columns::clip, one, std::uint16_t{2});
    meadow.set(columns::path, one, kLivelyPath);
    meadow.set(columns::group, one, kLivelyGroup);
    meadow.set(columns::tags, std::span(&to, 1), std::uint64_t{0});
    meadow.set(columns::materialChoices, one, MaterialChoices{1, 1, 1});
    BrushSettings settings = brush(static_cast<BrushKind>(kind), BrushSelection::Point);
    settings.op = BrushOperator::Uniform;
    if (auto* scale = settings.find<ScaleSettings>()) {
        scale->heightOperator = BrushOperator::Uniform;
    }
    if (settings.find<TemplateSettings>() != nullptr) {
        meadow.set(columns::templateId, std::span(&to, 1), kOtherMan);
    }
    if (settings.find<MaterialSettings>() != nullptr) {
        meadow.set(columns::materialChoices, std::span(&to, 1), MaterialChoices{0, 1, 1});
    }
    const Scene& scene = meadow.document.scene();
    const std::size_t row = meadow.people().rowOf(from);
    const TemplateEntry* entry = scene.findTemplate(meadow.value(columns::templateId, from));
    const auto& type = brushType(static_cast<BrushKind>(kind));
    QVERIFY(type.take != nullptr);
    QVERIFY(!type.take(settings, {scene, *entry, from, row}).empty());
    const View view = fromAbove();
    QVERIFY(meadow.paint(view, settings, {pixelOf(view, meadow.value(columns::position, to))})
                .isCommitted);
    const auto id = static_cast<ColumnId>(column);
    QCOMPARE(meadow.people().values(id, std::array{to}),
             meadow.people().values(id, std::array{from}));
}

CROWD_TEST(tst_BrushNeighbours)
#include "tst_BrushNeighbours.moc"
