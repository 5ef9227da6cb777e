// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QtCore/QRectF>
#include <QtCore/QString>
#include <QtGui/QFont>

#include "model/base/Result.h"
#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/EditorState.h"

class QPainter;

namespace crowd::app {

/// A line of the card: what one does, and what comes of it.
struct CardRow
{
    QString keys; ///< or the mouse, or the name of a choice
    QString what;
    QString icon = {}; ///< resources/icons/NAME.svg; empty: none
};

struct CardSection
{
    QString title;
    std::vector<CardRow> rows;
};

/// Sections as they are written down one after the other.
class CardList
{
public:
    explicit CardList(const widgets::ActionRegistry& actions) : m_actions(actions) {}

    void heading(const QString& title) { m_sections.push_back({title, {}}); }
    /// Below the last heading.
    void row(const QString& keys, const QString& what, const QString& icon = {})
    {
        m_sections.back().rows.push_back({keys, what, icon});
    }
    /// Of an action, as they are shown; empty for none.
    [[nodiscard]] QString keysOf(const char* actionId) const;
    [[nodiscard]] std::vector<CardSection> take() { return std::move(m_sections); }

private:
    const widgets::ActionRegistry& m_actions;
    std::vector<CardSection> m_sections;
};

/// The quick reference card: all brushes, areas and operators, the mouse, cameras and states, made
/// from what the editor has, in the language of now.
[[nodiscard]] std::vector<CardSection> cardSections(const widgets::ActionRegistry& actions,
                                                    widgets::ButtonMapping buttons);

/// Lays the card out in three columns of a page and paints it as large as everything finds room.
/// Units are the painter's; A4 in any of them will do.
class QuickCard
{
public:
    QuickCard(std::vector<CardSection> sections, const QSizeF& page);

    /// Height of a line's letters, in the units of the page.
    [[nodiscard]] double letterSize() const { return m_letters; }
    /// Where headings and rows are; none is cut, none covers another.
    [[nodiscard]] std::vector<QRectF> rowPlaces() const;
    /// The headings of these, one above each column too, where a section goes on.
    [[nodiscard]] std::vector<QRectF> headingPlaces() const;
    void paint(QPainter& painter) const;

private:
    struct Placed
    {
        const CardRow* row = nullptr; ///< null: a heading
        QString title;
        QRectF place;
        double keysWidth = 0.0;
    };

    /// Widths in a row.
    struct Rooms
    {
        double icon = 0.0;
        double keys = 0.0;
        double what = 0.0;
    };

    /// False: it does not fit.
    [[nodiscard]] bool layOut(double letters);
    [[nodiscard]] Rooms roomsOf(const CardRow& row, double keysWidth, double width) const;
    [[nodiscard]] std::optional<double> heightOf(const CardRow& row, double keysWidth,
                                                 double width) const;
    [[nodiscard]] QFont headingFont() const;
    [[nodiscard]] double keysWidthOf(const CardSection& section, double width) const;
    void paintRow(QPainter& painter, const Placed& placed) const;

    std::vector<CardSection> m_sections;
    QSizeF m_page;
    double m_letters = 0.0;
    std::vector<Placed> m_placed;
};

/// Writes the card as one A4 page.
[[nodiscard]] model::Result<void> writeCard(const std::vector<CardSection>& sections,
                                            const QString& path);

} // namespace crowd::app
