// SPDX-License-Identifier: MIT
#include <algorithm>

#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QToolButton>

#include "model/brush/IndividualEdits.h"
#include "model/population/PropertyValues.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/IndividualDock.h"
#include "widgets/forms/NumberField.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::fieldBeside;
using crowd::testing::type;

namespace {

using IndividualDesk = crowd::testing::Desk<IndividualDock>;

template<class Child>
Child* named(const IndividualDesk& desk, const QString& accessibleName)
{
    for (Child* child : desk.all<Child>()) {
        if (child->accessibleName() == accessibleName) {
            return child;
        }
    }
    return nullptr;
}

/// As a hand does it: the entry, and what the box says of it.
void chooseEntry(QComboBox& box, const QString& text)
{
    const int index = box.findText(text);
    QVERIFY2(index >= 0, qPrintable(text));
    box.setCurrentIndex(index);
    Q_EMIT box.activated(index);
    Q_EMIT box.textActivated(text);
}

/// A second template: the clips in another order and one less, one slot, no parts.
model::TemplateId addPlainTemplate(IndividualDesk& desk)
{
    auto asset = testing::makeBoxMan();
    asset->name = "plain";
    asset->clips = {asset->clips[1], asset->clips[0]};
    asset->seatedClip = -1;
    asset->slots.resize(1);
    asset->parts.clear();
    model::TemplateEntry entry = testing::entryFor(asset, 0);
    const auto edit = desk.document.beginEdit().value();
    const model::TemplateId id = edit->addTemplate(entry);
    edit->commit(QStringLiteral("Import"));
    return id;
}

void become(IndividualDesk& desk, std::span<const model::IndividualId> ids, model::TemplateId id)
{
    const auto edit = desk.document.beginEdit().value();
    edit->setColumn(model::columns::templateId, ids, std::span<const model::TemplateId>(&id, 1));
    edit->commit(QStringLiteral("Change template"));
}

template<class T>
std::vector<T> valuesOf(const IndividualDesk& desk, model::ColumnKey<T> key)
{
    const auto column = desk.document.scene().population.column(key);
    return {column.begin(), column.end()};
}

} // namespace

class IndividualDockTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nobodyHasNoFields();
    void mixedNumbersAreWrittenToAll();
    void everyPlainNumberHasARow();
    void clipsAreComparedByName();
    void nonsenseIsIgnored();
    void whatIsRefusedIsShownNoLonger();
    void aClipGoesToThoseWhoHaveIt();
    void aTemplateIsExchangedForAll();
    void tagsAreWrittenAsNumbers();
    void groupIsWrittenToAll();
    void aFreeSeatIsTakenByItsNumber();
    void standingUpFreesTheSeats();
    void anOutfitIsChosenForAll();
    void aRightClickTakesTheTintOff();
    void aTintMultipliesOrReplaces();
    void partsAreHiddenAndShown();
};

void IndividualDockTest::nobodyHasNoFields()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    QVERIFY(desk.all<NumberField>().isEmpty());
}

void IndividualDockTest::mixedNumbersAreWrittenToAll()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 3);
    {
        const float tall = 1.25F;
        const auto edit = desk.document.beginEdit().value();
        edit->setColumn(model::columns::height, std::span(ids).first(1),
                        std::span<const float>(&tall, 1));
        edit->commit(QStringLiteral("Grow"));
    }
    desk.state.selection().set(ids);
    QTRY_VERIFY(!desk.all<NumberField>().isEmpty());
    auto* height = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Height"));
    auto* girth = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Girth"));
    QVERIFY(height != nullptr && girth != nullptr);
    QTRY_VERIFY2(height->text().isEmpty(), "three heights are mixed");
    QVERIFY(!girth->text().isEmpty());
    const int steps = desk.document.undoStack().count();
    type(*height, QLocale().toString(1.5, 'f', 1));
    QCOMPARE(desk.document.undoStack().count(), steps + 1);
    for (const float value : desk.document.scene().population.column(model::columns::height)) {
        QCOMPARE(value, 1.5F);
    }
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[0], 1.25F);
    QTRY_VERIFY(height->text().isEmpty());
}

void IndividualDockTest::everyPlainNumberHasARow()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    desk.state.selection().set(ids);
    QTRY_VERIFY(!desk.all<NumberField>().isEmpty());
    for (const char* name :
         {"heading", "height", "girth", "phase", "speed", "group", "walkSpeed"}) {
        const model::PropertyInfo& property = *model::findProperty(name);
        const QString unit = QString::fromUtf8(property.meta.unit);
        const QString label = QString::fromUtf8(property.meta.label) +
                              (unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
        auto* field = fieldBeside<NumberField>(*desk.dock, label);
        QVERIFY2(field != nullptr, name);
        const double wanted = property.column.type == model::ColumnType::Float ? 0.5 : 3.0;
        const int steps = desk.document.undoStack().count();
        type(*field, QLocale().toString(wanted));
        QCOMPARE(desk.document.undoStack().count(), steps + 1);
        const auto column = desk.document.scene().population.columnBytes(property.id);
        for (std::size_t row = 0; row < ids.size(); ++row) {
            const double shown =
                model::scalarAt(property.column.type, column, row) * property.meta.shownScale;
            QVERIFY2(qAbs(shown - wanted) < 1e-5, name);
        }
    }
}

void IndividualDockTest::clipsAreComparedByName()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    desk.state.selection().set(ids);
    auto* clip = fieldBeside<QComboBox>(*desk.dock, QStringLiteral("Clip"));
    QVERIFY(clip != nullptr);
    QTRY_COMPARE(clip->currentIndex(), 0);
    const auto edit = desk.document.beginEdit().value();
    model::TemplateEntry other = desk.document.scene().templates.front();
    other.id = 0;
    std::ranges::reverse(other.clipNames);
    QVERIFY(other.clipNames.front() != other.clipNames.back());
    const model::TemplateId id = edit->addTemplate(other);
    edit->setColumn(model::columns::templateId, std::span(ids).last(1),
                    std::span<const model::TemplateId>(&id, 1));
    edit->commit(QStringLiteral("Change template"));
    QTRY_VERIFY2(clip->currentIndex() < 0, "the same index is another clip in the other template");
}

void IndividualDockTest::nonsenseIsIgnored()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(testing::addPeople(desk.document, 1));
    QTRY_VERIFY(!desk.all<NumberField>().isEmpty());
    auto* height = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Height"));
    const QString shown = height->text();
    const int steps = desk.document.undoStack().count();
    type(*height, QStringLiteral("tall"));
    QCOMPARE(desk.document.undoStack().count(), steps);
    QCOMPARE(height->text(), shown);
}

void IndividualDockTest::whatIsRefusedIsShownNoLonger()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(testing::addPeople(desk.document, 1));
    auto* clip = fieldBeside<QComboBox>(*desk.dock, QStringLiteral("Clip"));
    auto* height = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Height"));
    QVERIFY(clip != nullptr && height != nullptr);
    QTRY_COMPARE(clip->count(), 3);
    const QString was = clip->currentText();
    const QString tall = height->text();
    const auto open = desk.document.beginEdit().value(); // a script's, say
    chooseEntry(*clip,
                was == QLatin1String("rise") ? QStringLiteral("sit") : QStringLiteral("rise"));
    type(*height, QLocale().toString(1.25, 'f', 2));
    QTRY_COMPARE(clip->currentText(), was);
    QTRY_COMPARE(height->text(), tall);
}

void IndividualDockTest::aClipGoesToThoseWhoHaveIt()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 3);
    become(desk, std::span(ids).last(1), addPlainTemplate(desk));
    desk.state.selection().set(ids);
    auto* clip = fieldBeside<QComboBox>(*desk.dock, QStringLiteral("Clip"));
    QVERIFY(clip != nullptr);
    QTRY_COMPARE(clip->count(), 3);
    chooseEntry(*clip, QStringLiteral("rise"));
    // The same clip has another number in the other template.
    QCOMPARE(valuesOf(desk, model::columns::clip), (std::vector<std::uint16_t>{1, 1, 0}));
    chooseEntry(*clip, QStringLiteral("sit"));
    QCOMPARE(valuesOf(desk, model::columns::clip), (std::vector<std::uint16_t>{2, 2, 0}));
    desk.document.undoStack().undo();
    QCOMPARE(valuesOf(desk, model::columns::clip), (std::vector<std::uint16_t>{1, 1, 0}));
}

void IndividualDockTest::aTemplateIsExchangedForAll()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 3);
    const model::TemplateId plain = addPlainTemplate(desk);
    desk.state.selection().set(ids);
    auto* box = fieldBeside<QComboBox>(*desk.dock, QStringLiteral("Template"));
    QVERIFY(box != nullptr);
    QTRY_COMPARE(box->count(), 2);
    QTRY_COMPARE(box->currentText(), QStringLiteral("box man"));
    chooseEntry(*box, QStringLiteral("plain"));
    QCOMPARE(valuesOf(desk, model::columns::templateId), std::vector<model::TemplateId>(3, plain));
    QTRY_COMPARE(named<QToolButton>(desk, QStringLiteral("top")), nullptr);
    desk.document.undoStack().undo();
    QCOMPARE(valuesOf(desk, model::columns::templateId), std::vector<model::TemplateId>(3, 1));
    QTRY_VERIFY(named<QToolButton>(desk, QStringLiteral("top")) != nullptr);
}

void IndividualDockTest::tagsAreWrittenAsNumbers()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(testing::addPeople(desk.document, 2));
    auto* tags = fieldBeside<QLineEdit>(*desk.dock, QStringLiteral("Tags"));
    QVERIFY(tags != nullptr);
    QTRY_VERIFY(tags->isVisible());
    type(*tags, QStringLiteral("1, 3-5, 64, 70"));
    const std::uint64_t wanted = 0b11101ULL | 1ULL << 63U;
    QCOMPARE(valuesOf(desk, model::columns::tags), std::vector<std::uint64_t>(2, wanted));
    QTRY_COMPARE(tags->text(), QStringLiteral("1, 3-5, 64"));
}

void IndividualDockTest::groupIsWrittenToAll()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    desk.state.selection().set(testing::addPeople(desk.document, 2));
    auto* group = fieldBeside<NumberField>(*desk.dock, QStringLiteral("Group"));
    QVERIFY(group != nullptr);
    QTRY_VERIFY(group->isVisible());
    type(*group, QStringLiteral("12"));
    QCOMPARE(valuesOf(desk, model::columns::group), std::vector<std::uint32_t>(2, 12));
}

void IndividualDockTest::aFreeSeatIsTakenByItsNumber()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    desk.state.selection().set(std::vector{ids[0]});
    auto* seat = named<NumberField>(desk, QStringLiteral("Seat"));
    QTRY_VERIFY((seat = named<NumberField>(desk, QStringLiteral("Seat"))) != nullptr);
    type(*seat, QStringLiteral("3"));
    const model::SeatId third = (model::SeatId{1} << 24U) + 2;
    QCOMPARE(valuesOf(desk, model::columns::seat).front(), third);
    QTRY_VERIFY(seat->text() == QStringLiteral("3"));
    const auto* area = desk.dock->findChild<QScrollArea*>();
    QVERIFY2(area->widget()->minimumSizeHint().width() <= area->minimumWidth(),
             "what is shown of a seat fits the narrowest panel");
    QCOMPARE(valuesOf(desk, model::columns::position).front().x,
             desk.document.scene().stages.front().asset->seats[2].position.x);
    // Taken, and not there at all: both are refused without an undo step.
    const int steps = desk.document.undoStack().count();
    desk.state.selection().set(std::vector{ids[1]});
    QTRY_VERIFY(seat->text().isEmpty());
    type(*seat, QStringLiteral("3"));
    QTRY_VERIFY(seat->text().isEmpty());
    type(*seat, QStringLiteral("9999"));
    QTRY_VERIFY(seat->text().isEmpty());
    QCOMPARE(desk.document.undoStack().count(), steps);
}

void IndividualDockTest::standingUpFreesTheSeats()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto edit = desk.document.beginEdit().value();
        const auto number = static_cast<model::SeatId>(i);
        QVERIFY(model::sitDown(*edit, ids[i], (model::SeatId{1} << 24U) + number) ==
                model::SitResult::Done);
        edit->commit(QStringLiteral("Sit"));
    }
    desk.state.selection().set(ids);
    QTRY_VERIFY(named<QToolButton>(desk, QStringLiteral("Stand Up")) != nullptr);
    auto* button = named<QToolButton>(desk, QStringLiteral("Stand Up"));
    QTRY_VERIFY(button->isEnabled());
    QVERIFY2(!named<NumberField>(desk, QStringLiteral("Seat"))->isEnabled(),
             "two people cannot have one seat");
    const int steps = desk.document.undoStack().count();
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(valuesOf(desk, model::columns::seat), std::vector<model::SeatId>(2, model::kNoSeat));
    QCOMPARE(desk.document.undoStack().count(), steps + 1);
    QTRY_VERIFY(!button->isEnabled());
}

void IndividualDockTest::anOutfitIsChosenForAll()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 3);
    become(desk, std::span(ids).last(1), addPlainTemplate(desk)); // has no top
    desk.state.selection().set(ids);
    QComboBox* outfit = nullptr;
    const auto offersBlue = [&] {
        for (QComboBox* box : desk.all<QComboBox>()) {
            outfit = box->findText(QStringLiteral("blue")) >= 0 ? box : outfit;
        }
        return outfit != nullptr;
    };
    QTRY_VERIFY(offersBlue());
    chooseEntry(*outfit, QStringLiteral("blue"));
    const auto choices = valuesOf(desk, model::columns::materialChoices);
    QCOMPARE(choices[0][1], std::uint8_t{1});
    QCOMPARE(choices[1][1], std::uint8_t{1});
    QCOMPARE(choices[2][1], std::uint8_t{0});
}

void IndividualDockTest::aRightClickTakesTheTintOff()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    {
        const model::Tint red{255, 0, 0, 255};
        const auto edit = desk.document.beginEdit().value();
        edit->setColumn(model::columns::tint(1), ids, std::span<const model::Tint>(&red, 1));
        edit->commit(QStringLiteral("Tint"));
    }
    desk.state.selection().set(ids);
    QTRY_VERIFY(named<QToolButton>(desk, QStringLiteral("top")) != nullptr);
    auto* top = named<QToolButton>(desk, QStringLiteral("top"));
    QVERIFY(top->isEnabled());
    QVERIFY2(!named<QToolButton>(desk, QStringLiteral("hat"))->isEnabled(),
             "what is not tintable is not offered");
    Q_EMIT top->customContextMenuRequested({});
    QCOMPARE(valuesOf(desk, model::columns::tint(1)), std::vector<model::Tint>(2));
}

void IndividualDockTest::aTintMultipliesOrReplaces()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 3);
    {
        const std::uint16_t other = 1U << 2U; // of another slot: it stays
        const auto edit = desk.document.beginEdit().value();
        edit->setColumn(model::columns::tintReplaces, std::span(ids).first(1),
                        std::span<const std::uint16_t>(&other, 1));
        edit->commit(QStringLiteral("Mode"));
    }
    desk.state.selection().set(std::span(ids).first(2));
    const auto mode = [&desk] {
        return named<QComboBox>(desk, QStringLiteral("Mode of the tint of top"));
    };
    QTRY_VERIFY(mode() != nullptr);
    QCOMPARE(mode()->currentText(), QStringLiteral("Multiply"));
    chooseEntry(*mode(), QStringLiteral("Replace"));
    QCOMPARE(valuesOf(desk, model::columns::tintReplaces),
             (std::vector<std::uint16_t>{0b110, 0b010, 0}));
    desk.state.selection().set(ids);
    QTRY_COMPARE(mode()->currentIndex(), -1); // mixed
    desk.document.undoStack().undo();
    QCOMPARE(valuesOf(desk, model::columns::tintReplaces),
             (std::vector<std::uint16_t>{0b100, 0, 0}));
}

void IndividualDockTest::partsAreHiddenAndShown()
{
    IndividualDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = testing::addPeople(desk.document, 2);
    {
        const std::uint32_t none = 0;
        const auto edit = desk.document.beginEdit().value();
        edit->setColumn(model::columns::parts, std::span(ids).first(1),
                        std::span<const std::uint32_t>(&none, 1));
        edit->commit(QStringLiteral("Take the hat off"));
    }
    desk.state.selection().set(ids);
    QTRY_COMPARE(desk.all<QCheckBox>().size(), qsizetype{1});
    QCheckBox* hat = desk.all<QCheckBox>().front();
    QCOMPARE(hat->text(), QStringLiteral("hat"));
    QCOMPARE(hat->checkState(), Qt::PartiallyChecked);
    hat->click();
    QCOMPARE(valuesOf(desk, model::columns::parts), std::vector<std::uint32_t>(2, 1));
    QTRY_COMPARE(hat->checkState(), Qt::Checked);
    hat->click();
    QCOMPARE(valuesOf(desk, model::columns::parts), std::vector<std::uint32_t>(2, 0));
    QTRY_COMPARE(hat->checkState(), Qt::Unchecked);
}

CROWD_WINDOW_TEST(IndividualDockTest)
#include "tst_IndividualDock.moc"
