// SPDX-License-Identifier: MIT
#include "widgets/docks/ColourDock.h"

#include <algorithm>

#include <QtCore/QEvent>
#include <QtGui/QAction>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/docks/ColourSquare.h"
#include "widgets/docks/SwatchGrid.h"
#include "widgets/state/StoredColours.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kChipSize = 22;
constexpr int kSwatchSize = 18;
constexpr std::size_t kMostColors = 16;
constexpr std::size_t kMostRecent = 7;
constexpr const char* kSwatchesKey = "colours/swatches";

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
QStringList firstSwatches()
{
    return {QStringLiteral("#f4efe6"), QStringLiteral("#d8cbb0"), QStringLiteral("#a98d68"),
            QStringLiteral("#6b4a34"), QStringLiteral("#3a2c26"), QStringLiteral("#9aa0a8"),
            QStringLiteral("#5c636d"), QStringLiteral("#24272c"), QStringLiteral("#d64030"),
            QStringLiteral("#9e2b3c"), QStringLiteral("#e8842e"), QStringLiteral("#e6c34a"),
            QStringLiteral("#7fa650"), QStringLiteral("#3f6f4f"), QStringLiteral("#4a90d9"),
            QStringLiteral("#2c4a86"), QStringLiteral("#6a4b8c"), QStringLiteral("#b0558f"),
            QStringLiteral("#7fc4c9")};
}

/// Swatches with a control at their right.
QWidget* rowOf(QWidget* swatches, QWidget* control, QWidget* parent)
{
    auto* line = new QWidget(parent);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(swatches, 1, Qt::AlignTop);
    row->addWidget(control, 0, Qt::AlignTop);
    return line;
}

} // namespace

ColourDock::ColourDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Colour"), "colour", parent), m_state(state),
      m_chips(new SwatchGrid(kChipSize, this)), m_square(new ColourSquare(this)),
      m_dropper(new QToolButton(this)), m_hex(new QLineEdit(this)),
      m_recent(new SwatchGrid(kSwatchSize, this)), m_swatches(new SwatchGrid(kSwatchSize, this)),
      m_ofWhom(new QLabel(this))
{
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->setSpacing(5);
    layout->addWidget(m_ofWhom);
    layout->addWidget(rowOf(m_chips, m_dropper, content));
    layout->addWidget(m_square, 1);
    layout->addWidget(rowOf(m_recent, m_hex, content));
    layout->addWidget(m_swatches);
    m_ofWhom->setObjectName(QStringLiteral("coloursOfWhom"));
    m_ofWhom->setText(tr("New characters wear these:"));
    m_ofWhom->setEnabled(false);
    m_hex->setMaxLength(7);
    m_hex->setFixedWidth(68);
    m_hex->setToolTip(tr("The colour in hexadecimal, as #rrggbb"));
    m_dropper->setAutoRaise(true);
    m_dropper->setCheckable(true);
    m_dropper->setToolTip(tr("Take a colour from somebody in the picture (Ctrl and click with the "
                             "colour brush)"));
    m_recent->setHint(tr("Painted with lately"));
    m_chips->setObjectName(QStringLiteral("brushColours"));
    m_recent->setObjectName(QStringLiteral("recentColours"));
    m_swatches->setObjectName(QStringLiteral("swatches"));
    m_swatches->setHint(tr("A right click removes it"));
    m_swatches->setAddition(tr("Keep the colour as a swatch"));
    m_recent->setColors(storedColours(kRecentColours));
    m_swatches->setColors(storedColours(kSwatchesKey, firstSwatches()));
    setScrolledContent(content);
    connectState();
    refreshIcons();
    refresh();
}

void ColourDock::connectState()
{
    connect(m_chips, &SwatchGrid::chosen, this, &ColourDock::choose);
    connect(m_chips, &SwatchGrid::additionRequested, this, &ColourDock::addColor);
    connect(m_chips, &SwatchGrid::removalRequested, this, &ColourDock::removeColor);
    connect(m_recent, &SwatchGrid::chosen, this,
            [this](int index) { setColor(m_recent->colors()[static_cast<std::size_t>(index)]); });
    connect(m_swatches, &SwatchGrid::chosen, this,
            [this](int index) { setColor(m_swatches->colors()[static_cast<std::size_t>(index)]); });
    connect(m_swatches, &SwatchGrid::additionRequested, this, &ColourDock::keepSwatch);
    connect(m_swatches, &SwatchGrid::removalRequested, this, &ColourDock::removeSwatch);
    connect(m_square, &ColourSquare::colorPicked, this, &ColourDock::setColor);
    connect(m_dropper, &QToolButton::clicked, this, &ColourDock::pick);
    connect(m_hex, &QLineEdit::editingFinished, this, [this] {
        const QColor typed(m_hex->text());
        if (typed.isValid() && typed != color()) {
            setColor(typed);
        }
        refresh();
    });
    connect(&m_state, &EditorState::brushChanged, this, &ColourDock::refresh);
    connect(&m_state, &EditorState::toolChanged, this, [this] {
        m_chosen = 0;
        refresh();
    });
    connect(&m_state, &EditorState::pickingChanged, this, &ColourDock::refresh);
    connect(&m_state, &EditorState::colorPicked, this,
            [this](const model::PaintColor& color) { setColor(toColor(color)); });
    connect(&m_state, &EditorState::strokeCommitted, this, &ColourDock::noteUsed);
}

model::BrushKind ColourDock::kind() const
{
    return m_state.tool() == ToolId::BrushCreate ? model::BrushKind::Create
                                                 : model::BrushKind::Colour;
}

std::vector<model::PaintColor>& ColourDock::colorsOf(model::BrushSettings& brush) const
{
    return brush.kind() == model::BrushKind::Create ? brush.as<model::CreateSettings>().palette
                                                    : brush.as<model::ColourSettings>().colors;
}

std::vector<QColor> ColourDock::colors() const
{
    model::BrushSettings brush = m_state.brush(kind());
    std::vector<QColor> colors;
    for (const model::PaintColor& color : colorsOf(brush)) {
        colors.push_back(toColor(color));
    }
    return colors;
}

QColor ColourDock::color() const
{
    const std::vector<QColor> all = colors();
    return all.empty() ? m_square->color().toRgb() : all[std::min(m_chosen, all.size() - 1)];
}

void ColourDock::setColor(const QColor& color)
{
    model::BrushSettings brush = m_state.brush(kind());
    std::vector<model::PaintColor>& all = colorsOf(brush);
    if (all.empty()) {
        all.push_back(toPaint(color));
    } else {
        all[std::min(m_chosen, all.size() - 1)] = toPaint(color);
    }
    m_state.setBrush(brush);
}

bool ColourDock::paintsFirst() const
{
    return kind() == model::BrushKind::Colour &&
           m_state.brush(kind()).op == model::BrushOperator::Uniform;
}

void ColourDock::choose(int index)
{
    m_chosen = static_cast<std::size_t>(index);
    bringChosenFirst();
    refresh();
}

/// The marked colour is the one that paints: the two change places.
void ColourDock::bringChosenFirst()
{
    model::BrushSettings brush = m_state.brush(kind());
    std::vector<model::PaintColor>& all = colorsOf(brush);
    if (!paintsFirst() || m_chosen == 0 || m_chosen >= all.size()) {
        return;
    }
    std::swap(all.front(), all[m_chosen]);
    m_chosen = 0;
    m_state.setBrush(brush);
}

void ColourDock::addColor()
{
    model::BrushSettings brush = m_state.brush(kind());
    std::vector<model::PaintColor>& all = colorsOf(brush);
    all.push_back(toPaint(color()));
    m_chosen = all.size() - 1;
    m_state.setBrush(brush);
}

void ColourDock::removeColor(int index)
{
    model::BrushSettings brush = m_state.brush(kind());
    std::vector<model::PaintColor>& all = colorsOf(brush);
    // The colour brush always has something to paint with; new people may go untinted.
    if (all.size() > 1 || brush.kind() == model::BrushKind::Create) {
        all.erase(all.begin() + index);
        m_chosen = std::min(m_chosen, all.empty() ? 0 : all.size() - 1);
        m_state.setBrush(brush);
    }
}

void ColourDock::pick()
{
    const bool isPicking = m_state.picking() == Picking::Colour;
    if (!isPicking && m_state.tool() != ToolId::BrushCreate) {
        m_state.setTool(ToolId::BrushColour);
    }
    m_state.setPicking(isPicking ? Picking::None : Picking::Colour);
    refresh();
}

void ColourDock::noteUsed(model::BrushKind kind)
{
    if (kind != model::BrushKind::Colour) {
        return;
    }
    const model::BrushSettings& brush = m_state.brush(kind);
    const bool usesAll = brush.op != model::BrushOperator::Uniform;
    std::vector<QColor> recent = m_recent->colors();
    for (std::size_t i = usesAll ? brush.as<model::ColourSettings>().colors.size() : 1; i-- > 0;) {
        const QColor used = toColor(brush.as<model::ColourSettings>().colors[i]);
        std::erase(recent, used);
        recent.insert(recent.begin(), used);
    }
    recent.resize(std::min(recent.size(), kMostRecent));
    storeColours(kRecentColours, recent);
    m_recent->setColors(std::move(recent));
    refresh();
}

void ColourDock::refresh()
{
    const bool isCreation = kind() == model::BrushKind::Create;
    m_ofWhom->setVisible(isCreation); // a title that changed would move all tabs beside it
    const std::vector<QColor> all = colors();
    m_chosen = paintsFirst() ? 0 : m_chosen;
    m_chips->setAddition(all.size() >= kMostColors ? QString()
                         : isCreation ? tr("Another colour that new characters may wear")
                                      : tr("Another colour for random and for gradients"));
    m_chips->setHint(paintsFirst() ? tr("A click brings it to the front, from where it paints; "
                                        "a right click removes it")
                                   : tr("A right click removes it"));
    m_chips->setSelected(all.empty() ? -1 : static_cast<int>(std::min(m_chosen, all.size() - 1)));
    m_chips->setColors(all);
    m_square->setColor(color());
    m_dropper->setChecked(m_state.picking() == Picking::Colour);
    if (!m_hex->hasFocus()) {
        m_hex->setText(color().name());
    }
}

void ColourDock::refreshIcons()
{
    m_dropper->setIcon(iconNamed("dropper"));
}

void ColourDock::changeEvent(QEvent* event)
{
    DockBase::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        refreshIcons();
    }
}

void ColourDock::keepSwatch()
{
    std::vector<QColor> swatches = m_swatches->colors();
    if (std::ranges::find(swatches, color()) == swatches.end()) {
        swatches.push_back(color());
        storeColours(kSwatchesKey, swatches);
        m_swatches->setColors(std::move(swatches));
    }
}

void ColourDock::removeSwatch(int index)
{
    std::vector<QColor> swatches = m_swatches->colors();
    swatches.erase(swatches.begin() + index);
    storeColours(kSwatchesKey, swatches);
    m_swatches->setColors(std::move(swatches));
}

} // namespace crowd::widgets
