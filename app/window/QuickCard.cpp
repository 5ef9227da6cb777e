// SPDX-License-Identifier: MIT
#include "app/window/QuickCard.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QtCore/QCoreApplication>
#include <QtCore/QRegularExpression>
#include <QtCore/QSaveFile>
#include <QtGui/QFontMetricsF>
#include <QtGui/QGuiApplication>
#include <QtGui/QKeySequence>
#include <QtGui/QPainter>
#include <QtGui/QPdfWriter>

#include "app/window/KeysDialog.h"
#include "model/brush/BrushSettings.h"
#include "widgets/actions/MenuText.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/ToolId.h"
#include "widgets/theme/Icons.h"

namespace crowd::app {

namespace {

constexpr int kColumns = 3;
constexpr double kMargin = 0.035;  ///< of the page's width
constexpr double kGap = 0.02;      ///< between columns, of the page's width
constexpr double kLargest = 0.022; ///< letters, of the page's width
constexpr double kSmallest = 0.004;
constexpr double kShrink = 0.97;      ///< from one size that is tried to the next
constexpr double kTitleLines = 2.6;   ///< room of the card's title, in letters
constexpr double kHeadingLines = 2.3; ///< of a section's
constexpr double kRowGap = 0.35;      ///< in letters
constexpr double kIconLines = 1.7;    ///< side, in letters
constexpr double kKeysShare = 0.46;   ///< of a column, at most
constexpr int kPdfDots = 600;         ///< an inch
constexpr int kIconPixels = 96;
const QColor kInk(32, 32, 32);
const QColor kSoft(95, 95, 95);
const QColor kLine(216, 140, 50);

struct CardText
{
    Q_DECLARE_TR_FUNCTIONS(QuickCard)
};

QFont cardFont(double letters, bool isBold)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(std::max(1, static_cast<int>(letters)));
    font.setBold(isBold);
    return font;
}

/// Long names of keys may go on in the next line behind what joins them.
QString breakable(QString keys)
{
    const QString chance = QStringLiteral("\u200B");
    for (const char16_t joint : {u'+', u'-'}) {
        keys.replace(QChar(joint), QChar(joint) + chance);
    }
    return keys;
}

/// Whether no word is wider than the room.
bool doWordsFit(const QString& text, double room, const QFontMetricsF& metrics)
{
    static const QRegularExpression kBreaks(QStringLiteral("[\\s\u200B]+"));
    const QStringList words = text.split(kBreaks);
    return std::ranges::all_of(
        words, [&](const QString& word) { return metrics.horizontalAdvance(word) <= room; });
}

/// What is wanted most often beside painting.
constexpr std::array kCommands{"undo",           "redo",           "save",         "duplicate",
                               "delete",         "select-all",     "select-none",  "select-similar",
                               "select-related", "group-selected", "save-picture", "make-movie",
                               "rules",          "timeline",       "keys"};

void addCommands(CardList& list, const widgets::ActionRegistry& actions)
{
    list.heading(CardText::tr("Editing"));
    for (const char* id : kCommands) {
        QString text = widgets::menuText(actions.action(id)->text());
        list.row(list.keysOf(id), text.remove(QChar(0x2026)).trimmed());
    }
}

void addBrushes(CardList& list)
{
    list.heading(CardText::tr("Brushes"));
    for (const model::BrushKind kind : model::shownBrushes()) {
        const widgets::ToolInfo& tool = widgets::toolInfo(widgets::toolOf(kind));
        const model::BrushInfo& info = model::brushType(kind).info;
        list.row(list.keysOf(tool.stableId),
                 widgets::menuText(QCoreApplication::translate("Actions", info.menu)),
                 QLatin1String(tool.stableId));
    }
}

template<class Choices>
void addChoices(CardList& list, const Choices& choices, const QStringList& meanings)
{
    qsizetype index = 0;
    for (const model::FieldChoice& choice : choices) {
        list.row(QCoreApplication::translate("Fields", choice.label), meanings.value(index++));
    }
}

QStringList areaMeanings()
{
    return {CardText::tr("whom the cursor points at"), CardText::tr("some in the circle, a second"),
            CardText::tr("all whom the circle passes"), CardText::tr("all in a rectangle"),
            CardText::tr("all inside a drawn line")};
}

QStringList operatorMeanings()
{
    return {CardText::tr("the same value for all"), CardText::tr("drawn for each of them"),
            CardText::tr("from one end of the line to the other")};
}

} // namespace

QString CardList::keysOf(const char* actionId) const
{
    return m_actions.action(actionId)->shortcut().toString(QKeySequence::NativeText);
}

std::vector<CardSection> cardSections(const widgets::ActionRegistry& actions,
                                      widgets::ButtonMapping buttons)
{
    CardList list(actions);
    addBrushes(list);
    list.heading(CardText::tr("Areas"));
    addChoices(list, model::kSelections, areaMeanings());
    list.heading(CardText::tr("Values"));
    addChoices(list, model::kOperatorChoices, operatorMeanings());
    KeysDialog::addMouse(list, buttons);
    addCommands(list, actions);
    return list.take();
}

QuickCard::QuickCard(std::vector<CardSection> sections, const QSizeF& page)
    : m_sections(std::move(sections)), m_page(page)
{
    for (CardSection& section : m_sections) {
        for (CardRow& row : section.rows) {
            row.keys = breakable(row.keys);
        }
    }
    double letters = kLargest * page.width();
    while (!layOut(letters) && letters > kSmallest * page.width()) {
        letters *= kShrink;
    }
}

double QuickCard::keysWidthOf(const CardSection& section, double width) const
{
    const QFontMetricsF metrics(cardFont(m_letters, true));
    double widest = 0.0;
    for (const CardRow& row : section.rows) {
        widest = std::max(widest, metrics.horizontalAdvance(row.keys));
    }
    return std::min(widest + m_letters, width * kKeysShare);
}

QuickCard::Rooms QuickCard::roomsOf(const CardRow& row, double keysWidth, double width) const
{
    const double icon = row.icon.isEmpty() ? 0.0 : (kIconLines + 0.5) * m_letters;
    return {icon, keysWidth - 0.5 * m_letters, width - icon - keysWidth};
}

/// Nothing: a word of it finds no room.
std::optional<double> QuickCard::heightOf(const CardRow& row, double keysWidth, double width) const
{
    const Rooms rooms = roomsOf(row, keysWidth, width);
    double height = row.icon.isEmpty() ? 0.0 : kIconLines * m_letters;
    for (const bool isKeys : {true, false}) {
        const QFontMetricsF metrics(cardFont(m_letters, isKeys));
        const QString& text = isKeys ? row.keys : row.what;
        const double room = isKeys ? rooms.keys : rooms.what;
        if (!doWordsFit(text, room, metrics)) {
            return std::nullopt;
        }
        const QRectF all(0.0, 0.0, room, m_page.height());
        height = std::max(height, metrics.boundingRect(all, Qt::TextWordWrap, text).height());
    }
    return height + kRowGap * m_letters;
}

bool QuickCard::layOut(double letters)
{
    m_letters = letters;
    m_placed.clear();
    const double margin = kMargin * m_page.width();
    const double gap = kGap * m_page.width();
    const double width = (m_page.width() - 2.0 * margin - gap * (kColumns - 1)) / kColumns;
    const double top = margin + kTitleLines * letters * 1.6;
    const double bottom = m_page.height() - margin;
    int column = 0;
    double y = top;
    const auto place = [&](double height, double together) {
        if (y + together > bottom) {
            ++column;
            y = top;
        }
        const QRectF at(margin + column * (width + gap), y, width, height);
        y += height;
        return at;
    };
    for (const CardSection& section : m_sections) {
        const double keysWidth = keysWidthOf(section, width);
        const double heading = kHeadingLines * letters;
        bool isFirst = true;
        if (!doWordsFit(section.title, width, QFontMetricsF(headingFont()))) {
            return false;
        }
        for (const CardRow& row : section.rows) {
            const auto height = heightOf(row, keysWidth, width);
            if (!height) {
                return false;
            }
            const bool goesOn = !isFirst && y + *height > bottom; // in the next column
            if (std::exchange(isFirst, false) || goesOn) { // never a heading alone at the end
                const QString before =
                    goesOn ? QString(QChar(0x2026)) + QLatin1Char(' ') : QString();
                m_placed.push_back(
                    {nullptr, before + section.title, place(heading, heading + *height), 0});
            }
            m_placed.push_back({&row, {}, place(*height, *height), keysWidth});
        }
    }
    return column < kColumns;
}

QFont QuickCard::headingFont() const
{
    return cardFont(m_letters * 1.2, true);
}

std::vector<QRectF> QuickCard::rowPlaces() const
{
    std::vector<QRectF> places;
    places.reserve(m_placed.size());
    for (const Placed& each : m_placed) {
        places.push_back(each.place);
    }
    return places;
}

std::vector<QRectF> QuickCard::headingPlaces() const
{
    std::vector<QRectF> places;
    for (const Placed& each : m_placed) {
        if (each.row == nullptr) {
            places.push_back(each.place);
        }
    }
    return places;
}

void QuickCard::paintRow(QPainter& painter, const Placed& placed) const
{
    const CardRow& row = *placed.row;
    const Rooms rooms = roomsOf(row, placed.keysWidth, placed.place.width());
    const QRectF place = placed.place.adjusted(0.0, 0.0, 0.0, -kRowGap * m_letters);
    const int flags = Qt::TextWordWrap | (row.icon.isEmpty() ? Qt::AlignTop : Qt::AlignVCenter);
    if (!row.icon.isEmpty()) {
        const double side = kIconLines * m_letters;
        const QPixmap icon = widgets::iconPixmap(qPrintable(row.icon), kIconPixels, kInk);
        const double top = place.top() + 0.5 * (place.height() - side);
        painter.drawPixmap(QRectF(place.left(), top, side, side), icon, icon.rect());
    }
    QRectF room = place;
    room.setLeft(place.left() + rooms.icon);
    room.setWidth(rooms.keys);
    painter.setPen(kInk);
    painter.setFont(cardFont(m_letters, true));
    painter.drawText(room, flags, row.keys);
    room.setLeft(place.right() - rooms.what);
    room.setRight(place.right());
    painter.setPen(kSoft);
    painter.setFont(cardFont(m_letters, false));
    painter.drawText(room, flags, row.what);
}

void QuickCard::paint(QPainter& painter) const
{
    const double margin = kMargin * m_page.width();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.setPen(kInk);
    painter.setFont(cardFont(m_letters * 2.0, true));
    const QRectF title(margin, margin, m_page.width() - 2.0 * margin, m_letters * 3.0);
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                     CardText::tr("Crowdbrush at a glance"));
    for (const Placed& each : m_placed) {
        if (each.row != nullptr) {
            paintRow(painter, each);
            continue;
        }
        painter.setPen(kInk);
        painter.setFont(headingFont());
        const QRectF place = each.place.adjusted(0.0, 0.4 * m_letters, 0.0, -0.4 * m_letters);
        painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, each.title);
        painter.setPen(QPen(kLine, 0.12 * m_letters));
        painter.drawLine(place.bottomLeft(), place.bottomRight());
    }
}

model::Result<void> writeCard(const std::vector<CardSection>& sections, const QString& path)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return model::Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2"),
                            path.toStdString(), file.errorString().toStdString()};
    }
    {
        QPdfWriter writer(&file);
        writer.setResolution(kPdfDots);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF());
        writer.setTitle(CardText::tr("Crowdbrush at a glance"));
        QPainter painter(&writer);
        const QuickCard card(sections, QSizeF(writer.width(), writer.height()));
        card.paint(painter);
    }
    if (!file.commit()) {
        return model::Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2"),
                            path.toStdString(), file.errorString().toStdString()};
    }
    return {};
}

} // namespace crowd::app
