// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtTest/QTest>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTabWidget>

#include "app/window/KeysDialog.h"
#include "app/window/Language.h"
#include "app/window/QuickCard.h"
#include "app/window/WindowActions.h"
#include "model/brush/BrushSettings.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::app;

namespace {

constexpr QSizeF kA4(2480.0, 3508.0);

/// Keys as they come, in the language of now.
struct Keys
{
    Keys() : registry(&window) { addActionsAlone(registry); }
    [[nodiscard]] std::vector<CardSection>
    sections(widgets::ButtonMapping buttons = widgets::ButtonMapping::Standard) const
    {
        return cardSections(registry, buttons);
    }

    QWidget window;
    widgets::ActionRegistry registry;
};

} // namespace

/// The quick reference card: all that there is, on one page.
class TestQuickCard : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { useLanguage(QStringLiteral("en")); }

    void saysAllThatThereIs()
    {
        useLanguage(QStringLiteral("en"));
        const auto sections = Keys().sections();
        QCOMPARE(sections.front().rows.size(), model::shownBrushes().size());
        for (const CardRow& row : sections.front().rows) {
            QVERIFY2(!row.keys.isEmpty() && !row.icon.isEmpty(), qPrintable(row.what));
        }
        QCOMPARE(sections[1].rows.size(), std::size(model::kSelections));
        QCOMPARE(sections[2].rows.size(), std::size(model::kOperatorChoices));
        bool isStateThere = false;
        for (const CardSection& section : sections) {
            QVERIFY(!section.title.isEmpty());
            QVERIFY(!section.rows.empty());
            for (const CardRow& row : section.rows) {
                QVERIFY2(!row.what.isEmpty(), qPrintable(section.title + row.keys));
                isStateThere |= row.keys.startsWith(QStringLiteral("Shift+F1"));
            }
        }
        QVERIFY(isStateThere);
    }

    void fitsOnePageInEachLanguage_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("isPaper");
        for (const Language& language : languages()) {
            for (const bool isPaper : {false, true}) {
                QTest::addRow("%s%s", qPrintable(language.code), isPaper ? ", three buttons" : "")
                    << language.code << isPaper;
            }
        }
    }

    void fitsOnePageInEachLanguage()
    {
        QFETCH(QString, language);
        QFETCH(bool, isPaper);
        useLanguage(language);
        const QuickCard card(Keys().sections(isPaper ? widgets::ButtonMapping::Paper
                                                     : widgets::ButtonMapping::Standard),
                             kA4);
        // Letters of 2 mm at least can be read.
        QVERIFY2(card.letterSize() >= kA4.width() / 210.0 * 2.0,
                 QByteArray::number(card.letterSize()).constData());
        const std::vector<QRectF> places = card.rowPlaces();
        QVERIFY(places.size() > 60);
        const QRectF page(QPointF(), kA4);
        const std::vector<QRectF> headings = card.headingPlaces();
        for (const QRectF& place : places) { // above each column one says what is in it
            const auto isAbove = [&place](const QRectF& other) {
                return std::abs(other.left() - place.left()) < 1.0 && other.top() < place.top();
            };
            QVERIFY(std::ranges::any_of(places, isAbove) ||
                    std::ranges::find(headings, place) != headings.end());
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            QVERIFY(page.contains(places[i]));
            for (std::size_t k = i + 1; k < places.size(); ++k) {
                const QRectF both = places[i].intersected(places[k]);
                QVERIFY(both.width() < 1.0 || both.height() < 1.0);
            }
        }
        QImage picture(kA4.toSize(), QImage::Format_RGB32);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        card.paint(painter);
        painter.end();
        int dark = 0;
        for (int y = 0; y < picture.height(); y += 4) {
            for (int x = 0; x < picture.width(); x += 4) {
                dark += qGray(picture.pixel(x, y)) < 128 ? 1 : 0;
            }
        }
        QVERIFY2(dark > 4000, QByteArray::number(dark).constData());
    }

    void isWrittenAsOnePage()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("card.pdf"));
        QVERIFY(writeCard(Keys().sections(), path).isOk());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("%PDF"));
        QCOMPARE(bytes.count("/Type /Page\n"), 1);
        const auto refused =
            writeCard(Keys().sections(), folder.filePath(QStringLiteral("no/where/card.pdf")));
        QVERIFY(!refused);
        QVERIFY(
            QString::fromStdString(refused.error().message).contains(QStringLiteral("card.pdf")));
    }

    void theDialogShowsIt()
    {
        Keys keys;
        KeysDialog dialog(keys.registry, widgets::ButtonMapping::Standard, nullptr);
        dialog.show();
        auto* view = dialog.findChild<QWidget*>(QStringLiteral("cardView"));
        QVERIFY(view != nullptr);
        QTRY_VERIFY(view->isVisible() && view->height() > view->width());
        QVERIFY(dialog.findChild<QPushButton*>(QStringLiteral("saveCard")) != nullptr);
        QCOMPARE(dialog.findChild<QTabWidget*>()->count(), 2);
    }
};

CROWD_WINDOW_TEST(TestQuickCard)
#include "tst_QuickCard.moc"
