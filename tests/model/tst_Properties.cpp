// SPDX-License-Identifier: MIT
#include "model/population/PropertyValues.h"

#include <cmath>
#include <cstring>

#include <QtTest/QTest>

#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "model/population/ColumnSet.h"
#include "model/population/StoredRows.h"
#include "model/project/ProjectReader.h"
#include "model/project/ProjectWriter.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

using ValueBytes = std::vector<std::byte>;

/// Two people, with a template, a path and a seat to refer to, all of them with the id 1.
Scene twoPeople()
{
    Scene scene;
    TemplateEntry entry;
    entry.id = 1;
    entry.path = "builtin:templates/man.glb";
    entry.clipNames = {"idle", "sit"};
    scene.templates = {entry};
    entry.id = 2;
    scene.templates.push_back(entry);
    Path path;
    path.id = 1;
    scene.paths = {path};
    IndividualRows rows = IndividualRows::withDefaults({1, 2});
    std::ranges::fill(rows.column(columns::templateId), TemplateId{2});
    scene.population.add(rows);
    scene.nextId = 3;
    return scene;
}

/// A legal value that is not the default.
ValueBytes otherValue(const PropertyInfo& property)
{
    const ColumnType type = property.column.type;
    const FieldMeta& meta = property.meta;
    if (isScalar(type)) {
        return scalarBytes(type,
                           type == ColumnType::Float ? 0.75 * meta.low + 0.25 * meta.high : 1);
    }
    ValueBytes bytes(property.column.stride, std::byte{1});
    if (type == ColumnType::Vec3) {
        const glm::vec3 point(1.0F, -2.5F, 1e-7F);
        std::memcpy(bytes.data(), &point, sizeof(point));
    }
    return bytes;
}

ValueBytes valueOf(const Scene& scene, const PropertyInfo& property, IndividualId id)
{
    return scene.population.values(property.id, std::vector<IndividualId>{id});
}

void change(SceneDocument& document, const PropertyInfo& property, IndividualId id,
            const ValueBytes& value)
{
    const auto edit = document.beginEdit().value();
    edit->setColumn(property.id, std::vector<IndividualId>{id}, value);
    edit->commit(QStringLiteral("Change"));
}

} // namespace

class tst_Properties : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void setsHoldAnyNumberOfColumns();
    void peopleBeginWithTheDefaults();
    void defaultsAreLegal();
    void everyPropertyIsSaid();
    void everyPropertyComesBackFromAFile();
    void everyPropertyIsUndone();
    void everyPropertyComesBackWithSomebodyRemoved();
    void theHistoryKeepsTouchedColumnsAlone();
    void oddNumbersOfAFileAreKeptAndTold();
    void numbersAreCheckedInTheirOwnPrecision();
};

void tst_Properties::setsHoldAnyNumberOfColumns()
{
    constexpr std::size_t kMany = 130;
    ColumnBits<kMany> set;
    QVERIFY(set.isEmpty());
    for (std::size_t c = 0; c < kMany; c += 3) {
        set.insert(static_cast<ColumnId>(c));
    }
    for (std::size_t c = 0; c < kMany; ++c) {
        QCOMPARE(set.contains(static_cast<ColumnId>(c)), c % 3 == 0);
    }
    ColumnBits<kMany> last{static_cast<ColumnId>(kMany - 1)};
    QVERIFY(last.contains(static_cast<ColumnId>(kMany - 1)));
    QVERIFY(!last.contains(static_cast<ColumnId>((kMany - 1) % 32)));
    QVERIFY(!last.contains(static_cast<ColumnId>((kMany - 1) % 64)));
}

void tst_Properties::peopleBeginWithTheDefaults()
{
    const IndividualRows rows = IndividualRows::withDefaults({1, 2, 3});
    QCOMPARE(rows.column(columns::height)[2], 1.0F);
    QCOMPARE(rows.column(columns::playbackSpeed)[1], 1.0F);
    QCOMPARE(rows.column(columns::seat)[0], kNoSeat);
    QCOMPARE(rows.column(columns::parts)[2], std::uint32_t{0xFFFFFFFFU});
    QVERIFY(rows.column(columns::tint(7))[2] == Tint{});
    QCOMPARE(rows.column(columns::position)[2], glm::vec3(0.0F));
}

void tst_Properties::defaultsAreLegal()
{
    for (const PropertyInfo& property : properties()) {
        const auto value = std::span(property.initial).first(property.column.stride);
        QVERIFY2(!firstIllegal(property, value), property.meta.key);
        QCOMPARE(findProperty(property.meta.key), &property);
    }
    QVERIFY(findProperty("weight") == nullptr);
}

void tst_Properties::everyPropertyIsSaid()
{
    for (const PropertyInfo& property : properties()) {
        QVERIFY2(*property.meta.doc != '\0', property.meta.key);
        QVERIFY2(property.traits.writers != 0, property.meta.key);
        const FieldMeta& meta = property.meta;
        QVERIFY2(meta.sliderLow >= meta.low * meta.shownScale &&
                     meta.sliderHigh <= meta.high * meta.shownScale,
                 property.meta.key);
    }
}

void tst_Properties::everyPropertyComesBackFromAFile()
{
    for (const PropertyInfo& property : properties()) {
        SceneDocument document;
        document.replaceScene(twoPeople(), {});
        const ValueBytes value = otherValue(property);
        change(document, property, 2, value);
        const auto text = projectToText(document.scene());
        QVERIFY2(text.isOk(), property.meta.key);
        const auto read = projectFromText(text.value());
        QVERIFY2(read.isOk(), read ? "" : read.error().message.c_str());
        QVERIFY2(valueOf(read.value(), property, 2) == value, property.meta.key);
        QVERIFY2(read.value().population == document.scene().population, property.meta.key);
        QVERIFY2(read.value().readWarnings.empty(), property.meta.key);
    }
}

void tst_Properties::everyPropertyIsUndone()
{
    for (const PropertyInfo& property : properties()) {
        SceneDocument document;
        document.replaceScene(twoPeople(), {});
        ColumnSet told;
        const auto connection = QObject::connect(
            &document, &SceneDocument::changed, this, [&](const SceneChange& each) {
                if (const auto* columns = std::get_if<ColumnsChanged>(&each)) {
                    told = columns->columns;
                }
            });
        const ValueBytes before = valueOf(document.scene(), property, 1);
        const ValueBytes after = otherValue(property);
        QVERIFY2(before != after, property.meta.key);
        change(document, property, 1, after);
        QVERIFY2(told == ColumnSet{property.id}, property.meta.key);
        document.undoStack().undo();
        QVERIFY2(valueOf(document.scene(), property, 1) == before, property.meta.key);
        document.undoStack().redo();
        QVERIFY2(valueOf(document.scene(), property, 1) == after, property.meta.key);
        QVERIFY2(told == ColumnSet{property.id}, property.meta.key);
        QObject::disconnect(connection);
    }
}

void tst_Properties::everyPropertyComesBackWithSomebodyRemoved()
{
    SceneDocument document;
    document.replaceScene(twoPeople(), {});
    for (const PropertyInfo& property : properties()) {
        change(document, property, 2, otherValue(property));
    }
    const Population before = document.scene().population;
    const auto edit = document.beginEdit().value();
    edit->removeIndividuals(std::vector<IndividualId>{1, 2});
    edit->commit(QStringLiteral("Remove"));
    QVERIFY(document.scene().population.isEmpty());
    document.undoStack().undo();
    QVERIFY(document.scene().population == before);
}

void tst_Properties::theHistoryKeepsTouchedColumnsAlone()
{
    constexpr std::size_t kPeople = 1000;
    IndividualRows rows = IndividualRows::withDefaults(std::vector<IndividualId>(kPeople));
    std::ranges::fill(rows.column(columns::templateId), TemplateId{1});
    for (std::size_t i = 0; i < kPeople; ++i) {
        rows.ids[i] = static_cast<IndividualId>(i + 1);
        rows.column(columns::heading)[i] = static_cast<float>(i);
    }
    const StoredRows stored(rows);
    QCOMPARE(stored.columns.size(), std::size_t{2});
    QCOMPARE(stored.columns[0].column, ColumnId::Template);
    QCOMPARE(stored.columns[0].bytes.size(), sizeof(TemplateId));
    QCOMPARE(stored.columns[1].column, ColumnId::Heading);
    QCOMPARE(stored.columns[1].bytes.size(), kPeople * sizeof(float));
    const IndividualRows again = stored.unpacked();
    QVERIFY(again.ids == rows.ids && again.bytes == rows.bytes);
    QVERIFY(StoredRows(IndividualRows::withDefaults({})).columns.empty());
}

void tst_Properties::oddNumbersOfAFileAreKeptAndTold()
{
    Scene scene = twoPeople();
    const std::vector<float> heights{500.0F, 0.0F};
    scene.population.setValues(columns::height, std::vector<IndividualId>{1, 2},
                               std::span<const float>(heights));
    const float turned = 2e6F;
    scene.population.setValues(columns::heading, std::vector<IndividualId>{1},
                               std::span<const float>(&turned, 1));
    const auto read = projectFromText(projectToText(scene).value());
    QVERIFY(read.isOk());
    QVERIFY(read.value().population == scene.population);
    const auto& warnings = read.value().readWarnings;
    QCOMPARE(warnings.size(), std::size_t{2});
    QCOMPARE(warnings[0].english(),
             std::string("1 individual has a heading outside -1e+06 to 1e+06; "
                         "it is kept."));
    QCOMPARE(warnings[1].english(),
             std::string("2 individuals have a height outside 0.01 to 100; it is kept."));
}

void tst_Properties::numbersAreCheckedInTheirOwnPrecision()
{
    const PropertyInfo& height = propertyInfo(ColumnId::Height);
    for (const float legal : {0.01F, 1.0F, 100.0F}) {
        QVERIFY(!firstIllegal(height, std::as_bytes(std::span(&legal, 1))));
    }
    const float wrong[]{1.0F, std::nextafter(100.0F, 200.0F), std::nanf(""), 0.0F};
    const auto bytes = std::as_bytes(std::span(wrong));
    QCOMPARE(firstIllegal(height, bytes)->row, std::size_t{1});
    QCOMPARE(countIllegal(height, bytes), std::size_t{3});
    QCOMPARE(nearestLegal(height, 1e6F), 100.0F);
    QCOMPARE(nearestLegal(height, -1.0F), 0.01F);
    QCOMPARE(nearestLegal(height, 1.7F), 1.7F);
    const glm::vec3 places[]{{0, 0, 0}, {0, -2e6F, 2e6F}, {0, 0, 1}};
    const PropertyInfo& position = propertyInfo(ColumnId::Position);
    QCOMPARE(firstIllegal(position, std::as_bytes(std::span(places)))->row, std::size_t{1});
    QCOMPARE(countIllegal(position, std::as_bytes(std::span(places))), std::size_t{1});
    QCOMPARE(scalarAt(ColumnType::UInt32, scalarBytes(ColumnType::UInt32, 4294967295.0), 0),
             4294967295.0);
}

CROWD_TEST(tst_Properties)
#include "tst_Properties.moc"
