// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "tests/gui/Studio.h"
#include "tests/program/WindowTest.h"
#include "widgets/viewport/PropertyLegend.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Studio;

namespace {

/// A studio whose people are seen by property.
struct ColouredStudio : Studio
{
    ColouredStudio()
    {
        ids = crowd::testing::addPeople(document, 4, 4.0F);
        const std::uint64_t tag = 1;
        document.edit(QStringLiteral("Tag"), [&](model::SceneEdit& change) {
            const std::vector<model::IndividualId> some(ids.begin(), ids.begin() + 3);
            change.setColumn(model::columns::tags, some, std::span<const std::uint64_t>(&tag, 1));
        });
        setLook(render::Look::Property);
    }
    void setLook(render::Look look)
    {
        ViewOptions options = state.viewOptions();
        options.look = look;
        state.setViewOptions(options);
    }
    [[nodiscard]] PropertyLegend* legend() const { return view->findChild<PropertyLegend*>(); }
    [[nodiscard]] QComboBox* choice() const { return legend()->findChild<QComboBox*>(); }
    [[nodiscard]] std::vector<QToolButton*> rows() const
    {
        std::vector<QToolButton*> shown;
        for (QToolButton* each : legend()->findChildren<QToolButton*>()) {
            if (each->isVisible()) {
                shown.push_back(each);
            }
        }
        return shown;
    }
    /// As from the list.
    void choose(const QString& text)
    {
        const int index = choice()->findText(text);
        QVERIFY2(index >= 0, qPrintable(text));
        choice()->setCurrentIndex(index);
        Q_EMIT choice()->activated(index);
    }

    std::vector<model::IndividualId> ids;
};

} // namespace

class TestPropertyLegend : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhatColoursMean();
    void aClickSelectsThem();
    void followsTheScene();
    void isThereInItsLookAlone();
};

void TestPropertyLegend::saysWhatColoursMean()
{
    ColouredStudio studio;
    QVERIFY(studio.isReady());
    QTRY_VERIFY(studio.legend()->isVisible());
    QTRY_COMPARE(studio.rows().size(), std::size_t{1}); // all are of one template
    QVERIFY(studio.rows().front()->text().endsWith(QLatin1String("4")));
    const QImage alike = studio.picture();
    studio.choose(QStringLiteral("Tag"));
    QCOMPARE(studio.state.viewOptions().property, std::string("tag"));
    QTRY_COMPARE(studio.rows().size(), std::size_t{2});
    QVERIFY2(studio.rows()[0]->text().startsWith(QLatin1String("Tag 1")),
             qPrintable(studio.rows()[0]->text()));
    QVERIFY(studio.rows()[1]->text().startsWith(QLatin1String("none")));
    QVERIFY(studio.picture() != alike);
    const QRect picture = studio.view->rect();
    QVERIFY(picture.contains(studio.legend()->geometry()));
}

void TestPropertyLegend::aClickSelectsThem()
{
    ColouredStudio studio;
    QVERIFY(studio.isReady());
    QTRY_VERIFY(studio.legend()->isVisible());
    studio.choose(QStringLiteral("Tag"));
    QTRY_COMPARE(studio.rows().size(), std::size_t{2});
    QTest::mouseClick(studio.rows()[1], Qt::LeftButton);
    const auto selected = [&studio] {
        const auto now = studio.state.selection().ids();
        return std::vector<model::IndividualId>(now.begin(), now.end());
    };
    QCOMPARE(selected(), std::vector<model::IndividualId>{studio.ids[3]});
    QTest::mouseClick(studio.rows()[0], Qt::LeftButton, Qt::ShiftModifier);
    QCOMPARE(selected(), studio.ids);
    QCOMPARE(studio.people(), std::size_t{4}); // no brush was meant
}

void TestPropertyLegend::followsTheScene()
{
    ColouredStudio studio;
    QVERIFY(studio.isReady());
    QTRY_VERIFY(studio.legend()->isVisible());
    studio.choose(QStringLiteral("Tag"));
    QTRY_COMPARE(studio.rows().size(), std::size_t{2});
    studio.document.edit(QStringLiteral("Name"), [](model::SceneEdit& edit) {
        edit.setTags({{.bit = 0, .name = "singers", .color = {200, 10, 10}}});
    });
    QTRY_VERIFY2(studio.rows()[0]->text().startsWith(QLatin1String("singers")),
                 qPrintable(studio.rows()[0]->text()));
    (void)crowd::testing::addPeople(studio.document, 2, 6.0F);
    QTRY_VERIFY(studio.rows()[1]->text().endsWith(QLatin1String("3")));
}

void TestPropertyLegend::isThereInItsLookAlone()
{
    ColouredStudio studio;
    QVERIFY(studio.isReady());
    QTRY_VERIFY(studio.legend()->isVisible());
    studio.setLook(render::Look::Lit);
    QTRY_VERIFY(!studio.legend()->isVisible());
}

CROWD_WINDOW_TEST(TestPropertyLegend)
#include "tst_PropertyLegend.moc"
