// SPDX-License-Identifier: MIT
#include "widgets/docks/ColourDock.h"

#include <algorithm>

#include <QtCore/QSettings>
#include <QtGui/QPainter>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/docks/ColourSquare.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kSwatchColumns = 7;
constexpr int kSwatchSize = 20;
const QString kSwatchesKey = QStringLiteral("colours/swatches");

QPixmap swatch(const QColor& color, int size)
{
    QPixmap picture(size, size);
    picture.fill(color);
    QPainter painter(&picture);
    painter.setPen(QColor(0, 0, 0, 90));
    painter.drawRect(0, 0, size - 1, size - 1);
    return picture;
}

QColor toColor(const model::PaintColor& color)
{
    return {color[0], color[1], color[2]};
}

model::PaintColor toPaint(const QColor& color)
{
    return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
            static_cast<std::uint8_t>(color.blue())};
}

/// Cloth and paint that look right on people, from calm to loud.
std::vector<QColor> firstSwatches()
{
    std::vector<QColor> colors;
    for (const char* name :
         {"#f4efe6", "#d8cbb0", "#a98d68", "#6b4a34", "#3a2c26", "#9aa0a8", "#5c636d",
          "#24272c", "#d64030", "#9e2b3c", "#e8842e", "#e6c34a", "#7fa650", "#3f6f4f",
          "#4a90d9", "#2c4a86", "#6a4b8c", "#b0558f", "#e79aa8", "#7fc4c9"}) {
        colors.emplace_back(QLatin1String(name));
    }
    return colors;
}

} // namespace

ColourDock::ColourDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Colour"), "colour", parent), m_state(state), m_square(new ColourSquare(this)),
      m_hex(new QLineEdit(this)), m_swatchArea(new QWidget(this)),
      m_swatchGrid(new QGridLayout(m_swatchArea))
{
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    auto* row = new QHBoxLayout;
    const std::array<QString, 2> names{tr("A"), tr("B")};
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
        m_ends[i] = new QToolButton(content);
        m_ends[i]->setText(names[i]);
        m_ends[i]->setCheckable(true);
        m_ends[i]->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        m_ends[i]->setToolTip(i == 0 ? tr("The colour that is painted; where a gradient begins")
                                     : tr("Where a gradient ends; the other colour of random"));
        connect(m_ends[i], &QToolButton::clicked, this, [this, i] {
            m_isSecond = i == 1;
            refresh();
        });
        row->addWidget(m_ends[i]);
    }
    m_hex->setMaxLength(7);
    m_hex->setFixedWidth(74);
    m_hex->setToolTip(tr("The colour in hexadecimal, as #rrggbb"));
    row->addStretch(1);
    row->addWidget(m_hex);
    layout->addLayout(row);
    layout->addWidget(m_square, 1);
    m_swatchGrid->setContentsMargins(0, 0, 0, 0);
    m_swatchGrid->setSpacing(2);
    layout->addWidget(m_swatchArea);
    setScrolledContent(content);

    connect(m_square, &ColourSquare::colorPicked, this, &ColourDock::setColor);
    connect(m_hex, &QLineEdit::editingFinished, this, [this] {
        const QColor typed(m_hex->text());
        if (typed.isValid()) {
            setColor(typed);
        }
        refresh();
    });
    connect(&m_state, &EditorState::brushChanged, this, [this](model::BrushKind kind) {
        if (kind == model::BrushKind::Colour) {
            refresh();
        }
    });
    loadSwatches();
    fillSwatches();
    refresh();
}

std::size_t ColourDock::colorIndex() const
{
    const auto& colors = m_state.brush(model::BrushKind::Colour).colour.colors;
    return m_isSecond ? colors.size() - 1 : 0;
}

QColor ColourDock::color() const
{
    return toColor(m_state.brush(model::BrushKind::Colour).colour.colors[colorIndex()]);
}

void ColourDock::setColor(const QColor& color)
{
    model::BrushSettings brush = m_state.brush(model::BrushKind::Colour);
    if (m_isSecond && brush.colour.colors.size() < 2) {
        brush.colour.colors.push_back(toPaint(color));
    } else {
        brush.colour.colors[colorIndex()] = toPaint(color);
    }
    m_state.setBrush(brush);
}

void ColourDock::refresh()
{
    const auto& colors = m_state.brush(model::BrushKind::Colour).colour.colors;
    m_ends[0]->setIcon(swatch(toColor(colors.front()), kSwatchSize));
    m_ends[1]->setIcon(swatch(toColor(colors.back()), kSwatchSize));
    m_ends[0]->setChecked(!m_isSecond);
    m_ends[1]->setChecked(m_isSecond);
    m_square->setColor(color());
    if (!m_hex->hasFocus()) {
        m_hex->setText(color().name());
    }
}

void ColourDock::fillSwatches()
{
    qDeleteAll(m_swatchArea->findChildren<QToolButton*>());
    int index = 0;
    const auto place = [&](QToolButton* button) {
        button->setAutoRaise(true);
        button->setFixedSize(kSwatchSize + 6, kSwatchSize + 6);
        m_swatchGrid->addWidget(button, index / kSwatchColumns, index % kSwatchColumns);
        ++index;
    };
    for (const QColor& color : m_swatches) {
        auto* button = new QToolButton(m_swatchArea);
        button->setIcon(swatch(color, kSwatchSize));
        button->setToolTip(tr("%1; a right click removes it").arg(color.name()));
        button->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(button, &QToolButton::clicked, this, [this, color] { setColor(color); });
        // Later: the button must not die inside its own signal.
        connect(
            button, &QToolButton::customContextMenuRequested, this,
            [this, color] { removeSwatch(color); }, Qt::QueuedConnection);
        place(button);
    }
    auto* addition = new QToolButton(m_swatchArea);
    addition->setIcon(iconNamed("add"));
    addition->setToolTip(tr("Keep the colour as a swatch"));
    connect(
        addition, &QToolButton::clicked, this,
        [this] {
            if (std::ranges::find(m_swatches, color()) == m_swatches.end()) {
                m_swatches.push_back(color());
                saveSwatches();
                fillSwatches();
            }
        },
        Qt::QueuedConnection);
    place(addition);
}

void ColourDock::removeSwatch(const QColor& color)
{
    std::erase(m_swatches, color);
    saveSwatches();
    fillSwatches();
}

void ColourDock::loadSwatches()
{
    const QVariant stored = QSettings().value(kSwatchesKey);
    if (!stored.isValid()) {
        m_swatches = firstSwatches();
        return;
    }
    for (const QString& name : stored.toStringList()) {
        if (const QColor color(name); color.isValid()) {
            m_swatches.push_back(color);
        }
    }
}

void ColourDock::saveSwatches() const
{
    QStringList names;
    for (const QColor& color : m_swatches) {
        names << color.name();
    }
    QSettings().setValue(kSwatchesKey, names);
}

} // namespace crowd::widgets
